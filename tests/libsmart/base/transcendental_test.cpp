// SPDX-License-Identifier: MIT
#include "libsmart/base/transcendental.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include "tests/libsmart/base/transcendental_bits.h"

namespace {

namespace m = smart::math;
constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// Distance to the exact value in units of a float's last place there.
double errorUlp(float got, long double exact) {
    if (std::isnan(got) || std::isnan(exact)) return std::isnan(got) == std::isnan(exact) ? 0 : 1e9;
    constexpr long double kMax = std::numeric_limits<float>::max();
    if (std::fabs(exact) > kMax * (1 + 0x1p-25L)) return std::isinf(got) ? 0 : 1e9;
    if (std::isinf(got)) return 1e9;
    int exponent = 0;
    std::frexp(exact, &exponent);
    const long double ulp = std::ldexp(1.0L, std::max(exponent - 24, -149));
    return double(std::fabs(got - exact) / ulp);
}

/// Every kind of float: uniform bits, and uniform values in a range.
template <class Check>
void forManyFloats(float low, float high, Check&& check) {
    std::mt19937 random(11);
    std::uniform_real_distribution<float> inRange(low, high);
    for (int i = 0; i < 150000; ++i) {
        check(std::bit_cast<float>(uint32_t(random())));
        check(inRange(random));
    }
    for (const float x : {0.0f, -0.0f, 1.0f, -1.0f, 1e-45f, -1e-45f, 1e-38f, 3.4e38f, kInf, -kInf})
        check(x);
}

constexpr double kBound = 0.501;

TEST(TranscendentalTest, ExpAndLog) {
    double worst = 0;
    forManyFloats(-110, 95, [&](float x) {
        worst = std::max(worst, errorUlp(m::exp(x), std::exp((long double)x)));
    });
    EXPECT_LT(worst, kBound);
    worst = 0;
    forManyFloats(0, 4, [&](float x) {
        if (!(x >= 0)) return;
        if (x == 0) EXPECT_EQ(m::log(x), -kInf);
        else if (x == kInf) EXPECT_EQ(m::log(x), kInf);
        else worst = std::max(worst, errorUlp(m::log(x), std::log((long double)x)));
    });
    EXPECT_LT(worst, kBound);
    EXPECT_TRUE(std::isnan(m::log(-1.0f)));
    EXPECT_TRUE(std::isnan(m::log(kNan)));
    EXPECT_TRUE(std::isnan(m::exp(kNan)));
    EXPECT_EQ(m::exp(0.0f), 1);
    EXPECT_EQ(m::log(1.0f), 0);
}

TEST(TranscendentalTest, SinAndCosAtAnySize) {
    double worst = 0;
    const auto check = [&](float x) {
        if (!std::isfinite(x)) {
            EXPECT_TRUE(std::isnan(m::sin(x)) && std::isnan(m::cos(x)));
            return;
        }
        // The C library reduces large arguments exactly in double.
        worst = std::max(worst, errorUlp(m::sin(x), std::sin(double(x))));
        worst = std::max(worst, errorUlp(m::cos(x), std::cos(double(x))));
    };
    forManyFloats(-400, 400, check);
    forManyFloats(-2e5f, 2e5f, check);
    // Floats next to multiples of pi/2, where most is lost.
    for (int k = 1; k < 200000; k += 7) {
        const auto x = float(k * 1.57079632679489661923);
        check(x);
        check(std::nextafter(x, 0.0f));
    }
    check(16367173.0f * 0x1p72f); // the float that is closest to a multiple of pi/2
    EXPECT_LT(worst, kBound);
    EXPECT_EQ(m::sin(0.0f), 0);
    EXPECT_TRUE(std::signbit(m::sin(-0.0f)));
    EXPECT_EQ(m::cos(0.0f), 1);
}

TEST(TranscendentalTest, Atan2AndAsin) {
    double worst = 0;
    std::mt19937 random(12);
    std::uniform_real_distribution<float> inRange(-2, 2);
    for (int i = 0; i < 300000; ++i) {
        float y = inRange(random), x = inRange(random);
        if (i % 3 == 0) {
            y = std::bit_cast<float>(uint32_t(random()));
            x = std::bit_cast<float>(uint32_t(random()));
        }
        const float got = m::atan2(y, x);
        if (std::isnan(x) || std::isnan(y)) EXPECT_TRUE(std::isnan(got));
        else worst = std::max(worst, errorUlp(got, std::atan2((long double)y, (long double)x)));
    }
    for (const float y : {0.0f, -0.0f, 1.0f, -1.0f, kInf, -kInf})
        for (const float x : {0.0f, -0.0f, 1.0f, -1.0f, kInf, -kInf}) {
            const float got = m::atan2(y, x);
            EXPECT_LT(errorUlp(got, std::atan2((long double)y, (long double)x)), kBound);
            EXPECT_EQ(std::signbit(got), std::signbit(y)) << y << " " << x;
        }
    EXPECT_LT(worst, kBound);
    worst = 0;
    forManyFloats(-1, 1, [&](float x) {
        if (std::fabs(x) > 1 || std::isnan(x)) EXPECT_TRUE(std::isnan(m::asin(x)));
        else worst = std::max(worst, errorUlp(m::asin(x), std::asin((long double)x)));
    });
    EXPECT_LT(worst, kBound);
    EXPECT_FLOAT_EQ(m::asin(1.0f), 1.57079633f);
}

TEST(TranscendentalTest, Pow) {
    double worst = 0;
    std::mt19937 random(13);
    std::uniform_real_distribution<float> base(0, 3), exponent(-20, 20);
    for (int i = 0; i < 300000; ++i) {
        float x = base(random), y = exponent(random);
        if (i % 3 == 0) {
            x = std::bit_cast<float>(uint32_t(random()));
            y = std::bit_cast<float>(uint32_t(random()));
        } else if (i % 3 == 1) {
            x = -x;
            y = std::floor(y);
        }
        worst = std::max(worst, errorUlp(m::pow(x, y), std::pow((long double)x, (long double)y)));
    }
    EXPECT_LT(worst, kBound);
    // Special cases: the C library's pow is bound by C99's annex F.
    const float special[] = {0.0f, -0.0f, 1.0f,  -1.0f, 2.0f, -2.0f, 3.0f,  -3.0f,
                             0.5f, -0.5f, kInf, -kInf, 1e30f, -1e30f, 1e-30f, kNan};
    for (const float x : special)
        for (const float y : special) {
            if ((x == 1 || y == 0)) {
                EXPECT_EQ(m::pow(x, y), 1);
                continue;
            }
            const auto exact = float(std::pow(double(x), double(y)));
            const float got = m::pow(x, y);
            if (std::isnan(exact)) EXPECT_TRUE(std::isnan(got)) << x << " " << y;
            else {
                EXPECT_FLOAT_EQ(got, exact) << x << " " << y;
                EXPECT_EQ(std::signbit(got), std::signbit(exact)) << x << " " << y;
            }
        }
}

TEST(TranscendentalTest, Srgb) {
    double worst = 0;
    for (int i = 0; i <= 100000; ++i) {
        const auto x = float(i) / 100000;
        const long double l = x;
        const long double encoded =
            x > 0.0031308f ? 1.055L * std::pow(l, 1 / 2.4L) - 0.055L : 12.92L * l;
        const long double decoded =
            x > 0.04045f ? std::pow((l + 0.055L) / 1.055L, 2.4L) : l / 12.92L;
        // One rounding more, of 12.92 as a float.
        worst = std::max({worst, errorUlp(m::encodeSrgb(x), encoded) - (x > 0.0031308f ? 0 : 1),
                          errorUlp(m::decodeSrgb(x), decoded)});
    }
    EXPECT_LT(worst, kBound);
    for (int i = 0; i < 256; ++i) // bytes survive both ways
        EXPECT_EQ(int(m::encodeSrgb(m::decodeSrgb(float(i) / 255)) * 255 + 0.5f), i);
    EXPECT_EQ(m::encodeSrgb(0.0f), 0);
    EXPECT_EQ(m::encodeSrgb(1.0f), 1);
    EXPECT_EQ(m::decodeSrgb(1.0f), 1);
    EXPECT_EQ(m::encodeSrgb(kInf), kInf);
    EXPECT_EQ(m::decodeSrgb(kInf), kInf);
    EXPECT_TRUE(std::isnan(m::encodeSrgb(kNan)));
}

TEST(TranscendentalTest, TheErrorBoundSeesAWrongLastBit) {
    double worst = 0;
    for (float x = 0.1f; x < 3; x += 0.01f)
        worst = std::max(worst, errorUlp(std::nextafter(m::exp(x), 100.0f),
                                         std::exp((long double)x)));
    EXPECT_GT(worst, 1.0);
}

TEST(TranscendentalTest, BitsDoNotDependOnTheInstructionSet) {
#if defined(__x86_64__)
    if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma"))
        GTEST_SKIP() << "this machine has no AVX2 and FMA";
    EXPECT_EQ(wideBits(), baselineBits());
    // Contracted code gives other bits: the digest would notice.
    EXPECT_NE(contractedBits(), baselineBits());
#else
    GTEST_SKIP() << "compares instruction sets of x86-64";
#endif
}

} // namespace
