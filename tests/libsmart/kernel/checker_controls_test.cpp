// SPDX-License-Identifier: MIT
// The checkers of this folder must find planted mistakes: a check that can not fail shows nothing.
#include <gtest/gtest.h>

#include <map>

#include "tests/libsmart/kernel/engine_check.h"
#include "tests/support/one_sided_tree.h"
#include "tests/support/procedural_meshes.h"
#include "tests/support/ray_sets.h"
#include "tests/support/woop_brute_force.h"

namespace smart::test {
namespace {

std::vector<Triangle> grid() {
    return snapped(icosphere(3), 16);
}

TEST(CheckerControls, APlantedWrongPrimitiveIsFound) {
    const auto mesh = grid();
    const TracedScene scene(mesh);
    const auto rays = raysFromOutside(mesh, 1, 400, Target::Interior, Aim::Rounded, 60);
    const auto truth = scene.truth(rays);
    const auto hits =
        tracePackets(kernels(), Precision::Watertight, scene.view(), rays, Filling::Full);
    ASSERT_EQ(scene.judgeAll(rays, truth, hits)[Verdict::Right], rays.size());
    const auto planted = [&](auto change) {
        auto wrong = hits;
        change(wrong[123]);
        EXPECT_EQ(differences(wrong, hits), 1u);
        return scene.judgeAll(rays, truth, wrong);
    };
    const auto size = uint32_t(mesh.size());
    EXPECT_EQ(planted([&](Hit& h) { h.triangle = (h.triangle + size / 2) % size; }).wrong(), 1u);
    EXPECT_EQ(planted([&](Hit& h) { h.triangle = kNoHit; }).lost(), 1u);
    EXPECT_EQ(planted([&](Hit& h) { h.path[0] = 1; }).wrong(), 1u);
    EXPECT_EQ(planted([&](Hit& h) { h.t *= 1.5f; }).wrong(), 1u);
    EXPECT_GT(planted([&](Hit& h) { h.t *= 1 + 0x1p-18f; }).worstT, 16);
    planted([&](Hit& h) { h.u = std::nextafter(h.u, 2.0f); });

    // A neighbour within delta is benign for the verdict, but counted.
    const auto edges = raysFromOutside(mesh, 1, 50, Target::Edge, Aim::Exact, 61);
    for (const Ray& ray : edges) {
        const ExactAnswer answer = scene.reference().nearest(ray);
        ASSERT_EQ(answer.nearest.size(), 2u);
        for (const ExactCrossing& tie : answer.nearest) {
            const Claim claim = {tie.triangle, float(tie.t.get_d()), 0, 0};
            EXPECT_EQ(judge(scene.reference(), answer, ray, claim), Verdict::Right);
        }
    }
}

TEST(CheckerControls, AOneSidedSplitIsFound) {
    const auto mesh = grid();
    const TracedScene scene(mesh);
    const OneSidedTree broken(scene.scene());
    ASSERT_GT(broken.dropped, 0u);
    const auto rays = raysFromOutside(mesh, 1, 2000, Target::Edge, Aim::Exact, 62);
    const auto truth = scene.truth(rays);
    for (const KernelTable* table : availableKernels()) {
        const auto whole =
            tracePackets(*table, Precision::Watertight, scene.view(), rays, Filling::Full);
        EXPECT_EQ(scene.judgeAll(rays, truth, whole).lost(), 0u);
        const auto hits =
            tracePackets(*table, Precision::Watertight, broken.scene, rays, Filling::Full);
        EXPECT_GT(scene.judgeAll(rays, truth, hits).lost(), 0u) << table->name;
    }
}

TEST(CheckerControls, AContractedEdgeFunctionIsFound) {
    const auto mesh = grid();
    ExactReference reference;
    reference.add(mesh);
    VerdictCounts plain, contracted;
    for (const Ray& ray : raysFromOutside(mesh, 1, 2000, Target::Edge, Aim::Exact, 63)) {
        const ExactAnswer truth = reference.nearest(ray);
        plain.add(reference, truth, ray, woopNearest<false>(mesh, ray));
        contracted.add(reference, truth, ray, woopNearest<true>(mesh, ray));
    }
    EXPECT_EQ(plain.lost(), 0u) << plain;
    EXPECT_GT(contracted.lost(), 0u) << contracted;
}

} // namespace
} // namespace smart::test
