// SPDX-License-Identifier: MIT
#include "libsmart/render/fragments.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <random>
#include <vector>

namespace smart::test {
namespace {

using Color = std::array<double, 4>;

glm::vec4 toVec(const Color& c) {
    return {float(c[0]), float(c[1]), float(c[2]), float(c[3])};
}

Fragment fragmentOf(const FixedState& state, const glm::vec4& color, float depth = 0.5f) {
    Fragment fragment;
    fragment.state = &state;
    fragment.color = color;
    fragment.depth = depth;
    return fragment;
}

/// What a function of OpenGL's answers for (below, equal, above), in the order of the tokens.
struct Comparison {
    CompareFunction function;
    bool below, equal, above;
};
constexpr Comparison kComparisons[] = {
    {CompareFunction::Never, false, false, false},
    {CompareFunction::Less, true, false, false},
    {CompareFunction::Equal, false, true, false},
    {CompareFunction::LessEqual, true, true, false},
    {CompareFunction::Greater, false, false, true},
    {CompareFunction::NotEqual, true, false, true},
    {CompareFunction::GreaterEqual, false, true, true},
    {CompareFunction::Always, true, true, true},
};

TEST(Fragments, DepthFunctionsAndMask) {
    for (const Comparison& c : kComparisons)
        for (const bool mask : {false, true})
            for (const float depth : {0.25f, 0.5f, 0.75f}) {
                FixedState state;
                state.ops.depthTest = true;
                state.ops.depthFunction = c.function;
                state.ops.depthMask = mask;
                PixelValue pixel{{0, 0, 0, 0}, 0.5f};
                const Fragment fragment = fragmentOf(state, {1, 0.5f, 0.25f, 1}, depth);
                replay({&fragment, 1}, pixel);
                const bool passes = depth < 0.5f ? c.below : depth == 0.5f ? c.equal : c.above;
                EXPECT_EQ(pixel.color.r, passes ? 1.0f : 0.0f) << int(c.function) << depth;
                EXPECT_EQ(pixel.depth, passes && mask ? depth : 0.5f) << int(c.function);
            }
}

TEST(Fragments, WithoutDepthTestNoDepthIsWritten) {
    FixedState state;
    PixelValue pixel{{0, 0, 0, 0}, 0.5f};
    const Fragment fragment = fragmentOf(state, {1, 1, 1, 1}, 0.75f);
    replay({&fragment, 1}, pixel);
    EXPECT_EQ(pixel.color.r, 1.0f);
    EXPECT_EQ(pixel.depth, 0.5f);
}

TEST(Fragments, AlphaFunctions) {
    for (const Comparison& c : kComparisons)
        for (const float alpha : {0.25f, 0.5f, 0.75f}) {
            FixedState state;
            state.ops.alphaTest = true;
            state.ops.alphaFunction = c.function;
            state.ops.alphaReference = 0.5f;
            state.ops.depthTest = true;
            PixelValue pixel;
            const Fragment fragment = fragmentOf(state, {1, 1, 1, alpha});
            replay({&fragment, 1}, pixel);
            const bool passes = alpha < 0.5f ? c.below : alpha == 0.5f ? c.equal : c.above;
            EXPECT_EQ(pixel.color.r, passes ? 1.0f : 0.0f) << int(c.function) << alpha;
            EXPECT_EQ(pixel.depth, passes ? 0.5f : 1.0f); // what fails writes no depth
        }
}

/// OpenGL 1.5, table 4.1, one function of (source, destination, constant, channel) each.
using Factor = std::function<double(const Color&, const Color&, const Color&, int)>;
struct NamedFactor {
    BlendFactor name;
    Factor value;
};
const std::vector<NamedFactor>& factors() {
    using C = const Color&;
    static const std::vector<NamedFactor> all = {
        {BlendFactor::Zero, [](C, C, C, int) { return 0.0; }},
        {BlendFactor::One, [](C, C, C, int) { return 1.0; }},
        {BlendFactor::SourceColor, [](C s, C, C, int k) { return s[size_t(k)]; }},
        {BlendFactor::OneMinusSourceColor, [](C s, C, C, int k) { return 1 - s[size_t(k)]; }},
        {BlendFactor::DestinationColor, [](C, C d, C, int k) { return d[size_t(k)]; }},
        {BlendFactor::OneMinusDestinationColor, [](C, C d, C, int k) { return 1 - d[size_t(k)]; }},
        {BlendFactor::SourceAlpha, [](C s, C, C, int) { return s[3]; }},
        {BlendFactor::OneMinusSourceAlpha, [](C s, C, C, int) { return 1 - s[3]; }},
        {BlendFactor::DestinationAlpha, [](C, C d, C, int) { return d[3]; }},
        {BlendFactor::OneMinusDestinationAlpha, [](C, C d, C, int) { return 1 - d[3]; }},
        {BlendFactor::ConstantColor, [](C, C, C c, int k) { return c[size_t(k)]; }},
        {BlendFactor::OneMinusConstantColor, [](C, C, C c, int k) { return 1 - c[size_t(k)]; }},
        {BlendFactor::ConstantAlpha, [](C, C, C c, int) { return c[3]; }},
        {BlendFactor::OneMinusConstantAlpha, [](C, C, C c, int) { return 1 - c[3]; }},
        {BlendFactor::SourceAlphaSaturate,
         [](C s, C d, C, int k) { return k == 3 ? 1.0 : std::min(s[3], 1 - d[3]); }},
    };
    return all;
}

double limited(double value) {
    return std::min(std::max(value, 0.0), 1.0);
}

TEST(Fragments, BlendFactorsAndEquations) {
    const Color source{0.8, 0.3, 0.55, 0.4}, destination{0.2, 0.9, 0.45, 0.7},
        constant{0.25, 0.5, 0.75, 0.6};
    const BlendEquation equations[] = {BlendEquation::Add, BlendEquation::Subtract,
                                       BlendEquation::ReverseSubtract, BlendEquation::Min,
                                       BlendEquation::Max};
    int cases = 0;
    for (const NamedFactor& from : factors())
        for (const NamedFactor& to : factors())
            for (const BlendEquation equation : equations) {
                FixedState state;
                state.ops.blend = true;
                state.ops.blendEquation = equation;
                state.ops.sourceRgb = state.ops.sourceAlpha = from.name;
                state.ops.destinationRgb = state.ops.destinationAlpha = to.name;
                state.ops.blendColor = toVec(constant);
                PixelValue pixel{toVec(destination), 1.0f};
                const Fragment fragment = fragmentOf(state, toVec(source));
                replay({&fragment, 1}, pixel);
                for (int k = 0; k < 4; ++k) {
                    const size_t i = size_t(k);
                    const double s = source[i] * from.value(source, destination, constant, k);
                    const double d = destination[i] * to.value(source, destination, constant, k);
                    double expected = 0;
                    switch (equation) {
                    case BlendEquation::Add: expected = s + d; break;
                    case BlendEquation::Subtract: expected = s - d; break;
                    case BlendEquation::ReverseSubtract: expected = d - s; break;
                    case BlendEquation::Min: expected = std::min(source[i], destination[i]); break;
                    case BlendEquation::Max: expected = std::max(source[i], destination[i]); break;
                    }
                    EXPECT_NEAR(pixel.color[k], limited(expected), 1e-6)
                        << int(from.name) << ' ' << int(to.name) << ' ' << int(equation);
                }
                ++cases;
            }
    EXPECT_EQ(cases, 15 * 15 * 5);
}

TEST(Fragments, SeparateFactorsForAlpha) {
    FixedState state;
    state.ops.blend = true;
    state.ops.sourceRgb = BlendFactor::SourceAlpha;
    state.ops.destinationRgb = BlendFactor::OneMinusSourceAlpha;
    state.ops.sourceAlpha = BlendFactor::Zero;
    state.ops.destinationAlpha = BlendFactor::One;
    PixelValue pixel{{0, 0, 0, 0.375f}, 1.0f};
    const Fragment fragment = fragmentOf(state, {1, 1, 1, 0.25f});
    replay({&fragment, 1}, pixel);
    EXPECT_EQ(pixel.color, glm::vec4(0.25f, 0.25f, 0.25f, 0.375f));
}

/// OpenGL 1.5, table 4.2, in the order of the tokens.
const std::vector<std::function<unsigned(unsigned, unsigned)>>& logicOps() {
    using U = unsigned;
    static const std::vector<std::function<U(U, U)>> all = {
        [](U, U) { return 0u; },         [](U s, U d) { return s & d; },
        [](U s, U d) { return s & ~d; }, [](U s, U) { return s; },
        [](U s, U d) { return ~s & d; }, [](U, U d) { return d; },
        [](U s, U d) { return s ^ d; },  [](U s, U d) { return s | d; },
        [](U s, U d) { return ~(s | d); }, [](U s, U d) { return ~(s ^ d); },
        [](U, U d) { return ~d; },       [](U s, U d) { return s | ~d; },
        [](U s, U) { return ~s; },       [](U s, U d) { return ~s | d; },
        [](U s, U d) { return ~(s & d); }, [](U, U) { return ~0u; },
    };
    return all;
}

TEST(Fragments, LogicalOperations) {
    for (unsigned op = 0; op < 16; ++op)
        for (unsigned s = 0; s < 256; s += 15)
            for (unsigned d = 0; d < 256; d += 17) {
                FixedState state;
                state.ops.colorLogicOp = true;
                state.ops.blend = true; // which the operation switches off
                state.ops.logicOp = uint8_t(op);
                PixelValue pixel{glm::vec4(float(d) / 255.0f), 1.0f};
                const Fragment fragment = fragmentOf(state, glm::vec4(float(s) / 255.0f));
                replay({&fragment, 1}, pixel);
                EXPECT_NEAR(pixel.color.g * 255.0f, float(logicOps()[op](s, d) & 0xFFu), 1e-3)
                    << op << ' ' << s << ' ' << d;
            }
}

TEST(Fragments, ColorMaskAndClamping) {
    FixedState state;
    state.ops.colorMask[1] = state.ops.colorMask[3] = false;
    PixelValue pixel{{0.1f, 0.2f, 0.3f, 0.4f}, 1.0f};
    const Fragment fragment = fragmentOf(state, {2.0f, 0.9f, -1.0f, 0.9f});
    replay({&fragment, 1}, pixel);
    EXPECT_EQ(pixel.color, glm::vec4(1.0f, 0.2f, 0.0f, 0.4f));
}

TEST(Fragments, WithoutStateTheNearestAndNoClamping) {
    Fragment fragments[3];
    const float depths[] = {0.5f, 0.25f, 0.25f};
    for (uint32_t i = 0; i < 3; ++i) {
        fragments[i].depth = depths[i];
        fragments[i].color = glm::vec4(2.0f + float(i));
        fragments[i].source = i;
    }
    PixelValue pixel;
    replay(fragments, pixel);
    EXPECT_EQ(pixel.color.r, 3.0f);
    EXPECT_EQ(pixel.depth, 0.25f);
    EXPECT_EQ(pixel.source, 1u);
}

TEST(Fragments, OrderOfWhatLiesBetweenInstances) {
    EXPECT_LT(orderBeforeInstance(0, 0xFFFFFFFFu), orderOfInstance(0, 0));
    EXPECT_LT(orderOfInstance(0, 0xFFFFFFFFu), orderBeforeInstance(1, 0));
    EXPECT_LT(orderBeforeInstance(1, 5), orderBeforeInstance(1, 6));
    EXPECT_LT(orderOfInstance(0xFFFFFFFEu, 7), orderOfInstance(0xFFFFFFFFu, 0));
}

// States of all kinds, in pixels of up to eight fragments.
class RandomPixels {
public:
    explicit RandomPixels(uint32_t seed) : random_(seed) {}

