// SPDX-License-Identifier: MIT
#include "libsmart/render/ray_offset.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <random>
#include <vector>

#include "libsmart/kernel/kernels.h"
#include "libsmart/shading/surface_point.h"
#include "tests/libsmart/render/picture_scene.h"

namespace smart::test {
namespace {

struct Count {
    int rays = 0;
    int blocked = 0;
    double largestStep = 0; ///< offset over the size of the coordinates
};

/// Shoots rays at a convex body and, from where they hit, rays outward: whatever these meet is
/// the surface they leave. Without `leave`, they start at the point itself.
Count spawnOutward(const Scene& scene, const glm::dvec3& centre, double radius, bool leave) {
    Count count;
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal;
    const auto randomDirection = [&] {
        return glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
    };
    const KernelTable& table = kernels();
    for (int i = 0; i < 4000; ++i) {
        const glm::dvec3 from = centre + 3.0 * radius * randomDirection();
        const glm::dvec3 towards = centre + 0.7 * radius * randomDirection();
        const glm::dvec3 d = glm::normalize(towards - from);
        Ray ray{{float(from.x), float(from.y), float(from.z)},
                {float(d.x), float(d.y), float(d.z)},
                0.0f,
                std::numeric_limits<float>::infinity()};
        Hit hit;
        table.intersect1[1](scene.view(), ray, hit);
        if (hit.triangle == kNoHit) continue;
        const HitChain chain = resolve(scene, hit.path, hit.levels, hit.triangle);
        RTSstate state{};
        fillSurfacePoint(chain, hit.path[0], ray, hit.t, hit.u, hit.v, state);
        glm::dvec3 n(state.geometricNormal[0], state.geometricNormal[1], state.geometricNormal[2]);
        const glm::dvec3 at(state.position[0], state.position[1], state.position[2]);
        if (glm::dot(n, at - centre) < 0) n = -n; // a mirrored body
        glm::dvec3 out = randomDirection();
        if (i % 2) out = glm::normalize(out - glm::dot(out, n) * n + 1e-3 * n); // grazing
        if (glm::dot(out, n) < 0) out = -out;
        const glm::vec3 direction(out);
        if (!(glm::dot(glm::dvec3(direction), n) > 0)) continue;
        glm::vec3 origin(state.position[0], state.position[1], state.position[2]);
        if (leave) {
            const float error = surfaceError(chain, state.position, hit.u, hit.v);
            origin = leaveSurface(state.position, state.geometricNormal, state.rayDirection,
                                  direction, error);
            const double size = std::max(glm::length(centre), radius);
            count.largestStep = std::max(count.largestStep, double(error) / size);
        }
        const Ray spawned{{origin.x, origin.y, origin.z},
                          {direction.x, direction.y, direction.z},
                          0.0f,
                          std::numeric_limits<float>::infinity()};
        ++count.rays;
        count.blocked += table.occluded1[1](scene.view(), spawned);
    }
    return count;
}

/// A cube with rotated faces: convex to the bit nowhere near its edges, so that only the face
/// itself could stand in the way.
std::vector<Triangle> cubeAt(const glm::dvec3& centre, double radius) {
    const glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), 0.7, glm::dvec3(1.0, 2.0, 3.0));
    IndexedMesh mesh;
    addCube(mesh, 1.0, 1, false);
    for (std::size_t i = 0; i < mesh.xyz.size(); i += 3) {
        const glm::dvec4 corner(mesh.xyz[i], mesh.xyz[i + 1], mesh.xyz[i + 2], 1.0);
        const glm::dvec3 placed = centre + radius * glm::dvec3(turn * corner);
        for (int k = 0; k < 3; ++k) mesh.xyz[i + std::size_t(k)] = placed[k];
    }
    return mesh.triangles();
}

TEST(RayOffset, SpawnedRaysNeverMeetTheSurfaceTheyLeave) {
    const struct {
        glm::dvec3 centre;
        double radius;
    } cases[] = {{{0, 0, 0}, 1},       {{0, 0, 0}, 1e-6},    {{0, 0, 0}, 1e6},
                 {{1000, -500, 3}, 1}, {{1e5, 1e5, 1e5}, 1}, {{1e-3, 0, 1e3}, 100}};
    int blockedWithout = 0;
    for (const auto& [centre, radius] : cases) {
        const ScenePtr scene = makeScene({place(makeModel(cubeAt(centre, radius)))});
        const Count count = spawnOutward(*scene, centre, radius, true);
        EXPECT_GT(count.rays, 3000);
        EXPECT_EQ(count.blocked, 0) << radius;
        EXPECT_LT(count.largestStep, 2e-6);
        blockedWithout += spawnOutward(*scene, centre, radius, false).blocked;
    }
    EXPECT_GT(blockedWithout, 1000); // the rounding is real
}

TEST(RayOffset, InstancedSurfacesToo) {
    // The model far from its own origin, brought back by the instance; scaled, mirrored, nested.
    const ModelPtr far = makeModel(cubeAt({3e4, -2e4, 1e4}, 10.0));
    glm::dmat4 back = glm::scale(glm::dmat4(1.0), glm::dvec3(0.1, 0.2, -0.15));
    back = glm::rotate(back, 1.1, glm::dvec3(1, -1, 2));
    back = glm::translate(back, glm::dvec3(-3e4, 2e4, -1e4));
    const ModelPtr nested = makeModel({}, {place(far, glm::dmat4x3(back))});
    const glm::dmat4 away = glm::translate(glm::dmat4(1.0), glm::dvec3(5, 6, 7));
    for (const bool twice : {false, true}) {
        const ScenePtr scene = makeScene(
            {twice ? place(nested, glm::dmat4x3(away)) : place(far, glm::dmat4x3(away * back))});
        const Count count = spawnOutward(*scene, {5, 6, 7}, 3.0, true);
        EXPECT_GT(count.rays, 1500);
        EXPECT_EQ(count.blocked, 0);
        EXPECT_GT(spawnOutward(*scene, {5, 6, 7}, 3.0, false).blocked, 100);
    }
}

TEST(RayOffset, GoesToTheSideOfTheNewDirection) {
    const float position[3] = {1.0f, 2.0f, 3.0f}, normal[3] = {0.0f, 0.0f, 1.0f};
    const float incoming[3] = {0.0f, 0.0f, -1.0f};
    EXPECT_GT(leaveSurface(position, normal, incoming, {0.6f, 0.0f, 0.8f}, 1e-3f).z, 3.0f);
    EXPECT_LT(leaveSurface(position, normal, incoming, {0.6f, 0.0f, -0.8f}, 1e-3f).z, 3.0f);
    EXPECT_GT(leaveSurface(position, normal, incoming, {1.0f, 0.0f, 0.0f}, 1e-3f).z, 3.0f);
}

} // namespace
} // namespace smart::test
