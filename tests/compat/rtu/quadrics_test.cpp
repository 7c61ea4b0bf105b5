// SPDX-License-Identifier: MIT
// Quadrics against GLU itself: the same calls with the same numbers in the same order.
#include <GL/glu.h>
#include <gtest/gtest.h>
#include <openrt/rt.h>
#include <openrt/rtu.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <tuple>

#include "tests/compat/rtu/calls.h"

using namespace testing_rtu;

namespace {

struct Styled : testing::TestWithParam<std::tuple<int, int, int, int>> {
    void SetUp() override {
        rtInit(nullptr, nullptr);
        const auto [style, normals, orientation, texture] = GetParam();
        rtuQuadricDrawStyle(rt, RTU_POINT + unsigned(style));
        gluQuadricDrawStyle(gl, GLU_POINT + unsigned(style));
        rtuQuadricNormals(rt, RTU_SMOOTH + unsigned(normals));
        gluQuadricNormals(gl, GLU_SMOOTH + unsigned(normals));
        rtuQuadricOrientation(rt, RTU_OUTSIDE + unsigned(orientation));
        gluQuadricOrientation(gl, GLU_OUTSIDE + unsigned(orientation));
        rtuQuadricTexture(rt, RTboolean(texture));
        gluQuadricTexture(gl, GLboolean(texture));
        glCalls.clear();
        rtCalls.clear();
    }
    void TearDown() override {
        rtuDeleteQuadric(rt);
        gluDeleteQuadric(gl);
        rtExit();
    }
    /// GLU reads numbers that it never wrote for flat normals of points and of some outlines.
    bool gluIsDefined() const {
        const auto [style, normals, orientation, texture] = GetParam();
        return normals != 1 || style == 1 || style == 2;
    }

