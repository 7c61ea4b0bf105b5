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

// Two vectors in flight a unit hide the latency; sums are used, so that nothing is left out.
constexpr int kChains = 12, kSteps = 2'000'000;

typedef float Vector16 __attribute__((vector_size(64)));

#if defined(__x86_64__)
__attribute__((target_clones("avx512f", "avx2,fma", "default")))
#endif
float multiplyAdd() {
    Vector16 sum[kChains];
    for (int i = 0; i < kChains; ++i) sum[i] = Vector16{} + float(i);
    const Vector16 factor = Vector16{} + 0.999f, term = Vector16{} + 0.001f;
    for (int step = 0; step < kSteps / kChains; ++step) {
        for (int i = 0; i < kChains; ++i) sum[i] = sum[i] * factor + term;
    }
    float total = 0;
    for (int i = 0; i < kChains; ++i)
        for (int lane = 0; lane < 16; ++lane) total += sum[i][lane];
    return total;
}

volatile float keepFloat;
volatile unsigned long keepInteger;

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
    const double flops = double(kSteps / kChains * kChains) * 16 * 2;
    limits.gigaflops = flops * 1e-9 / fastest(6, [] { keepFloat = multiplyAdd(); });
    limits.cacheGBs = triadGBs(256 << 10);
    limits.memoryGBs = triadGBs(std::size_t(192) << 20);
    return limits;
}

} // namespace smart::bench
