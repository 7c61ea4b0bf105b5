// SPDX-License-Identifier: MIT
// Lanes against the same operation on one float or vector, to the bit.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include "libsmart/shading/builtin/lane_math.h"
#include "openrt/packet_vectors.hpp"

namespace {

using namespace openrt;

constexpr int kRounds = 200;

/// Numbers of all sizes and signs, zeros, infinities and NaN among them.
class Numbers {
public:
    Floats lanes() {
        Floats values;
        for (int i = 0; i < kLanes; ++i) values[i] = next();
        return values;
    }
    PacketVec2 pairs() { return {lanes(), lanes()}; }
    PacketVec4 quadruples() { return {lanes(), lanes(), lanes(), lanes()}; }
    PacketVec3 vectors() { return {lanes(), lanes(), lanes()}; }
    PacketColor colors() { return {lanes(), lanes(), lanes()}; }

private:
    float next() {
        constexpr float kInfinity = std::numeric_limits<float>::infinity();
        switch (random_() % 16) {
        case 0: return 0.0f;
        case 1: return -0.0f;
        case 2: return random_() % 2 ? kInfinity : -kInfinity;
        case 3: return std::numeric_limits<float>::quiet_NaN();
        case 4: return 1.0f;
        default:
            return std::ldexp(float(int64_t(random_() % 2000001) - 1000000),
                              int(random_() % 80) - 60);
        }
    }
    std::mt19937_64 random_{20};
};

/// Equal bits, or both NaN: which NaN comes out of two is the instruction's choice.
bool same(float a, float b) {
    return std::bit_cast<uint32_t>(a) == std::bit_cast<uint32_t>(b) ||
           (std::isnan(a) && std::isnan(b));
}
bool same(const Vec2& a, const Vec2& b) {
    return same(a.x, b.x) && same(a.y, b.y);
}
bool same(const Vec4& a, const Vec4& b) {
    return same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z) && same(a.w, b.w);
}
bool same(const Vec3& a, const Vec3& b) {
    return same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z);
}
bool same(const Color& a, const Color& b) {
    return same(a.r, b.r) && same(a.g, b.g) && same(a.b, b.b);
}

/// Lanes where packet and scalar results differ, over many random arguments.
template <class Draw, class Packet, class Scalar>
int differences(Draw draw, Packet packet, Scalar scalar) {
    Numbers numbers;
    int count = 0;
    for (int round = 0; round < kRounds; ++round) {
        const auto a = draw(numbers), b = draw(numbers);
        const auto result = packet(a, b);
        for (int i = 0; i < kLanes; ++i) count += !same(result[i], scalar(a[i], b[i]));
    }
    return count;
}

template <class Draw, class Function>
int differences(Draw draw, Function function) {
    return differences(draw, function, function);
}

const auto kFloats = [](Numbers& n) { return n.lanes(); };
const auto kPairs = [](Numbers& n) { return n.pairs(); };
const auto kQuadruples = [](Numbers& n) { return n.quadruples(); };
const auto kVectors = [](Numbers& n) { return n.vectors(); };
const auto kColors = [](Numbers& n) { return n.colors(); };

TEST(Lanes, ArithmeticIsThatOfFloats) {
    EXPECT_EQ(differences(kFloats, [](const auto& a, const auto& b) { return a + b; }), 0);
    EXPECT_EQ(differences(kFloats, [](const auto& a, const auto& b) { return a - b; }), 0);
    EXPECT_EQ(differences(kFloats, [](const auto& a, const auto& b) { return a * b; }), 0);
    EXPECT_EQ(differences(kFloats, [](const auto& a, const auto& b) { return a / b; }), 0);
    EXPECT_EQ(differences(kFloats, [](const auto& a, const auto&) { return -a; }), 0);
    EXPECT_EQ(differences(kFloats, [](const auto& a, const auto&) { return 2.0f * a - 1.0f; }), 0);
}

TEST(Lanes, FunctionsAreThoseOfFloats) {
    EXPECT_EQ(differences(kFloats, [](const auto& a, const auto&) { return sqrt(a); }), 0);
    EXPECT_EQ(differences(kFloats, [](const auto& a, const auto&) { return floor(a); }), 0);
    EXPECT_EQ(differences(kFloats, [](const auto& a, const auto&) { return abs(a); }), 0);
    EXPECT_EQ(differences(kFloats, [](const auto& a, const auto& b) { return min(a, b); }), 0);
    EXPECT_EQ(differences(kFloats, [](const auto& a, const auto& b) { return max(a, b); }), 0);
    EXPECT_EQ(differences(kFloats, [](const auto& a, const auto&) {
                  return smart::math::pow(a, 2.5f);
              }),
              0);
}

TEST(Lanes, AnotherOperationIsNoticed) {
    EXPECT_GT(differences(
                  kFloats, [](const Floats& a, const Floats& b) { return a + b; },
                  [](float a, float b) { return b - a; }),
              kRounds * kLanes / 2);
}

