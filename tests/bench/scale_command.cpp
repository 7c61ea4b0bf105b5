// SPDX-License-Identifier: MIT
// How time grows with the number of triangles, and with that of pixels.
#include <algorithm>
#include <cmath>
#include <ctime>
#include <iomanip>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "libsmart/render/tile_order.h"
#include "libsmart/render/tracers.h"
#include "libsmart/render/worker.h"
#include "tests/bench/command.h"
#include "tests/bench/machine.h"
#include "tests/bench/measurement.h"
#include "tests/bench/openrt_engine.h"
#include "tests/bench/options.h"
#include "tests/bench/phong_frame.h"
#include "tests/support/procedural_meshes.h"
#ifdef OPENRT_BENCH_EMBREE
#include "tests/bench/embree_engine.h"
#endif

namespace smart::bench {
namespace {

struct Options {
    std::string isa, json;
    std::vector<std::string> peers;
    uint32_t fewest = 10'000, most = 10'000'000, size = 1024, largest = 4096;
    unsigned repeat = 5;
};

/// One scene and picture: milliseconds of one thread, medians. 0: not measured.
struct Point {
    std::size_t triangles = 0;
    uint32_t size = 0;
    double buildMs = 0, frameMs = 0;                   ///< frame: primary, shadow, Phong
    double primaryMs = 0, embreePrimaryMs = 0;         ///< rays alone
    double shadowMs = 0, embreeShadowMs = 0;
};

double processorSeconds() {
    timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

/// Milliseconds of a thread of its own, whose floating-point environment the work may change.
template <class Work>
double milliseconds(const Work& work) {
    double seconds = 0;
    std::thread([&] {
        const double start = processorSeconds();
        work();
        seconds = processorSeconds() - start;
    }).join();
    return seconds * 1e3;
}

void renderAll(const Frame& frame) {
    const FrameTracer tracer;
    const auto pixels = std::make_unique<TilePixels>();
    for (const Tile& tile : mortonTiles(frame.target.width, frame.target.height)) {
        tracer.render(frame, tile, *pixels);
        writeTile(frame.target, tile, *pixels);
    }
}

/// Traces with the fastest of the engines.
double traceMs(const std::vector<EnginePtr>& engines, const RaySet& rays, Query query) {
    double best = INFINITY;
    std::vector<Found> found(query == Query::Closest ? rays.packets.size() : 0);
    std::vector<uint32_t> blocked(query == Query::Any ? rays.packets.size() : 0);
    for (const EnginePtr& engine : engines) {
        engine->load(rays, query);
        best = std::min(best, milliseconds([&] {
            engine->enterThread();
            if (query == Query::Closest)
                engine->closest(rays, 0, rays.packets.size(), found.data());
            else
                engine->any(rays, 0, rays.packets.size(), blocked.data());
        }));
        engine->unload(rays, found.data(), blocked.data());
    }
    return best;
}

/// Our engines and, where wanted, Embree's best two for such rays.
struct Contest {
    ScenePtr scene;
    std::vector<EnginePtr> ours, embree;
};

Contest contestOf(const std::vector<Triangle>& triangles, const Options& options, Point& point) {
    Contest contest;
    BuildReport report;
    contest.scene = buildOpenrt(triangles, Precision::Watertight, coreCount(), report);
    point.buildMs = report.seconds * 1e3;
    contest.ours =
        openrtEngines(contest.scene, Precision::Watertight, Coherence::Coherent, false);
    std::erase_if(contest.ours, [](const EnginePtr& engine) {
        return engine->name().find("tile") == std::string::npos &&
               engine->name().find("stream") == std::string::npos;
    });
#ifdef OPENRT_BENCH_EMBREE
    if (wantsEmbree(options.peers)) {
        for (EnginePtr& engine :
             embreeEngines(triangles, EmbreeQuality::Medium, false, coreCount(), options.isa)) {
            if (engine->name().starts_with("embree 16 coherent"))
                contest.embree.push_back(std::move(engine));
        }
    }
#endif
    return contest;
}

void measure(const Contest& contest, const View& view, const Options& options,
             const std::vector<Triangle>& triangles, Point& point) {
    std::vector<float> pixels;
    const std::unique_ptr<Frame> frame = phongFrame(contest.scene, view, point.size, pixels);
    const RaySet primary = primaryRays(view, point.size);
    const RaySet shadow =
        shadowRays(view, surfacePoints(primary, contest.scene->view(), triangles));
    std::vector<double> times[5];
    for (unsigned repeat = 0; repeat <= options.repeat; ++repeat) {
        showProgress(std::to_string(point.triangles) + " triangles, " +
                     std::to_string(point.size) + " squared, repeat " + std::to_string(repeat));
        const double now[5] = {
            milliseconds([&] { renderAll(*frame); }),
            traceMs(contest.ours, primary, Query::Closest),
            contest.embree.empty() ? 0 : traceMs(contest.embree, primary, Query::Closest),
            traceMs(contest.ours, shadow, Query::Any),
            contest.embree.empty() ? 0 : traceMs(contest.embree, shadow, Query::Any)};
        for (std::size_t i = 0; i < 5 && repeat > 0; ++i) times[i].push_back(now[i]);
    }
    point.frameMs = medianOf(times[0]);
    point.primaryMs = medianOf(times[1]);
    point.embreePrimaryMs = medianOf(times[2]);
    point.shadowMs = medianOf(times[3]);
    point.embreeShadowMs = medianOf(times[4]);
}

/// Least squares of y over x.
struct Line {
    double slope, atZero;
};
Line fit(const std::vector<double>& x, const std::vector<double>& y) {
    const double n = double(x.size());
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        sx += x[i];
        sy += y[i];
        sxx += x[i] * x[i];
        sxy += x[i] * y[i];
    }
    const double slope = (n * sxy - sx * sy) / (n * sxx - sx * sx);
    return {slope, (sy - slope * sx) / n};
}

/// Growth by triangles: time = a + b log2(n), b in milliseconds a doubling, and the power p of
/// time = c n^p, which is near 0 where growth is logarithmic.
nlohmann::json growth(const char* what, const std::vector<Point>& points, double Point::*time) {
    std::vector<double> logSize, logTime, times;
    for (const Point& point : points) {
        if (point.*time == 0) return nullptr;
        logSize.push_back(std::log2(double(point.triangles)));
        logTime.push_back(std::log2(point.*time));
        times.push_back(point.*time);
    }
    if (points.size() < 2) return nullptr;
    const Line line = fit(logSize, times), power = fit(logSize, logTime);
    std::cout << "  " << std::left << std::setw(16) << what << std::right << std::setw(8)
              << line.slope << " ms a doubling, power " << power.slope << '\n';
    return {{"millisecondsADoubling", line.slope}, {"power", power.slope}};
}

nlohmann::json jsonOf(const std::vector<Point>& points) {
    nlohmann::json result = nlohmann::json::array();
    for (const Point& p : points)
        result.push_back({{"triangles", p.triangles},
                          {"size", p.size},
                          {"buildMs", p.buildMs},
                          {"frameMs", p.frameMs},
                          {"primaryMs", p.primaryMs},
                          {"embreePrimaryMs", p.embreePrimaryMs},
                          {"shadowMs", p.shadowMs},
                          {"embreeShadowMs", p.embreeShadowMs}});
    return result;
}

void print(const Point& p) {
    const double pixels = double(p.size) * p.size;
    std::cout << std::fixed << std::setprecision(2) << std::setw(10) << p.triangles << " triangles "
              << std::setw(5) << p.size << " squared: frame " << p.frameMs << " ms ("
              << p.frameMs * 1e6 / pixels << " ns a pixel), primary " << p.primaryMs << " ms";
    if (p.embreePrimaryMs > 0) std::cout << " (Embree " << p.embreePrimaryMs << ')';
    std::cout << ", shadow " << p.shadowMs << " ms";
    if (p.embreeShadowMs > 0) std::cout << " (Embree " << p.embreeShadowMs << ')';
    std::cout << ", build " << p.buildMs << " ms\n" << std::flush;
}

int run(const Options& options) {
    if (options.fewest > options.most) throw UsageError("--fewest is more than --most");
    selectIsa(options.isa);
    const View view;
    std::vector<Point> byTriangles, byPixels;
    for (int step = 0;; ++step) { // 1, 3.2, 10, 32, ...
        const double wanted = options.fewest * std::pow(10.0, step / 2.0);
        if (wanted > options.most * 1.001) break;
        const std::vector<Triangle> triangles = test::bumpySphere(uint32_t(std::lround(wanted)));
        Point point{triangles.size(), options.size};
        const Contest contest = contestOf(triangles, options, point);
        measure(contest, view, options, triangles, point);
        showProgress("");
        print(byTriangles.emplace_back(point));
    }
    const std::vector<Triangle> triangles = test::bumpySphere(100'000);
    Point made;
    const Contest contest = contestOf(triangles, options, made);
    for (uint32_t size = 128; size <= options.largest; size *= 2) {
        Point point{triangles.size(), size, made.buildMs};
        measure(contest, view, options, triangles, point);
        showProgress("");
        print(byPixels.emplace_back(point));
    }
    std::cout << "growth with the number of triangles\n";
    const nlohmann::json grows = {
        {"frame", growth("frame", byTriangles, &Point::frameMs)},
        {"primary", growth("primary", byTriangles, &Point::primaryMs)},
        {"embreePrimary", growth("Embree primary", byTriangles, &Point::embreePrimaryMs)},
        {"shadow", growth("shadow", byTriangles, &Point::shadowMs)},
        {"embreeShadow", growth("Embree shadow", byTriangles, &Point::embreeShadowMs)}};
    writeJson(options.json, {{"isa", kernels().name},
                             {"machine", machine()},
                             {"byTriangles", jsonOf(byTriangles)},
                             {"byPixels", jsonOf(byPixels)},
                             {"growth", grows}});
    return 0;
}

} // namespace

Run addScale(CLI::App& app) {
    const auto options = std::make_shared<Options>();
    app.add_option("--fewest", options->fewest, "triangles of the smallest scene")
        ->check(CLI::Range(100, 100'000'000))
        ->capture_default_str();
    app.add_option("--most", options->most, "triangles of the largest")
        ->check(CLI::Range(100, 100'000'000))
        ->capture_default_str();
    addSize(app, options->size);
    app.add_option("--largest", options->largest, "width and height of the largest picture")
        ->check(CLI::Range(128, 16384))
        ->capture_default_str();
    addRepeat(app, options->repeat);
    addIsa(app, options->isa);
    addPeers(app, options->peers);
    addJson(app, options->json);
    return [options] { return run(*options); };
}

} // namespace smart::bench
