// SPDX-License-Identifier: MIT
#include "libsmart/shading/texture_image.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <string>

#include "libsmart/base/error.h"
#include "libsmart/base/half.h"

namespace smart {
namespace {

template <class T>
std::vector<std::byte> texels(const std::vector<T>& values) {
    std::vector<std::byte> bytes(values.size() * sizeof(T));
    std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
}

glm::vec4 texel(const TextureImage& image, std::size_t number) {
    const std::size_t numbers[] = {number};
    glm::vec4 rgba(-7.0f);
    image.read(numbers, &rgba);
    return rgba;
}

constexpr TexelType kTypes[] = {TexelType::Byte, TexelType::Short, TexelType::Half,
                                TexelType::Float};

// sRGB's definition (IEC 61966-2-1), in long double.
long double decodedByDefinition(long double encoded) {
    return encoded <= 0.04045L ? encoded / 12.92L
                               : std::pow((encoded + 0.055L) / 1.055L, 2.4L);
}

TEST(TextureImageTest, ChannelsOfEveryTypeByHand) {
    // Two texels of 0, 0.2, 0.4, 0.6 and 1, 0.8, 0.6, 0.4, the first channels of them.
    const double values[2][4] = {{0, 0.2, 0.4, 0.6}, {1, 0.8, 0.6, 0.4}};
    for (const TexelType type : kTypes)
        for (uint32_t channels = 1; channels <= 4; ++channels) {
            std::vector<uint8_t> bytes;
            std::vector<uint16_t> shorts, halves;
            std::vector<float> floats;
            for (const auto& pixel : values)
                for (uint32_t c = 0; c < channels; ++c) {
                    bytes.push_back(uint8_t(std::lround(pixel[c] * 255)));
                    shorts.push_back(uint16_t(std::lround(pixel[c] * 65535)));
                    halves.push_back(floatToHalf(float(pixel[c])));
                    floats.push_back(float(pixel[c]));
                }
            const TextureImage image(2, 1, channels, type, false,
                                     type == TexelType::Byte    ? texels(bytes)
                                     : type == TexelType::Short ? texels(shorts)
                                     : type == TexelType::Half  ? texels(halves)
                                                                : texels(floats));
            for (std::size_t i = 0; i < 2; ++i) {
                // 0.2, 0.4 ... are whole numbers of 255ths and of 65535ths.
                const auto value = [&](int c) {
                    return type == TexelType::Half
                               ? halfToFloat(floatToHalf(float(values[i][c])))
                               : float(values[i][c]);
                };
                const glm::vec4 found = texel(image, i);
                EXPECT_EQ(found.r, value(0));
                EXPECT_EQ(found.g, channels < 3 ? value(0) : value(1));
                EXPECT_EQ(found.b, channels < 3 ? value(0) : value(2));
                EXPECT_EQ(found.a, channels == 4   ? value(3)
                                   : channels == 2 ? value(1)
                                                   : 1.0f);
            }
        }
}

TEST(TextureImageTest, SrgbIsDecodedAndAlphaIsNot) {
    for (int i = 0; i < 256; ++i) {
        const auto code = uint8_t(i);
        const TextureImage image(1, 1, 4, TexelType::Byte, true,
                                 texels<uint8_t>({code, code, code, code}));
        const auto color = float(decodedByDefinition(i / 255.0L));
        EXPECT_EQ(texel(image, 0), glm::vec4(color, color, color, float(i / 255.0)));
    }
    for (int i = 0; i < 65536; i += 7) {
        const auto code = uint16_t(i);
        const TextureImage image(1, 1, 2, TexelType::Short, true, texels<uint16_t>({code, code}));
        ASSERT_EQ(texel(image, 0).r, float(decodedByDefinition(i / 65535.0L))) << i;
        ASSERT_EQ(texel(image, 0).a, float(code) / 65535.0f) << i;
    }
    for (const float value : {0.0f, 0.02f, 0.04045f, 0.25f, 0.5f, 1.0f, 3.0f}) {
        const TextureImage f(1, 1, 4, TexelType::Float, true,
                             texels<float>({value, value, value, value}));
        const auto decoded = double(decodedByDefinition((long double)value));
        EXPECT_NEAR(double(texel(f, 0).g), decoded, decoded * 0x1p-24 * 1.02);
        EXPECT_EQ(texel(f, 0).a, value);
        const uint16_t half = floatToHalf(value);
        const TextureImage h(1, 1, 3, TexelType::Half, true, texels<uint16_t>({half, half, half}));
        const double expected = double(decodedByDefinition(halfToFloat(half)));
        EXPECT_NEAR(double(texel(h, 0).b), expected, expected / 2048 + 1e-7);
    }
    // Brighter than a half can hold: the largest, not infinity.
    const uint16_t bright = floatToHalf(60000.0f);
    const TextureImage h(1, 1, 1, TexelType::Half, true, texels<uint16_t>({bright}));
    EXPECT_EQ(texel(h, 0).r, 65504.0f);
}

TEST(TextureImageTest, LinearIsAnotherImageThanSrgb) {
    const auto bytes = texels<uint8_t>({128});
    const TextureImage linear(1, 1, 1, TexelType::Byte, false, bytes);
    const TextureImage encoded(1, 1, 1, TexelType::Byte, true, bytes);
    EXPECT_GT(texel(linear, 0).r - texel(encoded, 0).r, 0.2f);
}

TEST(TextureImageTest, EncodingIsTheInverseOfReading) {
    for (const bool srgb : {false, true})
        for (uint32_t channels = 1; channels <= 4; ++channels) {
            std::vector<uint8_t> bytes(256 * channels);
            std::vector<uint16_t> shorts(256 * channels);
            for (std::size_t i = 0; i < bytes.size(); ++i) {
                bytes[i] = uint8_t(i);
                shorts[i] = uint16_t(i * 257 % 65536);
            }
            const auto expectBack = [&](TexelType type, const std::vector<std::byte>& given) {
                const TextureImage image(256, 1, channels, type, srgb, given);
                std::vector<float> row(256 * channels);
                image.readRow(0, row.data());
                const std::vector<double> values(row.begin(), row.end());
                std::vector<std::byte> back(given.size());
                encodeTexels(values.data(), values.size(), channels, type, srgb, back.data());
                EXPECT_EQ(back, given) << int(type) << " " << channels << " " << srgb;
            };
            expectBack(TexelType::Byte, texels(bytes));
            expectBack(TexelType::Short, texels(shorts));
        }
}

TEST(TextureImageTest, EncodingTakesTheNearestCode) {
    const auto byteOf = [](double value, bool srgb) {
        std::byte code{};
        encodeTexels(&value, 1, 1, TexelType::Byte, srgb, &code);
        return int(code);
    };
    EXPECT_EQ(byteOf(-3, false), 0);
    EXPECT_EQ(byteOf(7, false), 255);
    EXPECT_EQ(byteOf(0.4999 / 255, false), 0);
    EXPECT_EQ(byteOf(0.5001 / 255, false), 1);
    EXPECT_EQ(byteOf(-3, true), 0);
    EXPECT_EQ(byteOf(7, true), 255);
    for (int i = 0; i < 255; ++i) {
        const auto middle = double(decodedByDefinition((i + 0.5L) / 255.0L));
        EXPECT_EQ(byteOf(middle * (1 - 1e-9), true), i);
        EXPECT_EQ(byteOf(middle * (1 + 1e-9), true), i + 1);
    }
}

TEST(TextureImageTest, PartsReplaceAndConvert) {
    // 3 x 2 of zeros; a part of 2 x 1 at (1, 1), in every pair of types.
    for (const TexelType type : kTypes)
        for (const TexelType partType : kTypes)
            for (const bool srgb : {false, true}) {
                TextureImage result(3, 2, 1, type, srgb,
                                    std::vector<std::byte>(6 * bytesPerChannel(type)));
                const double values[] = {0.2, 0.8};
                std::vector<std::byte> partTexels(2 * bytesPerChannel(partType));
                encodeTexels(values, 2, 1, partType, false, partTexels.data());
                const TextureImage part(2, 1, 1, partType, srgb, std::move(partTexels));
                result.setPart(1, 1, part);
                for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(texel(result, i).r, 0);
                for (std::size_t i = 0; i < 2; ++i) {
                    const double expected =
                        srgb ? double(decodedByDefinition(values[i])) : values[i];
                    // Half a code of 1/255 in the slowest and 2.3/255 in the fastest part of sRGB.
                    EXPECT_NEAR(double(texel(result, 4 + i).r), expected, 0.005)
                        << int(type) << int(partType) << srgb;
                }
            }
    TextureImage image(3, 2, 1, TexelType::Byte, false, std::vector<std::byte>(6));
    const TextureImage wide(4, 1, 1, TexelType::Byte, false, std::vector<std::byte>(4));
    const TextureImage two(1, 1, 2, TexelType::Byte, false, std::vector<std::byte>(2));
    EXPECT_THROW(image.setPart(0, 0, wide), Error);
    EXPECT_THROW(image.setPart(0xFFFFFFFFu, 0, image), Error);
    EXPECT_THROW(image.setPart(0, 1, image), Error);
    EXPECT_THROW(image.setPart(0, 0, two), Error);
}

TEST(TextureImageTest, NonFiniteHalvesAndFloatsAreReplaced) {
    const TextureImage h(4, 1, 1, TexelType::Half, false,
                         texels<uint16_t>({0x7C00, 0xFC00, 0x7E01, 0x3C00}));
    EXPECT_EQ(texel(h, 0).r, 65504.0f);
    EXPECT_EQ(texel(h, 1).r, -65504.0f);
    EXPECT_EQ(texel(h, 2).r, 0.0f);
    EXPECT_EQ(texel(h, 3).r, 1.0f);
    constexpr float kInf = std::numeric_limits<float>::infinity();
    const TextureImage f(3, 1, 1, TexelType::Float, true,
                         texels<float>({kInf, -kInf, std::nanf("")}));
    EXPECT_TRUE(std::isfinite(texel(f, 0).r) && texel(f, 0).r > 1e38f);
    EXPECT_TRUE(std::isfinite(texel(f, 1).r) && texel(f, 1).r < -1e37f);
    EXPECT_EQ(texel(f, 2).r, 0.0f);
}

TEST(TextureImageTest, WrongSizesAreRefusedWithAText) {
    const auto expectRefused = [](uint32_t w, uint32_t h, uint32_t channels, TexelType type,
                                  std::size_t bytes) {
        try {
            TextureImage(w, h, channels, type, false, std::vector<std::byte>(bytes));
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
    expectRefused(2, 2, 4, TexelType::Half, 16);
    expectRefused(0xFFFFFFFFu, 0xFFFFFFFFu, 4, TexelType::Float, 16);
    expectRefused(1u << 31, 2, 1, TexelType::Byte, 0);
    EXPECT_NO_THROW(TextureImage(2, 2, 4, TexelType::Float, false, std::vector<std::byte>(64)));
}

} // namespace
} // namespace smart
