// SPDX-License-Identifier: MIT
#include "libsmart/kernel/kernels.h"

#include <stdlib.h>

#include <atomic>
#include <cstdio>
#include <cstring>

#include "libsmart/base/variable_warning.h"

namespace smart {

#if defined(__x86_64__)
namespace avx512 { extern const KernelTable kTable; }
namespace avx2 { extern const KernelTable kTable; }
namespace sse4 { extern const KernelTable kTable; }
#elif defined(__aarch64__)
namespace neon { extern const KernelTable kTable; }
#endif
namespace generic { extern const KernelTable kTable; }

namespace {

struct Candidate {
    const KernelTable* table;
    bool (*supported)();
};

// Best first. The conditions are the flags that libsmart/kernel/CMakeLists.txt compiles with.
const Candidate kCandidates[] = {
#if defined(__x86_64__)
    {&avx512::kTable,
     [] {
         return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl") &&
                __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx2") &&
                __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi") &&
                __builtin_cpu_supports("bmi2");
     }},
    {&avx2::kTable,
     [] {
         return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
     }},
    {&sse4::kTable, [] { return bool(__builtin_cpu_supports("sse4.2")); }},
#elif defined(__aarch64__)
    {&neon::kTable, [] { return true; }},
#endif
    {&generic::kTable, [] { return true; }},
};

const KernelTable& choose() {
    const KernelTable* best = nullptr;
    for (const Candidate& c : kCandidates)
        if (!best && c.supported()) best = c.table;
    const char* wanted = secure_getenv("OPENRT_ISA");
    if (!wanted || !*wanted) return *best;
    if (const KernelTable* table = findKernels(wanted)) return *table;

    // A set that the machine lacks: the best one below it.
    const KernelTable* below = nullptr;
    bool known = false;
    for (const Candidate& c : kCandidates) {
        known = known || std::strcmp(c.table->name, wanted) == 0;
        if (known && !below && c.supported()) below = c.table;
    }
    const KernelTable& table = below ? *below : *best;
    char reason[80];
    std::snprintf(reason, sizeof reason, "%s; using %s",
                  known ? "not supported by this machine" : "unknown", table.name);
    warnOfVariable("OPENRT_ISA", wanted, reason);
    return table;
}

std::atomic<const KernelTable*>& selected() {
    static std::atomic<const KernelTable*> table{&choose()};
    return table;
}

} // namespace

const KernelTable& kernels() { return *selected().load(std::memory_order_acquire); }

const KernelTable* findKernels(const char* name) {
    for (const Candidate& c : kCandidates)
        if (std::strcmp(c.table->name, name) == 0) return c.supported() ? c.table : nullptr;
    return nullptr;
}

bool selectKernels(const char* name) {
    const KernelTable* table = findKernels(name);
    if (table) selected().store(table, std::memory_order_release);
    return table != nullptr;
}

} // namespace smart
