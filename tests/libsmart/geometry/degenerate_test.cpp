// SPDX-License-Identifier: MIT
// Truth: the cross product in rational numbers.
#include "libsmart/geometry/degenerate.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>

namespace smart {
namespace {

bool isZeroExactly(const Triangle& triangle) {
    mpq_class a[3], b[3];
    for (int k = 0; k < 3; ++k) {
        a[k] = mpq_class(triangle.v1[k]) - mpq_class(triangle.v0[k]);
        b[k] = mpq_class(triangle.v2[k]) - mpq_class(triangle.v0[k]);
    }
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        if (a[i] * b[j] != a[j] * b[i]) return false;
    }
    return true;
}

bool isZeroInDouble(const Triangle& triangle) {
    double a[3], b[3];
    for (int k = 0; k < 3; ++k) {
        a[k] = double(triangle.v1[k]) - triangle.v0[k];
        b[k] = double(triangle.v2[k]) - triangle.v0[k];
    }
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        if (a[i] * b[j] != a[j] * b[i]) return false;
    }
    return true;
}

class DegenerateTest : public testing::Test {
protected:
    int integer(int lo, int hi) { return lo + int(generator_() % uint32_t(hi - lo + 1)); }
    float mantissa() { return float(int(generator_() >> 8) - (1 << 23)); }

    /// Asks about many triangles and wants the exact answer about each; both answers must occur.
    void compare(int rounds, const std::function<Triangle()>& make) {
        int degenerate = 0, plain = 0, wrongInDouble = 0;
        for (int i = 0; i < rounds; ++i) {
            const Triangle triangle = make();
            if (!isFinite(triangle)) continue;
            const bool expected = isZeroExactly(triangle);
            ASSERT_EQ(isDegenerate(triangle), expected);
            ++(expected ? degenerate : plain);
            wrongInDouble += isZeroInDouble(triangle) != expected;
        }
        EXPECT_GT(degenerate, rounds / 20);
        EXPECT_GT(plain, rounds / 20);
        wrongInDouble_ += wrongInDouble;
    }
    /// Moves one coordinate to a neighbouring float, half the time.
    void nudge(Triangle& triangle) {
        if (integer(0, 1)) return;
        float* const corners[3] = {triangle.v0, triangle.v1, triangle.v2};
        float& value = corners[integer(0, 2)][integer(0, 2)];
        value = std::nextafter(value, integer(0, 1) ? 3e38f : -3e38f);
    }

    std::mt19937 generator_{7};
    int wrongInDouble_ = 0;
};

TEST_F(DegenerateTest, CollinearPointsOnALattice) {
    compare(20000, [this] {
        Triangle triangle;
        const int s = integer(-9, 9), t = integer(-9, 9);
        for (int k = 0; k < 3; ++k) {
            const int origin = integer(-1000, 1000), step = integer(-50, 50);
            triangle.v0[k] = float(origin);
            triangle.v1[k] = float(origin + s * step);
            triangle.v2[k] = float(origin + t * step);
        }
        nudge(triangle);
        return triangle;
    });
}

TEST_F(DegenerateTest, PointsOnALineThroughTheOriginAtAnyScale) {
    compare(20000, [this] {
        Triangle triangle;
        const int e0 = integer(-120, 90), e1 = integer(-120, 90), e2 = integer(-120, 90);
        for (int k = 0; k < 3; ++k) {
            const float direction = mantissa();
            triangle.v0[k] = std::ldexp(direction, e0);
            triangle.v1[k] = std::ldexp(direction, e1);
            triangle.v2[k] = std::ldexp(direction, e2);
        }
        nudge(triangle);
        return triangle;
    });
    // Control: double arithmetic alone does not decide these, so the exact path is needed.
    EXPECT_GT(wrongInDouble_, 0);
}

TEST_F(DegenerateTest, SubnormalAndHugeCoordinates) {
    compare(20000, [this] {
        Triangle triangle;
        const bool tiny = integer(0, 1);
        const int s = integer(-3, 3), t = integer(-3, 3);
        for (int k = 0; k < 3; ++k) {
            const int step = integer(-20, 20);
            const int origin = integer(-100, 100);
            const int exponent = tiny ? -149 : 120;
            triangle.v0[k] = std::ldexp(float(origin), exponent);
            triangle.v1[k] = std::ldexp(float(origin + s * step), exponent);
            triangle.v2[k] = std::ldexp(float(origin + t * step), exponent);
        }
        nudge(triangle);
        return triangle;
    });
}

TEST_F(DegenerateTest, RepeatedCorners) {
    const Triangle point{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}};
    const Triangle needle{{1, 2, 3}, {4, 5, 7}, {1, 2, 3}};
    const Triangle signedZeros{{0.0f, 0, 0}, {-0.0f, 0, 0}, {1, 1, 1}};
    const Triangle thin{{0, 0, 0}, {1, 0, 0}, {1, 0x1p-149f, 0}};
    EXPECT_TRUE(isDegenerate(point));
    EXPECT_TRUE(isDegenerate(needle));
    EXPECT_TRUE(isDegenerate(signedZeros));
    EXPECT_FALSE(isDegenerate(thin));
}

TEST_F(DegenerateTest, FiniteMeansEveryCoordinate) {
    const float inf = std::numeric_limits<float>::infinity();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const Triangle good{{0, 0, 0}, {1, 0, 0}, {0, 1, 3e38f}};
    EXPECT_TRUE(isFinite(good));
    for (const float bad : {inf, -inf, nan}) {
        for (int i = 0; i < 9; ++i) {
            Triangle triangle = good;
            (i < 3 ? triangle.v0 : i < 6 ? triangle.v1 : triangle.v2)[i % 3] = bad;
            EXPECT_FALSE(isFinite(triangle));
        }
    }
}

} // namespace
} // namespace smart
