// SPDX-License-Identifier: MIT
// Limits of rays, rays that can not be, and directions of any length.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/libsmart/kernel/engine_check.h"
#include "tests/libsmart/kernel/test_size.h"
#include "tests/support/procedural_meshes.h"
#include "tests/support/ray_sets.h"

namespace smart::test {
namespace {

constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kMax = std::numeric_limits<float>::max();

/// Box [-1,1]^3 in quads: a ray from x = -5 meets it at exactly t = 4 and t = 6.
const TracedScene& box() {
    static const TracedScene scene = [] {
        IndexedMesh mesh;
        addCube(mesh, 1, 1, false);
        return TracedScene(mesh.triangles());
    }();
    return scene;
}

Ray through(float tNear, float tFar) {
    return {{-5, 0.25f, 0.125f}, {1, 0, 0}, tNear, tFar};
}

/// Distance of the hit as every kernel sees it, or -1.
float distance(const Ray& ray) {
    // Among ordinary rays in a packet, and alone.
    const std::vector<Ray> rays = {ray, through(0, kInf), ray, through(0, 5), ray, ray};
    const std::vector<Hit> hits = traceAllWays(box(), rays);
    EXPECT_EQ(hits[1].t, 4);
    EXPECT_TRUE(sameHit(hits[1], hits[3]));
    EXPECT_TRUE(sameHit(hits[0], hits[2]) && sameHit(hits[0], hits[5]));
    return hits[0].triangle == kNoHit ? -1 : hits[0].t;
}

TEST(RayLimits, AreClosed) {
    EXPECT_EQ(distance(through(0, 4)), 4);
    EXPECT_EQ(distance(through(4, kInf)), 4);
    EXPECT_EQ(distance(through(4, 4)), 4);
    EXPECT_EQ(distance(through(6, 6)), 6);
    EXPECT_EQ(distance(through(0, std::nextafter(4.0f, 0.0f))), -1);
    EXPECT_EQ(distance(through(std::nextafter(4.0f, 8.0f), kInf)), 6);
    EXPECT_EQ(distance(through(std::nextafter(4.0f, 0.0f), std::nextafter(4.0f, 8.0f))), 4);
    EXPECT_EQ(distance(through(4.5f, 5.5f)), -1);
    EXPECT_EQ(distance(through(std::nextafter(6.0f, 8.0f), kInf)), -1);
}

TEST(RayLimits, MayBeInfiniteOrNegative) {
    EXPECT_EQ(distance(through(-kInf, kInf)), 4);
    EXPECT_EQ(distance(through(-3, 4)), 4);
    EXPECT_EQ(distance(through(0, kMax)), 4);
    EXPECT_EQ(distance(through(-kInf, 0)), -1);
    EXPECT_EQ(distance(through(0, -1)), -1);
    EXPECT_EQ(distance(through(kInf, kInf)), -1);
    EXPECT_EQ(distance(through(-kInf, -kInf)), -1);
    Ray away = through(-10, kInf); // what lies behind the origin stays unseen
    away.dir[0] = -1;
    EXPECT_EQ(distance(away), -1);
}

TEST(RayLimits, OutOfOrderOrNaNMiss) {
    EXPECT_EQ(distance(through(5, 3)), -1);
    EXPECT_EQ(distance(through(kInf, 0)), -1);
    EXPECT_EQ(distance(through(kNaN, 10)), -1);
    EXPECT_EQ(distance(through(0, kNaN)), -1);
    EXPECT_EQ(distance(through(kNaN, kNaN)), -1);
}

TEST(RayLimits, RaysThatCanNotBeMiss) {
    for (const float bad : {kNaN, kInf, -kInf}) {
        for (int k = 0; k < 3; ++k) {
            Ray ray = through(0, kInf);
            ray.org[k] = bad;
            EXPECT_EQ(distance(ray), -1);
            ray = through(0, kInf);
            ray.dir[k] = bad;
            EXPECT_EQ(distance(ray), -1);
        }
    }
    for (const float zero : {0.0f, -0.0f}) {
        Ray ray = through(0, kInf);
        for (float& x : ray.dir) x = zero;
        EXPECT_EQ(distance(ray), -1);
        for (float& x : ray.org) x = 0.5f;
        EXPECT_EQ(distance(ray), -1);
    }
}

TEST(RayLimits, NoValueCrashesOrHangs) {
    const float values[] = {0.0f, -0.0f, 1.0f, -1.0f, 1e-45f, -1e-38f, 1e38f, -kMax, kInf, kNaN};
    Random random(20);
    std::vector<Ray> rays(rayCount(5000));
    for (Ray& ray : rays) {
        const auto any = [&] { return values[random.below(uint32_t(std::size(values)))]; };
        for (int k = 0; k < 3; ++k) {
            ray.org[k] = any();
            ray.dir[k] = any();
        }
        ray.tNear = any();
        ray.tFar = any();
    }
    const TracedScene room(closedRoom());
    traceAllWays(room, rays);
}

TEST(RayLimits, RandomLimitsAsExact) {
    const auto mesh = bumpySphere(1000);
    const TracedScene scene(mesh);
    auto rays = randomRays(mesh, rayCount(5000), 21);
    Random random(22);
    for (Ray& ray : rays) {
        ray.tNear = float(random.between(-0.2, 1));
        ray.tFar = float(ray.tNear + random.between(-0.1, 2));
    }
    checkWatertight(scene, rays, "random limits");
}

TEST(RayLimits, DirectionsOfAnyLengthHit) {
    const auto mesh = snapped(icosphere(2), 16);
    const TracedScene scene(mesh);
    const auto base = raysFromInside(mesh, 1, rayCount(500) + 50, Target::Edge, Aim::Exact, 23);
    for (const int power : {-126, -100, -60, -30, 30, 60, 100, 125}) {
        std::vector<Ray> rays;
        for (Ray ray : base) {
            bool finite = true;
            for (float& x : ray.dir) {
                x = std::ldexp(x, power);
                finite = finite && std::isfinite(x);
            }
            if (!finite) continue;
            const ExactAnswer answer = scene.reference().nearest(ray);
            if (answer.must && answer.nearest[0].t > kMax) continue; // t is no float
            rays.push_back(ray);
        }
        const VerdictCounts counts =
            checkWatertight(scene, rays, "length 2^" + std::to_string(power));
        EXPECT_EQ(counts.hits, rays.size());
    }
}

} // namespace
} // namespace smart::test
