// SPDX-License-Identifier: MIT
#include "compat/recorder/transforms.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <random>

#include "libsmart/base/error.h"

namespace smart::compat {
namespace {

constexpr long double kPi = 3.14159265358979323846264338327950288L;
constexpr double kInf = std::numeric_limits<double>::infinity();

/// Largest difference of elements, relative to the largest element.
double difference(const glm::dmat4& a, const glm::dmat4& b) {
    double most = 0, scale = 0;
    for (int i = 0; i < 16; ++i) {
        most = std::max(most, std::fabs(a[i / 4][i % 4] - b[i / 4][i % 4]));
        scale = std::max(scale, std::fabs(b[i / 4][i % 4]));
    }
    return most / scale;
}

glm::dvec3 project(const glm::dmat4& m, const glm::dvec3& p) {
    const glm::dvec4 q = m * glm::dvec4(p, 1.0);
    return glm::dvec3(q) / q.w;
}

void expectNear(const glm::dvec3& a, const glm::dvec3& b, double tolerance) {
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], tolerance);
}

TEST(SinCosDegrees, AgreesWithExtendedPrecision) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> angles(-1000, 1000);
    for (int i = 0; i < 100000; ++i) {
        const double degrees = angles(random);
        const long double radians = std::fmod((long double)degrees, 360.0L) * kPi / 180.0L;
        const SinCos found = sinCosDegrees(degrees);
        ASSERT_NEAR(found.sin, double(std::sin(radians)), 2.5e-16) << degrees;
        ASSERT_NEAR(found.cos, double(std::cos(radians)), 2.5e-16) << degrees;
    }
}

TEST(SinCosDegrees, IsExactAtQuarterTurns) {
    for (int quarter = -40; quarter <= 40; ++quarter) {
        const SinCos found = sinCosDegrees(90.0 * quarter);
        const int q = ((quarter % 4) + 4) % 4;
        EXPECT_EQ(found.sin, q == 1 ? 1 : q == 3 ? -1 : 0);
        EXPECT_EQ(found.cos, q == 0 ? 1 : q == 2 ? -1 : 0);
    }
    EXPECT_EQ(sinCosDegrees(90.0 * (1ll << 40)).sin, 0);
    EXPECT_TRUE(std::isnan(sinCosDegrees(kInf).sin));
}

TEST(Rotation, TurnsAnticlockwiseAboutTheAxis) {
    expectNear(project(makeRotation(90, {0, 0, 5}), {1, 0, 0}), {0, 1, 0}, 0);
    expectNear(project(makeRotation(90, {2, 0, 0}), {0, 1, 0}), {0, 0, 1}, 0);
    expectNear(project(makeRotation(90, {0, 3, 0}), {0, 0, 1}), {1, 0, 0}, 0);
    EXPECT_EQ(difference(makeRotation(77, {0, 0, 0}), glm::dmat4(1.0)), 0);
}

// Rodrigues' formula on vectors.
TEST(Rotation, AgreesWithTheVectorFormula) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 axis(unit(random), unit(random), unit(random));
        const glm::dvec3 v(unit(random), unit(random), unit(random));
        const double degrees = 400 * unit(random), radians = degrees * double(kPi) / 180;
        const glm::dvec3 a = axis / glm::length(axis);
        const glm::dvec3 expected = v * std::cos(radians) + glm::cross(a, v) * std::sin(radians) +
                                    a * glm::dot(a, v) * (1 - std::cos(radians));
        expectNear(project(makeRotation(degrees, axis), v), expected, 1e-14);
    }
}

TEST(Projections, MapTheirCornersToTheCube) {
    const glm::dmat4 frustum = makeFrustum(-1, 3, -2, 1, 2, 50);
    expectNear(project(frustum, {-1, -2, -2}), {-1, -1, -1}, 1e-14);
    expectNear(project(frustum, {3, 1, -2}), {1, 1, -1}, 1e-14);
    expectNear(project(frustum, {-1 * 25, 1 * 25, -50}), {-1, 1, 1}, 1e-13);
    const glm::dmat4 ortho = makeOrtho(-1, 3, -2, 1, -4, 50);
    expectNear(project(ortho, {-1, -2, 4}), {-1, -1, -1}, 1e-14);
    expectNear(project(ortho, {3, 1, -50}), {1, 1, 1}, 1e-14);
    // A control: the two are not the same.
    EXPECT_GT(difference(frustum, ortho), 0.1);
}

TEST(Projections, PerspectiveIsAFrustum) {
    const double top = std::tan(double(kPi) / 6) * 0.5, right = top * 1.5;
    EXPECT_LT(difference(makePerspective(60, 1.5, 0.5, 90),
                         makeFrustum(-right, right, -top, top, 0.5, 90)),
              1e-15);
}

