// SPDX-License-Identifier: MIT
#include "tests/memory/failing_new.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace openrt::test {
namespace {

std::atomic<Failing> mode{Failing::Never};
std::atomic<int64_t> allocations{0}, failures{0}, failing{0}, live{0};

bool fails() {
    const Failing how = mode.load(std::memory_order_relaxed);
    const int64_t number = allocations.fetch_add(1, std::memory_order_relaxed);
    if (how == Failing::Never) return false;
    const int64_t n = failing.load(std::memory_order_relaxed);
    if (how == Failing::Once ? number != n : number < n) return false;
    ++failures;
    return true;
}

void* allocate(std::size_t bytes, std::size_t alignment) noexcept {
    if (fails()) return nullptr;
    alignment = std::max(alignment, alignof(std::max_align_t));
    void* const block = std::aligned_alloc(
        alignment, (std::max(bytes, std::size_t(1)) + alignment - 1) / alignment * alignment);
    if (block) ++live;
    return block;
}

void* allocateOrThrow(std::size_t bytes, std::size_t alignment) {
    void* const block = allocate(bytes, alignment);
    if (!block) throw std::bad_alloc();
    return block;
}

void release(void* block) noexcept {
    if (block) --live;
    std::free(block);
}

} // namespace

void failAllocation(Failing how, int64_t n) {
    allocations = 0;
    failures = 0;
    failing = n;
    mode = how;
}
int64_t endFailing() {
    mode = Failing::Never;
    return allocations;
}
int64_t failedAllocations() { return failures; }
int64_t liveBlocks() { return live; }

} // namespace openrt::test

using openrt::test::allocate;
using openrt::test::allocateOrThrow;
using openrt::test::release;

void* operator new(std::size_t bytes) { return allocateOrThrow(bytes, 1); }
void* operator new[](std::size_t bytes) { return allocateOrThrow(bytes, 1); }
void* operator new(std::size_t bytes, std::align_val_t alignment) {
    return allocateOrThrow(bytes, std::size_t(alignment));
}
void* operator new[](std::size_t bytes, std::align_val_t alignment) {
    return allocateOrThrow(bytes, std::size_t(alignment));
}
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept { return allocate(bytes, 1); }
void* operator new[](std::size_t bytes, const std::nothrow_t&) noexcept {
    return allocate(bytes, 1);
}
void* operator new(std::size_t bytes, std::align_val_t alignment, const std::nothrow_t&) noexcept {
    return allocate(bytes, std::size_t(alignment));
}
void* operator new[](std::size_t bytes, std::align_val_t alignment,
                     const std::nothrow_t&) noexcept {
    return allocate(bytes, std::size_t(alignment));
}
void operator delete(void* block) noexcept { release(block); }
void operator delete[](void* block) noexcept { release(block); }
void operator delete(void* block, std::size_t) noexcept { release(block); }
void operator delete[](void* block, std::size_t) noexcept { release(block); }
void operator delete(void* block, std::align_val_t) noexcept { release(block); }
void operator delete[](void* block, std::align_val_t) noexcept { release(block); }
void operator delete(void* block, std::size_t, std::align_val_t) noexcept { release(block); }
void operator delete[](void* block, std::size_t, std::align_val_t) noexcept { release(block); }
void operator delete(void* block, const std::nothrow_t&) noexcept { release(block); }
void operator delete[](void* block, const std::nothrow_t&) noexcept { release(block); }
void operator delete(void* block, std::align_val_t, const std::nothrow_t&) noexcept {
    release(block);
}
void operator delete[](void* block, std::align_val_t, const std::nothrow_t&) noexcept {
    release(block);
}
