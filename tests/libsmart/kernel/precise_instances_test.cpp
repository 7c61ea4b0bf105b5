// SPDX-License-Identifier: MIT
// The precise mode through instances: as if the vertices had been multiplied by the matrices
// without rounding.
#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "tests/libsmart/kernel/precise_check.h"
#include "tests/libsmart/kernel/test_size.h"
#include "tests/support/procedural_meshes.h"
#include "tests/support/ray_sets.h"

namespace smart::test {
namespace {

const glm::dmat4 kOne(1.0);
const glm::dvec3 kAxis(0.36, 0.48, 0.8);

glm::dmat4 rotated(double angle) {
    return glm::rotate(kOne, angle, kAxis);
}
glm::dmat4 scaled(double x, double y, double z) {
    return glm::scale(kOne, glm::dvec3(x, y, z));
}
glm::dmat4 moved(double x, double y, double z) {
    return glm::translate(kOne, glm::dvec3(x, y, z));
}
Instance placed(const ModelPtr& model, const glm::dmat4& matrix) {
    return place(model, glm::dmat4x3(matrix));
}
/// Entries rounded to 11 bits, so that vertices on a grid stay exact in double.
glm::dmat4 coarse(glm::dmat4 matrix) {
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 3; ++row) {
            int exponent;
            const double fraction = std::frexp(matrix[column][row], &exponent);
            matrix[column][row] = std::ldexp(std::round(fraction * 2048) / 2048, exponent);
        }
    }
    return matrix;
}

/// Rays at vertices, edges and interiors of triangles in world space, from any side.
std::vector<Ray> aimedAtWorld(const TracedScene& scene, std::size_t count, uint64_t seed) {
    const ExactReference& reference = scene.reference();
    Random random(seed);
    std::vector<Ray> rays;
    while (rays.size() < count) {
        const uint32_t triangle = random.below(reference.count());
        if (reference.degenerate(triangle)) continue;
        const std::array<double, 3> away = random.onSphere();
        const auto& v = reference.corners(triangle);
        double weight[3] = {1, 0, 0};
        const uint32_t kind = random.below(3);
        if (kind >= 1) {
            weight[1] = random.between(0.05, 0.95);
            weight[0] = 1 - weight[1];
        }
        if (kind == 2) {
            weight[2] = random.between(0.05, 0.95) * weight[0];
            weight[0] -= weight[2];
        }
        double origin[3], target[3];
        for (std::size_t k = 0; k < 3; ++k) {
            target[k] = weight[0] * v[k] + weight[1] * v[3 + k] + weight[2] * v[6 + k];
            origin[k] = target[k] + 2 * reference.extent() * away[k];
        }
        rays.push_back(makeRay(origin, target, Aim::Normalised));
    }
    return rays;
}

TEST(PreciseInstances, HitAsExact) {
    const ModelPtr model = makeModel(snapped(icosphere(1), 16));
    const std::pair<const char*, glm::dmat4> placements[] = {
        {"moved", moved(3, -2, 0.7)},
        {"rotated and moved", moved(10, -20, 30) * rotated(2.1)},
        {"scaled by (1, 1e-3, 1e3) and rotated", coarse(rotated(0.4) * scaled(1, 1e-3, 1e3))},
        {"mirrored", coarse(rotated(0.9) * scaled(-1, 1, 1))},
        {"moved by 1e4", coarse(moved(5770, -5900, 5650) * rotated(1))},
        {"one axis times 1e-6", coarse(rotated(0.3) * scaled(1, 1, 1e-6))},
        {"one axis times 1e-12", coarse(rotated(0.3) * scaled(1, 1, 1e-12))},
        {"times 1e-12", scaled(1e-12, 1e-12, 1e-12) * rotated(0.3)},
        {"times 1e12", scaled(1e12, 1e12, 1e12) * rotated(0.3)},
        {"sheared", glm::dmat4(1, 0, 0, 0, 0.5, 1, 0, 0, 0.25, -0.75, 1, 0, 0, 0, 0, 1)}};
    for (const auto& [name, matrix] : placements) {
        const TracedScene scene({placed(model, matrix)});
        ASSERT_EQ(scene.scene().group().dropped(), 0u) << name;
        const auto rays = aimedAtWorld(scene, rayCount(150), 30);
        EXPECT_GT(checkPrecise(scene, rays, name).hits, rays.size() / 2);
    }
}

