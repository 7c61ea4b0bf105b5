// SPDX-License-Identifier: MIT
// Truth: matrices and corners in rational numbers.
#include "libsmart/geometry/instance_group.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <glm/mat3x3.hpp>
#include <limits>
#include <random>
#include <set>

#include "libsmart/geometry/corner_reach.h"
#include "libsmart/geometry/model_builder.h"
#include "libsmart/kernel/affine_inverse.h"
#include "tests/support/procedural_meshes.h"

namespace smart {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

ModelPtr makeModel(const Triangle& triangle) {
    ModelBuilder builder;
    builder.triangles = {triangle};
    return std::move(builder).build();
}

ModelPtr unitModel() {
    return makeModel({{0, 0, 0}, {1, 0, 0}, {0, 1, 1}});
}

Instance place(ModelPtr model, const glm::dmat4x3& matrix) {
    Instance instance;
    instance.model = std::move(model);
    instance.toParent = matrix;
    return instance;
}

glm::dmat4x3 translation(double x, double y, double z) {
    glm::dmat4x3 matrix(1.0);
    matrix[3] = {x, y, z};
    return matrix;
}

class RandomMatrices {
public:
    double uniform() { return int32_t(generator_()) * 0x1p-31; }
    /// Any affine matrix: shears, mirrors, scales that differ by factors up to 2^2e.
    glm::dmat4x3 matrix(int e) {
        glm::dmat4x3 matrix;
        for (int column = 0; column < 4; ++column) {
            const double scale = std::ldexp(1.0, int(generator_() % unsigned(2 * e + 1)) - e);
            for (int row = 0; row < 3; ++row) matrix[column][row] = uniform() * scale;
        }
        return matrix;
    }

private:
    std::mt19937 generator_{11};
};

struct Columns {
    explicit Columns(const glm::dmat4x3& matrix) {
        std::memcpy(of, &matrix[0][0], sizeof of);
    }
    AffineColumns of;
};

/// Both functions have to agree.
bool invert(const glm::dmat4x3& matrix, glm::dmat4x3& inverse) {
    AffineRows rows;
    const bool done = invertAffine(Columns(matrix).of, rows);
    EXPECT_EQ(isInvertible(Columns(matrix).of), done);
    if (!done) return false;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column) inverse[column][row] = rows[row][column];
    return true;
}

double residual(const glm::dmat4x3& a, const glm::dmat4x3& b) {
    double worst = 0;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 4; ++column) {
            mpq_class sum = column == 3 ? mpq_class(a[3][row]) : mpq_class(0);
            for (int k = 0; k < 3; ++k) sum += mpq_class(a[k][row]) * mpq_class(b[column][k]);
            if (row == column) sum -= 1;
            worst = std::max(worst, std::fabs(sum.get_d()));
        }
    }
    return worst;
}

TEST(InvertAffineTest, InverseTimesMatrixIsTheIdentity) {
    RandomMatrices random;
    for (int i = 0; i < 2000; ++i) {
        const glm::dmat4x3 matrix = random.matrix(0);
        glm::dmat4x3 inverse;
        ASSERT_TRUE(invert(matrix, inverse));
        double condition = 1;
        for (int column = 0; column < 4; ++column) {
            for (int row = 0; row < 3; ++row) {
                condition = std::max(condition, std::fabs(inverse[column][row]));
            }
        }
        EXPECT_LT(residual(matrix, inverse), 1e-14 * condition * condition);
        // Control: an inverse with one entry off is told from a good one.
        if (condition < 100) {
            inverse[1][2] += 1e-6;
            EXPECT_GT(residual(matrix, inverse), 1e-13 * condition * condition);
        }
    }
}

TEST(InvertAffineTest, ScalesOfAnySizeAreNotSingular) {
    for (const double scale : {1e-300, 1e-160, 1e-20, 1e20, 1e160, 1e300}) {
        glm::dmat4x3 matrix(scale), inverse;
        ASSERT_TRUE(invert(matrix, inverse)) << scale;
        EXPECT_LT(residual(matrix, inverse), 1e-15);
        matrix = glm::dmat4x3(1.0);
        matrix[1][1] = scale;
        ASSERT_TRUE(invert(matrix, inverse)) << scale;
        EXPECT_LT(residual(matrix, inverse), 1e-15);
    }
}

