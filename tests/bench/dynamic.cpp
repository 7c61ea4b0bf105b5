// SPDX-License-Identifier: MIT
#include "tests/bench/dynamic.h"

#include <algorithm>
#include <atomic>
#include <barrier>
#include <chrono>
#include <cmath>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <thread>

#include "openrt/rt.h"

namespace smart::bench {
namespace {

constexpr std::size_t kChunk = 256;         ///< packets that a thread takes at a time
constexpr double kDifferingLimit = 2e-3;    ///< edges of small triangles, and no more
constexpr float kDistanceTolerance = 1e-3f; ///< relative

double since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The same surface: where several lie within rounding of each other, any of them.
bool agree(float a, bool hitA, float b, bool hitB) {
    if (hitA != hitB) return false;
    return !hitA || std::abs(a - b) <= kDistanceTolerance * std::max(std::abs(a), std::abs(b));
}

double differing(const std::vector<DynamicFound>& a, const std::vector<DynamicFound>& b) {
    std::size_t count = 0;
    for (std::size_t p = 0; p < a.size(); ++p)
        for (int i = 0; i < kPacketSize; ++i)
            count += !agree(a[p].t[i], a[p].triangle[i] != kNoHit, b[p].t[i],
                            b[p].triangle[i] != kNoHit);
    return double(count) / double(a.size() * kPacketSize);
}

DynamicSeries measureSeries(const DynamicScene& scene, std::span<const DynamicEnginePtr> engines,
                            const DynamicOptions& options, const std::string& name,
                            const DynamicProgress& progress) {
    const RaySet rays = primaryRays(scene.view(), options.size);
    std::vector<std::vector<DynamicFound>> found(
        engines.size(), std::vector<DynamicFound>(rays.packets.size()));
    std::vector<std::vector<double>> update(engines.size()), build(update), trace(update),
        step(update);
    DynamicSeries series{name, scene.instances(), scene.triangles().size(), {}};
    for (const DynamicEnginePtr& engine : engines)
        series.results.push_back({engine->name(), engine->peer()});
    for (unsigned number = 0; number <= options.repeat; ++number) {
        const DynamicStep now = scene.step(number);
        for (std::size_t e = 0; e < engines.size(); ++e) {
            progress(name + ", step " + std::to_string(number) + ": " + engines[e]->name());
            const bool isLate = options.plantError && e == 0 && number > 0;
            const DynamicStep before = isLate ? scene.step(number - 1) : DynamicStep();
            auto start = std::chrono::steady_clock::now();
            engines[e]->update(isLate ? before : now);
            const double updated = since(start);
            start = std::chrono::steady_clock::now();
            engines[e]->build();
            const double built = since(start);
            const double traced = timedTrace(*engines[e], rays, options.threads, found[e]);
            if (number == 0) continue;
            update[e].push_back(updated);
            build[e].push_back(built);
            trace[e].push_back(traced);
            step[e].push_back(updated + built + traced);
        }
        // The yardstick is the last engine: a peer, where there is one.
        for (std::size_t e = 0; number > 0 && e < engines.size(); ++e)
            series.results[e].differing =
                std::max(series.results[e].differing, differing(found[e], found.back()));
    }
    for (std::size_t e = 0; e < engines.size(); ++e) {
        DynamicResult& result = series.results[e];
        result.update = median(update[e]);
        result.build = median(build[e]);
        result.trace = median(trace[e]);
        result.step = median(step[e]);
        result.bytes = engines[e]->bytes();
        result.refused = !result.peer && result.differing > kDifferingLimit;
    }
    return series;
}

std::vector<DynamicEnginePtr> instanceEngines(const DynamicScene& scene,
                                              const DynamicOptions& options) {
    std::vector<DynamicEnginePtr> engines;
    engines.push_back(
        dynamicOpenrt(scene, options.threads, SheetWay::Update, RT_DONT_CARE, "openrt"));
#ifdef OPENRT_BENCH_EMBREE
    for (const EmbreeWay way : {EmbreeWay::Low, EmbreeWay::Medium})
        if (options.embree) engines.push_back(dynamicEmbree(scene, options.threads, way));
#endif
    return engines;
}

std::vector<DynamicEnginePtr> sheetEngines(const DynamicScene& scene,
                                           const DynamicOptions& options) {
    std::vector<DynamicEnginePtr> engines;
    const auto add = [&](SheetWay way, uint32_t quality, const char* name) {
        engines.push_back(dynamicOpenrt(scene, options.threads, way, quality, name));
    };
    add(SheetWay::Update, RT_DONT_CARE, "openrt update");
    add(SheetWay::Update, RT_FASTEST, "openrt update, fastest");
    add(SheetWay::Redefine, RT_FASTEST, "openrt redefine, fastest");
    add(SheetWay::Redefine, RT_DONT_CARE, "openrt redefine");
    add(SheetWay::Redefine, RT_NICEST, "openrt redefine, nicest");
    add(SheetWay::Redefine, RT_KD_TREE, "openrt redefine, kd-tree");
#ifdef OPENRT_BENCH_EMBREE
    for (const EmbreeWay way : {EmbreeWay::Refit, EmbreeWay::Low, EmbreeWay::Medium})
        if (options.embree) engines.push_back(dynamicEmbree(scene, options.threads, way));
#endif
    return engines;
}

} // namespace

double timedTrace(const DynamicEngine& engine, const RaySet& rays, unsigned threads,
                  std::vector<DynamicFound>& found) {
    std::atomic<std::size_t> next{0};
    auto start = std::chrono::steady_clock::now();
    const auto begin = [&start]() noexcept { start = std::chrono::steady_clock::now(); };
    std::barrier ready(std::ptrdiff_t(threads), begin);
    std::vector<std::thread> workers;
    for (unsigned i = 0; i < threads; ++i) {
        workers.emplace_back([&] {
            engine.enterThread();
            ready.arrive_and_wait();
            for (;;) {
                const std::size_t first = next.fetch_add(kChunk);
                if (first >= rays.packets.size()) break;
                engine.trace(rays, first, std::min(kChunk, rays.packets.size() - first),
                             found.data());
            }
        });
    }
    for (std::thread& worker : workers) worker.join();
    return since(start);
}

double median(std::vector<double> values) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    const std::size_t n = values.size();
    return n % 2 ? values[n / 2] : 0.5 * (values[n / 2 - 1] + values[n / 2]);
}

