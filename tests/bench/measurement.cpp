// SPDX-License-Identifier: MIT
#include "tests/bench/measurement.h"

#include <algorithm>
#include <atomic>
#include <barrier>
#include <chrono>
#include <ctime>
#include <thread>

namespace smart::bench {
namespace {

constexpr std::size_t kChunk = 256; ///< packets that a thread takes at a time

double processorSeconds() {
    timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

/// Seconds from the moment when all threads are ready to the end of the last; of one thread its
/// processor time, which does not count what else the machine did.
template <typename Work>
double timed(const Engine& engine, std::size_t packets, unsigned threads, const Work& work) {
    std::atomic<std::size_t> next{0};
    auto start = std::chrono::steady_clock::now();
    const auto begin = [&start]() noexcept { start = std::chrono::steady_clock::now(); };
    std::barrier ready(std::ptrdiff_t(threads), begin);
    double alone = 0;
    std::vector<std::thread> workers;
    for (unsigned i = 0; i < threads; ++i) {
        workers.emplace_back([&] {
            engine.enterThread();
            ready.arrive_and_wait();
            const double entered = processorSeconds();
            for (;;) {
                const std::size_t first = next.fetch_add(kChunk);
                if (first >= packets) break;
                work(first, std::min(kChunk, packets - first));
            }
            if (threads == 1) alone = processorSeconds() - entered;
        });
    }
    for (std::thread& worker : workers) worker.join();
    if (threads == 1) return alone;
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

} // namespace

double Result::median() const {
    std::vector<double> sorted = mraysPerSecond;
    std::sort(sorted.begin(), sorted.end());
    const std::size_t n = sorted.size();
    if (n == 0) return 0;
    return n % 2 ? sorted[n / 2] : 0.5 * (sorted[n / 2 - 1] + sorted[n / 2]);
}

Series measure(const std::vector<Triangle>& triangles, const RaySet& rays, Kind kind,
               std::span<const EnginePtr> engines, unsigned threads, unsigned repeats,
               const Progress& progress) {
    const std::size_t packets = rays.packets.size();
    std::vector<std::vector<Found>> found(engines.size());
    std::vector<std::vector<uint32_t>> blocked(engines.size());
    Series series{kind, threads, rays.active, {}};
    for (std::size_t e = 0; e < engines.size(); ++e) {
        series.results.push_back({engines[e]->name(), engines[e]->peer(), {}, {}, false});
        if (kind == Kind::Primary)
            found[e].resize(packets);
        else
            blocked[e].resize(packets);
    }
    for (unsigned repeat = 0; repeat <= repeats; ++repeat) { // the first only warms caches
        for (std::size_t e = 0; e < engines.size(); ++e) {
            progress((kind == Kind::Primary ? "primary, " : "shadow, ") + std::to_string(threads) +
                     " thread(s), repeat " + std::to_string(repeat) + " of " +
                     std::to_string(repeats) + ": " + engines[e]->name());
            const double seconds =
                timed(*engines[e], packets, threads, [&](std::size_t first, std::size_t count) {
                    if (kind == Kind::Primary) {
                        engines[e]->closest(rays, first, count, found[e].data());
                    } else {
                        engines[e]->any(rays, first, count, blocked[e].data());
                    }
                });
            if (repeat == 0) continue;
            series.results[e].mraysPerSecond.push_back(double(rays.active) / seconds * 1e-6);
        }
    }
    progress("comparing the answers");
    const std::vector<Mistakes> mistakes = kind == Kind::Primary
                                               ? judgeClosest(triangles, rays, found)
                                               : judgeAny(triangles, rays, engines, blocked);
    for (std::size_t e = 0; e < engines.size(); ++e) {
        Result& result = series.results[e];
        result.mistakes = mistakes[e];
        result.refused =
            !result.peer && double(mistakes[e].wrong) > kWrongLimit * double(rays.active);
    }
    return series;
}

} // namespace smart::bench