    void make() {
        states_.clear();
        fragments.clear();
        const int count = int(random_() % 8) + 1;
        for (int i = 0; i < count; ++i) {
            FixedState& state = states_.emplace_back();
            FixedFragmentOps& ops = state.ops;
            ops.alphaTest = chance(4);
            ops.alphaFunction = CompareFunction(random_() % 8);
            ops.alphaReference = 0.5f;
            ops.depthTest = !chance(4);
            ops.depthFunction = chance(2) ? CompareFunction::Less : CompareFunction(random_() % 8);
            ops.depthMask = !chance(4);
            ops.blend = chance(3);
            ops.sourceRgb = BlendFactor::SourceAlpha;
            ops.destinationRgb = BlendFactor::OneMinusSourceAlpha;
            ops.colorLogicOp = chance(10);
            ops.logicOp = uint8_t(random_() % 16);
            if (chance(6)) std::fill_n(ops.colorMask, 4, false);
            if (chance(6)) ops.colorMask[random_() % 4] = false;
        }
        for (const FixedState& state : states_) {
            Fragment fragment = fragmentOf(state, color(), float(random_() % 5) / 4.0f);
            fragment.source = uint32_t(fragments.size());
            fragments.push_back(fragment);
        }
        background = {color(), float(random_() % 5) / 4.0f};
    }
    glm::vec4 color() {
        const auto channel = [&] { return float(random_() % 9) / 8.0f; };
        return {channel(), channel(), channel(), channel()};
    }
    PixelValue replayed() const {
        PixelValue pixel = background;
        replay(fragments, pixel);
        return pixel;
    }

