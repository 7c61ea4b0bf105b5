// SPDX-License-Identifier: MIT
#include "libsmart/render/sampling.h"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <utility>

namespace smart {
namespace {

TEST(Sampling, OneSampleIsTheCentre) {
    for (const uint32_t seed : {0u, 1u, 77u})
        EXPECT_EQ(samplePosition(3, 9, seed, 0, 1), glm::vec2(0.5f, 0.5f));
}

TEST(Sampling, PositionsDependOnPixelSampleAndSeedOnly) {
    // Known when compiled: nothing of the machine goes in.
    static_assert(samplePosition(5, 6, 7, 2, 8) == samplePosition(5, 6, 7, 2, 8));
    std::set<std::pair<float, float>> all;
    int count = 0;
    for (uint32_t x = 0; x < 8; ++x)
        for (uint32_t seed = 0; seed < 4; ++seed)
            for (uint32_t i = 0; i < 8; ++i, ++count) {
                const glm::vec2 p = samplePosition(x, 100, seed, i, 8);
                EXPECT_GE(p.x, 0.0f);
                EXPECT_LT(p.x, 1.0f);
                EXPECT_GE(p.y, 0.0f);
                EXPECT_LT(p.y, 1.0f);
                all.emplace(p.x, p.y);
            }
    EXPECT_EQ(all.size(), std::size_t(count)); // all different
}

// 256 samples in 64 cells: a square lattice of the plane has 4 in each; independent random
// positions would leave cells with one or none, and others with ten.
TEST(Sampling, PositionsFillTheSquareEvenly) {
    for (uint32_t pixel = 0; pixel < 20; ++pixel) {
        std::array<int, 64> cells{};
        for (uint32_t i = 0; i < 256; ++i) {
            const glm::vec2 p = samplePosition(pixel, 2, 0, i, 256);
            ++cells[std::size_t(p.x * 8) + 8 * std::size_t(p.y * 8)];
        }
        for (const int count : cells) {
            EXPECT_GE(count, 2);
            EXPECT_LE(count, 6);
        }
    }
}

TEST(Sampling, RandomNumbersAreUniformAndTheirOwnForEachSample) {
    double sum = 0, squares = 0;
    constexpr int kCount = 100000;
    RandomStream stream(1, 2, 3, 4);
    for (int i = 0; i < kCount; ++i) {
        const float x = stream.next();
        ASSERT_GE(x, 0.0f);
        ASSERT_LT(x, 1.0f);
        sum += x;
        squares += double(x) * x;
    }
    // Five standard deviations of the means of n uniform numbers and of their squares.
    EXPECT_NEAR(sum / kCount, 0.5, 5 * 0.2887 / 316.0);
    EXPECT_NEAR(squares / kCount, 1.0 / 3.0, 5 * 0.2981 / 316.0);

    std::set<float> firsts;
    for (uint32_t x = 0; x < 4; ++x)
        for (uint32_t y = 0; y < 4; ++y)
            for (uint32_t sample = 0; sample < 4; ++sample)
                for (uint32_t seed = 0; seed < 4; ++seed)
                    firsts.insert(RandomStream(x, y, sample, seed).next());
    EXPECT_EQ(firsts.size(), 256u);
    EXPECT_EQ(RandomStream(9, 8, 7, 6).next(), RandomStream(9, 8, 7, 6).next());
}

} // namespace
} // namespace smart
