// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iostream>
#include <limits>
#include <memory>

#include "tests/bench/command.h"
#include "tests/bench/openrt_engine.h"
#include "tests/bench/options.h"
#include "tests/bench/report.h"
#ifdef OPENRT_BENCH_EMBREE
#include "tests/bench/embree_engine.h"
#endif

namespace smart::bench {
namespace {

constexpr uint32_t kAoRays = 4;      // a hit
constexpr double kAoReach = 0.1;     // of the diagonal

struct Options {
    std::string scene, isa, precision = "watertight", json;
    ViewOptions view;
    std::vector<std::string> peers, kinds;
    uint32_t size = 1024;
    unsigned threads = 1, repeat = 5;
    uint64_t seed = 1;
    bool plantError = false, kdTree = false;

    bool wants(Kind kind) const {
        return kinds.empty() || std::find(kinds.begin(), kinds.end(), nameOf(kind)) != kinds.end();
    }
};

/// The same rays for the same seed, for every kind from the same camera rays.
class RayMaker {
public:
    RayMaker(View view, uint32_t size, ScenePtr scene, const std::vector<Triangle>& triangles)
        : view_(view), size_(size), scene_(std::move(scene)), triangles_(triangles),
          reach_(float(kAoReach * diagonalOf(triangles))) {}

    RaySet make(Kind kind, uint64_t seed) const {
        RaySet primary = primaryRays(view_, size_, seed);
        if (kind == Kind::Primary) return primary;
        const std::vector<SurfacePacket> points =
            surfacePoints(primary, scene_->view(), triangles_);
        if (kind == Kind::Shadow) return shadowRays(view_, points);
        if (kind == Kind::Ao) return diffuseRays(points, kAoRays, reach_, seed);
        return diffuseRays(points, 1, std::numeric_limits<float>::infinity(), seed);
    }

private:
    const View view_;
    const uint32_t size_;
    const ScenePtr scene_;
    const std::vector<Triangle>& triangles_;
    const float reach_;
};

/// Of every kCountEvery-th packet.
RayCounts countOf(Kind kind, const RaySet& rays, const Scene& scene) {
    constexpr std::size_t kCountEvery = 16;
    RayCounts counts;
    counts.kind = kind;
    const auto trace = kernels().intersectCounted[int(scene.precision())];
    HitPacket hits;
    for (std::size_t p = 0; p < rays.packets.size(); p += kCountEvery) {
        RayPacket packet = rays.packets[p];
        const uint32_t active = packet.active;
        if (active == 0) continue;
        trace(scene.view(), packet, hits, counts.together);
        ++counts.packets;
        for (int lane = 0; lane < kPacketSize; ++lane) {
            packet.active = active & 1u << lane;
            if (packet.active == 0) continue;
            trace(scene.view(), packet, hits, counts.alone);
            ++counts.rays;
        }
    }
    return counts;
}

int run(const Options& options) {
    selectIsa(options.isa);
    Report report;
    report.scene = options.scene;
    report.isa = kernels().name;
    report.precision = options.precision;
    report.size = options.size;
    const std::vector<Triangle> triangles = readTriangles(options.scene);
    report.triangles = triangles.size();
    const Precision precision = precisionOf(options.precision);
    showProgress("what the machine can do");
    report.limits = measureLimits();
    showProgress("building");
    BuildReport built;
    const ScenePtr scene =
        buildOpenrt(triangles, precision, options.threads, built,
                    options.kdTree ? BuildQuality::KdTree : BuildQuality::Nicest);
    report.builds.push_back({"openrt", options.threads, built});
    std::vector<EnginePtr> peers;
#ifdef OPENRT_BENCH_EMBREE
    if (wantsEmbree(options.peers)) peers = embreeEngines(triangles, options.threads, options.isa);
#endif
    const RayMaker maker(options.view.view(options.scene), options.size, scene, triangles);
    const Truth truth(triangles);
    const EnginePtr referee = preciseEngine(scene);
    for (const Kind kind : kKinds) {
        if (!options.wants(kind)) continue;
        std::vector<EnginePtr> engines = openrtEngines(
            scene, precision, coherent(kind) ? Coherence::Coherent : Coherence::Incoherent,
            options.plantError);
        const std::size_t ours = engines.size();
        for (EnginePtr& peer : peers) engines.push_back(std::move(peer));
        const Plan plan{kind,
                        [&](uint64_t repeat) {
                            return maker.make(kind, repeat * options.seed);
                        },
                        threadCounts(options.threads), options.repeat, referee.get()};
        report.counts.push_back(countOf(kind, maker.make(kind, 0), *scene));
        for (Series& series : measure(truth, plan, engines, showProgress))
            report.series.push_back(std::move(series));
        for (std::size_t i = 0; i < peers.size(); ++i) peers[i] = std::move(engines[ours + i]);
    }
    showProgress("");
    std::cout << report;
    writeJson(options.json, report.json());
    return report.anyRefused() ? kExitRefused : 0;
}

} // namespace

Run addRays(CLI::App& app) {
    const auto options = std::make_shared<Options>();
    addScene(app, options->scene);
    options->view.add(app);
    addSize(app, options->size);
    addThreads(app, options->threads, "threads measured beside one thread");
    addRepeat(app, options->repeat);
    addIsa(app, options->isa);
    addPrecision(app, options->precision);
    addPeers(app, options->peers);
    addJson(app, options->json);
    app.add_option("--kinds", options->kinds, "of rays: primary, shadow, ao, bounce; all if none")
        ->delimiter(',')
        ->check(CLI::IsMember({"primary", "shadow", "ao", "bounce"}));
    app.add_option("--seed", options->seed, "of the places in pixels and of diffuse rays")
        ->capture_default_str();
    app.add_flag("--kd-tree", options->kdTree, "ours in the kd-tree, not in the best tree of boxes");
    app.add_flag("--plant-error", options->plantError,
                 "name wrong triangles now and then, to prove the comparison");
    return [options] { return run(*options); };
}

} // namespace smart::bench