    std::vector<Fragment> fragments;
    PixelValue background;

private:
    bool chance(uint32_t n) { return random_() % n == 0; }
    std::mt19937 random_;
    std::deque<FixedState> states_;
};

TEST(Fragments, ColoursThatAreNotNeededDoNotMatter) {
    RandomPixels pixels(1);
    size_t spared = 0, total = 0, mattering = 0;
    for (int i = 0; i < 20000; ++i) {
        pixels.make();
        uint8_t needed[8];
        findNeeded(pixels.fragments, pixels.background.depth, needed);
        const PixelValue truth = pixels.replayed();
        total += pixels.fragments.size();
        for (size_t k = 0; k < pixels.fragments.size(); ++k) {
            const glm::vec4 kept = pixels.fragments[k].color;
            pixels.fragments[k].color = pixels.color();
            const PixelValue changed = pixels.replayed();
            const bool same = changed.color == truth.color && changed.depth == truth.depth &&
                              changed.source == truth.source;
            if (!needed[k]) {
                ++spared;
                ASSERT_TRUE(same) << "pixel " << i << ", fragment " << k;
            } else {
                mattering += !same;
            }
            pixels.fragments[k].color = kept;
        }
    }
    EXPECT_GT(spared, total / 3);     // most of what is hidden is found
    EXPECT_GT(mattering, total / 10); // the control: colours do matter
}

} // namespace
} // namespace smart::test
