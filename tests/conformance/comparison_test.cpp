// SPDX-License-Identifier: MIT
#include "tests/conformance/comparison.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/conformance/flip.h"

namespace conformance {
namespace {

constexpr int kSize = 64;

// A shaded square on black, its lower left corner at (x, y).
Frame square(int x, int y) {
    Frame frame{{kSize, kSize, {}}, {kSize, kSize, {}}};
    frame.color.pixels.resize(kSize * kSize);
    frame.depth.depth.resize(kSize * kSize, 1.0f);
    for (int v = y; v < y + 30; ++v)
        for (int u = x; u < x + 30; ++u) {
            frame.color.pixels[std::size_t(v * kSize + u)] = {200, std::uint8_t(100 + u - x),
                                                              std::uint8_t(100 + v - y)};
            frame.depth.depth[std::size_t(v * kSize + u)] = 0.5f + 0.001f * float(u - x);
        }
    return frame;
}

bool passes(const Reference& reference, const Frame& test) {
    return failuresOf(compare(reference, test, true), Kind::kEqual, kSize, kSize).empty();
}

TEST(Comparison, EqualPicturesPass) {
    const Reference reference{square(10, 10), {}, {}};
    const Measures measures = compare(reference, square(10, 10), true);
    EXPECT_TRUE(failuresOf(measures, Kind::kEqual, kSize, kSize).empty());
    EXPECT_EQ(measures.coverageInside, 0);
    EXPECT_EQ(measures.colorMean, 0);
    EXPECT_EQ(measures.flip, 0);
    EXPECT_NEAR(measures.silhouettes, (4.0 * 31 - 4 + 4 + 4 * 29 - 4 + 4) / (kSize * kSize), 0.01);
}

TEST(Comparison, WhatAReferenceFrameShowsIsAllowed) {
    const Reference reference{square(10, 10), {square(11, 10)}, {}};
    // FLIP, which knows one reference only, is left out.
    const Measures measures = compare(reference, square(11, 10), false);
    EXPECT_TRUE(failuresOf(measures, Kind::kEqual, kSize, kSize).empty());
}

// The controls: each defect by itself is found.
TEST(Comparison, DefectsFail) {
    const Reference reference{square(10, 10), {}, {}};
    EXPECT_FALSE(passes(reference, square(11, 10))) << "moved by a pixel";

    Frame hole = square(10, 10);
    hole.color.pixels[25 * kSize + 25] = {0, 0, 0};
    hole.depth.depth[25 * kSize + 25] = 1.0f;
    EXPECT_FALSE(passes(reference, hole)) << "a missing pixel";

    Frame speck = square(10, 10);
    speck.color.pixels[55 * kSize + 55] = {200, 0, 0};
    EXPECT_FALSE(passes(reference, speck)) << "a pixel too many";

    Frame deep = square(10, 10);
    deep.depth.depth[25 * kSize + 25] += 2e-5f;
    EXPECT_FALSE(passes(reference, deep)) << "depth";

    Frame unknown = square(10, 10);
    unknown.depth.depth[25 * kSize + 25] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(passes(reference, unknown)) << "NaN";

    Frame brighter = square(10, 10);
    for (auto& pixel : brighter.color.pixels)
        if (pixel[0]) ++pixel[0];
    EXPECT_FALSE(passes(reference, brighter)) << "one level everywhere";

    Frame spots = square(10, 10);
    for (int i = 0; i < 4; ++i) spots.color.pixels[std::size_t((15 + 5 * i) * kSize + 25)][1] += 9;
    EXPECT_FALSE(passes(reference, spots)) << "few pixels by much";
}

TEST(Comparison, DifferentSizesAreRefused) {
    Frame other = square(10, 10);
    other.color.width = kSize / 2;
    other.color.height = kSize * 2;
    EXPECT_THROW(compare({square(10, 10), {}, {}}, other, false), std::runtime_error);
}

Picture plain(std::uint8_t r, std::uint8_t g, std::uint8_t b) {
    Picture picture{32, 32, {}};
    picture.pixels.assign(32 * 32, {r, g, b});
    return picture;
}

// Between plain pictures nothing is filtered and no feature differs: the error is the colour
// difference alone. Black to white is 100 in lightness; the largest difference is green to blue.
TEST(Flip, PlainColours) {
    EXPECT_EQ(meanOf(flipErrors(plain(9, 99, 199), plain(9, 99, 199))), 0.0f);
    EXPECT_NEAR(meanOf(flipErrors(plain(0, 255, 0), plain(0, 0, 255))), 1.0f, 1e-3f);
    const float small = meanOf(flipErrors(plain(100, 100, 100), plain(101, 101, 101)));
    const float larger = meanOf(flipErrors(plain(100, 100, 100), plain(120, 120, 120)));
    EXPECT_GT(small, 0.0f);
    EXPECT_GT(larger, 3 * small);
    EXPECT_EQ(meanOf(flipErrors(plain(0, 0, 0), plain(255, 255, 255))),
              meanOf(flipErrors(plain(255, 255, 255), plain(0, 0, 0))));
}

TEST(Flip, AFeatureThatOneLacksCountsMore) {
    Picture line = plain(128, 128, 128);
    for (int y = 0; y < 32; ++y) line.pixels[std::size_t(y * 32 + 16)] = {255, 255, 255};
    const std::vector<float> errors = flipErrors(plain(128, 128, 128), line);
    EXPECT_GT(errors[16 * 32 + 16], 0.2f);
    EXPECT_LT(errors[16 * 32 + 2], errors[16 * 32 + 16] / 4);
}

} // namespace
} // namespace conformance
