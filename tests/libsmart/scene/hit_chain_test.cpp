// SPDX-License-Identifier: MIT
// Truth: matrices applied one after the other in rational numbers.
#include "libsmart/scene/hit_chain.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/support/procedural_meshes.h"
#include "tests/support/ray_sets.h"
#include "tests/support/traced_scene.h"

namespace smart {
namespace {

using ExactVector = std::array<mpq_class, 3>;

ExactVector exact(const float (&vertex)[3]) {
    return {mpq_class(vertex[0]), mpq_class(vertex[1]), mpq_class(vertex[2])};
}

ExactVector applied(const glm::dmat4x3& matrix, const ExactVector& point) {
    ExactVector result;
    for (int row = 0; row < 3; ++row) {
        result[row] = mpq_class(matrix[3][row]);
        for (int k = 0; k < 3; ++k) result[row] += mpq_class(matrix[k][row]) * point[k];
    }
    return result;
}

ExactVector normalOf(const std::array<ExactVector, 3>& corners) {
    ExactVector a, b, result;
    for (int k = 0; k < 3; ++k) {
        a[k] = corners[1][k] - corners[0][k];
        b[k] = corners[2][k] - corners[0][k];
    }
    for (int k = 0; k < 3; ++k) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        result[k] = a[i] * b[j] - a[j] * b[i];
    }
    return result;
}

/// Largest component of the difference over the largest of the truth.
double relativeError(const glm::dvec3& value, const ExactVector& truth) {
    double error = 0, size = 0;
    for (int k = 0; k < 3; ++k) {
        error = std::max(error, std::fabs(mpq_class(mpq_class(value[k]) - truth[k]).get_d()));
        size = std::max(size, std::fabs(truth[k].get_d()));
    }
    return error / size;
}

class HitChainTest : public testing::Test {
protected:
    glm::dmat4x3 matrix() {
        glm::dmat4x3 result(1.0);
        for (int column = 0; column < 4; ++column) {
            for (int row = 0; row < 3; ++row) result[column][row] += random_.between(-0.4, 0.4);
        }
        if (random_.below(2)) result[0] = -result[0];
        return result;
    }
    Instance place(ModelPtr model, uint32_t objectId) {
        Instance instance = test::place(std::move(model), matrix());
        instance.objectId = objectId;
        return instance;
    }

    test::Random random_{17};
};

TEST_F(HitChainTest, PathsLeadThroughNestedModels) {
    const ModelPtr leaf = test::makeModel(test::icosphere(0));
    const ModelPtr middle =
        test::makeModel(test::triangleSoup(5, 0.5f, 1), {place(leaf, 1), place(leaf, 2)});
    const ModelPtr upper =
        test::makeModel({}, {place(leaf, 3), place(middle, 4), place(middle, 5)});
    const Scene scene({place(leaf, 6), place(upper, 7)}, Precision::Watertight, 1);

    const struct {
        std::vector<uint32_t> path;
        const Model* model;
        std::vector<uint32_t> objects;
    } cases[] = {{{0}, leaf.get(), {6}},
                 {{1, 0}, leaf.get(), {7, 3}},
                 {{1, 2}, middle.get(), {7, 5}},
                 {{1, 1, 0}, leaf.get(), {7, 4, 1}},
                 {{1, 2, 1}, leaf.get(), {7, 5, 2}}};
    for (const auto& expected : cases) {
        const uint32_t levels = uint32_t(expected.path.size());
        for (uint32_t triangle = 0; triangle < expected.model->triangles.size(); ++triangle) {
            const HitChain chain = resolve(scene, expected.path.data(), levels, triangle);
            EXPECT_EQ(chain.model, expected.model);
            EXPECT_EQ(chain.triangle, triangle);
            ASSERT_EQ(chain.levels, levels);
            for (uint32_t level = 0; level < levels; ++level) {
                EXPECT_EQ(chain.instances[level]->objectId, expected.objects[level]);
            }

            const Triangle& own = expected.model->triangles[triangle];
            std::array<ExactVector, 3> corners{exact(own.v0), exact(own.v1), exact(own.v2)};
            for (ExactVector& corner : corners) {
                for (uint32_t level = levels; level-- > 0;) {
                    corner = applied(toParent(*chain.instances[level]), corner);
                }
            }
            for (int corner = 0; corner < 3; ++corner) {
                EXPECT_LT(relativeError(chain.worldVertex(corner), corners[corner]), 1e-14);
            }
            const ExactVector normal = normalOf(corners);
            EXPECT_LT(relativeError(chain.worldNormal(), normal), 1e-13);
            EXPECT_GT(relativeError(-chain.worldNormal(), normal), 1) << "control";
        }
    }
}

TEST_F(HitChainTest, NormalLosesNothingToAFarTranslation) {
    glm::dmat4x3 far(1.0);
    far[3] = {1e9, -3e9, 2e9};
    const ModelPtr model = test::makeModel(test::triangleSoup(20, 1e-3f, 9));
    const Scene scene({test::place(model, far)}, Precision::Watertight, 1);
    const uint32_t path = 0;
    for (uint32_t triangle = 0; triangle < 20; ++triangle) {
        const Triangle& own = model->triangles[triangle];
        const ExactVector normal = normalOf({exact(own.v0), exact(own.v1), exact(own.v2)});
        EXPECT_LT(relativeError(resolve(scene, &path, 1, triangle).worldNormal(), normal), 1e-10);
    }
}

} // namespace
} // namespace smart
