// SPDX-License-Identifier: MIT
// Rays that start on surfaces: nothing shadows itself, nothing lets rays through. An origin lies
// 4 units in the last place of its largest coordinate off the point that the barycentrics give.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/libsmart/kernel/engine_check.h"
#include "tests/libsmart/kernel/test_size.h"
#include "tests/support/procedural_meshes.h"
#include "tests/support/ray_sets.h"

namespace smart::test {
namespace {

/// From random points of the mesh, `side` = 1 outward, -1 inward, at most about 84 degrees from
/// the normal.
std::vector<Ray> raysOffSurface(const std::vector<Triangle>& mesh, double side, std::size_t count) {
    Random random(80);
    std::vector<Ray> rays;
    while (rays.size() < count) {
        const Triangle& triangle = mesh[random.below(uint32_t(mesh.size()))];
        double u = random.unit(), v = random.unit();
        if (u + v > 1) {
            u = 1 - u;
            v = 1 - v;
        }
        const std::array<double, 3> toward = random.onSphere();
        double point[3], normal[3], square = 0, cosine = 0, largest = 0;
        for (int k = 0; k < 3; ++k) {
            const int i = (k + 1) % 3, j = (k + 2) % 3;
            point[k] = (1 - u - v) * triangle.v0[k] + u * triangle.v1[k] + v * triangle.v2[k];
            normal[k] = (double(triangle.v1[i]) - triangle.v0[i]) *
                            (double(triangle.v2[j]) - triangle.v0[j]) -
                        (double(triangle.v1[j]) - triangle.v0[j]) *
                            (double(triangle.v2[i]) - triangle.v0[i]);
            square += normal[k] * normal[k];
            cosine += normal[k] * toward[std::size_t(k)];
            largest = std::max(largest, std::abs(point[k]));
        }
        const double length = std::sqrt(square);
        if (side * cosine < 0.1 * length) continue;
        Ray ray{{}, {}, 0, INFINITY};
        for (int k = 0; k < 3; ++k) {
            ray.org[k] = float(point[k] + side * 4 * 0x1p-23 * largest * normal[k] / length);
            ray.dir[k] = float(toward[std::size_t(k)]);
        }
        rays.push_back(ray);
    }
    return rays;
}

void expectNoAcneAndNoLeak(const std::vector<Triangle>& mesh, const char* name) {
    SCOPED_TRACE(name);
    const TracedScene scene(mesh);
    const std::size_t count = rayCount(2000);
    const auto outward = raysOffSurface(mesh, 1, count), inward = raysOffSurface(mesh, -1, count);
    for (const Precision precision : {Precision::Watertight, Precision::Precise}) {
        std::size_t shadowed = 0, escaped = 0;
        for (const Hit& hit : traceAllWays(scene, outward, precision))
            shadowed += hit.triangle != kNoHit;
        for (const Hit& hit : traceAllWays(scene, inward, precision))
            escaped += hit.triangle == kNoHit;
        EXPECT_EQ(shadowed, 0u) << "of " << count << " in mode " << int(precision);
        EXPECT_EQ(escaped, 0u) << "of " << count << " in mode " << int(precision);
    }
}

TEST(SecondaryRays, NeitherShadowThemselvesNorLeakOnConvexMeshes) {
    expectNoAcneAndNoLeak(icosphere(4), "sphere");
    expectNoAcneAndNoLeak(prism(64, 1, 8), "prism");
    expectNoAcneAndNoLeak(prism(1024, 1, 8), "prism of slivers");
    auto moved = prism(256, 1, 4);
    for (Triangle& triangle : moved) {
        for (float* v : {triangle.v0, triangle.v1, triangle.v2}) v[0] += 100;
    }
    expectNoAcneAndNoLeak(moved, "prism far from the origin");
}

} // namespace
} // namespace smart::test