TEST(InvertAffineTest, MatricesWithoutAnInverseAreRefused) {
    glm::dmat4x3 inverse;
    EXPECT_FALSE(invert(glm::dmat4x3(0.0), inverse));
    for (int column = 0; column < 3; ++column) {
        glm::dmat4x3 matrix(1.0);
        matrix[column] = {0, 0, 0};
        EXPECT_FALSE(invert(matrix, inverse));
    }
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 3; ++row) {
            for (const double bad : {kInfinity, -kInfinity, kNan}) {
                glm::dmat4x3 matrix(1.0);
                matrix[column][row] = bad;
                EXPECT_FALSE(invert(matrix, inverse));
            }
        }
    }
    glm::dmat4x3 tooFar(1e-300); // its inverse's translation is no double
    tooFar[3] = {1e300, 0, 0};
    EXPECT_FALSE(invert(tooFar, inverse));
}

TEST(InvertAffineTest, FlatteningIsSeenThroughRotations) {
    RandomMatrices random;
    for (int i = 0; i < 500; ++i) {
        const double a = 3 * random.uniform(), b = 3 * random.uniform();
        const glm::dmat3 turnZ(std::cos(a), std::sin(a), 0, -std::sin(a), std::cos(a), 0, 0, 0, 1);
        const glm::dmat3 turnX(1, 0, 0, 0, std::cos(b), std::sin(b), 0, -std::sin(b), std::cos(b));
        glm::dmat3 flat(1.0);
        flat[1][1] = 0;
        const glm::dmat3 product = turnZ * turnX * flat * turnX * turnZ;
        const glm::dmat4x3 matrix(product[0], product[1], product[2], glm::dvec3(1, 2, 3));
        glm::dmat4x3 inverse;
        EXPECT_FALSE(invert(matrix, inverse));
    }
}

TEST(InvertAffineTest, TheUsualWayGivesTheSameBits) {
    RandomMatrices random;
    int usual = 0, refused = 0, mirrored = 0;
    for (int i = 0; i < 20000; ++i) {
        glm::dmat4x3 matrix = random.matrix(i % 3 ? i % 99 : 180);
        for (int entry = i % 8; entry < 3; ++entry)
            matrix[entry][(entry + i) % 3] = i % 16 ? 0 : -0.0;
        if (i % 40 == 1) matrix[2] = 2.0 * matrix[1];
        const Columns columns(matrix);
        AffineRows slow, fast;
        if (!invertAffine(columns.of, slow)) {
            EXPECT_FALSE(isInvertible(columns.of));
            ++refused;
            continue;
        }
        EXPECT_TRUE(isInvertible(columns.of));
        if (!isUsual(columns.of)) continue;
        invertUsual(columns.of, fast);
        ++usual;
        EXPECT_EQ(std::memcmp(slow, fast, sizeof slow), 0) << i;
        mirrored += glm::determinant(glm::dmat3(matrix[0], matrix[1], matrix[2])) < 0;
    }
    EXPECT_GT(usual, 10000);
    EXPECT_GT(mirrored, 1000);
    EXPECT_GT(refused, 100);
    AffineColumns unusual = {{1, 0, 0}, {0, 0x1p-101, 0}, {0, 0, 1}, {0, 0, 0}};
    EXPECT_FALSE(isUsual(unusual));
    unusual[1][1] = kNan;
    EXPECT_FALSE(isUsual(unusual));
}

