// SPDX-License-Identifier: MIT
#include "tests/bench/truth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/bench/agreement.h"
#include "tests/support/exact_reference.h"
#include "tests/support/procedural_meshes.h"
#include "tests/support/ray_sets.h"

namespace smart::bench {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

const Triangle kWall{{-1, -1, 5}, {1, -1, 5}, {0, 1, 5}};
const Triangle kBehind{{-100, -100, 9}, {100, -100, 9}, {0, 100, 9}};

Ray at(float x, float y) {
    return {{0, 0, 0}, {x, y, 5}, 0, kInfinity};
}

TEST(Truth, NamesNearestOfTwo) {
    const std::vector<Triangle> triangles{kBehind, kWall};
    const Truth truth(triangles);
    EXPECT_EQ(truth.closest(at(0, 0), 1, 1.0f), Verdict::Right);
    EXPECT_EQ(truth.closest(at(0, 0), 0, 1.8f), Verdict::Wrong);
    EXPECT_EQ(truth.closest(at(0, 0), kNoHit, 0), Verdict::Wrong);
    EXPECT_EQ(truth.closest(at(0, 0), 1, 1.01f), Verdict::Wrong); // its distance
    EXPECT_EQ(truth.closest(at(0, 0), 7, 1.0f), Verdict::Wrong);  // there is no such triangle
    EXPECT_EQ(truth.closest(at(3, 0), 0, 1.8f), Verdict::Right);
    EXPECT_EQ(truth.closest(at(3, 0), 1, 1.0f), Verdict::Wrong);
}

TEST(Truth, KeepsToTheRange) {
    const std::vector<Triangle> triangles{kWall};
    const Truth truth(triangles);
    Ray ray = at(0, 0);
    ray.tFar = 0.9f;
    EXPECT_EQ(truth.any(ray, true), Verdict::Wrong);
    EXPECT_EQ(truth.any(ray, false), Verdict::Right);
    ray.tFar = 1; // both: the last bit decides
    EXPECT_EQ(truth.any(ray, true), Verdict::Right);
    EXPECT_EQ(truth.any(ray, false), Verdict::Tie);
    ray.tNear = 1.1f;
    ray.tFar = 2;
    EXPECT_EQ(truth.closest(ray, kNoHit, 0), Verdict::Right);
}

TEST(Truth, BesideASilhouetteBothAreRight) {
    const std::vector<Triangle> triangles{kWall, kBehind};
    const Truth truth(triangles);
    const float edge = 1 - 0x1p-22f; // (1, -1) lies on the corner; this height on the lower edge
    const Ray inside{{0, 0, 0}, {0.25f, -edge, 5}, 0, kInfinity};
    EXPECT_EQ(truth.closest(inside, 0, 1.0f), Verdict::Right);
    EXPECT_EQ(truth.closest(inside, 1, 1.8f), Verdict::Tie);
    const Ray well{{0, 0, 0}, {0.25f, -1 + 0x1p-18f, 5}, 0, kInfinity};
    EXPECT_EQ(truth.closest(well, 1, 1.8f), Verdict::Wrong);
}

TEST(Truth, NothingPassesBetweenNeighbours) {
    // Two halves of a square before a wall; rays at their common edge.
    const std::vector<Triangle> triangles{
        {{-1, -1, 5}, {1, -1, 5}, {1, 1, 5}}, {{-1, -1, 5}, {1, 1, 5}, {-1, 1, 5}}, kBehind};
    const Truth truth(triangles);
    for (const float x : {0.1f, 0.3f, 0.7f}) {
        EXPECT_NE(truth.closest(at(x, x), 0, 1.0f), Verdict::Wrong);
        EXPECT_NE(truth.closest(at(x, x), 1, 1.0f), Verdict::Wrong);
        EXPECT_EQ(truth.closest(at(x, x), 2, 1.8f), Verdict::Wrong);
        EXPECT_EQ(truth.any(at(x, x), false), Verdict::Wrong);
    }
}

TEST(Truth, FindsWhatExactArithmeticFinds) {
    const std::vector<Triangle> triangles = test::bumpySphere(3000);
    const Truth truth(triangles);
    test::ExactReference reference;
    reference.add(triangles);
    const std::vector<Ray> rays = test::randomRays(triangles, 300, 7);
    for (const Ray& ray : rays) {
        const test::ExactAnswer answer = reference.nearest(ray);
        if (!answer.must) {
            if (answer.touches.empty()) {
                EXPECT_EQ(truth.closest(ray, kNoHit, 0), Verdict::Right);
            }
            continue;
        }
        const test::ExactCrossing& nearest = answer.nearest.front();
        const auto t = float(nearest.t.get_d());
        EXPECT_EQ(truth.closest(ray, nearest.triangle, t), Verdict::Right);
        EXPECT_EQ(truth.any(ray, true), Verdict::Right);
        EXPECT_NE(truth.closest(ray, kNoHit, 0), Verdict::Right);
        EXPECT_EQ(truth.closest(ray, (nearest.triangle + 1000) % 2000, t), Verdict::Wrong);
    }
}

TEST(Truth, SceneWithoutTriangles) {
    const std::vector<Triangle> none;
    const Truth truth(none);
    EXPECT_EQ(truth.closest(at(0, 0), kNoHit, 0), Verdict::Right);
    EXPECT_EQ(truth.any(at(0, 0), true), Verdict::Wrong);
}

TEST(Agreement, OneWrongAnswerOfTwoEnginesIsCounted) {
    const std::vector<Triangle> triangles{kBehind, kWall};
    const Truth truth(triangles);
    RaySet rays;
    const Ray some[] = {at(0, 0), at(3, 0), at(0.1f, 0.1f)};
    rays.add(some);
    Found right{{1, 1.8f, 1}, {1, 0, 1}};
    Found wrong = right;
    wrong.triangle[1] = kNoHit;
    const std::vector<Found> found[] = {{right}, {wrong}};
    const std::vector<Mistakes> mistakes = judgeClosest(truth, rays, found);
    EXPECT_EQ(mistakes[0].wrong, 0u);
    EXPECT_EQ(mistakes[1].wrong, 1u);
    const std::vector<uint32_t> blocked[] = {{7u}, {3u}};
    const std::vector<Mistakes> others = judgeAny(truth, rays, blocked);
    EXPECT_EQ(others[0].wrong, 0u);
    EXPECT_EQ(others[1].wrong, 1u);
}

} // namespace
} // namespace smart::bench
