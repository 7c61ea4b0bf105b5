// SPDX-License-Identifier: MIT
// Ambient occlusion among planes, whose share of the sky is known.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "openrt/shader.hpp"
#include "tests/libsmart/shading/fake_tracer.h"

namespace smart {
namespace {

using test::MadeShader;

constexpr double kPi = 3.14159265358979323846;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// Walls that shadow rays from (x, 0, 0) on the floor z = 0 may meet.
struct Walls {
    float wallDistance = kInfinity, wallHeight = kInfinity; ///< a wall across +x
    float ceiling = kInfinity;
    std::mt19937 random{9};
};

double occlusion(Walls& walls, int samples, float distance, int rounds) {
    RTSfunctions functions = {};
    functions.structSize = sizeof functions;
    functions.shadow = [](RTSstate* s, const float*, const float d[3], float reach,
                          float attenuation[3]) {
        const Walls& w = *static_cast<const Walls*>(s->tracer);
        const float toWall = d[0] > 0 ? w.wallDistance / d[0] : kInfinity;
        const bool meetsWall = toWall < reach && toWall * d[2] < w.wallHeight;
        const bool meetsCeiling = d[2] > 0 && w.ceiling / d[2] < reach;
        for (int k = 0; k < 3; ++k) attenuation[k] = meetsWall || meetsCeiling ? 0.0f : 1.0f;
        return 1;
    };
    functions.random = [](RTSstate* s) {
        return float(static_cast<Walls*>(s->tracer)->random() >> 8) * 0x1p-24f;
    };
    RTSstate state{};
    state.functions = &functions;
    state.tracer = &walls;
    state.geometricNormal[2] = state.shadingNormal[2] = 1;
    state.rayDirection[2] = -1;
    state.frontFace = 1;
    state.weight = 1;
    const auto shader =
        MadeShader("AmbientOcclusion").set("samples", samples).set("distance", distance).make();
    double sum = 0;
    for (int i = 0; i < rounds; ++i) {
        EXPECT_EQ(shader->functions().shade(shader->block(), &state), 0);
        sum += double(state.result[1]);
    }
    return sum / rounds;
}

TEST(AmbientOcclusionTest, AnOpenPlaneSeesTheWholeSky) {
    Walls open;
    EXPECT_EQ(occlusion(open, 16, kInfinity, 10), 1);
    EXPECT_EQ(occlusion(open, 0, kInfinity, 10), 1); // counts as one sample
}

TEST(AmbientOcclusionTest, AWallTakesHalfOfTheSkyTimesTheCosineOfItsEdge) {
    for (const float height : {0.5f, 1.0f, 4.0f, kInfinity}) {
        Walls walls;
        walls.wallDistance = 1;
        walls.wallHeight = height;
        const double cosine = std::isinf(height) ? 0 : 1 / std::sqrt(1 + double(height) * height);
        EXPECT_NEAR(occlusion(walls, 25, kInfinity, 2000), 1 - (1 - cosine) / 2, 0.004) << height;
    }
}

TEST(AmbientOcclusionTest, OnlyWhatIsWithinTheDistanceCounts) {
    // Directions with density cosine / pi fall evenly on the unit disk of the floor; those that
    // reach a wall at x within R fill the segment beyond a = x / R.
    for (const double a : {0.0, 0.25, 0.7, 1.0}) {
        Walls walls;
        walls.wallDistance = float(a);
        const double segment = (std::acos(a) - a * std::sqrt(1 - a * a)) / kPi;
        EXPECT_NEAR(occlusion(walls, 25, 1, 2000), 1 - segment, 0.004) << a;
    }
}

TEST(AmbientOcclusionTest, InsideAClosedRoom) {
    Walls room;
    room.ceiling = 1;
    EXPECT_EQ(occlusion(room, 16, kInfinity, 10), 0);
    EXPECT_EQ(occlusion(room, 16, 0.9f, 10), 1);
    // Rays within the cone that reaches the ceiling: 1 - cos^2 is the share that does not.
    EXPECT_NEAR(occlusion(room, 25, 2, 2000), 0.25, 0.004);
}

TEST(AmbientOcclusionTest, ColourMultiplies) {
    test::FakeTracer tracer;
    tracer.shadowAttenuation = {1, 0.5f, 0};
    const auto rgba = tracer.shade(
        *MadeShader("AmbientOcclusion").set("color", openrt::Color(0.5f, 1, 1)).make());
    EXPECT_EQ(rgba, (std::array<float, 4>{0.5f, 0.5f, 0, 1}));
    EXPECT_EQ(tracer.shadowRays, 16);
}

} // namespace
} // namespace smart
