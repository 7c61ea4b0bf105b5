// SPDX-License-Identifier: MIT
#include "libsmart/shading/fixed_frame_light.h"

#include <gtest/gtest.h>

#include <cmath>

namespace smart {
namespace {

/// What arrives at a point; radiance NaN where nothing does.
RTSlightsample sampled(const FixedLight& light, float x, float y, float z) {
    const auto object = makeFrameLight(light);
    const float at[3] = {x, y, z};
    RTSlightsample sample = {};
    if (object->functions().illuminate(object->block(), at, &sample) != 1)
        sample.radiance[0] = std::nanf("");
    return sample;
}

FixedLight lamp() {
    FixedLight light;
    light.diffuse = {2, 4, 8, 1};
    light.position = {3, 6, 0, 3}; // (1, 2, 0)
    return light;
}

TEST(FixedFrameLight, AtAPlaceDoesNotFallOffUnlessItIsToldTo) {
    FixedLight light = lamp();
    RTSlightsample sample = sampled(light, 1, -2, 3); // (0, 4, -3) away
    EXPECT_FLOAT_EQ(sample.distance, 5);
    EXPECT_FLOAT_EQ(sample.direction[1], 0.8f);
    EXPECT_FLOAT_EQ(sample.direction[2], -0.6f);
    EXPECT_FLOAT_EQ(sample.radiance[2], 8);
    light.constantAttenuation = 0.5f;
    light.linearAttenuation = 0.25f;
    light.quadraticAttenuation = 2;
    sample = sampled(light, 1, -2, 3);
    EXPECT_FLOAT_EQ(sample.radiance[0], 2 / (0.5f + 0.25f * 5 + 2 * 25));
    EXPECT_FLOAT_EQ(sample.radiance[1], 4 / (0.5f + 0.25f * 5 + 2 * 25));
    EXPECT_TRUE(std::isnan(sampled(light, 1, 2, 0).radiance[0])) << "at the light itself";
}

TEST(FixedFrameLight, AtInfinity) {
    FixedLight light = lamp();
    light.position = {0, 3, -4, 0};
    light.linearAttenuation = 7; // without effect
    const RTSlightsample sample = sampled(light, 100, 200, 300);
    EXPECT_TRUE(std::isinf(sample.distance));
    EXPECT_FLOAT_EQ(sample.direction[1], 0.6f);
    EXPECT_FLOAT_EQ(sample.direction[2], -0.8f);
    EXPECT_FLOAT_EQ(sample.radiance[0], 2);
    light.position = {0, 0, 0, 0};
    EXPECT_TRUE(std::isnan(sampled(light, 0, 0, 0).radiance[0]));
}

TEST(FixedFrameLight, Spot) {
    FixedLight light = lamp();
    light.spotDirection = {0, -2, 0};
    light.spotCutoff = 45;
    light.spotExponent = 3;
    EXPECT_FLOAT_EQ(sampled(light, 1, 0, 0).radiance[0], 2);
    const float cosine = 2 / std::sqrt(5.0f); // one aside, two down
    EXPECT_NEAR(sampled(light, 2, 0, 0).radiance[0], 2 * cosine * cosine * cosine, 1e-6f);
    EXPECT_TRUE(std::isnan(sampled(light, 4, 0, 0).radiance[0])) << "outside of the cone";
    EXPECT_TRUE(std::isnan(sampled(light, 1, 5, 0).radiance[0])) << "behind it";
}

} // namespace
} // namespace smart
