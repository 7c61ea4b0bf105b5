// SPDX-License-Identifier: MIT
// A scene from a file, with instances, against exact arithmetic.
#include <gtest/gtest.h>

#include <filesystem>

#include "samples/common/scene_loader.h"
#include "tests/libsmart/kernel/engine_check.h"
#include "tests/libsmart/kernel/test_size.h"
#include "tests/support/ray_sets.h"

namespace smart::test {
namespace {

std::vector<Triangle> trianglesOf(const samples::MeshDescription& mesh) {
    std::vector<Triangle> triangles;
    for (const samples::MeshPart& part : mesh.parts) {
        for (std::size_t i = 0; i < part.triangleCount(); ++i) {
            Triangle triangle;
            float* const corners[3] = {triangle.v0, triangle.v1, triangle.v2};
            for (std::size_t c = 0; c < 3; ++c) {
                const std::size_t at = 3 * i + c;
                const glm::vec3& p = part.positions[part.indices.empty() ? at : part.indices[at]];
                for (int k = 0; k < 3; ++k) corners[c][k] = p[k];
            }
            triangles.push_back(triangle);
        }
    }
    return triangles;
}

TEST(LoadedScene, HitsAsExact) {
    const samples::SceneDescription file = samples::loadScene(OPENRT_TEST_SCENE);
    std::vector<ModelPtr> models;
    for (const samples::MeshDescription& mesh : file.meshes) {
        models.push_back(makeModel(trianglesOf(mesh)));
    }
    std::vector<Instance> instances;
    for (const samples::InstanceDescription& instance : file.instances) {
        instances.push_back(place(models[instance.mesh], glm::dmat4x3(instance.transform)));
    }
    const TracedScene scene(std::move(instances));
    const ExactReference& reference = scene.reference();
    ASSERT_GE(reference.count(), 50000u);

    Random random(70);
    const auto cornerOf = [&](double point[3]) { // a point of a random triangle
        const auto& v = reference.corners(random.below(reference.count()));
        double s = random.unit(), r = random.unit();
        if (s + r > 1) {
            s = 1 - s;
            r = 1 - r;
        }
        for (std::size_t k = 0; k < 3; ++k) {
            point[k] = v[k] + s * (v[3 + k] - v[k]) + r * (v[6 + k] - v[k]);
        }
    };
    std::vector<Ray> rays;
    while (rays.size() < rayCount(300)) {
        double from[3], to[3];
        cornerOf(from);
        cornerOf(to);
        const std::array<double, 3> away = random.onSphere();
        for (std::size_t k = 0; k < 3; ++k) from[k] += 0.05 * reference.extent() * away[k];
        rays.push_back(makeRay(from, to, Aim::Normalised));
    }
    const VerdictCounts counts =
        checkWatertight(scene, rays, std::filesystem::path(OPENRT_TEST_SCENE).filename().string());
    EXPECT_GT(counts.hits, rays.size() * 3 / 4);
    EXPECT_LE(counts[Verdict::WrongPrim], 1u) << counts;
}

} // namespace
} // namespace smart::test
