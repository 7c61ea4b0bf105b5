// SPDX-License-Identifier: MIT
#include "libsmart/shading/texture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "libsmart/base/error.h"

namespace smart {
namespace {

template <class T>
std::vector<std::byte> texels(const std::vector<T>& values) {
    std::vector<std::byte> bytes(values.size() * sizeof(T));
    std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
}

TextureOptions options(TextureWrap wrap, TextureFilter filter, bool srgb = false) {
    return {wrap, wrap, filter, srgb};
}

const auto kNearest = options(TextureWrap::Repeat, TextureFilter::Nearest);
const auto kLinear = options(TextureWrap::Repeat, TextureFilter::Linear);

TEST(TextureTest, ChannelsAndTypes) {
    const Texture l(1, 1, 1, TexelType::Byte, texels<uint8_t>({51}), kNearest);
    EXPECT_EQ(l.sample(0.5f, 0.5f), glm::vec4(0.2f, 0.2f, 0.2f, 1.0f));
    const Texture la(1, 1, 2, TexelType::Byte, texels<uint8_t>({51, 102}), kNearest);
    EXPECT_EQ(la.sample(0.5f, 0.5f), glm::vec4(0.2f, 0.2f, 0.2f, 0.4f));
    const Texture rgb(1, 1, 3, TexelType::Short, texels<uint16_t>({0, 13107, 65535}), kNearest);
    EXPECT_EQ(rgb.sample(0.5f, 0.5f), glm::vec4(0.0f, 0.2f, 1.0f, 1.0f));
    const Texture rgba(1, 1, 4, TexelType::Float, texels<float>({-1, 2, 3e5f, 0.5f}), kNearest);
    EXPECT_EQ(rgba.sample(0.5f, 0.5f), glm::vec4(-1.0f, 2.0f, 3e5f, 0.5f));
}

TEST(TextureTest, SrgbBytesAreDecodedAndAlphaIsNot) {
    for (int i = 0; i < 256; ++i) {
        const auto byte = uint8_t(i);
        const Texture t(1, 1, 4, TexelType::Byte, texels<uint8_t>({byte, byte, byte, byte}),
                        options(TextureWrap::Repeat, TextureFilter::Nearest, true));
        const long double encoded = i / 255.0L;
        const long double linear = encoded <= 0.04045L
                                       ? encoded / 12.92L
                                       : std::pow((encoded + 0.055L) / 1.055L, 2.4L);
        const auto color = float(linear);
        EXPECT_EQ(t.sample(0.5f, 0.5f), glm::vec4(color, color, color, float(i / 255.0)));
    }
}

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
    const Texture clamped = numbered(options(TextureWrap::Clamp, TextureFilter::Linear));
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
    const Texture nearest = numbered(options(TextureWrap::Clamp, TextureFilter::Nearest));
    EXPECT_EQ(nearest.sample(1.0f, 1.0f).r, 5);
    const auto mirror = options(TextureWrap::Mirror, TextureFilter::Nearest);
    EXPECT_EQ(numbered(mirror).sample(1.0f, 0.0f).r, 2);
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
                          options(TextureWrap::Clamp, TextureFilter::Linear));
    EXPECT_GT(std::fabs(clamped.sample(0.0f, 0.5f).r - tentSum(image, 4, 1, 0, 0.5)), 1);
}

TEST(TextureTest, HugeAndNonFiniteCoordinates) {
    constexpr float kInf = std::numeric_limits<float>::infinity();
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    constexpr float kMax = std::numeric_limits<float>::max();
    for (const auto wrap : {TextureWrap::Repeat, TextureWrap::Clamp, TextureWrap::Mirror})
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

TEST(TextureTest, WrongSizesAreRefusedWithAText) {
    const auto expectRefused = [](uint32_t w, uint32_t h, uint32_t channels, TexelType type,
                                  std::size_t bytes) {
        try {
            Texture(w, h, channels, type, std::vector<std::byte>(bytes), {});
            ADD_FAILURE() << w << " x " << h << " x " << channels << ": " << bytes;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::InvalidValue);
            EXPECT_FALSE(std::string(error.what()).empty());
        }
    };
    expectRefused(0, 1, 1, TexelType::Byte, 0);
    expectRefused(1, 0, 1, TexelType::Byte, 0);
    expectRefused(2, 2, 0, TexelType::Byte, 0);
    expectRefused(2, 2, 5, TexelType::Byte, 20);
    expectRefused(2, 2, 4, TexelType::Byte, 15);
    expectRefused(2, 2, 4, TexelType::Byte, 17);
    expectRefused(2, 2, 4, TexelType::Short, 16);
    expectRefused(0xFFFFFFFFu, 0xFFFFFFFFu, 4, TexelType::Float, 16);
    expectRefused(1u << 31, 2, 1, TexelType::Byte, 0);
    EXPECT_NO_THROW(Texture(2, 2, 4, TexelType::Float, std::vector<std::byte>(64), {}));
}

} // namespace
} // namespace smart