TEST(Projections, RefuseWhatOpenGlRefuses) {
    const auto refuses = [](auto&& make) {
        try {
            make();
            return false;
        } catch (const Error& error) {
            return error.code() == ErrorCode::InvalidValue;
        }
    };
    EXPECT_TRUE(refuses([] { makeFrustum(1, 1, 0, 1, 1, 2); }));
    EXPECT_TRUE(refuses([] { makeFrustum(0, 1, 2, 2, 1, 2); }));
    EXPECT_TRUE(refuses([] { makeFrustum(0, 1, 0, 1, 2, 2); }));
    EXPECT_TRUE(refuses([] { makeFrustum(0, 1, 0, 1, 0, 2); }));
    EXPECT_TRUE(refuses([] { makeFrustum(0, 1, 0, 1, 1, -2); }));
    EXPECT_TRUE(refuses([] { makeFrustum(0, kInf, 0, 1, 1, 2); }));
    EXPECT_TRUE(refuses([] { makeFrustum(0, 1e-320, 0, 1, 1, 2); }));
    EXPECT_TRUE(refuses([] { makeOrtho(0, 1, 0, 1, 3, 3); }));
    EXPECT_TRUE(refuses([] { makePerspective(0, 1, 1, 2); }));
    EXPECT_TRUE(refuses([] { makePerspective(60, -1, 1, 2); }));
    EXPECT_TRUE(refuses([] { makePerspective(60, 0, 1, 2); }));
    EXPECT_TRUE(refuses([] { makePerspective(60, 1, 0, 2); }));
    EXPECT_TRUE(refuses([] { makePerspective(60, 1, 1, 0); }));
    EXPECT_TRUE(refuses([] { makePerspective(60, 1, 2, 2); }));
    EXPECT_TRUE(refuses([] { makeFrustum(0, 1, 0, 1, 0, 2); }));
    EXPECT_TRUE(refuses([] { makeFrustum(0, 1, 0, 1, 1, 0); }));
    EXPECT_TRUE(refuses([] { makeLookAt({0, 0, 0}, {0, 0, 0}, {0, 1, 0}); }));
    EXPECT_TRUE(refuses([] { makeLookAt({0, 0, 0}, {0, 2, 0}, {0, 1, 0}); }));
    EXPECT_TRUE(refuses([] { makeLookAt({0, 0, 0}, {kInf, 2, 0}, {0, 1, 0}); }));
    EXPECT_FALSE(refuses([] { makeOrtho(1, 0, 1, 0, 1, 0); })) << "reversed is legal";
    EXPECT_FALSE(refuses([] { makeFrustum(0, 1, 0, 1, 3, 2); }));
    EXPECT_FALSE(refuses([] { makePerspective(60, 1, 3, 2); }));
}

TEST(LookAt, PutsTheEyeAtTheOriginAndTheCentreAhead) {
    const glm::dvec3 eye(3, -2, 7), center(-1, 4, 2), up(0.1, 0.9, -0.3);
    const glm::dmat4 m = makeLookAt(eye, center, up);
    expectNear(project(m, eye), {0, 0, 0}, 1e-14);
    expectNear(project(m, center), {0, 0, -glm::length(center - eye)}, 1e-14);
    const glm::dvec3 above = project(m, center + up);
    EXPECT_NEAR(above.x, 0, 1e-14);
    EXPECT_GT(above.y, 0);
    EXPECT_NEAR(glm::determinant(m), 1, 1e-14); // no scaling, no mirroring
}

TEST(NormalMatrix, KeepsNormalsPerpendicular) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (int i = 0; i < 1000; ++i) {
        glm::dmat4 m(1.0);
        for (int k = 0; k < 12; ++k) m[k / 3][k % 3] = unit(random);
        const glm::dvec3 a(unit(random), unit(random), unit(random));
        const glm::dvec3 b(unit(random), unit(random), unit(random));
        const glm::dvec3 normal = makeNormalMatrix(m) * glm::cross(a, b);
        const glm::dvec3 ta = glm::dmat3(m) * a, tb = glm::dmat3(m) * b;
        EXPECT_NEAR(glm::dot(normal, ta) / glm::length(normal) / glm::length(ta), 0, 1e-10);
        EXPECT_NEAR(glm::dot(normal, tb) / glm::length(normal) / glm::length(tb), 0, 1e-10);
        // n . v does not change when both are transformed: so it is the inverse transpose itself.
        const glm::dvec3 n(unit(random), unit(random), unit(random));
        EXPECT_NEAR(glm::dot(makeNormalMatrix(m) * n, ta), glm::dot(n, a), 1e-9);
    }
    // Flattened to a plane: the normal of the plane.
    const glm::dvec3 flat = makeNormalMatrix(makeScaling({1, 1, 0})) * glm::dvec3(0.5, 0.5, 1);
    expectNear(flat, {0, 0, 1}, 0);
}

TEST(Affine, DropsTheLastRow) {
    const glm::dmat4x3 plain = makeAffine(makeTranslation({1, 2, 3}));
    expectNear(plain[3], {1, 2, 3}, 0);
    expectNear(makeAffine(makeTranslation({2, 4, 6}) * 2.0)[3], {2, 4, 6}, 0);
    EXPECT_THROW(makeAffine(makeFrustum(-1, 1, -1, 1, 1, 2)), Error);
    EXPECT_EQ(makeAffine(glm::dmat4(0.0))[0][0], 0);
    glm::dmat4 broken(1.0);
    broken[0][3] = kInf;
    EXPECT_TRUE(std::isnan(makeAffine(broken)[0][0]));
}

TEST(Invert, RefusesSingularAndInfinite) {
    glm::dmat4 inverse(0.0);
    const glm::dmat4 m = makeFrustum(-1, 2, -1, 1, 1, 5) * makeRotation(30, {1, 2, 3});
    ASSERT_TRUE(invert(m, inverse));
    EXPECT_LT(difference(m * inverse, glm::dmat4(1.0)), 1e-14);
    EXPECT_FALSE(invert(makeScaling({1, 0, 1}), inverse));
    EXPECT_FALSE(invert(makeScaling({1, kInf, 1}), inverse));
    EXPECT_FALSE(invert(makeScaling({1e-200, 1e-200, 1}), inverse)) << "its inverse overflows";
}

} // namespace
} // namespace smart::compat
