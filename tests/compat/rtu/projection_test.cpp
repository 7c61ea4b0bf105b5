// SPDX-License-Identifier: MIT
// Projections against GLU's, by number.
#include <GL/glu.h>
#include <gtest/gtest.h>
#include <openrt/rt.h>
#include <openrt/rtu.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <random>

#include "tests/compat/rtu/calls.h"

namespace {

constexpr RTint kView[4] = {10, 20, 640, 480};

struct Projections : testing::Test {
    void SetUp() override {
        rtInit(nullptr, nullptr);
        rtMatrixMode(RT_PROJECTION);
        rtPerspective(50, 640.0 / 480, 0.5, 100);
        rtGetDoublev(RT_PROJECTION_MATRIX, proj);
        rtMatrixMode(RT_MODELVIEW);
        rtLookAt(3, 4, 5, 0, 1, 0, 0.1, 1, 0);
        rtRotated(33, 1, 2, 3);
        rtScaled(1, 2, 0.5);
        rtGetDoublev(RT_MODELVIEW_MATRIX, model);
    }
    void TearDown() override { rtExit(); }
    double proj[16], model[16];
    std::mt19937 random{1};
    double number(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    }
};

TEST_F(Projections, tenThousandPointsAreWhereGluHasThem) {
    for (int i = 0; i < 10000; ++i) {
        const double p[3] = {number(-20, 20), number(-20, 20), number(-20, 20)};
        double rt[3], gl[3];
        ASSERT_EQ(rtuProject(p[0], p[1], p[2], model, proj, kView, rt, rt + 1, rt + 2), RT_TRUE);
        ASSERT_EQ(gluProject(p[0], p[1], p[2], model, proj, kView, gl, gl + 1, gl + 2), GL_TRUE);
        for (int k = 0; k < 3; ++k)
            ASSERT_NEAR(rt[k], gl[k], 1e-9 * std::max(1.0, std::fabs(gl[k])));
    }
}

TEST_F(Projections, andComeBack) {
    for (int i = 0; i < 10000; ++i) {
        const double w[3] = {number(0, 640), number(0, 480), number(0, 1)};
        double rt[3], gl[3], there[3];
        ASSERT_TRUE(rtuUnProject(w[0], w[1], w[2], model, proj, kView, rt, rt + 1, rt + 2));
        ASSERT_TRUE(gluUnProject(w[0], w[1], w[2], model, proj, kView, gl, gl + 1, gl + 2));
        ASSERT_TRUE(rtuProject(rt[0], rt[1], rt[2], model, proj, kView, there, there + 1,
                               there + 2));
        for (int k = 0; k < 3; ++k) {
            ASSERT_NEAR(rt[k], gl[k], 1e-9 * std::max(1.0, std::fabs(gl[k])));
            ASSERT_NEAR(there[k], w[k], 1e-8);
        }
        double rt4[4], gl4[4];
        const double clipW = number(0.5, 2);
        ASSERT_TRUE(rtuUnProject4(w[0], w[1], w[2], clipW, model, proj, kView, 0.1, 0.9, rt4,
                                  rt4 + 1, rt4 + 2, rt4 + 3));
        ASSERT_TRUE(gluUnProject4(w[0], w[1], w[2], clipW, model, proj, kView, 0.1, 0.9, gl4,
                                  gl4 + 1, gl4 + 2, gl4 + 3));
        for (int k = 0; k < 4; ++k)
            ASSERT_NEAR(rt4[k], gl4[k], 1e-9 * std::max(1.0, std::fabs(gl4[k])));
    }
}

TEST_F(Projections, pickRaysLeadFromTheNearPlaneThroughThePixel) {
    for (int i = 0; i < 1000; ++i) {
        const double x = number(10, 650), y = number(20, 500);
        float origin[3], direction[3];
        ASSERT_TRUE(rtuPickRay(x, y, model, proj, kView, origin, direction));
        double nearPoint[3], farPoint[3];
        gluUnProject(x, y, 0, model, proj, kView, nearPoint, nearPoint + 1, nearPoint + 2);
        gluUnProject(x, y, 1, model, proj, kView, farPoint, farPoint + 1, farPoint + 2);
        double length = 0, dot = 0, squares = 0;
        for (int k = 0; k < 3; ++k) {
            EXPECT_NEAR(origin[k], nearPoint[k], 1e-5);
            const double way = farPoint[k] - nearPoint[k];
            length += way * way;
            dot += way * double(direction[k]);
            squares += double(direction[k]) * double(direction[k]);
        }
        EXPECT_NEAR(dot / std::sqrt(length), 1, 1e-6);
        EXPECT_NEAR(squares, 1, 1e-6);
    }
}

TEST_F(Projections, pickRaysAimForwardsWithAFarPlaneAtInfinity) {
    const double endless[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, -1, 0, 0, -0.2, 0};
    const double identity[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    float origin[3], direction[3];
    ASSERT_TRUE(rtuPickRay(10 + 320, 20 + 240, identity, endless, kView, origin, direction));
    EXPECT_NEAR(origin[2], -0.1, 1e-6);
    EXPECT_NEAR(direction[2], -1, 1e-6);
}

TEST_F(Projections, matricesWithoutInverseAreToldAndChangeNothing) {
    const double flat[16] = {1, 0, 0, 0, 0, 1};
    double x = 7, y = 8, z = 9;
    float origin[3] = {1, 2, 3}, direction[3] = {4, 5, 6};
    EXPECT_EQ(rtuUnProject(1, 1, 0.5, flat, proj, kView, &x, &y, &z), RT_FALSE);
    EXPECT_EQ(rtuProject(1, 1, 1, flat, flat, kView, &x, &y, &z), RT_FALSE);
    EXPECT_EQ(rtGetError(), RTenum(RT_NO_ERROR)) << "GLU returns its error";
    EXPECT_EQ(rtuPickRay(1, 1, flat, proj, kView, origin, direction), RT_FALSE);
    EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_VALUE));
    EXPECT_TRUE(x == 7 && y == 8 && z == 9 && origin[0] == 1 && direction[2] == 6);
    EXPECT_EQ(rtuProject(1, 1, 1, nullptr, proj, kView, &x, &y, &z), RT_FALSE);
    EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_VALUE));
    EXPECT_EQ(rtuUnProject(1, 1, 1, model, proj, nullptr, &x, &y, &z), RT_FALSE);
    EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_VALUE));
}