TEST(InstanceGroupTest, BoxHoldsTheExactVerticesAndLittleMoreThanTheCorners) {
    RandomMatrices random;
    int tight = 0, smaller = 0;
    for (int i = 0; i < 2000; ++i) {
        Triangle triangle;
        for (float* corner : {triangle.v0, triangle.v1, triangle.v2}) {
            for (int k = 0; k < 3; ++k) corner[k] = float(random.uniform() * (i % 3 ? 1 : 1e6));
        }
        const ModelPtr model = makeModel(triangle);
        ASSERT_EQ(model->droppedTriangles, 0u);
        const Aabb inner = model->bounds;
        const glm::dmat4x3 matrix = random.matrix(i % 2 ? 0 : 12);
        const InstanceGroup group({place(model, matrix)}, 1);
        ASSERT_EQ(group.dropped(), 0u);
        const Aabb box = group.bounds();
        for (int row = 0; row < 3; ++row) {
            mpq_class lo, hi, lowest, highest; // of the corners; of the vertices
            double magnitude = std::fabs(matrix[3][row]);
            for (int corner = 0; corner < 8; ++corner) {
                mpq_class sum(matrix[3][row]);
                for (int k = 0; k < 3; ++k) {
                    const float value = (corner >> k) & 1 ? inner.hi[k] : inner.lo[k];
                    sum += mpq_class(matrix[k][row]) * mpq_class(value);
                    magnitude += std::fabs(matrix[k][row] * value);
                }
                if (corner == 0 || sum < lo) lo = sum;
                if (corner == 0 || sum > hi) hi = sum;
            }
            for (const float* const vertex : {triangle.v0, triangle.v1, triangle.v2}) {
                mpq_class sum(matrix[3][row]);
                for (int k = 0; k < 3; ++k) sum += mpq_class(matrix[k][row]) * mpq_class(vertex[k]);
                if (vertex == triangle.v0 || sum < lowest) lowest = sum;
                if (vertex == triangle.v0 || sum > highest) highest = sum;
            }
            EXPECT_LE(mpq_class(box.lo[row]), lowest);
            EXPECT_GE(mpq_class(box.hi[row]), highest);
            EXPECT_GT(box.lo[row], lo.get_d() - 1e-6 * magnitude);
            EXPECT_LT(box.hi[row], hi.get_d() + 1e-6 * magnitude);
            tight += box.lo[row] > lowest.get_d() - 1e-9 * magnitude;
            smaller += box.lo[row] > lo.get_d() + 1e-3 * magnitude;
        }
    }
    EXPECT_EQ(tight, 0) << "rays are rounded in object space: no box without padding";
    EXPECT_GT(smaller, 100) << "what does not reach the corners takes less room";
}

TEST(InstanceGroupTest, ABallTakesAsMuchRoomHoweverItIsTurned) {
    ModelBuilder builder;
    builder.triangles = test::bumpySphere(300);
    const ModelPtr model = std::move(builder).build();
    EXPECT_LT(model->reach(), 1.2);
    for (int step = 0; step < 20; ++step) {
        const double c = std::cos(0.15 * step), s = std::sin(0.15 * step);
        const glm::dmat4x3 matrix(glm::dvec3(c, 0, s), glm::dvec3(0, 1, 0), glm::dvec3(-s, 0, c),
                                  glm::dvec3(0.0));
        const Aabb box = InstanceGroup({place(model, matrix)}, 1).bounds();
        const double wide = model->bounds.hi[0] - model->bounds.lo[0];
        EXPECT_LT(box.hi[0] - box.lo[0], 1.25 * wide) << step;
    }
    // Nested, and with a part that reaches into a corner, the box counts.
    ModelBuilder outer;
    outer.children = {place(model, glm::dmat4x3(1.0))};
    EXPECT_EQ(std::move(outer).build()->reach(), kReachesCorners);
    ModelBuilder cornered;
    cornered.triangles = test::bumpySphere(300);
    cornered.triangles.push_back({{1.2f, 1.2f, 1.2f}, {1.2f, 1.2f, 1.1f}, {1.2f, 1.1f, 1.2f}});
    EXPECT_EQ(std::move(cornered).build()->reach(), kReachesCorners);
}

