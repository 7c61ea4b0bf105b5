// SPDX-License-Identifier: MIT
#include "samples/common/environment_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "samples/common/image_file.h"

namespace samples {
namespace {

std::vector<uint8_t> bytesOf(std::string_view text) { return {text.begin(), text.end()}; }

TEST(Environment, RadianceHasOneExponentForThreeNumbers) {
    std::vector<uint8_t> file = bytesOf("#?RGBE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 1\n");
    file.insert(file.end(), {128, 64, 255, 129, 1, 2, 3, 0});
    PixelBudget budget;
    const Environment picture = decodeEnvironment(file, budget);
    ASSERT_EQ(picture.width, 1u);
    ASSERT_EQ(picture.height, 2u);
    // The upper row is the last; an exponent of 0 is black.
    EXPECT_EQ(picture.rgb, (std::vector<float>{0, 0, 0, 1, 0.5f, 255.0f / 128}));
}

#ifdef SAMPLES_HAVE_EXR
TEST(Environment, WhatWasWrittenComesBack) {
    std::vector<float> pixels;
    for (int i = 0; i < 5 * 3 * 4; ++i) pixels.push_back(float(i) * 0.25f);
    PixelBudget budget;
    const Environment picture = decodeEnvironment(encodeExr(5, 3, pixels), budget);
    ASSERT_EQ(picture.rgb.size(), 5u * 3 * 3);
    for (std::size_t i = 0; i < 15; ++i) {
        for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(picture.rgb[3 * i + c], pixels[4 * i + c]);
    }
}

TEST(Environment, EveryNumberIsLight) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = HUGE_VALF;
    PixelBudget budget;
    const Environment picture = decodeEnvironment(
        encodeExr(2, 1, std::vector<float>{nan, infinity, -infinity, 1, -1, 0, 2, 1}), budget);
    EXPECT_EQ(picture.rgb, (std::vector<float>{0, 1e9f, 0, 0, 0, 2}));
}

TEST(Environment, ABudgetBoundsWhatIsDecoded) {
    const std::vector<uint8_t> file = encodeExr(8, 8, std::vector<float>(8 * 8 * 4));
    PixelBudget budget{100};
    EXPECT_NO_THROW(decodeEnvironment(file, budget));
    EXPECT_THROW(decodeEnvironment(file, budget), LoadError);
}
#endif

} // namespace
} // namespace samples
