// SPDX-License-Identifier: MIT
// A library to be preloaded, in which allocations that libOpenRT makes fail; those of the program
// and of other libraries do not: programs need not expect what the library promises to survive. Of a
// program that has the core inside itself all fail.
//   OPENRT_FAIL_ALLOCATION  number of the one that fails, from 0
//   OPENRT_FAIL_THEN        if set, all that follow fail too
//   OPENRT_COUNT_FILE       gets two numbers at the end: allocations, failures
#include <link.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>

namespace {

std::atomic<long> allocations{0}, failures{0};
uintptr_t codeBegin = 0, codeEnd = 0;
long failing = -1;
bool thenToo = false;

/// The program comes first, and its name is empty.
int findLibrary(dl_phdr_info* info, std::size_t, void*) {
    if (info->dlpi_name[0] != 0 && !std::strstr(info->dlpi_name, "libOpenRT.so")) return 0;
    for (int i = 0; i < info->dlpi_phnum; ++i) {
        const auto& segment = info->dlpi_phdr[i];
        if (segment.p_type != PT_LOAD || !(segment.p_flags & PF_X)) continue;
        codeBegin = info->dlpi_addr + segment.p_vaddr;
        codeEnd = codeBegin + segment.p_memsz;
    }
    return info->dlpi_name[0] != 0; // or look on
}

__attribute__((constructor)) void begin() {
    dl_iterate_phdr(findLibrary, nullptr);
    if (const char* number = std::getenv("OPENRT_FAIL_ALLOCATION")) failing = std::atol(number);
    thenToo = std::getenv("OPENRT_FAIL_THEN") != nullptr;
}

__attribute__((destructor)) void end() {
    const char* const path = std::getenv("OPENRT_COUNT_FILE");
    FILE* const file = path ? std::fopen(path, "w") : nullptr;
    if (!file) return;
    std::fprintf(file, "%ld %ld\n", allocations.load(), failures.load());
    std::fclose(file);
}

bool fails(void* caller) {
    const auto address = reinterpret_cast<uintptr_t>(caller);
    if (address < codeBegin || address >= codeEnd) return false;
    const long number = allocations++;
    if (failing < 0 || (thenToo ? number < failing : number != failing)) return false;
    ++failures;
    return true;
}

void* allocate(std::size_t bytes, std::size_t alignment, void* caller) {
    if (fails(caller)) return nullptr;
    alignment = std::max(alignment, alignof(std::max_align_t));
    return std::aligned_alloc(alignment, (std::max(bytes, std::size_t(1)) + alignment - 1) /
                                             alignment * alignment);
}
void* orThrow(void* block) {
    if (!block) throw std::bad_alloc();
    return block;
}

} // namespace

#define CALLER __builtin_return_address(0)
#define SHOWN __attribute__((visibility("default"), noinline))
SHOWN void* operator new(std::size_t n) { return orThrow(allocate(n, 1, CALLER)); }
SHOWN void* operator new[](std::size_t n) { return orThrow(allocate(n, 1, CALLER)); }
SHOWN void* operator new(std::size_t n, std::align_val_t a) {
    return orThrow(allocate(n, std::size_t(a), CALLER));
}
SHOWN void* operator new[](std::size_t n, std::align_val_t a) {
    return orThrow(allocate(n, std::size_t(a), CALLER));
}
SHOWN void* operator new(std::size_t n, const std::nothrow_t&) noexcept {
    return allocate(n, 1, CALLER);
}
SHOWN void* operator new[](std::size_t n, const std::nothrow_t&) noexcept {
    return allocate(n, 1, CALLER);
}
