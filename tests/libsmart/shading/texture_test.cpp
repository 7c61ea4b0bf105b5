// SPDX-License-Identifier: MIT
#include "libsmart/shading/texture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/common.hpp>
#include <limits>
#include <random>
#include <vector>

namespace smart {
namespace {

template <class T>
std::vector<std::byte> texels(const std::vector<T>& values) {
    std::vector<std::byte> bytes(values.size() * sizeof(T));
    std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
}

TextureOptions options(TextureWrap wrap, TextureFilter filter) {
    return {.wrapS = wrap, .wrapT = wrap, .magnification = filter};
}

constexpr TextureWrap kWraps[] = {TextureWrap::Repeat, TextureWrap::Mirror,
                                  TextureWrap::ClampToEdge, TextureWrap::ClampToBorder,
                                  TextureWrap::Clamp};

const auto kNearest = options(TextureWrap::Repeat, TextureFilter::Nearest);
const auto kLinear = options(TextureWrap::Repeat, TextureFilter::Linear);

// Texels 0 1 2 / 3 4 5 from the bottom.
Texture numbered(const TextureOptions& o) {
    return Texture(3, 2, 1, TexelType::Float, texels<float>({0, 1, 2, 3, 4, 5}), o);
}

TEST(TextureTest, NearestTakesTheTexelThatHoldsThePoint) {
    const Texture t = numbered(kNearest);
    EXPECT_EQ(t.sample(0.0f, 0.0f).r, 0);
    EXPECT_EQ(t.sample(0.3f, 0.1f).r, 0);
    EXPECT_EQ(t.sample(0.34f, 0.1f).r, 1);
    EXPECT_EQ(t.sample(0.99f, 0.49f).r, 2);
    EXPECT_EQ(t.sample(0.99f, 0.51f).r, 5);
    EXPECT_EQ(t.sample(1.0f, 0.0f).r, 0);   // the next image's first
    EXPECT_EQ(t.sample(-0.1f, -0.1f).r, 5);
    EXPECT_EQ(t.sample(-2.9f, 7.0f).r, 0);
}

// Texels 0 1 2 3 / 10 11 12 13 from the bottom.
Texture eight() {
    return Texture(4, 2, 1, TexelType::Float, texels<float>({0, 1, 2, 3, 10, 11, 12, 13}), kLinear);
}

TEST(TextureTest, LinearMeetsCentresAndMiddles) {
    const Texture t = eight();
    for (int x = 0; x < 4; ++x)
        for (int y = 0; y < 2; ++y)
            EXPECT_EQ(t.sample((float(x) + 0.5f) / 4, (float(y) + 0.5f) / 2).r, float(10 * y + x));
    EXPECT_EQ(t.sample(0.25f, 0.25f).r, 0.5f);
    EXPECT_EQ(t.sample(0.5f, 0.5f).r, 6.5f);
    EXPECT_EQ(t.sample(0.1875f, 0.25f).r, 0.25f);
}

TEST(TextureTest, RepeatingHasNoSeam) {
    const Texture t = eight();
    // At the border both texels have half the weight.
    EXPECT_EQ(t.sample(0.0f, 0.25f).r, 1.5f);
    EXPECT_EQ(t.sample(1.0f, 0.25f).r, 1.5f);
    EXPECT_EQ(t.sample(0.125f, 0.0f).r, 5.0f);
    EXPECT_EQ(t.sample(0.125f, 1.0f).r, 5.0f);
    EXPECT_EQ(t.sample(0.0f, 0.0f).r, 6.5f);
    // A small step changes the value little, everywhere, borders included.
    float before = t.sample(-1.0f, 0.25f).r;
    for (float s = -1.0f; s <= 2.0f; s += 1.0f / 256) {
        const float value = t.sample(s, 0.25f).r;
        EXPECT_LE(std::fabs(value - before), 3.0f * 4 / 256 + 1e-5f) << s;
        before = value;
        EXPECT_EQ(t.sample(s + 3, 0.25f).r, value) << s; // sums of dyadic numbers are exact
    }
    EXPECT_NEAR(t.sample(-1e-30f, 0.25f).r, 1.5f, 1e-6f);
    EXPECT_NEAR(t.sample(std::nextafter(1.0f, 0.0f), 0.25f).r, 1.5f, 1e-5f);
}

TEST(TextureTest, ClampingAndMirroringKeepTheBorder) {
    const Texture clamped = numbered(options(TextureWrap::ClampToEdge, TextureFilter::Linear));
    EXPECT_EQ(clamped.sample(-5.0f, 0.25f).r, 0);
    EXPECT_EQ(clamped.sample(0.0f, 0.25f).r, 0);
    EXPECT_EQ(clamped.sample(1.0f, 0.25f).r, 2);
    EXPECT_EQ(clamped.sample(9.0f, 0.75f).r, 5);
    const Texture mirrored = numbered(options(TextureWrap::Mirror, TextureFilter::Linear));
    for (float s = 0; s <= 1; s += 1.0f / 64) {
        const float value = mirrored.sample(s, 0.25f).r;
        EXPECT_EQ(mirrored.sample(-s, 0.25f).r, value) << s;
        EXPECT_EQ(mirrored.sample(2 - s, 0.25f).r, value) << s;
        EXPECT_EQ(mirrored.sample(s + 4, 0.25f).r, value) << s;
        EXPECT_EQ(clamped.sample(s, 0.25f).r, value) << s;
    }
    const Texture nearest = numbered(options(TextureWrap::ClampToEdge, TextureFilter::Nearest));
    EXPECT_EQ(nearest.sample(1.0f, 1.0f).r, 5);
    const auto mirror = options(TextureWrap::Mirror, TextureFilter::Nearest);
    EXPECT_EQ(numbered(mirror).sample(1.0f, 0.0f).r, 2);
}

TEST(TextureTest, BordersHaveTheChannelsOfTheImage) {
    const glm::vec4 border(0.25f, 0.5f, 0.75f, 0.125f);
    const auto seen = [&](uint32_t channels, TexelFormat format) {
        const std::vector<float> image(channels, 1.0f);
        return Texture(1, 1, channels, TexelType::Float, texels(image),
                       {.wrapS = TextureWrap::ClampToBorder, .border = border, .format = format})
            .sample(5.0f, 0.5f);
    };
    const TexelFormat any = TexelFormat::ByChannels;
    EXPECT_EQ(seen(1, any), glm::vec4(0.25f, 0.25f, 0.25f, 1.0f));
    EXPECT_EQ(seen(2, any), glm::vec4(0.25f, 0.25f, 0.25f, 0.125f));
    EXPECT_EQ(seen(3, any), glm::vec4(0.25f, 0.5f, 0.75f, 1.0f));
    EXPECT_EQ(seen(4, any), border);
    EXPECT_EQ(seen(4, TexelFormat::Intensity), glm::vec4(0.25f));
}

// The definition, texel by texel: sum over all copies of the image of texel times tent function.
double tentSum(const std::vector<float>& image, int width, int height, double s, double t) {
    const double x = s * width, y = t * height;
    double sum = 0;
    for (int j = int(std::floor(y)) - 2; j <= int(std::floor(y)) + 2; ++j)
        for (int i = int(std::floor(x)) - 2; i <= int(std::floor(x)) + 2; ++i) {
            const double wx = 1 - std::fabs(x - (i + 0.5)), wy = 1 - std::fabs(y - (j + 0.5));
            if (wx <= 0 || wy <= 0) continue;
            const int column = ((i % width) + width) % width;
            const int row = ((j % height) + height) % height;
            sum += wx * wy * double(image[std::size_t(row * width + column)]);
        }
    return sum;
}

TEST(TextureTest, LinearFilteringIsTheTentOverTheTiledPlane) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> value(0, 1), coordinate(-4, 4);
    for (const auto& [width, height] : {std::pair{1, 1}, {1, 5}, {7, 3}, {16, 16}}) {
        std::vector<float> image(std::size_t(width * height));
        for (float& v : image) v = value(random);
        const Texture t(uint32_t(width), uint32_t(height), 1, TexelType::Float, texels(image),
                        kLinear);
        for (int i = 0; i < 500; ++i) {
            const float s = coordinate(random), u = coordinate(random);
            EXPECT_NEAR(t.sample(s, u).r, tentSum(image, width, height, s, u), 1e-6)
                << width << " x " << height << " at " << s << ", " << u;
        }
    }
}

TEST(TextureTest, TheTentCheckerSeesASeam) {
    // What a texture that clamps at its border would give there.
    const std::vector<float> image = {0, 1, 2, 3};
    const Texture clamped(4, 1, 1, TexelType::Float, texels(image),
                          options(TextureWrap::ClampToEdge, TextureFilter::Linear));
    EXPECT_GT(std::fabs(clamped.sample(0.0f, 0.5f).r - tentSum(image, 4, 1, 0, 0.5)), 1);
}

TEST(TextureTest, HugeAndNonFiniteCoordinates) {
    constexpr float kInf = std::numeric_limits<float>::infinity();
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    constexpr float kMax = std::numeric_limits<float>::max();
    for (const auto wrap : kWraps)
        for (const auto filter : {TextureFilter::Nearest, TextureFilter::Linear}) {
            const Texture t = numbered(options(wrap, filter));
            for (const float s : {kMax, -kMax, 1e20f, -1e20f, 16777217.0f, 1e-45f, -1e-45f})
                for (const float u : {kMax, -kMax, 0.3f}) {
                    const float value = t.sample(s, u).r;
                    EXPECT_GE(value, 0) << s;
                    EXPECT_LE(value, 5) << s;
                }
            for (const float bad : {kInf, -kInf, kNan}) {
                EXPECT_EQ(t.sample(bad, 0.5f), glm::vec4(0, 0, 0, 1));
                EXPECT_EQ(t.sample(0.5f, bad), glm::vec4(0, 0, 0, 1));
            }
        }
}

TEST(TextureTest, NonFiniteTexelsDoNotSpread) {
    constexpr float kInf = std::numeric_limits<float>::infinity();
    constexpr float kMax = std::numeric_limits<float>::max();
    const Texture t(4, 1, 1, TexelType::Float,
                    texels<float>({std::nanf(""), kInf, -kInf, 1.0f}), kLinear);
    EXPECT_EQ(t.sample(0.125f, 0.5f).r, 0);
    EXPECT_EQ(t.sample(0.375f, 0.5f).r, kMax);
    EXPECT_EQ(t.sample(0.625f, 0.5f).r, -kMax);
    EXPECT_EQ(t.sample(0.5f, 0.5f).r, 0);
    EXPECT_EQ(t.sample(0.875f, 0.5f).r, 1);
}

// OpenGL 1.5, section 3.8.7, by the letter: where texel i of an endless row is found in one of
// `size` texels; -1: the border.
int wrappedTexel(int i, int size, TextureWrap wrap) {
    const int period = ((i % size) + size) % size;
    switch (wrap) {
    case TextureWrap::Repeat: return period;
    case TextureWrap::Mirror: {
        const int copy = (i - period) / size;
        return copy % 2 == 0 ? period : size - 1 - period;
    }
    case TextureWrap::ClampToEdge: return std::clamp(i, 0, size - 1);
    case TextureWrap::ClampToBorder:
    case TextureWrap::Clamp: break;
    }
    return i < 0 || i >= size ? -1 : i;
}

double clampedCoordinate(double c, int size, TextureWrap wrap) {
    const double half = 0.5 / size;
    switch (wrap) {
    case TextureWrap::ClampToEdge: return std::clamp(c, half, 1 - half);
    case TextureWrap::ClampToBorder: return std::clamp(c, -half, 1 + half);
    case TextureWrap::Clamp: return std::clamp(c, 0.0, 1.0);
    default: return c;
    }
}

TEST(TextureTest, EveryWrapAndFilterIsWhatOpenGLSays) {
    constexpr int kWidth = 5, kHeight = 3;
    constexpr float kBorder = 9;
    std::mt19937 random(17);
    std::uniform_real_distribution<float> value(0, 1), coordinate(-3, 3);
    std::vector<float> image(kWidth * kHeight);
    for (float& v : image) v = value(random);
    const auto texel = [&](int i, int j, TextureWrap wrapS, TextureWrap wrapT) {
        const int column = wrappedTexel(i, kWidth, wrapS), row = wrappedTexel(j, kHeight, wrapT);
        return column < 0 || row < 0 ? double(kBorder)
                                     : double(image[std::size_t(row * kWidth + column)]);
    };
    for (const auto wrapS : kWraps)
        for (const auto wrapT : kWraps)
            for (const auto filter : {TextureFilter::Nearest, TextureFilter::Linear}) {
                const Texture t(kWidth, kHeight, 1, TexelType::Float, texels(image),
                                {.wrapS = wrapS, .wrapT = wrapT, .magnification = filter,
                                 .border = glm::vec4(kBorder, 0, 0, 0)});
                for (int n = 0; n < 300; ++n) {
                    const float s = coordinate(random), u = coordinate(random);
                    const double x = clampedCoordinate(double(s), kWidth, wrapS) * kWidth;
                    const double y = clampedCoordinate(double(u), kHeight, wrapT) * kHeight;
                    double expected = 0;
                    if (filter == TextureFilter::Nearest) {
                        const bool right = x == kWidth && wrapS != TextureWrap::Repeat;
                        const bool top = y == kHeight && wrapT != TextureWrap::Repeat;
                        expected = texel(right ? kWidth - 1 : int(std::floor(x)),
                                         top ? kHeight - 1 : int(std::floor(y)), wrapS, wrapT);
                    } else {
                        const int i = int(std::floor(x - 0.5)), j = int(std::floor(y - 0.5));
                        const double a = x - 0.5 - i, b = y - 0.5 - j;
                        expected = (1 - a) * (1 - b) * texel(i, j, wrapS, wrapT) +
                                   a * (1 - b) * texel(i + 1, j, wrapS, wrapT) +
                                   (1 - a) * b * texel(i, j + 1, wrapS, wrapT) +
                                   a * b * texel(i + 1, j + 1, wrapS, wrapT);
                    }
                    ASSERT_NEAR(double(t.sample(s, u).r), expected, 1e-5)
                        << int(wrapS) << int(wrapT) << int(filter) << " at " << s << ", " << u;
                }
            }
}

TEST(TextureTest, TheWrapCheckerTellsTheClampsApart) {
    // At the border half of the colour is the border's, beyond it all of it, or none.
    const auto at = [](TextureWrap wrap, float s) {
        TextureOptions o = options(wrap, TextureFilter::Linear);
        o.border = glm::vec4(9.0f);
        return numbered(o).sample(s, 0.25f).r;
    };
    EXPECT_EQ(at(TextureWrap::Clamp, 1.0f), (2 + 9) / 2.0f);
    EXPECT_EQ(at(TextureWrap::Clamp, 5.0f), (2 + 9) / 2.0f);
    EXPECT_EQ(at(TextureWrap::ClampToBorder, 1.0f), (2 + 9) / 2.0f);
    EXPECT_EQ(at(TextureWrap::ClampToBorder, 5.0f), 9);
    EXPECT_EQ(at(TextureWrap::ClampToEdge, 5.0f), 2);
}

TEST(TextureTest, TheBorderHasTheChannelsOfTheImage) {
    for (uint32_t channels = 1; channels <= 4; ++channels) {
        TextureOptions o = options(TextureWrap::ClampToBorder, TextureFilter::Nearest);
        o.border = {0.25f, 0.5f, 3.0f, 0.75f};
        const glm::vec4 expected[] = {{0.25f, 0.25f, 0.25f, 1.0f},
                                      {0.25f, 0.25f, 0.25f, 0.75f},
                                      {0.25f, 0.5f, 3.0f, 1.0f},
                                      {0.25f, 0.5f, 3.0f, 0.75f}};
        const Texture f(1, 1, channels, TexelType::Float, std::vector<std::byte>(4 * channels), o);
        EXPECT_EQ(f.sample(2.0f, 0.5f), expected[channels - 1]);
        const Texture b(1, 1, channels, TexelType::Byte, std::vector<std::byte>(channels), o);
        EXPECT_EQ(b.sample(0.5f, -1.0f), glm::min(expected[channels - 1], 1.0f));
    }
}

} // namespace
} // namespace smart