    RTUquadric* rt = rtuNewQuadric();
    GLUquadric* gl = gluNewQuadric();
};

/// "" or the first difference.
std::string difference(const std::vector<Call>& expected, const std::vector<Call>& found,
                       bool compareNormals) {
    if (expected.size() != found.size())
        return std::to_string(expected.size()) + " calls, not " + std::to_string(found.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        if (expected[i].kind != found[i].kind) return "another call at " + std::to_string(i);
        if (expected[i].kind == Call::Normal && !compareNormals) continue;
        for (int k = 0; k < 3; ++k)
            if (!(std::fabs(expected[i].values[k] - found[i].values[k]) < 3e-6f))
                return "call " + std::to_string(i) + ", number " + std::to_string(k) + ": " +
                       std::to_string(expected[i].values[k]) + " and " +
                       std::to_string(found[i].values[k]);
    }
    return {};
}

TEST_P(Styled, spheresAreThoseOfGlu) {
    for (const auto& [slices, stacks] : {std::pair(2, 1), {3, 2}, {7, 5}, {16, 12}}) {
        rtuSphere(rt, 1.5, slices, stacks);
        gluSphere(gl, 1.5, slices, stacks);
    }
    ASSERT_FALSE(glCalls.empty());
    EXPECT_EQ(difference(glCalls, rtCalls, gluIsDefined()), "");
}

TEST_P(Styled, cylindersAreThoseOfGlu) {
    for (const auto& [base, top] : {std::pair(1.0, 2.0), {1.0, 0.0}, {0.5, 0.5}}) {
        rtuCylinder(rt, base, top, 3, 5, 4);
        gluCylinder(gl, base, top, 3, 5, 4);
    }
    ASSERT_FALSE(glCalls.empty());
    EXPECT_EQ(difference(glCalls, rtCalls, gluIsDefined()), "");
}

TEST_P(Styled, disksAreThoseOfGlu) {
    for (const auto& [inner, outer] : {std::pair(0.0, 2.0), {1.0, 2.0}, {2.0, 2.0}})
        for (const int loops : {1, 3}) {
            rtuDisk(rt, inner, outer, 6, loops);
            gluDisk(gl, inner, outer, 6, loops);
            for (const double sweep : {100.0, -90.0, 400.0, 360.0, -360.0}) {
                rtuPartialDisk(rt, inner, outer, 5, loops, 30, sweep);
                gluPartialDisk(gl, inner, outer, 5, loops, 30, sweep);
            }
        }
    ASSERT_FALSE(glCalls.empty());
    EXPECT_EQ(difference(glCalls, rtCalls, true), "");
}

TEST_P(Styled, aDifferenceIsSeen) {
    rtuSphere(rt, 1.5, 8, 6);
    gluSphere(gl, 1.5001, 8, 6);
    EXPECT_NE(difference(glCalls, rtCalls, false), "");
}

INSTANTIATE_TEST_SUITE_P(Quadrics, Styled,
                         testing::Combine(testing::Range(0, 4), testing::Range(0, 3),
                                          testing::Range(0, 2), testing::Range(0, 2)));

struct Quadrics : testing::Test {
    void SetUp() override {
        rtInit(nullptr, nullptr);
        quad = rtuNewQuadric();
        rtCalls.clear();
        glCalls.clear();
        lastError = 0;
    }
    void TearDown() override {
        rtuDeleteQuadric(quad);
        rtExit();
    }
    RTUquadric* quad = nullptr;
    static RTenum lastError;
};
RTenum Quadrics::lastError = 0;

TEST_F(Quadrics, manySlicesAreClampedAsInGlu) {
    GLUquadric* gl = gluNewQuadric();
    rtuSphere(quad, 1, 300, 3);
    gluSphere(gl, 1, 300, 3);
    rtuCylinder(quad, 1, 1, 1, 1000, 2);
    gluCylinder(gl, 1, 1, 1, 1000, 2);
    gluDeleteQuadric(gl);
    EXPECT_EQ(difference(glCalls, rtCalls, true), "");
}

TEST_F(Quadrics, wrongMeasuresDrawNothingAndAreReported) {
    rtuQuadricCallback(quad, RTU_ERROR,
                       reinterpret_cast<RTUfuncptr>(+[](RTenum error) { lastError = error; }));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    const auto isRefused = [&](auto&& call) {
        lastError = 0;
        call();
        return lastError == RTU_INVALID_VALUE && rtGetError() == RT_INVALID_VALUE &&
               rtCalls.empty();
    };
    for (const double wrong : {nan, infinity, -1.0}) {
        EXPECT_TRUE(isRefused([&] { rtuSphere(quad, wrong, 8, 8); }));
        EXPECT_TRUE(isRefused([&] { rtuCylinder(quad, wrong, 1, 1, 8, 8); }));
        EXPECT_TRUE(isRefused([&] { rtuCylinder(quad, 1, wrong, 1, 8, 8); }));
        EXPECT_TRUE(isRefused([&] { rtuCylinder(quad, 1, 1, wrong, 8, 8); }));
        EXPECT_TRUE(isRefused([&] { rtuDisk(quad, 0, wrong, 8, 8); }));
        EXPECT_TRUE(isRefused([&] { rtuDisk(quad, wrong, 1, 8, 8); }));
    }
    for (const int wrong : {1, 0, -5, std::numeric_limits<int>::min()}) {
        EXPECT_TRUE(isRefused([&] { rtuSphere(quad, 1, wrong, 8); }));
        EXPECT_TRUE(isRefused([&] { rtuCylinder(quad, 1, 1, 1, wrong, 8); }));
        EXPECT_TRUE(isRefused([&] { rtuDisk(quad, 0, 1, wrong, 8); }));
    }
    for (const int wrong : {0, -5, std::numeric_limits<int>::max()}) {
        EXPECT_TRUE(isRefused([&] { rtuSphere(quad, 1, 8, wrong); }));
        EXPECT_TRUE(isRefused([&] { rtuCylinder(quad, 1, 1, 1, 8, wrong); }));
        EXPECT_TRUE(isRefused([&] { rtuDisk(quad, 0, 1, 8, wrong); }));
    }
    EXPECT_TRUE(isRefused([&] { rtuDisk(quad, 2, 1, 8, 8); }));
    EXPECT_TRUE(isRefused([&] { rtuPartialDisk(quad, 0, 1, 8, 8, nan, 90); }));
    EXPECT_TRUE(isRefused([&] { rtuPartialDisk(quad, 0, 1, 8, 8, 0, infinity); }));
    EXPECT_FALSE(isRefused([&] { rtuSphere(quad, 1, 8, 8); })) << "control";
}

TEST_F(Quadrics, exceptionsOfCallbacksStayInside) {
    rtuQuadricCallback(quad, RTU_ERROR, reinterpret_cast<RTUfuncptr>(+[](RTenum error) {
                           lastError = error;
                           throw std::runtime_error("of a callback");
                       }));
    EXPECT_NO_THROW(rtuSphere(quad, -1, 8, 8));
    EXPECT_EQ(lastError, RTenum(RTU_INVALID_VALUE));
    EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_VALUE));
    EXPECT_NO_THROW(rtuQuadricNormals(quad, 0));
    EXPECT_EQ(lastError, RTenum(RTU_INVALID_ENUM));
    EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_ENUM));
}

TEST_F(Quadrics, unknownStylesChangeNothing) {
    rtuQuadricDrawStyle(quad, 12345);
    EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_ENUM));
    rtuQuadricNormals(quad, 0);
    EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_ENUM));
    rtuQuadricOrientation(quad, RTU_FILL);
    EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_ENUM));
    rtuQuadricCallback(quad, RTU_TESS_BEGIN, nullptr);
    EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_ENUM));
    rtuSphere(nullptr, 1, 8, 8);
    EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_VALUE));
    GLUquadric* gl = gluNewQuadric();
    rtuSphere(quad, 1, 8, 8);
    gluSphere(gl, 1, 8, 8);
    gluDeleteQuadric(gl);
    EXPECT_EQ(difference(glCalls, rtCalls, true), "");
}

} // namespace
