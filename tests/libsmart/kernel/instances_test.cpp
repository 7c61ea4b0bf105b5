// SPDX-License-Identifier: MIT
// Instances against the world-space triangles, multiplied exactly by the matrices.
#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "tests/libsmart/kernel/engine_check.h"
#include "tests/libsmart/kernel/test_size.h"
#include "tests/support/procedural_meshes.h"
#include "tests/support/ray_sets.h"

namespace smart::test {
namespace {

glm::dmat4x3 affine(const glm::dmat4& matrix) {
    return glm::dmat4x3(matrix);
}

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

/// Whether the triangle and all that share a corner with it face the direction clearly and the
/// same way. Near a silhouette the rounding of the ray in object space may decide.
bool clearlySeen(const ExactReference& reference, uint32_t triangle,
                 const std::array<double, 3>& direction) {
    int sides = 0, count = 0;
    for (uint32_t neighbour : reference.topology().neighbours(triangle)) {
        const auto& v = reference.corners(neighbour);
        const glm::dvec3 a(v[0], v[1], v[2]), b(v[3], v[4], v[5]), c(v[6], v[7], v[8]);
        const double cosine = glm::dot(glm::normalize(glm::cross(b - a, c - a)),
                                       glm::dvec3(direction[0], direction[1], direction[2]));
        if (std::abs(cosine) < 0.1) return false;
        sides += cosine > 0 ? 1 : -1;
        ++count;
    }
    return std::abs(sides) == count;
}

/// Rays at vertices, edges and interiors of what the reference sees in world space; at interiors
/// only where a triangle stands alone.
std::vector<Ray> aimedAtWorld(const TracedScene& scene, std::size_t count, uint64_t seed) {
    const ExactReference& reference = scene.reference();
    Random random(seed);
    std::vector<Ray> rays;
    while (rays.size() < count) {
        const uint32_t triangle = random.below(reference.count());
        const std::array<double, 3> away = random.onSphere();
        if (!clearlySeen(reference, triangle, away)) continue;
        const auto& v = reference.corners(triangle);
        const uint32_t kind = reference.topology().neighbours(triangle).size() < 4 ? 2 : random.below(3);
        double weight[3] = {1, 0, 0};
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

struct Placement {
    const char* name;
    glm::dmat4 matrix;
};

TEST(Instances, AsTransformedTriangles) {
    const Placement placements[] = {
        {"identity", kOne},
        {"moved", moved(3, -2, 0.7)},
        {"rotated", rotated(0.7)},
        {"rotated and moved", moved(10, -20, 30) * rotated(2.1)},
        {"uniform scale", scaled(3, 3, 3) * rotated(0.3)},
        {"non-uniform scale", rotated(1.1) * scaled(0.25, 1, 4) * rotated(0.4)},
        {"mirrored", rotated(0.9) * scaled(-1, 1, 1)},
        {"mirrored, scaled and moved", moved(1, 2, 3) * rotated(2.9) * scaled(-2, 0.5, 1)},
        {"sheared", glm::dmat4(1, 0, 0, 0, 0.5, 1, 0, 0, 0.25, -0.75, 1, 0, 0, 0, 0, 1)}};
    const ModelPtr model = makeModel(bumpySphere(800));
    for (const Placement& placement : placements) {
        const TracedScene scene({place(model, affine(placement.matrix))});
        const auto rays = aimedAtWorld(scene, rayCount(4000), 30);
        checkWatertight(scene, rays, placement.name);
    }
}

TEST(Instances, ManyOfOneModelAndOfSeveral) {
    Random random(31);
    const ModelPtr models[] = {makeModel(icosphere(1)), makeModel(closedRoom()),
                               makeModel(triangleSoup(60, 0.4f, 32))};
    std::vector<Instance> instances;
    for (int i = 0; i < 40; ++i) {
        const auto axis = random.onSphere();
        const double size = random.between(0.05, 0.4);
        const glm::dmat4 matrix =
            moved(random.between(-3, 3), random.between(-3, 3), random.between(-3, 3)) *
            glm::rotate(kOne, random.between(0, 6), glm::dvec3(axis[0], axis[1], axis[2])) *
            scaled(i % 3 ? size : -size, size, size * random.between(0.5, 2));
        instances.push_back(place(models[i % 3], affine(matrix)));
    }
    const TracedScene scene(std::move(instances));
    checkWatertight(scene, aimedAtWorld(scene, rayCount(3000), 33), "40 instances");
}

TEST(Instances, NestedToEveryDepth) {
    ModelPtr model = makeModel(icosphere(1));
    for (int levels = 1; levels <= kMaxLevels; ++levels) {
        // Each level adds its own triangles and places the level below twice.
        const TracedScene scene({place(model, affine(moved(0.5, 0.25, -1) * rotated(0.5)))});
        const auto rays = aimedAtWorld(scene, rayCount(800), uint64_t(34 + levels));
        const auto hits = traceAllWays(scene, rays);
        uint32_t deepest = 0;
        for (const Hit& hit : hits) {
            if (hit.triangle != kNoHit) deepest = std::max(deepest, hit.levels);
        }
        EXPECT_EQ(deepest, uint32_t(levels));
        checkWatertight(scene, rays, std::to_string(levels) + " levels");
        if (levels == kMaxLevels) break;
        std::vector<Instance> children = {
            place(model, affine(moved(1.5, 0, 0) * rotated(0.3 * levels) * scaled(0.6, 0.6, 0.6)))};
        if (levels < 4) {
            children.push_back(place(model, affine(moved(-1.5, 0.5, 0) * scaled(-0.5, 0.5, 0.75))));
        }
        model = makeModel(triangleSoup(20, 0.5f, uint32_t(levels)), std::move(children));
    }
}

TEST(Instances, EqualDistancesGoToTheLowestPath) {
    const auto mesh = icosphere(3);
    const ModelPtr model = makeModel(mesh);
    const auto rays = raysFromOutside(mesh, 1, rayCount(2000), Target::Interior, Aim::Rounded, 40);
    {
        const TracedScene scene({place(model), place(model), place(model)});
        for (const Hit& hit : traceAllWays(scene, rays)) {
            ASSERT_NE(hit.triangle, kNoHit);
            ASSERT_EQ(hit.levels, 1u);
            ASSERT_EQ(hit.path[0], 0u);
        }
    }
    { // A model's own triangles come before its children, whatever the numbers.
        const ModelPtr parent = makeModel(mesh, {place(model), place(model)});
        const TracedScene scene({place(parent), place(model)});
        for (const Hit& hit : traceAllWays(scene, rays)) {
            ASSERT_EQ(hit.levels, 1u);
            ASSERT_EQ(hit.path[0], 0u);
        }
    }
    {
        const ModelPtr parent = makeModel({}, {place(model), place(model)});
        const TracedScene scene({place(parent), place(model)});
        for (const Hit& hit : traceAllWays(scene, rays)) {
            ASSERT_EQ(hit.levels, 2u);
            ASSERT_EQ(hit.path[0], 0u);
            ASSERT_EQ(hit.path[1], 0u);
        }
    }
}

TEST(Instances, SingularAndInfiniteOnesKeepTheirNumberAndAreNeverHit) {
    const auto mesh = icosphere(3);
    const ModelPtr model = makeModel(mesh);
    glm::dmat4x3 infinite(1.0);
    infinite[3][0] = INFINITY;
    glm::dmat4x3 undefined(1.0);
    undefined[1][1] = NAN;
    const TracedScene scene({place(model, affine(scaled(1, 1, 0))), place(model, infinite),
                             place(model, undefined), place(makeModel({})), place(model)});
    const auto rays = raysFromOutside(mesh, 1, rayCount(500), Target::Edge, Aim::Rounded, 41);
    for (const Hit& hit : traceAllWays(scene, rays)) {
        ASSERT_NE(hit.triangle, kNoHit);
        ASSERT_EQ(hit.path[0], 4u);
    }
}

/// The same pixels, a field of 10 x 10 and of 100 x 100 instances. One ray a packet, so that the
/// counts are what a ray visits, not what 16 pixels see together.
TEST(Instances, VisitsGrowLittleFrom100To10000) {
    const ModelPtr model = makeModel(bumpySphere(2000));
    const auto rays = cameraRays({{0, 0, 2.2}, {0, 0, 0}, {0, 1, 0}, 50}, 256, 256);
    TraversalCounts counts[2];
    const int sides[2] = {10, 100};
    for (int size = 0; size < 2; ++size) {
        const int side = sides[size];
        std::vector<Instance> instances;
        for (int i = 0; i < side * side; ++i) {
            const double x = (i % side + 0.5) / side * 2 - 1, y = (i / side + 0.5) / side * 2 - 1;
            const double radius = 0.8 / side;
            instances.push_back(
                place(model, affine(moved(x, y, 0) * rotated(i) * scaled(radius, radius, radius))));
        }
        const Scene scene(std::move(instances), Precision::Watertight, 1);
        HitPacket hits;
        for (const Ray& ray : rays) {
            kernels().intersectCounted[int(Precision::Watertight)](
                scene.view(), packet({&ray, 1}, 0), hits, counts[size]);
        }
    }
    const double nodes = double(counts[1].nodes) / double(counts[0].nodes);
    const double entered = double(counts[1].instances) / double(counts[0].instances);
    std::cout << "    nodes a ray " << double(counts[0].nodes) / double(rays.size()) << " to "
              << double(counts[1].nodes) / double(rays.size()) << ", instances a ray "
              << double(counts[0].instances) / double(rays.size()) << " to "
              << double(counts[1].instances) / double(rays.size()) << '\n';
    EXPECT_GT(counts[0].nodes, 0u);
    EXPECT_GT(counts[0].instances, 0u);
    EXPECT_LT(nodes, 2);
    EXPECT_LT(entered, 2);
}

} // namespace
} // namespace smart::test
