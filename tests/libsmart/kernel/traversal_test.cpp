// SPDX-License-Identifier: MIT
// One model: closest hit and any hit of every kernel against exact arithmetic.
#include <gtest/gtest.h>

#include "tests/libsmart/kernel/engine_check.h"
#include "tests/libsmart/kernel/test_size.h"
#include "tests/support/procedural_meshes.h"
#include "tests/support/ray_sets.h"

namespace smart::test {
namespace {

TEST(Kernels, GenericIsAlwaysThereAndUnknownNamesAreRefused) {
    ASSERT_NE(findKernels("generic"), nullptr);
    EXPECT_STREQ(findKernels("generic")->name, "generic");
    EXPECT_EQ(findKernels("avx1024"), nullptr);
    EXPECT_EQ(findKernels(""), nullptr);
    EXPECT_FALSE(selectKernels("avx1024"));
    const std::string chosen = kernels().name;
    EXPECT_NE(findKernels(chosen.c_str()), nullptr);
    EXPECT_TRUE(selectKernels("generic"));
    EXPECT_STREQ(kernels().name, "generic");
    EXPECT_TRUE(selectKernels(chosen.c_str()));
}

TEST(Traversal, RandomRaysHitAsExact) {
    const std::pair<const char*, std::vector<Triangle>> meshes[] = {
        {"soup of large triangles", triangleSoup(400, 0.5f, 1)},
        {"soup of small triangles", triangleSoup(3000, 0.03f, 2)},
        {"icosphere", icosphere(3)},
        {"bumpy sphere", bumpySphere(3000)},
        {"heightfield", heightfield(3000)},
        {"one triangle", triangleSoup(1, 1.0f, 3)}};
    for (const auto& [name, mesh] : meshes) {
        const TracedScene scene(mesh);
        const auto rays = randomRays(mesh, rayCount(5000), 4);
        const VerdictCounts counts = checkWatertight(scene, rays, name);
        EXPECT_GT(counts.hits, rays.size() / 50);
        EXPECT_LE(counts[Verdict::WrongPrim], 1u) << counts;
    }
}

TEST(Traversal, LargeMeshHitsAsExact) {
    const auto mesh = bumpySphere(60000);
    const TracedScene scene(mesh);
    checkWatertight(scene, randomRays(mesh, rayCount(500), 5), "bumpy sphere of 60,000");
}

TEST(Traversal, CoherentCameraRaysHitAsExact) {
    const auto mesh = bumpySphere(2000);
    const TracedScene scene(mesh);
    const CameraPose poses[] = {{{0.3, 0.4, 3}, {0, 0, 0}, {0, 1, 0}, 45},
                                {{0.1, -0.1, 0.2}, {1, 0.2, 0}, {0, 1, 0}, 100},
                                {{-3, 0, 0}, {0, 0, 0}, {0, 0, 1}, 45}};
    for (const CameraPose& pose : poses) {
        const auto rays = cameraRays(pose, 80, 40);
        checkWatertight(scene, rays, "camera");
    }
}

class AimedRays : public testing::TestWithParam<std::tuple<Target, Aim>> {};

TEST_P(AimedRays, LoseNothingOnAClosedMesh) {
    const auto [target, aim] = GetParam();
    const auto mesh = aim == Aim::Exact ? snapped(icosphere(3), 16) : icosphere(3);
    const TracedScene scene(mesh);
    for (const bool inside : {false, true}) {
        const auto rays = inside ? raysFromInside(mesh, 1, rayCount(3000), target, aim, 6)
                                 : raysFromOutside(mesh, 1, rayCount(3000), target, aim, 7);
        const VerdictCounts counts = checkWatertight(scene, rays, inside ? "inside" : "outside");
        EXPECT_EQ(counts.hits, rays.size());
        EXPECT_EQ(counts.lost(), 0u);
        if (target == Target::Interior) {
            EXPECT_EQ(counts[Verdict::WrongPrim], 0u) << counts;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    All, AimedRays,
    testing::Combine(testing::Values(Target::Vertex, Target::Edge, Target::Interior),
                     testing::Values(Aim::Exact, Aim::Rounded, Aim::Normalised)));

TEST(Traversal, LosesNothingAtAnyScaleAndOffset) {
    for (const double scale : {1e-12, 1e-6, 1e-3, 1e3, 1e6, 1e12}) {
        auto mesh = icosphere(3);
        for (Triangle& triangle : mesh) {
            for (float* v : {triangle.v0, triangle.v1, triangle.v2}) {
                for (int k = 0; k < 3; ++k) v[k] = float(v[k] * scale);
            }
        }
        const TracedScene scene(mesh);
        for (const Target target : {Target::Vertex, Target::Edge}) {
            const auto rays =
                raysFromOutside(mesh, scale, rayCount(1000), target, Aim::Normalised, 8);
            const VerdictCounts counts =
                checkWatertight(scene, rays, "scale " + std::to_string(scale));
            EXPECT_EQ(counts.hits, rays.size());
        }
    }
    for (const double offset : {1e3, 1e4, 1e5}) {
        const double by[3] = {0.577 * offset, -0.59 * offset, 0.565 * offset};
        const auto mesh = icosphere(3);
        auto moved = mesh;
        for (Triangle& triangle : moved) {
            for (float* v : {triangle.v0, triangle.v1, triangle.v2}) {
                for (int k = 0; k < 3; ++k) v[k] = float(v[k] + by[k]);
            }
        }
        const TracedScene scene(moved);
        auto rays = raysFromOutside(mesh, 1, rayCount(1000), Target::Edge, Aim::Rounded, 9);
        for (Ray& ray : rays) {
            for (int k = 0; k < 3; ++k) ray.org[k] = float(ray.org[k] + by[k]);
        }
        const VerdictCounts counts =
            scene.judgeAll(rays, scene.truth(rays), traceAllWays(scene, rays));
        EXPECT_EQ(counts.lost(), 0u)
            << counts; // at 1e5 the mesh itself is coarse: count leaks only
        std::cout << "    offset " << offset << ": " << counts << '\n';
    }
}

TEST(Traversal, AxisParallelRaysOnPlanesAndEdgesHitAsExact) {
    const auto mesh = closedRoom();
    const TracedScene scene(mesh);
    checkWatertight(scene, axisParallelRays(7.9, 0, rayCount(3000), 10), "anywhere");
    checkWatertight(scene, axisParallelRays(7.5, 0.5, rayCount(3000), 11), "half-integer origins");
    checkWatertight(scene, axisParallelRays(7, 1, rayCount(3000), 12), "integer origins");
    checkWatertight(scene, axisParallelRays(8, 8, rayCount(500), 13), "origins on walls");
}

TEST(Traversal, DegenerateTrianglesAreNeverHitAndHarmNoNeighbour) {
    const auto clean = snapped(icosphere(3), 16);
    std::vector<Triangle> mesh;
    for (std::size_t i = 0; i < clean.size(); ++i) {
        mesh.push_back(clean[i]);
        if (i % 2) continue;
        Triangle bad = clean[i];
        switch (i / 2 % 4) {
            case 0:
                std::copy(bad.v0, bad.v0 + 3, bad.v1);
                break;
            case 1:
                for (int k = 0; k < 3; ++k) bad.v2[k] = 0.5f * (bad.v0[k] + bad.v1[k]);
                break;
            case 2:
                bad.v1[i % 3] = NAN;
                break;
            default:
                bad.v2[i % 3] = -INFINITY;
                break;
        }
        mesh.push_back(bad);
    }
    const TracedScene scene(mesh);
    for (const Target target : {Target::Vertex, Target::Edge}) {
        const auto rays = raysFromOutside(clean, 1, rayCount(2000), target, Aim::Exact, 14);
        EXPECT_EQ(checkWatertight(scene, rays, "with degenerate ones").hits, rays.size());
    }
}

TEST(Traversal, EqualDistancesGoToTheLowestTriangle) {
    const auto mesh = icosphere(3);
    std::vector<Triangle> twice = mesh;
    twice.insert(twice.end(), mesh.begin(), mesh.end());
    const TracedScene scene(twice);
    const auto rays = raysFromOutside(mesh, 1, rayCount(2000), Target::Interior, Aim::Rounded, 15);
    for (const Hit& hit : traceAllWays(scene, rays)) ASSERT_LT(hit.triangle, mesh.size());
}

TEST(Traversal, EmptySceneIsMissed) {
    const auto rays = randomRays(icosphere(0), 50, 16);
    const TracedScene nothing{std::vector<Instance>{}};
    for (const Hit& hit : traceAllWays(nothing, rays)) ASSERT_EQ(hit.triangle, kNoHit);
    const TracedScene empty{std::vector<Triangle>{}};
    for (const Hit& hit : traceAllWays(empty, rays)) ASSERT_EQ(hit.triangle, kNoHit);
}

} // namespace
} // namespace smart::test