/// Matrices that leave float no room: every triangle is judged without it.
TEST(PreciseInstances, ScalesBeyondFloatHitAsExact) {
    const ModelPtr model = makeModel(icosphere(0));
    for (const double scale : {1e-30, 1e-20, 1e20, 1e35}) {
        const TracedScene scene({placed(model, scaled(scale, scale, scale) * rotated(0.3))});
        const auto rays = aimedAtWorld(scene, rayCount(60) + 4, 38);
        EXPECT_GT(checkPrecise(scene, rays, "scale " + std::to_string(std::log10(scale))).hits, 0u);
    }
}

TEST(PreciseInstances, ManyThatOverlapHitAsExact) {
    Random random(31);
    const ModelPtr models[] = {makeModel(icosphere(1)), makeModel(triangleSoup(60, 0.4f, 32))};
    std::vector<Instance> instances;
    for (int i = 0; i < 40; ++i) {
        const auto axis = random.onSphere();
        const double size = random.between(0.05, 0.8);
        instances.push_back(placed(
            models[i % 2],
            moved(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)) *
                glm::rotate(kOne, random.between(0, 6), glm::dvec3(axis[0], axis[1], axis[2])) *
                scaled(i % 3 ? size : -size, size, size * random.between(0.5, 2))));
    }
    const TracedScene scene(std::move(instances));
    checkPrecise(scene, aimedAtWorld(scene, rayCount(400), 33), "40 instances");
}

TEST(PreciseInstances, NestedToEveryDepthHitAsExact) {
    ModelPtr model = makeModel(icosphere(1));
    for (int levels = 1; levels <= kMaxLevels; ++levels) {
        const TracedScene scene({placed(model, moved(0.5, 0.25, -1) * rotated(0.5))});
        checkPrecise(scene, aimedAtWorld(scene, rayCount(100), uint64_t(34 + levels)),
                     std::to_string(levels) + " levels");
        if (levels == kMaxLevels) break;
        std::vector<Instance> children = {
            placed(model, moved(1500, 0, 0) * rotated(0.3 * levels) * scaled(0.6, 0.6, 0.6))};
        if (levels < 4) {
            children.push_back(placed(model, moved(-1.5, 0.5, 0) * scaled(-0.5, 0.5, 0.75)));
        }
        model = makeModel(triangleSoup(20, 0.5f, uint32_t(levels)), std::move(children));
    }
}

/// Two ways to the same place: by one matrix or by two whose product it is, exactly.
TEST(PreciseInstances, EqualDistancesOfDifferentPathsGoToTheLowest) {
    const ModelPtr model = makeModel(snapped(icosphere(2), 16));
    const glm::dmat4 quarter = glm::dmat4(0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
    const ModelPtr turned = makeModel({}, {placed(model, moved(0.25, 0, 0) * scaled(2, 2, 2))});
    const glm::dmat4 whole = quarter * moved(0.25, 0, 0) * scaled(2, 2, 2);
    for (const bool nestedFirst : {false, true}) {
        std::vector<Instance> instances = {placed(turned, quarter), placed(model, whole)};
        if (!nestedFirst) std::swap(instances[0], instances[1]);
        const TracedScene scene(std::move(instances));
        const auto rays = aimedAtWorld(scene, rayCount(300), 36);
        EXPECT_GT(checkPrecise(scene, rays, "two ways").hits, rays.size() / 2);
        for (const Hit& hit : traceAllWays(scene, rays, Precision::Precise)) {
            if (hit.triangle != kNoHit) {
                ASSERT_EQ(hit.path[0], 0u);
            }
        }
    }
}

/// A surface placed twice, one unit in the last place of a double apart.
TEST(PreciseInstances, OrdersSurfacesOneUlpOfADoubleApart) {
    const ModelPtr model = makeModel(snapped(icosphere(2), 16));
    const double nearer = std::nextafter(3.0, 4.0);
    const TracedScene scene({placed(model, moved(0, 0, 3)), placed(model, moved(0, 0, nearer))});
    std::vector<Ray> rays;
    Random random(37);
    while (rays.size() < rayCount(200)) {
        const double target[3] = {random.between(-0.5, 0.5), random.between(-0.5, 0.5), 3.5};
        const double origin[3] = {random.between(-1, 1), random.between(-1, 1), 9};
        rays.push_back(makeRay(origin, target, Aim::Normalised));
    }
    for (const Hit& hit : traceAllWays(scene, rays, Precision::Precise)) {
        ASSERT_NE(hit.triangle, kNoHit);
        ASSERT_EQ(hit.path[0], 1u);
    }
    checkPrecise(scene, rays, "one ulp apart");
    const auto watertight =
        tracePackets(kernels(), Precision::Watertight, scene.view(), rays, Filling::Full);
    EXPECT_GT(compareAll(scene, rays, watertight).triangle, 0u) << "the check must find that";
}

} // namespace
} // namespace smart::test
