// SPDX-License-Identifier: MIT
#include "tests/bench/limits.h"

#include <algorithm>
#include <ctime>
#include <functional>
#include <vector>

namespace smart::bench {
namespace {

double processorSeconds() {
    timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

/// Least seconds of several runs.
double fastest(int runs, const std::function<void()>& work) {
    double best = 1e30;
    for (int i = 0; i < runs; ++i) {
        const double start = processorSeconds();
        work();
        best = std::min(best, processorSeconds() - start);
    }
    return best;
}

volatile float keepFloat;
volatile unsigned long keepInteger;

// As many sums in flight as hide the latency and fit the registers; all are used in the end, so that
// nothing is left out.
constexpr int kChains = 12, kSteps = 2'000'000;

typedef float Vector4 __attribute__((vector_size(16)));
typedef float Vector8 __attribute__((vector_size(32)));
typedef float Vector16 __attribute__((vector_size(64)));

/// Multiplies and adds; returns how many operations that were.
template <class Vector>
[[gnu::always_inline]] inline double runChains() {
    constexpr int kLanes = sizeof(Vector) / sizeof(float);
    Vector sum[kChains];
    for (int i = 0; i < kChains; ++i) sum[i] = Vector{} + float(i);
    const Vector factor = Vector{} + 0.999f, term = Vector{} + 0.001f;
    for (int step = 0; step < kSteps / kChains; ++step) {
        for (int i = 0; i < kChains; ++i) sum[i] = sum[i] * factor + term;
    }
    float total = 0;
    for (int i = 0; i < kChains; ++i)
        for (int lane = 0; lane < kLanes; ++lane) total += sum[i][lane];
    keepFloat = total;
    return 2.0 * kLanes * (kSteps / kChains) * kChains;
}

#if defined(__x86_64__)
__attribute__((target("avx512f"))) double runAvx512() {
    return runChains<Vector16>();
}
__attribute__((target("avx2"))) double runAvx2() {
    return runChains<Vector8>();
}
#endif

double multiplyAdd() {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx512f")) return runAvx512();
    if (__builtin_cpu_supports("avx2")) return runAvx2();
#endif
    return runChains<Vector4>();
}

double triadGBs(std::size_t bytes) {
    const std::size_t count = bytes / 3 / sizeof(float);
    std::vector<float> a(count, 1.0f), b(count, 2.0f), c(count, 3.0f);
    const std::size_t turns = std::max<std::size_t>(1, 50'000'000 / bytes);
    const double seconds = fastest(4, [&] {
        for (std::size_t turn = 0; turn < turns; ++turn) {
            const float scale = 1.0f + float(turn) * 1e-6f;
            for (std::size_t i = 0; i < count; ++i) a[i] = b[i] + scale * c[i];
            keepFloat = a[turn % count];
        }
    });
    return double(turns) * double(count) * 3 * sizeof(float) / seconds * 1e-9;
}

} // namespace

Limits measureLimits() {
    Limits limits;
    constexpr unsigned long kAdditions = 20'000'000;
    limits.clockGHz = double(kAdditions) * 1e-9 / fastest(4, [] {
        unsigned long sum = keepInteger;
        for (unsigned long i = 0; i < kAdditions; ++i) {
            sum += 3;
            __asm__ volatile("" : "+r"(sum)); // one after the other
        }
        keepInteger = sum;
    });
    double operations = 0;
    const double seconds = fastest(6, [&] { operations = multiplyAdd(); });
    limits.gigaflops = operations * 1e-9 / seconds;
    limits.cacheGBs = triadGBs(256 << 10);
    limits.memoryGBs = triadGBs(std::size_t(192) << 20);
    return limits;
}

} // namespace smart::bench
