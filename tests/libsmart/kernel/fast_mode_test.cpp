// SPDX-License-Identifier: MIT
// The fast mode may lose rays at edges, and nowhere else.
#include <gtest/gtest.h>

#include "tests/libsmart/kernel/engine_check.h"
#include "tests/libsmart/kernel/test_size.h"
#include "tests/support/procedural_meshes.h"
#include "tests/support/ray_sets.h"

namespace smart::test {
namespace {

VerdictCounts judgeFast(const std::vector<Triangle>& mesh, std::span<const Ray> rays) {
    const TracedScene scene(mesh, Precision::Fast);
    return scene.judgeAll(rays, scene.truth(rays),
                          traceAllWays(scene, rays, Precision::Fast));
}

TEST(FastMode, InteriorsAreRight) {
    const auto mesh = icosphere(3);
    for (const bool inside : {false, true}) {
        const auto rays =
            inside
                ? raysFromInside(mesh, 1, rayCount(8000), Target::Interior, Aim::Normalised, 50)
                : raysFromOutside(mesh, 1, rayCount(8000), Target::Interior, Aim::Normalised, 51);
        const VerdictCounts counts = judgeFast(mesh, rays);
        EXPECT_EQ(counts[Verdict::Right], rays.size()) << counts;
        EXPECT_LE(counts.worstT, 64) << counts;
    }
}

TEST(FastMode, RandomRaysErrRarely) {
    for (const auto& mesh : {bumpySphere(2000), triangleSoup(1000, 0.2f, 52), heightfield(2000)}) {
        const auto rays = randomRays(mesh, rayCount(8000), 53);
        const VerdictCounts counts = judgeFast(mesh, rays);
        EXPECT_LE(counts.wrong(), rays.size() / 2000 + 1) << counts;
        EXPECT_GT(counts.hits, rays.size() / 50) << counts;
    }
}

TEST(FastMode, LeaksAtEdgesAreCountedHereOnly) {
    const auto mesh = snapped(icosphere(3), 16);
    const auto rays = raysFromOutside(mesh, 1, rayCount(8000), Target::Edge, Aim::Exact, 54);
    const VerdictCounts counts = judgeFast(mesh, rays);
    std::cout << "    fast mode, exact edges: " << counts << '\n';
    EXPECT_LT(counts.lost(), rays.size() / 4) << counts;
}

} // namespace
} // namespace smart::test