TEST(PacketVectors, OperationsAreThoseOfVectors) {
    EXPECT_EQ(differences(kVectors, [](const auto& a, const auto& b) { return a + b; }), 0);
    EXPECT_EQ(differences(kVectors, [](const auto& a, const auto& b) { return a - b; }), 0);
    EXPECT_EQ(differences(kVectors, [](const auto& a, const auto& b) { return a * dot(a, b); }), 0);
    EXPECT_EQ(differences(kVectors, [](const auto& a, const auto& b) { return a / b.x; }), 0);
    EXPECT_EQ(differences(kVectors, [](const auto& a, const auto& b) { return cross(a, b); }), 0);
    EXPECT_EQ(differences(kVectors, [](const auto& a, const auto& b) { return dot(a, b); }), 0);
    EXPECT_EQ(differences(kVectors, [](const auto& a, const auto&) { return length(a); }), 0);
    EXPECT_EQ(differences(kVectors, [](const auto& a, const auto&) { return normalize(a); }), 0);
    EXPECT_EQ(differences(kVectors, [](const auto& a, const auto& b) { return reflect(a, b); }), 0);
    EXPECT_EQ(differences(kVectors, [](const auto& a, const auto&) {
                  return a + Vec3(1.0f, 2.0f, 3.0f);
              }),
              0);
}

TEST(PacketVectors, ColorsToo) {
    EXPECT_EQ(differences(kColors, [](const auto& a, const auto& b) { return a * b + a - b; }), 0);
    EXPECT_EQ(differences(kColors, [](const auto& a, const auto& b) { return a / b.r; }), 0);
    EXPECT_EQ(differences(kColors, [](const auto& a, const auto&) { return a.largest(); }), 0);
    EXPECT_EQ(differences(kColors, [](const auto& a, const auto&) {
                  return Color(0.5f, 0.25f, 2.0f) * a;
              }),
              0);
}

TEST(PacketVectors, TwoAndFourNumbersToo) {
    const auto combined = [](const auto& a, const auto& b) { return 2.0f * (a - b) + a * b.x; };
    const auto product = [](const auto& a, const auto& b) { return dot(a, b); };
    const auto lesser = [](const auto& a, const auto& b) { return select(a.x < b.x, a, b); };
    EXPECT_EQ(differences(kPairs, combined), 0);
    EXPECT_EQ(differences(kPairs, product), 0);
    EXPECT_EQ(differences(kPairs, lesser), 0);
    EXPECT_EQ(differences(kQuadruples, combined), 0);
    EXPECT_EQ(differences(kQuadruples, product), 0);
    EXPECT_EQ(differences(kQuadruples, lesser), 0);
}

TEST(PacketVectors, AssignmentsAreThoseOfVectors) {
    EXPECT_EQ(differences(kFloats,
                          [](auto a, const auto& b) {
                              a += b;
                              a *= 3.0f;
                              return a /= b;
                          }),
              0);
    EXPECT_EQ(differences(kVectors,
                          [](auto a, const auto& b) {
                              a -= b;
                              return a *= b.x;
                          }),
              0);
    EXPECT_EQ(differences(kColors,
                          [](auto a, const auto& b) {
                              a *= b;
                              return a *= 0.5f;
                          }),
              0);
}

TEST(PacketVectors, SelectTakesLanesApart) {
    Numbers numbers;
    const PacketColor yes = numbers.colors(), no = numbers.colors();
    const PacketColor chosen = select(Mask(0xA5F0u), yes, no);
    for (int i = 0; i < kLanes; ++i)
        EXPECT_TRUE(same(chosen[i], 0xA5F0u >> i & 1 ? yes[i] : no[i])) << i;
}

TEST(PacketVectors, ConditionsAreThoseOfFloats) {
    Numbers numbers;
    for (int round = 0; round < kRounds; ++round) {
        const Floats a = numbers.lanes(), b = numbers.lanes();
        const PacketColor c = numbers.colors();
        const Mask less = a < b, more = a > b, atMost = a <= b, atLeast = a >= b, equal = a == b,
                   other = a != b, black = c.black();
        Mask both = less, either = less;
        both &= other;
        either |= equal;
        for (int i = 0; i < kLanes; ++i) {
            EXPECT_EQ(less[i], a[i] < b[i]);
            EXPECT_EQ(more[i], a[i] > b[i]);
            EXPECT_EQ(atMost[i], a[i] <= b[i]);
            EXPECT_EQ(atLeast[i], a[i] >= b[i]);
            EXPECT_EQ(equal[i], a[i] == b[i]);
            EXPECT_EQ(other[i], a[i] != b[i]);
            EXPECT_EQ((!less)[i], !(a[i] < b[i]));
            EXPECT_EQ(black[i], c[i].black());
            EXPECT_EQ(both[i], a[i] < b[i] && a[i] != b[i]);
            EXPECT_EQ(either[i], a[i] < b[i] || a[i] == b[i]);
        }
    }
}

} // namespace