TEST(InstanceGroupTest, TreesForOneFrameHoldTheSameInstances) {
    RandomMatrices random;
    const ModelPtr model = unitModel(), empty = ModelBuilder().build();
    for (const int count : {1, 2, 300, 5000}) {
        for (const int holes : {0, 3, count}) {
            std::vector<Instance> instances;
            for (int i = 0; i < count; ++i) {
                const bool isHole = holes == count ? i > 0 : holes && i % holes == 1;
                instances.push_back(place(isHole ? empty : model, random.matrix(2)));
            }
            const InstanceGroup lasting(instances, 2);
            const InstanceGroup frame(instances, 2, GroupLife::OneFrame);
            const auto inTree = [](const InstanceGroup& group) {
                return std::multiset<uint32_t>(group.tree().prims.begin(),
                                               group.tree().prims.end());
            };
            EXPECT_EQ(inTree(frame), inTree(lasting));
            for (int k = 0; k < 3; ++k) {
                EXPECT_EQ(frame.bounds().lo[k], lasting.bounds().lo[k]);
                EXPECT_EQ(frame.bounds().hi[k], lasting.bounds().hi[k]);
            }
        }
    }
}

TEST(InstanceGroupTest, BoxesStayFiniteWhereTheTransformOverflows) {
    const ModelPtr model = makeModel({{-1, -1, -1}, {1, 1, 1}, {-1, 1, 1}});
    for (const double scale : {1e39, 1e200, 1e300}) {
        const InstanceGroup group({place(model, glm::dmat4x3(scale))}, 1);
        const Aabb box = group.bounds();
        for (int k = 0; k < 3; ++k) {
            EXPECT_EQ(box.lo[k], -std::numeric_limits<float>::max());
            EXPECT_EQ(box.hi[k], std::numeric_limits<float>::max());
        }
    }
}

TEST(InstanceGroupTest, WhatCannotBeHitKeepsItsNumberOutsideTheTree) {
    const ModelPtr good = unitModel();
    const ModelPtr empty = ModelBuilder().build();
    glm::dmat4x3 flat(1.0);
    flat[2] = {0, 0, 0};
    const InstanceGroup group(
        {place(good, flat), place(good, translation(1, 0, 0)), place(empty, glm::dmat4x3(1.0)),
         place(good, translation(kNan, 0, 0)), place(nullptr, glm::dmat4x3(1.0)),
         place(good, glm::dmat4x3(1.0))},
        1);
    EXPECT_EQ(group.dropped(), 2u);
    ASSERT_EQ(group.instances().size(), 6u);
    const std::set<uint32_t> inTree(group.tree().prims.begin(), group.tree().prims.end());
    EXPECT_EQ(inTree, (std::set<uint32_t>{1, 5}));
    for (uint32_t i = 0; i < 6; ++i) {
        EXPECT_EQ(group.instances()[i].model != nullptr, inTree.count(i) == 1);
    }
    EXPECT_EQ(group.instances()[1].model, &good->view());
    EXPECT_EQ(group.instances()[1].identity, 0u);
    EXPECT_NE(group.instances()[5].identity, 0u);
    ModelView view{};
    group.show(view);
    EXPECT_EQ(view.childCount, 6u);
    EXPECT_EQ(view.childTree.nodes, group.tree().nodes.data());
}

TEST(InstanceGroupTest, OneInstanceHasNoTree) {
    const InstanceGroup group({place(unitModel(), translation(5, 0, 0))}, 1);
    EXPECT_TRUE(group.tree().nodes.empty());
    ModelView view{};
    group.show(view);
    EXPECT_EQ(view.childCount, 1u);
    EXPECT_EQ(view.childTree.nodes, nullptr);
    EXPECT_LE(view.childTree.lo[0], 5);
    EXPECT_GE(view.childTree.hi[0], 6);
    EXPECT_EQ(view.childTree.maxAbs, group.bounds().hi[0]);
}

TEST(InstanceGroupTest, KernelsSeeNoChildWhereNoneCanBeHit) {
    const ModelPtr good = unitModel();
    const glm::dmat4x3 zero(0.0);
    for (const std::vector<Instance>& instances :
         {std::vector<Instance>{}, {place(good, zero)}, {place(good, zero), place(good, zero)}}) {
        const InstanceGroup group(instances, 1);
        EXPECT_EQ(group.dropped(), instances.size());
        EXPECT_TRUE(group.bounds().empty());
        ModelView view{};
        group.show(view);
        EXPECT_EQ(view.childCount, 0u);
        EXPECT_EQ(view.childTree.nodes, nullptr);
        EXPECT_EQ(view.childTree.maxAbs, 0);
    }
}

} // namespace
} // namespace smart
