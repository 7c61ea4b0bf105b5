// SPDX-License-Identifier: MIT
#include "libsmart/base/large_array.h"

#include <cstdint>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace smart {

void useHugePages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) noexcept {
#if defined(__linux__)
    constexpr uintptr_t kHugePage = uintptr_t(2) << 20; // what x86-64, and AArch64 as a rule, have
    const uintptr_t begin = (uintptr_t(memory) + kHugePage - 1) & ~(kHugePage - 1);
    const uintptr_t end = (uintptr_t(memory) + bytes) & ~(kHugePage - 1);
    if (begin >= end) return;
    void* const inside = reinterpret_cast<void*>(begin);
    // What the heap had before comes in small pages, which would stay.
    madvise(inside, end - begin, MADV_DONTNEED);
    madvise(inside, end - begin, MADV_HUGEPAGE);
#endif
}

} // namespace smart