TEST_F(Projections, pickMatricesAreThoseOfGlu) {
    rtLoadIdentity();
    rtuPickMatrix(123, 234, 5, 7, kView);
    double rt[16];
    rtGetDoublev(RT_MODELVIEW_MATRIX, rt);
    for (int i = 0; i < 16; ++i) testing_rtu::glMatrix[i] = i % 5 == 0;
    GLint view[4];
    std::copy(std::begin(kView), std::end(kView), view);
    gluPickMatrix(123, 234, 5, 7, view);
    for (int i = 0; i < 16; ++i) EXPECT_NEAR(rt[i], testing_rtu::glMatrix[i], 1e-4) << i;

    rtuPickMatrix(123, 234, 0, 7, kView);
    rtuPickMatrix(123, 234, NAN, 7, kView);
    double after[16];
    rtGetDoublev(RT_MODELVIEW_MATRIX, after);
    EXPECT_EQ(std::memcmp(rt, after, sizeof rt), 0);
    rtuPickMatrix(1, 1, 1, 1, nullptr);
    EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_VALUE));
}

/// The current matrix after `call`, which starts from the identity.
template <class Call>
std::array<double, 16> matrixAfter(Call&& call) {
    rtLoadIdentity();
    for (int i = 0; i < 16; ++i) testing_rtu::glMatrix[i] = i % 5 == 0;
    call();
    std::array<double, 16> m;
    rtGetDoublev(RT_MODELVIEW_MATRIX, m.data());
    return m;
}
constexpr std::array<double, 16> kIdentity = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

