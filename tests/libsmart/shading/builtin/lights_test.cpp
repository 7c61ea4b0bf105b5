// SPDX-License-Identifier: MIT
// Lights without extent and environments against their formulas.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "openrt/shader.hpp"
#include "tests/libsmart/shading/fake_tracer.h"

namespace smart {
namespace {

using openrt::Color;
using openrt::Vec3;
using test::FakeTracer;
using test::MadeShader;

constexpr double kPi = 3.14159265358979323846;

int illuminate(const ShaderObject& light, const Vec3& at, RTSlightsample& sample) {
    const float position[3] = {at.x, at.y, at.z};
    sample = {};
    return light.functions().illuminate(light.block(), position, &sample);
}

TEST(LightsTest, PointAndSpotLightsFallOffWithTheSquare) {
    for (const char* name : {"PointLight", "SpotLightShader", "PunctualLight"}) {
        const auto light = MadeShader(name)
                               .set("position", Vec3(1, 2, 3))
                               .set("radiance", Color(25, 50, 100))
                               .make();
        RTSlightsample s;
        ASSERT_EQ(illuminate(*light, Vec3(1, 5, 7), s), 1);
        EXPECT_FLOAT_EQ(s.direction[1], -0.6f);
        EXPECT_FLOAT_EQ(s.direction[2], -0.8f);
        EXPECT_EQ(s.distance, 5);
        EXPECT_EQ(s.radiance[0], 1);
        EXPECT_EQ(s.radiance[2], 4);
    }
}

TEST(LightsTest, ALightAtThePointGivesNothing) {
    for (const char* name : {"PointLight", "SpotLightShader", "PunctualLight"}) {
        const auto light = MadeShader(name).set("position", Vec3(1, 2, 3)).make();
        RTSlightsample s;
        EXPECT_EQ(illuminate(*light, Vec3(1, 2, 3), s), 0);
        // Nor so close that the radiance overflows.
        const auto origin = MadeShader(name).make();
        EXPECT_EQ(illuminate(*origin, Vec3(1e-30f, 0, 0), s), 0);
        ASSERT_EQ(illuminate(*origin, Vec3(1e-18f, 0, 0), s), 1);
        EXPECT_TRUE(std::isfinite(s.radiance[0]));
        EXPECT_EQ(s.direction[0], -1);
        ASSERT_EQ(illuminate(*origin, Vec3(1e30f, 0, 0), s), 1);
        EXPECT_EQ(s.direction[0], -1);
        EXPECT_EQ(s.radiance[0], 0);
    }
}

TEST(LightsTest, TheConeOfASpotLight) {
    const auto at = [](double degrees) {
        return Vec3(float(std::sin(degrees * kPi / 180)), 0, float(-std::cos(degrees * kPi / 180)));
    };
    const auto light = MadeShader("SpotLightShader")
                           .set("direction", Vec3(0, 0, -7))
                           .set("cutoff", 30.0f)
                           .set("exponent", 3.0f)
                           .make();
    RTSlightsample s;
    for (const double angle : {0.0, 10.0, 29.9}) {
        ASSERT_EQ(illuminate(*light, at(angle), s), 1) << angle;
        EXPECT_NEAR(s.radiance[0], std::pow(std::cos(angle * kPi / 180), 3), 1e-5) << angle;
    }
    for (const double angle : {30.1, 90.0, 180.0})
        EXPECT_EQ(illuminate(*light, at(angle), s), 0) << angle;
    const auto open = MadeShader("SpotLightShader").make();
    EXPECT_EQ(illuminate(*open, at(170), s), 1);
}

/// The formulas of KHR_lights_punctual.
TEST(LightsTest, TheRangeAndTheRimOfAPunctualLight) {
    const double range = 5, outer = 40, inner = 25;
    const auto light = MadeShader("PunctualLight")
                           .set("direction", Vec3(0, 0, -7))
                           .set("range", float(range))
                           .set("cutoff", float(outer))
                           .set("innerCutoff", float(inner))
                           .make();
    const auto cosine = [](double degrees) { return std::cos(degrees * kPi / 180); };
    for (const double distance : {0.5, 2.0, 4.9, 5.1}) {
        for (const double angle : {0.0, 24.0, 26.0, 33.0, 39.9, 40.1, 120.0}) {
            const double rim = std::clamp(
                (cosine(angle) - cosine(outer)) / (cosine(inner) - cosine(outer)), 0.0, 1.0);
            const double expected = std::max(1 - std::pow(distance / range, 4), 0.0) * rim * rim /
                                    (distance * distance);
            const Vec3 at(float(distance * std::sin(angle * kPi / 180)), 0,
                          float(-distance * cosine(angle)));
            RTSlightsample s;
            ASSERT_EQ(illuminate(*light, at, s), expected > 0) << distance << ' ' << angle;
            if (expected > 0) {
                EXPECT_NEAR(s.radiance[0], expected, 2e-6 * (1 + 1 / (distance * distance)))
                    << distance << ' ' << angle;
            }
        }
    }
}

TEST(LightsTest, DirectionalLightsAreTheSameEverywhere) {
    const auto light = MadeShader("DirectionalLight")
                           .set("direction", Vec3(0, -3, 4))
                           .set("radiance", Color(1, 2, 3))
                           .make();
    RTSlightsample s;
    for (const Vec3& at : {Vec3(), Vec3(1e9f, 0, 0)}) {
        ASSERT_EQ(illuminate(*light, at, s), 1);
        EXPECT_FLOAT_EQ(s.direction[1], 0.6f);
        EXPECT_FLOAT_EQ(s.direction[2], -0.8f);
        EXPECT_EQ(s.distance, std::numeric_limits<float>::infinity());
        EXPECT_EQ(s.radiance[1], 2);
    }
    const auto nowhere = MadeShader("DirectionalLight").set("direction", Vec3()).make();
    EXPECT_EQ(illuminate(*nowhere, {}, s), 0);
}

TEST(EnvironmentsTest, ConstantIsTheSameInAllDirections) {
    FakeTracer tracer;
    const auto sky = MadeShader("ConstantEnvironment").set("radiance", Color(1, 2, 3)).make();
    EXPECT_EQ(tracer.shade(*sky), (std::array<float, 4>{1, 2, 3, 1}));
}

/// Where the image environment looks: a function table whose texture answers with (s, t).
std::array<float, 2> lookedUp(const ShaderObject& sky, const Vec3& direction) {
    RTSfunctions functions = {};
    functions.structSize = sizeof(functions);
    functions.texture = [](RTSstate*, RTuint, float s, float t, float rgba[4]) {
        rgba[0] = s;
        rgba[1] = t;
        rgba[2] = rgba[3] = 1;
    };
    RTSstate state{};
    state.functions = &functions;
    const float d[3] = {direction.x, direction.y, direction.z};
    std::copy_n(d, 3, state.rayDirection);
    EXPECT_EQ(sky.functions().shade(sky.block(), &state), 0);
    return {state.result[0], state.result[1]};
}

TEST(EnvironmentsTest, ImagesAreLatitudeAndLongitude) {
    const auto sky = MadeShader("ImageEnvironment").set("texture", 1).make();
    const auto expectAt = [&](const ShaderObject& e, const Vec3& d, float s, float t) {
        const auto [gotS, gotT] = lookedUp(e, d);
        EXPECT_NEAR(gotS - std::floor(gotS), s, 1e-6f);
        EXPECT_NEAR(gotT, t, 1e-6f);
    };
    expectAt(*sky, {0, 0, -1}, 0.5f, 0.5f);
    expectAt(*sky, {1, 0, 0}, 0.75f, 0.5f);
    expectAt(*sky, {-1, 0, 0}, 0.25f, 0.5f);
    expectAt(*sky, {0, 0.6f, -0.8f}, 0.5f, float(0.5 + std::asin(0.6) / kPi));
    EXPECT_EQ(lookedUp(*sky, {0, 1, 0})[1], 1);
    EXPECT_EQ(lookedUp(*sky, {0, -1, 0})[1], 0);
    EXPECT_EQ(lookedUp(*sky, {0, std::nextafter(1.0f, 2.0f), 0})[1], 1); // rounding: no NaN
    // Turned anticlockwise by 90 degrees, what was ahead is at the left.
    const auto turned = MadeShader("ImageEnvironment").set("rotation", 90.0f).make();
    expectAt(*turned, {-1, 0, 0}, 0.5f, 0.5f);
}

} // namespace
} // namespace smart
