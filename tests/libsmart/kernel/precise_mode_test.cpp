// SPDX-License-Identifier: MIT
// The precise mode finds what exact arithmetic finds: the nearest crossing, touches included, and
// its t, u and v as the nearest floats.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/libsmart/kernel/engine_check.h"
#include "tests/libsmart/kernel/test_size.h"
#include "tests/support/procedural_meshes.h"
#include "tests/support/ray_sets.h"

namespace smart::test {
namespace {

/// How many hits differ from the exact ones, and in what.
struct Differences {
    std::size_t hits = 0, existence = 0, triangle = 0, rounding = 0;
    std::size_t all() const { return existence + triangle + rounding; }
};
std::ostream& operator<<(std::ostream& out, const Differences& d) {
    return out << d.hits << " hits; wrong: " << d.existence << " hit or miss, " << d.triangle
               << " triangles, " << d.rounding << " roundings";
}

bool isNearestFloat(float value, const mpq_class& exact) {
    if (std::isinf(value)) return abs(exact) >= mpq_class(std::ldexp(1.0, 128) - std::ldexp(1.0, 103));
    const mpq_class error = abs(mpq_class(value) - exact);
    for (const float other : {std::nextafter(value, INFINITY), std::nextafter(value, -INFINITY)}) {
        if (!std::isinf(other) && abs(mpq_class(other) - exact) < error) return false;
    }
    return true;
}

/// Compares with the exact nearest crossing of all: the first touch, or else the must layer.
void compare(const TracedScene& scene, const Ray& ray, const ExactAnswer& truth, const Hit& hit,
             Differences& differences) {
    const std::vector<ExactCrossing>& first = truth.touches.empty() ? truth.nearest : truth.touches;
    if (first.empty() != (hit.triangle == kNoHit)) {
        ++differences.existence;
        return;
    }
    if (first.empty()) return;
    ++differences.hits;
    const ExactCrossing* lowest = &first[0];
    for (const ExactCrossing& crossing : first) {
        if (crossing.t == first[0].t && crossing.triangle < lowest->triangle) lowest = &crossing;
    }
    if (scene.claim(hit).triangle != lowest->triangle) {
        ++differences.triangle;
        return;
    }
    differences.rounding += !isNearestFloat(hit.t, lowest->t) ||
                            !isNearestFloat(hit.u, lowest->u) || !isNearestFloat(hit.v, lowest->v);
    (void)ray;
}

Differences compareAll(const TracedScene& scene, std::span<const Ray> rays,
                       std::span<const Hit> hits) {
    Differences differences;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        compare(scene, rays[i], scene.reference().nearest(rays[i]), hits[i], differences);
    }
    return differences;
}

Differences checkPrecise(const TracedScene& scene, std::span<const Ray> rays,
                         const std::string& name) {
    SCOPED_TRACE(name);
    const Differences differences =
        compareAll(scene, rays, traceAllWays(scene.view(), rays, Precision::Precise));
    EXPECT_EQ(differences.all(), 0u) << differences;
    std::cout << "    " << name << ": " << differences << '\n';
    return differences;
}

TEST(PreciseMode, RandomRaysHitAsExact) {
    const std::pair<const char*, std::vector<Triangle>> meshes[] = {
        {"soup of large triangles", triangleSoup(400, 0.5f, 1)},
        {"soup of small triangles", triangleSoup(3000, 0.03f, 2)},
        {"bumpy sphere", bumpySphere(3000)},
        {"heightfield", heightfield(3000)},
        {"one triangle", triangleSoup(1, 1.0f, 3)}};
    for (const auto& [name, mesh] : meshes) {
        checkPrecise(TracedScene(mesh), randomRays(mesh, rayCount(3000), 4), name);
    }
}

TEST(PreciseMode, AimedRaysHitAsExact) {
    for (const Aim aim : {Aim::Exact, Aim::Rounded, Aim::Normalised}) {
        const auto mesh = aim == Aim::Exact ? snapped(icosphere(3), 16) : icosphere(3);
        const TracedScene scene(mesh);
        for (const Target target : {Target::Vertex, Target::Edge, Target::Interior}) {
            const auto outside = raysFromOutside(mesh, 1, rayCount(1000), target, aim, 7);
            EXPECT_EQ(checkPrecise(scene, outside, "outside").hits, outside.size());
            const auto inside = raysFromInside(mesh, 1, rayCount(1000), target, aim, 6);
            EXPECT_EQ(checkPrecise(scene, inside, "inside").hits, inside.size());
        }
    }
}

TEST(PreciseMode, AxisParallelRaysHitAsExact) {
    const TracedScene scene(closedRoom());
    checkPrecise(scene, axisParallelRays(7.9, 0, rayCount(1000), 10), "anywhere");
    checkPrecise(scene, axisParallelRays(7.5, 0.5, rayCount(1000), 11), "half-integer origins");
    checkPrecise(scene, axisParallelRays(7, 1, rayCount(1000), 12), "integer origins");
    checkPrecise(scene, axisParallelRays(8, 8, rayCount(500), 13), "origins on walls");
}

} // namespace
} // namespace smart::test