TEST_F(Projections, perspectivesAreThoseOfGluWhateverTheNumbers) {
    for (const auto& [fovy, aspect, near, far] :
         {std::array<double, 4>{45, 1.5, 1, 100}, {45, 1, 0, 100}, {45, 1, -1, 100},
          {45, 1, 1, 0}, {45, 1, 100, 1}, {45, -1, 1, 100}, {-45, 1, 1, 100}, {190, 1, 1, 10},
          {180, 1, 1, 10}, {500, 2, -3, -7}}) {
        const auto m = matrixAfter([&] { rtuPerspective(fovy, aspect, near, far); });
        const double f = 1 / std::tan(fovy * std::acos(-1) / 360);
        const std::array<double, 16> formula = {
            f / aspect, 0, 0, 0, 0, f, 0, 0, 0, 0, (far + near) / (near - far), -1,
            0, 0, 2 * far * near / (near - far), 0};
        gluPerspective(fovy, aspect, near, far);
        for (std::size_t i = 0; i < 16; ++i) {
            EXPECT_NEAR(m[i], formula[i], 1e-12 * std::max(1.0, std::fabs(m[i])))
                << fovy << ' ' << aspect << ' ' << near << ' ' << far << ", number " << i;
            EXPECT_NEAR(m[i], testing_rtu::glMatrix[i], 1e-12 * std::max(1.0, std::fabs(m[i])));
        }
        EXPECT_EQ(rtGetError(), RTenum(RT_NO_ERROR));
    }
    EXPECT_EQ(matrixAfter([] { rtuPerspective(50, 1.25, 0.5, 90); }),
              matrixAfter([] { rtPerspective(50, 1.25, 0.5, 90); }));
}

TEST_F(Projections, perspectivesWithoutWidthHeightOrDepthDoNothing) {
    for (const auto& [fovy, aspect, near, far] :
         {std::array<double, 4>{0, 1, 1, 100}, {45, 0, 1, 100}, {45, 1, 5, 5}, {45, 1, 0, 0}}) {
        const auto m = matrixAfter([&] { rtuPerspective(fovy, aspect, near, far); });
        gluPerspective(fovy, aspect, near, far);
        EXPECT_EQ(m, kIdentity);
        for (std::size_t i = 0; i < 16; ++i) EXPECT_EQ(testing_rtu::glMatrix[i], kIdentity[i]);
        EXPECT_EQ(rtGetError(), RTenum(RT_NO_ERROR));
    }
    EXPECT_EQ(matrixAfter([] { rtuPerspective(-720, 1, 1, 100); }), kIdentity);
    EXPECT_EQ(rtGetError(), RTenum(RT_NO_ERROR));
}

TEST_F(Projections, camerasLookAsInGluWhateverTheNumbers) {
    const auto compare = [](const std::array<double, 9>& a) {
        const auto m = matrixAfter(
            [&] { rtuLookAt(a[0], a[1], a[2], a[3], a[4], a[5], a[6], a[7], a[8]); });
        gluLookAt(a[0], a[1], a[2], a[3], a[4], a[5], a[6], a[7], a[8]);
        for (std::size_t i = 0; i < 16; ++i) // GLU counts in single precision
            EXPECT_NEAR(m[i], testing_rtu::glMatrix[i], 3e-6 * std::max(1.0, std::fabs(m[i])))
                << a[0] << ' ' << a[1] << ' ' << a[2] << ", number " << i;
        EXPECT_EQ(rtGetError(), RTenum(RT_NO_ERROR));
        return m;
    };
    compare({1, 2, 3, -2, 0.5, 1, 0.1, 1, 0.3});
    // Rows of zeros: side and upright, then all three.
    const std::array<double, 16> down = {0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, -10, 1};
    const std::array<double, 16> level = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, -5, 1};
    const std::array<double, 16> nothing = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1};
    EXPECT_EQ(compare({0, 10, 0, 0, 0, 0, 0, 1, 0}), down);
    EXPECT_EQ(compare({0, 0, 5, 0, 0, 0, 0, 0, 0}), level);
    EXPECT_EQ(compare({1, 1, 1, 1, 1, 1, 0, 1, 0}), nothing);
    EXPECT_EQ(matrixAfter([] { rtuLookAt(3, 4, 5, 0, 1, 0, 0.1, 1, 0); }),
              matrixAfter([] { rtLookAt(3, 4, 5, 0, 1, 0, 0.1, 1, 0); }));
}

TEST_F(Projections, whatIsNotFiniteIsRefused) {
    const auto refuses = [](auto call) {
        return matrixAfter(call) == kIdentity && rtGetError() == RTenum(RT_INVALID_VALUE);
    };
    EXPECT_TRUE(refuses([] { rtuPerspective(NAN, 1, 1, 2); }));
    EXPECT_TRUE(refuses([] { rtuPerspective(45, INFINITY, 1, 2); }));
    EXPECT_TRUE(refuses([] { rtuPerspective(45, 1, INFINITY, INFINITY); }));
    EXPECT_TRUE(refuses([] { rtuPerspective(45, 1, 1, -INFINITY); }));
    EXPECT_TRUE(refuses([] { rtuPerspective(45, 1, 1e200, 1e300); }));
    EXPECT_TRUE(refuses([] { rtuLookAt(NAN, 0, 0, 1, 1, 1, 0, 1, 0); }));
    EXPECT_TRUE(refuses([] { rtuLookAt(0, 0, 0, 0, INFINITY, 0, 0, 1, 0); }));
    EXPECT_TRUE(refuses([] { rtuLookAt(0, 0, 0, 0, 0, 0, 0, INFINITY, 0); }));
    EXPECT_TRUE(refuses([] { rtuLookAt(1e200, 0, 0, 0, 0, 0, 0, 1, 0); }));
}

