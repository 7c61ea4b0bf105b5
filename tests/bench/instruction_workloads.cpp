// SPDX-License-Identifier: MIT
// Small fixed work, one function each, whose instructions callgrind counts: nothing here depends
// on the machine, the time or a file. Run by instruction_counts.py.
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <memory>

#include "libsmart/kernel/kernels.h"
#include "libsmart/render/tile_order.h"
#include "libsmart/render/tracers.h"
#include "tests/bench/openrt_engine.h"
#include "tests/bench/phong_frame.h"
#include "tests/bench/workload.h"
#include "tests/support/procedural_meshes.h"

namespace {

using namespace smart;

constexpr uint32_t kTriangles = 8000, kSize = 96;

/// A bumpy sphere over hills: tiles with near and far surfaces, silhouettes, shadows.
std::vector<Triangle> sceneTriangles() {
    std::vector<Triangle> triangles = test::bumpySphere(kTriangles);
    for (Triangle triangle : test::heightfield(kTriangles)) {
        for (float* v : {triangle.v0, triangle.v1, triangle.v2}) {
            v[0] *= 3;
            v[1] -= 1.2f;
            v[2] *= 3;
        }
        triangles.push_back(triangle);
    }
    return triangles;
}

/// All rays through the public query; `again` of them in sixteen a second time.
void trace(const ScenePtr& scene, const bench::RaySet& rays, bench::Query query,
           Coherence coherence, std::size_t again) {
    const bench::EnginePtr stream =
        std::move(bench::openrtEngines(scene, scene->precision(), coherence, false).back());
    const std::size_t packets = rays.packets.size();
    std::vector<bench::Found> found(packets);
    std::vector<uint32_t> blocked(packets);
    for (const std::size_t count : {packets, packets * again / 16}) {
        if (query == bench::Query::Closest)
            stream->closest(rays, 0, count, found.data());
        else
            stream->any(rays, 0, count, blocked.data());
    }
}

void render(const Frame& frame, const Tracer& tracer, std::size_t again) {
    const auto pixels = std::make_unique<TilePixels>();
    const std::vector<Tile> tiles = mortonTiles(frame.target.width, frame.target.height);
    for (const std::size_t count : {tiles.size(), (tiles.size() * again + 15) / 16}) {
        for (std::size_t i = 0; i < count; ++i) {
            tracer.render(frame, tiles[i], *pixels);
            writeTile(frame.target, tiles[i], *pixels);
        }
    }
}

} // namespace

// What is counted: each from its call to its return.
extern "C" {
void countedBuild(const std::vector<Triangle>* triangles, ScenePtr* scene);
void countedKdBuild(const std::vector<Triangle>* triangles);
void countedPrimary(const ScenePtr* scene, const bench::RaySet* rays, std::size_t again);
void countedShadow(const ScenePtr* scene, const bench::RaySet* rays, std::size_t again);
void countedAo(const ScenePtr* scene, const bench::RaySet* rays, std::size_t again);
void countedBounce(const ScenePtr* scene, const bench::RaySet* rays, std::size_t again);
void countedPrecise(const ScenePtr* scene, const bench::RaySet* rays, std::size_t again);
void countedFrame(const Frame* frame, const Tracer* tracer, std::size_t again);

[[gnu::noinline]] void countedBuild(const std::vector<Triangle>* triangles, ScenePtr* scene) {
    bench::BuildReport report;
    *scene = bench::buildOpenrt(*triangles, Precision::Watertight, 1, report);
}
[[gnu::noinline]] void countedKdBuild(const std::vector<Triangle>* triangles) {
    bench::BuildReport report;
    bench::buildOpenrt(*triangles, Precision::Watertight, 1, report, BuildQuality::KdTree);
}
[[gnu::noinline]] void countedPrimary(const ScenePtr* scene, const bench::RaySet* rays,
                                      std::size_t again) {
    trace(*scene, *rays, bench::Query::Closest, Coherence::Coherent, again);
}
[[gnu::noinline]] void countedShadow(const ScenePtr* scene, const bench::RaySet* rays,
                                     std::size_t again) {
    trace(*scene, *rays, bench::Query::Any, Coherence::Coherent, again);
}
[[gnu::noinline]] void countedAo(const ScenePtr* scene, const bench::RaySet* rays,
                                 std::size_t again) {
    trace(*scene, *rays, bench::Query::Any, Coherence::Incoherent, again);
}
[[gnu::noinline]] void countedBounce(const ScenePtr* scene, const bench::RaySet* rays,
                                     std::size_t again) {
    trace(*scene, *rays, bench::Query::Closest, Coherence::Incoherent, again);
}
[[gnu::noinline]] void countedPrecise(const ScenePtr* scene, const bench::RaySet* rays,
                                      std::size_t again) {
    trace(*scene, *rays, bench::Query::Closest, Coherence::Coherent, again);
}
[[gnu::noinline]] void countedFrame(const Frame* frame, const Tracer* tracer, std::size_t again) {
    render(*frame, *tracer, again);
}
}

/// First argument: the instruction set. Second: how many sixteenths of the work are done again.
int main(int argc, char** argv) {
    if (argc != 3 || !selectKernels(argv[1])) {
        std::fprintf(stderr, "usage: instruction_workloads ISA SIXTEENTHS\n");
        return 2;
    }
    const std::size_t again = std::strtoul(argv[2], nullptr, 10);
    const std::vector<Triangle> triangles = sceneTriangles();
    const bench::View view;
    ScenePtr scene;
    for (int build = 0; build < (again > 0 ? 2 : 1); ++build) {
        countedBuild(&triangles, &scene);
        countedKdBuild(&triangles);
    }
    const bench::RaySet primary = bench::primaryRays(view, kSize);
    const std::vector<bench::SurfacePacket> points =
        bench::surfacePoints(primary, scene->view(), triangles);
    const bench::RaySet shadow = bench::shadowRays(view, points);
    const bench::RaySet ao = bench::diffuseRays(points, 2, 0.7f, 1);
    const bench::RaySet bounce =
        bench::diffuseRays(points, 1, std::numeric_limits<float>::infinity(), 2);
    countedPrimary(&scene, &primary, again);
    countedShadow(&scene, &shadow, again);
    countedAo(&scene, &ao, again);
    countedBounce(&scene, &bounce, again);
    bench::BuildReport report;
    const ScenePtr precise = bench::buildOpenrt(triangles, Precision::Precise, 1, report);
    countedPrecise(&precise, &primary, again);
    std::vector<float> pixels;
    const std::unique_ptr<Frame> frame = bench::phongFrame(scene, view, kSize, pixels);
    const Tracer& tracer = tracerFor(frame->shading(), ShadingForm::Packets);
    countedFrame(frame.get(), &tracer, again);
    return 0;
}
