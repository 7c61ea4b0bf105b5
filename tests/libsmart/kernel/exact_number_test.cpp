// SPDX-License-Identifier: MIT
// The numbers of the precise mode against those of another library.
#include "libsmart/kernel/exact_number.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "libsmart/kernel/exact_meeting.h"
#include "tests/libsmart/kernel/test_size.h"
#include "tests/support/ray_sets.h"

namespace smart::test {
namespace {

/// The same number twice.
struct Pair {
    ExactNumber ours;
    mpq_class theirs;
};

/// mpq_class(double) is exact.
Pair pairOf(double x) {
    return {ExactNumber(x), mpq_class(x)};
}

/// Doubles of any exponent from -limit to limit, some of few bits, some zero.
double anyDouble(Random& random, int limit) {
    if (random.below(20) == 0) return 0;
    const double fraction = random.below(2) ? random.between(-1, 1)
                                            : double(int(random.below(9)) - 4) / 4;
    return std::ldexp(fraction, int(random.below(uint32_t(2 * limit))) - limit);
}

/// Whether both are equal in value, as told by signs and by comparison with doubles near them.
void expectEqual(const Pair& pair) {
    ASSERT_EQ(pair.ours.sign(), sgn(pair.theirs));
    const ExactNumber one(1.0);
    const double near = pair.theirs.get_d();
    if (!std::isfinite(near)) return;
    for (const double x : {near, std::nextafter(near, INFINITY), std::nextafter(near, -INFINITY)}) {
        if (std::isinf(x)) continue;
        ASSERT_EQ(compareQuotient(pair.ours, one, x), sgn(mpq_class(pair.theirs - mpq_class(x))));
    }
}

TEST(ExactNumber, SumsAndProductsAreExact) {
    Random random(90);
    for (std::size_t i = 0; i < rayCount(20000); ++i) {
        const int limit = i % 2 ? 20 : 300;
        const Pair a = pairOf(anyDouble(random, limit)), b = pairOf(anyDouble(random, limit));
        const Pair c = pairOf(anyDouble(random, limit)), d = pairOf(anyDouble(random, limit));
        expectEqual(a);
        expectEqual({a.ours + b.ours, a.theirs + b.theirs});
        expectEqual({a.ours - b.ours, a.theirs - b.theirs});
        expectEqual({a.ours * b.ours, a.theirs * b.theirs});
        const Pair product = {a.ours * b.ours - c.ours * d.ours,
                              a.theirs * b.theirs - c.theirs * d.theirs};
        expectEqual(product);
        // What cancels leaves exactly what was added.
        expectEqual({(product.ours + a.ours) - product.ours, a.theirs});
        expectEqual({product.ours * product.ours - product.ours * product.ours, 0});
    }
}

TEST(ExactNumber, HoldsEveryFiniteDouble) {
    for (const double x : {5e-324, -5e-324, 2.2250738585072014e-308, 1.7976931348623157e308, 1.0,
                           -0.0, 0x1p-1022, 0x1.fffffffffffffp-1023, 0x1p31, 0x1p32, 0x1p-32}) {
        expectEqual(pairOf(x));
        const Pair square = {ExactNumber(x) * ExactNumber(x), mpq_class(x) * mpq_class(x)};
        ASSERT_EQ(square.ours.sign(), sgn(square.theirs));
        if (std::isinf(x * x)) continue;
        const ExactNumber tiny(0x1p-500);
        ASSERT_EQ(compareQuotient(square.ours * tiny, tiny, x * x),
                  sgn(mpq_class(square.theirs - mpq_class(x * x))));
    }
}

/// The nearest float, the even one of two, by rationals alone.
float nearestFloat(const mpq_class& x) {
    const auto distance = [&x](float candidate) -> mpq_class {
        const mpq_class place = std::isinf(candidate)
                                    ? mpq_class(candidate > 0 ? 0x1p128 : -0x1p128)
                                    : mpq_class(candidate);
        return abs(place - x);
    };
    float best = float(x.get_d());
    for (int step = 0; step < 4; ++step) {
        for (const float other : {std::nextafter(best, INFINITY), std::nextafter(best, -INFINITY)}) {
            const int order = cmp(distance(other), distance(best));
            if (order < 0 || (order == 0 && !(std::bit_cast<uint32_t>(other) & 1))) best = other;
        }
    }
    return best;
}

TEST(ExactNumber, QuotientsRoundToTheNearestFloat) {
    Random random(91);
    const auto check = [](double numerator, double more, double denominator, double scale) {
        const mpq_class exact = (mpq_class(numerator) + mpq_class(more)) / mpq_class(denominator) *
                                mpq_class(scale);
        const float rounded = roundedQuotient(ExactNumber(numerator) + ExactNumber(more),
                                              ExactNumber(denominator), scale);
        ASSERT_EQ(rounded, nearestFloat(exact))
            << numerator << " + " << more << " over " << denominator << " times " << scale;
    };
    for (std::size_t i = 0; i < rayCount(3000); ++i) {
        const double denominator = std::abs(anyDouble(random, 80)) + 0x1p-90;
        const double scale = std::ldexp(1.0, int(random.below(200)) - 100);
        check(anyDouble(random, 160), 0, denominator, scale);
        // Between two floats, or a hair off.
        const float below = float(anyDouble(random, 127));
        const double middle = (double(below) + std::nextafter(below, INFINITY)) / 2;
        for (const double hair : {0.0, 1e-300, -1e-300}) check(middle, hair, 1, 1);
    }
    for (const double limit : {0x1p128 - 0x1p103, 0x1p128, 0x1p-150, 0x1p-149, 3 * 0x1p-150}) {
        for (const double hair : {0.0, 1e-300, -1e-300}) {
            check(limit, hair, 1, 1);
            check(-limit, hair, 1, 1);
        }
    }
}

} // namespace
} // namespace smart::test
