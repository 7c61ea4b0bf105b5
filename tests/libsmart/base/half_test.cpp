// SPDX-License-Identifier: MIT
#include "libsmart/base/half.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace smart {
namespace {

// The definition: (-1)^sign * 2^(exponent - 15) * 1.mantissa.
double valueOf(uint16_t half) {
    const int exponent = (half >> 10) & 31, mantissa = half & 1023;
    const double sign = half & 0x8000 ? -1 : 1;
    if (exponent == 31)
        return mantissa ? std::numeric_limits<double>::quiet_NaN()
                        : sign * std::numeric_limits<double>::infinity();
    if (exponent == 0) return sign * std::ldexp(mantissa, -24);
    return sign * std::ldexp(1024 + mantissa, exponent - 25);
}

// By search among all halves of the sign, the nearest one and of two the even one.
uint16_t nearestHalf(double value) {
    static const std::vector<double> sizes = [] {
        std::vector<double> all;
        for (int i = 0; i < 0x7C00; ++i) all.push_back(valueOf(uint16_t(i)));
        all.push_back(65536.0); // where the next one would be; stands for infinity
        return all;
    }();
    const uint16_t sign = std::signbit(value) ? 0x8000 : 0;
    const double size = std::fabs(value);
    if (size >= sizes.back()) return uint16_t(sign | 0x7C00);
    const auto above = std::upper_bound(sizes.begin(), sizes.end(), size);
    const auto index = uint16_t(above - sizes.begin() - 1);
    const double down = size - sizes[index], up = *above - size;
    const bool next = up < down || (up == down && (index & 1));
    return uint16_t(sign | (index + next));
}

TEST(HalfTest, AllValuesAreExact) {
    for (int i = 0; i < 65536; ++i) {
        const auto half = uint16_t(i);
        const double expected = valueOf(half);
        const float found = halfToFloat(half);
        if (std::isnan(expected)) {
            EXPECT_TRUE(std::isnan(found)) << i;
            EXPECT_TRUE(std::isnan(halfToFloat(floatToHalf(found)))) << i;
            continue;
        }
        ASSERT_EQ(double(found), expected) << i;
        ASSERT_EQ(std::signbit(found), (i & 0x8000) != 0) << i;
        ASSERT_EQ(floatToHalf(found), half) << i;
    }
}

TEST(HalfTest, RoundsToTheNearest) {
    constexpr float kInf = std::numeric_limits<float>::infinity();
    std::vector<float> values = {0.0f, -0.0f, 65519.9f, 65520.0f, 65519.996f, 1e30f, -1e30f, kInf,
                                 0x1p-25f, 0x1.000002p-25f, 0x1p-26f, 1e-45f, 0x1.ffcp-15f,
                                 0x1.ffffp-15f};
    // Every middle between two neighbours, and the floats beside it.
    for (int i = 0; i < 0x7BFF; ++i) {
        const auto middle =
            float((valueOf(uint16_t(i)) + valueOf(uint16_t(i + 1))) / 2); // exact in float
        values.push_back(middle);
        values.push_back(std::nextafter(middle, 0.0f));
        values.push_back(std::nextafter(middle, kInf));
    }
    std::mt19937 random(3);
    std::uniform_int_distribution<uint32_t> bits;
    for (int i = 0; i < 20000; ++i) {
        const float value = std::bit_cast<float>(bits(random));
        if (!std::isnan(value)) values.push_back(value);
    }
    for (const float value : values) {
        ASSERT_EQ(floatToHalf(value), nearestHalf(value)) << value;
        ASSERT_EQ(floatToHalf(-value), nearestHalf(-double(value))) << value;
    }
}

TEST(HalfTest, TheCheckerSeesTruncation) {
    const auto truncated = [](float v) {
        return uint16_t((std::bit_cast<uint32_t>(v) - (112u << 23)) >> 13);
    };
    EXPECT_NE(truncated(1.0009f), nearestHalf(1.0009f));
}

} // namespace
} // namespace smart