DynamicReport measureDynamic(const DynamicOptions& options, const DynamicProgress& progress) {
    DynamicReport report;
    report.threads = options.threads;
    report.size = options.size;
    const auto measure = [&](const DynamicScene& scene, const std::string& name) {
        {
            const std::vector<DynamicEnginePtr> engines =
                scene.isSheet() ? sheetEngines(scene, options) : instanceEngines(scene, options);
            report.series.push_back(measureSeries(scene, engines, options, name, progress));
        }
        if (scene.isSheet()) return;
        for (const bool lit : {false, true}) {
            progress(name + (lit ? ", lit frames" : ", flat frames"));
            report.frames.push_back(measureFrame(scene, options, lit));
        }
    };
    for (const uint32_t count : options.instances)
        measure(DynamicScene::balls(count), std::to_string(count) + " instances");
    if (options.sheet > 0) measure(DynamicScene::sheet(options.sheet), "sheet");
    return report;
}

bool DynamicReport::anyRefused() const {
    for (const DynamicSeries& s : series)
        for (const DynamicResult& result : s.results)
            if (result.refused) return true;
    return false;
}

nlohmann::json DynamicReport::json() const {
    nlohmann::json root{{"threads", threads}, {"size", size}};
    for (const DynamicSeries& s : series) {
        nlohmann::json results = nlohmann::json::array();
        for (const DynamicResult& r : s.results)
            results.push_back({{"engine", r.engine},
                               {"update", r.update},
                               {"build", r.build},
                               {"trace", r.trace},
                               {"step", r.step},
                               {"bytes", r.bytes},
                               {"differing", r.differing},
                               {"refused", r.refused}});
        root["series"].push_back({{"scene", s.scene},
                                  {"instances", s.instances},
                                  {"triangles", s.triangles},
                                  {"results", results}});
    }
    for (const DynamicFrame& f : frames)
        root["frames"].push_back({{"instances", f.instances},
                                  {"lit", f.lit},
                                  {"describe", f.describe},
                                  {"freeze", f.freeze},
                                  {"render", f.render},
                                  {"whole", f.whole}});
    return root;
}

std::ostream& operator<<(std::ostream& out, const DynamicReport& report) {
    out << std::fixed << "threads: " << report.threads << ", camera rays: " << report.size << " x "
        << report.size << ", medians\n";
    for (const DynamicSeries& s : report.series) {
        double best = 0;
        for (const DynamicResult& r : s.results)
            if (r.peer && (best == 0 || r.step < best)) best = r.step;
        out << s.scene << ", " << s.triangles << " triangles\n"
            << "                               update ms   build ms   trace ms   a second"
            << "  to best peer      bytes each\n";
        for (const DynamicResult& r : s.results) {
            out << "  " << std::left << std::setw(26) << r.engine << std::right;
            if (r.refused) {
                out << "  refused: " << std::setprecision(3) << 100 * r.differing
                    << " % of the rays find something else\n";
                continue;
            }
            out << std::setprecision(3) << std::setw(12) << 1e3 * r.update << std::setw(11)
                << 1e3 * r.build << std::setw(11) << 1e3 * r.trace << std::setprecision(1)
                << std::setw(11) << 1 / r.step << std::setprecision(2) << std::setw(14)
                << best / r.step << std::setprecision(1) << std::setw(16)
                << double(r.bytes) / (s.instances > 1 ? s.instances : double(s.triangles))
                << '\n';
        }
    }
    const DynamicFrame* first[2] = {nullptr, nullptr};
    for (const DynamicFrame& f : report.frames) {
        if (!first[f.lit]) first[f.lit] = &f;
        out << "frames of " << f.instances << " instances, " << (f.lit ? "lit" : "flat")
            << std::setprecision(3) << ": describe " << 1e3 * f.describe << " ms, freeze "
            << 1e3 * f.freeze << " ms (" << std::setprecision(1) << 100 * f.freeze / f.whole
            << " %), render " << std::setprecision(3) << 1e3 * f.render << " ms; "
            << std::setprecision(1) << 1 / f.whole << " a second, " << std::setprecision(2)
            << f.whole / first[f.lit]->whole << " times the time of " << first[f.lit]->instances
            << '\n';
    }
    return out;
}

} // namespace smart::bench
