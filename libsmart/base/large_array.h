// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

namespace smart {

/// Asks for huge pages in that memory, which loses what was in it: where rays read all over some
/// hundred megabytes, the processor looks up pages less often. Does nothing for what is small, nor
/// where the system has none.
void useHugePages(void* memory, std::size_t bytes) noexcept;

/// Memory in huge pages. New elements without a value stay as they are.
template <class T>
struct LargeArrayAllocator {
    using value_type = T;

    LargeArrayAllocator() = default;
    template <class U>
    LargeArrayAllocator(const LargeArrayAllocator<U>&) noexcept {}

    T* allocate(std::size_t count) {
        T* const memory = std::allocator<T>().allocate(count);
        useHugePages(memory, count * sizeof(T));
        return memory;
    }
    void deallocate(T* memory, std::size_t count) noexcept {
        std::allocator<T>().deallocate(memory, count);
    }
    template <class U>
    void construct(U* element) noexcept {
        ::new (static_cast<void*>(element)) U;
    }

    bool operator==(const LargeArrayAllocator&) const = default;
};

/// What rays read all over; `LargeArray<float>(n)` is not initialised.
template <class T>
using LargeArray = std::vector<T, LargeArrayAllocator<T>>;

} // namespace smart