/// A frame of a rectangle that fills the view, by the matrices of now.
std::array<uint32_t, 64> picture() {
    std::array<uint32_t, 64> pixels;
    pixels.fill(0x12345678);
    rtSetFrameBuffer(reinterpret_cast<RTubyte*>(pixels.data()), 8, 8, RT_RGBA_8);
    rtRectf(-1000, -1000, 1000, 1000);
    rtClearColor(0, 0, 0, 0);
    rtRender();
    return pixels;
}

TEST_F(Projections, framesByMatricesWithoutAnInverse) {
    constexpr std::array<uint32_t, 64> kEmpty = {};
    rtMatrixMode(RT_PROJECTION);
    rtLoadIdentity();
    rtuPerspective(60, 1, 0.5, 100);
    rtMatrixMode(RT_MODELVIEW);
    rtLoadIdentity();
    rtTranslated(0, 0, -5);
    EXPECT_NE(picture(), kEmpty) << "control";
    EXPECT_EQ(rtGetError(), RTenum(RT_NO_ERROR));
    for (const double up : {0.0, 1.0}) {
        rtLoadIdentity();
        rtuLookAt(0, 5, 0, 0, 0, 0, 0, up, 0);
        EXPECT_EQ(picture(), kEmpty);
        EXPECT_EQ(rtGetError(), RTenum(RT_NO_ERROR));
    }
    rtMatrixMode(RT_PROJECTION);
    rtLoadIdentity();
    rtuPerspective(60, 1, 0, 100);
    EXPECT_EQ(rtGetError(), RTenum(RT_NO_ERROR));
    picture();
    EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_OPERATION)) << "as rt_frame.h says of rtRender";
}

TEST_F(Projections, ortho2DIsOrthoFromMinusOneToOne) {
    double flat[16], expected[16];
    rtLoadIdentity();
    rtuOrtho2D(-3, 5, 2, 4);
    rtGetDoublev(RT_MODELVIEW_MATRIX, flat);
    rtLoadIdentity();
    rtOrtho(-3, 5, 2, 4, -1, 1);
    rtGetDoublev(RT_MODELVIEW_MATRIX, expected);
    EXPECT_EQ(std::memcmp(flat, expected, sizeof flat), 0);
}

TEST(Strings, areThere) {
    EXPECT_STREQ(reinterpret_cast<const char*>(rtuErrorString(RT_STACK_OVERFLOW)),
                 "stack overflow");
    for (const RTenum error : {RTenum(RT_NO_ERROR), RTenum(RT_INVALID_ENUM),
                               RTenum(RT_INVALID_VALUE), RTenum(RT_INVALID_OPERATION),
                               RTenum(RT_STACK_UNDERFLOW), RTenum(RT_OUT_OF_MEMORY),
                               RTenum(RTU_INVALID_ENUM), RTenum(RTU_INVALID_VALUE),
                               RTenum(RTU_TESS_NEED_COMBINE_CALLBACK)})
        EXPECT_NE(rtuErrorString(error), nullptr) << error;
    EXPECT_EQ(rtuErrorString(4711), nullptr);
    EXPECT_STREQ(reinterpret_cast<const char*>(rtuGetString(RTU_VERSION)), "1.3");
    EXPECT_EQ(rtuGetString(0), nullptr);
    const auto check = [](const char* name, const char* list) {
        return rtuCheckExtension(reinterpret_cast<const RTubyte*>(name),
                                 reinterpret_cast<const RTubyte*>(list));
    };
    EXPECT_TRUE(check("b", "a b c"));
    EXPECT_TRUE(check("c", "a b c"));
    EXPECT_FALSE(check("b", "ab bc"));
    EXPECT_FALSE(check("", "a  b"));
    EXPECT_FALSE(check(nullptr, "a"));
    EXPECT_FALSE(check("a", nullptr));
}

} // namespace
