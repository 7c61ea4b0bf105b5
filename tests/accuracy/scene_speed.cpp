// SPDX-License-Identifier: MIT
#include "tests/accuracy/scene_speed.h"

#include <time.h>

#include <algorithm>
#include <span>
#include <thread>

#include "libsmart/kernel/kernels.h"
#include "tests/accuracy/engine.h"
#include "tests/bench/openrt_engine.h"
#include "tests/support/traced_scene.h"
#ifdef OPENRT_BENCH_EMBREE
#include "tests/bench/embree_engine.h"
#endif

namespace smart::test {
namespace {

/// An engine of the benchmark with the mode in its name.
class Named final : public bench::Engine {
public:
    Named(bench::EnginePtr engine, std::string name)
        : engine_(std::move(engine)), name_(std::move(name)) {}
    std::string name() const override { return name_; }
    bool peer() const override { return engine_->peer(); }
    void enterThread() const override { engine_->enterThread(); }
    void closest(const bench::RaySet& rays, std::size_t first, std::size_t count,
                 bench::Found* found) const override {
        engine_->closest(rays, first, count, found);
    }
    void any(const bench::RaySet& rays, std::size_t first, std::size_t count,
             uint32_t* blocked) const override {
        engine_->any(rays, first, count, blocked);
    }

private:
    const bench::EnginePtr engine_;
    const std::string name_;
};

void countTests(const Scene& scene, const bench::RaySet& rays, SceneSpeed& speed) {
    TraversalCounts counts;
    HitPacket hits;
    for (const RayPacket& packet : rays.packets) {
        kernels().intersectCounted[int(Precision::Precise)](scene.view(), packet, hits, counts);
    }
    speed.triangleTests = counts.triangles;
    speed.doubleTests = counts.doubles;
    speed.exactTests = counts.exacts;
}

double threadSeconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

/// All engines in turn, `repeats` times over.
std::vector<EngineSpeed> measure(const bench::Truth& truth, const bench::RaySet& rays,
                                 bench::Kind kind, std::span<const bench::EnginePtr> engines,
                                 unsigned repeats) {
    const std::size_t packets = rays.packets.size();
    std::vector<EngineSpeed> speeds;
    std::vector<std::vector<bench::Found>> found(engines.size());
    std::vector<std::vector<uint32_t>> blocked(engines.size());
    for (std::size_t e = 0; e < engines.size(); ++e) {
        speeds.push_back({engines[e]->name(), kind, {}, {}});
        found[e].resize(kind == bench::Kind::Primary ? packets : 0);
        blocked[e].resize(kind == bench::Kind::Shadow ? packets : 0);
    }
    for (unsigned repeat = 0; repeat <= repeats; ++repeat) { // the first only warms caches
        for (std::size_t e = 0; e < engines.size(); ++e) {
            std::thread([&] { // an engine may change its thread's floating-point environment
                engines[e]->enterThread();
                const double start = threadSeconds();
                if (kind == bench::Kind::Primary)
                    engines[e]->closest(rays, 0, packets, found[e].data());
                else
                    engines[e]->any(rays, 0, packets, blocked[e].data());
                const double seconds = threadSeconds() - start;
                if (repeat > 0)
                    speeds[e].nanosecondsPerRay.push_back(1e9 * seconds / double(rays.active));
            })
                .join();
        }
    }
    const std::vector<bench::Mistakes> mistakes =
        kind == bench::Kind::Primary ? bench::judgeClosest(truth, rays, found)
                                     : bench::judgeAny(truth, rays, blocked);
    for (std::size_t e = 0; e < engines.size(); ++e) speeds[e].mistakes = mistakes[e];
    return speeds;
}

} // namespace

double EngineSpeed::best() const {
    return *std::min_element(nanosecondsPerRay.begin(), nanosecondsPerRay.end());
}

SceneSpeed measureScene(const SpeedOptions& options) {
    SceneSpeed speed;
    speed.scene = options.scene;
    const std::vector<Triangle> triangles = bench::readTriangles(options.scene);
    speed.triangles = triangles.size();
    const ModelPtr model = makeModel(triangles);
    std::vector<bench::EnginePtr> engines;
    ScenePtr watertight, precise;
    for (int mode = 0; mode < kPrecisionCount; ++mode) {
        const auto scene = std::make_shared<const Scene>(std::vector<Instance>{place(model)},
                                                         Precision(mode), options.buildThreads);
        if (mode == int(Precision::Watertight)) watertight = scene;
        if (mode == int(Precision::Precise)) precise = scene;
        for (bench::EnginePtr& engine :
             bench::openrtEngines(scene, Precision(mode), Coherence::Coherent, false))
            for (const char* form : {" packet", " tile", " single"})
                if (engine && engine->name().starts_with(std::string("openrt") + form))
                    engines.push_back(std::make_unique<Named>(
                        std::move(engine), std::string("openrt-") + modeName(mode) + form));
    }
#ifdef OPENRT_BENCH_EMBREE
    if (options.embree) {
        for (bench::EnginePtr& engine :
             bench::embreeEngines(triangles, options.buildThreads, "")) {
            const std::string name = engine->name(), mode = engine->robust() ? "-robust" : "";
            if (name.starts_with("embree 16 coherent arrays medium"))
                engines.push_back(
                    std::make_unique<Named>(std::move(engine), "embree" + mode + " packet"));
            else if (name.starts_with("embree 1 incoherent arrays medium"))
                engines.push_back(
                    std::make_unique<Named>(std::move(engine), "embree" + mode + " single"));
        }
    }
#endif
    const bench::RaySet primary = bench::primaryRays(options.view, options.size);
    const bench::RaySet shadow = bench::shadowRays(
        options.view, bench::surfacePoints(primary, watertight->view(), triangles));
    const bench::Truth truth(triangles);
    speed.primaryRays = primary.active;
    speed.shadowRays = shadow.active;
    for (const bench::Kind kind : {bench::Kind::Primary, bench::Kind::Shadow}) {
        const bench::RaySet& rays = kind == bench::Kind::Primary ? primary : shadow;
        for (EngineSpeed& one : measure(truth, rays, kind, engines, options.repeat))
            speed.engines.push_back(std::move(one));
    }
    countTests(*precise, primary, speed);
    return speed;
}

} // namespace smart::test
