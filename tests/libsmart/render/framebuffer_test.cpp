// SPDX-License-Identifier: MIT
#include "libsmart/render/framebuffer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <vector>

namespace smart {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

/// One pixel through writeTile, as bytes.
std::vector<uint8_t> bytesOf(const glm::vec4& color, PixelFormat format, bool srgb = false) {
    const auto pixels = std::make_unique<TilePixels>();
    pixels->color[0] = color;
    std::vector<uint8_t> memory(bytesPerPixel(format) + 1, 0xAB);
    PixelTarget target;
    target.memory = memory.data();
    target.width = target.height = 1;
    target.format = format;
    target.srgb = srgb;
    writeTile(target, {0, 0, 1, 1}, *pixels);
    EXPECT_EQ(memory.back(), 0xAB); // nothing behind the pixel
    memory.pop_back();
    return memory;
}

std::vector<float> floatsOf(const glm::vec4& color, PixelFormat format) {
    const std::vector<uint8_t> bytes = bytesOf(color, format);
    std::vector<float> floats(bytes.size() / sizeof(float));
    std::memcpy(floats.data(), bytes.data(), bytes.size());
    return floats;
}

using Bytes = std::vector<uint8_t>;
using Floats = std::vector<float>;

TEST(Framebuffer, ChannelOrder) {
    const glm::vec4 color(0.0f, 0.2f, 0.4f, 0.6f); // 0, 51, 102, 153
    EXPECT_EQ(bytesOf(color, PixelFormat::Rgb8), (Bytes{0, 51, 102}));
    EXPECT_EQ(bytesOf(color, PixelFormat::Rgba8), (Bytes{0, 51, 102, 153}));
    EXPECT_EQ(bytesOf(color, PixelFormat::Bgra8), (Bytes{102, 51, 0, 153}));
    EXPECT_EQ(floatsOf(color, PixelFormat::Bgr32f), (Floats{0.4f, 0.2f, 0.0f}));
    EXPECT_EQ(floatsOf(color, PixelFormat::Rgb32f), (Floats{0.0f, 0.2f, 0.4f}));
    EXPECT_EQ(floatsOf(color, PixelFormat::Rgba32f), (Floats{0.0f, 0.2f, 0.4f, 0.6f}));
}

TEST(Framebuffer, BytesAreClampedAndRoundedToNearest) {
    EXPECT_EQ(bytesOf({kNan, -1.0f, 2.0f, kNan}, PixelFormat::Rgba8), (Bytes{0, 0, 255, 0}));
    EXPECT_EQ(bytesOf({kInf, -kInf, 1.0f, -0.0f}, PixelFormat::Rgba8), (Bytes{255, 0, 255, 0}));
    // The numbers around each border between two bytes.
    for (int i = 0; i < 255; ++i) {
        const double border = (i + 0.5) / 255.0;
        const float below = std::nextafter(float(border), 0.0f);
        const float above = std::nextafter(float(border), 1.0f);
        const Bytes bytes = bytesOf({below, above, 0.0f, 0.0f}, PixelFormat::Rgb8);
        EXPECT_EQ(bytes[0], i);
        EXPECT_EQ(bytes[1], i + 1);
    }
}

TEST(Framebuffer, FloatsAreNotClamped) {
    EXPECT_EQ(floatsOf({-3.0f, 1e30f, kInf, 7.0f}, PixelFormat::Rgba32f),
              (Floats{-3.0f, 1e30f, kInf, 7.0f}));
    EXPECT_TRUE(std::isnan(floatsOf({kNan, 0, 0, 0}, PixelFormat::Rgb32f)[0]));
}

TEST(Framebuffer, SrgbEncodesColoursAndLeavesAlpha) {
    for (int i = 0; i <= 4000; ++i) {
        const float linear = float(i) / 4000.0f;
        const double encoded = linear <= 0.0031308 ? 12.92 * double(linear)
                                                   : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
        const double exact = encoded * 255.0;
        if (std::abs(exact - std::floor(exact) - 0.5) < 1e-6) continue; // too near to tell
        const Bytes bytes = bytesOf({linear, linear, linear, linear}, PixelFormat::Rgba8, true);
        const auto expected = uint8_t(std::lround(exact));
        ASSERT_EQ(bytes, (Bytes{expected, expected, expected,
                                uint8_t(std::lround(double(linear) * 255.0))}))
            << linear;
    }
    EXPECT_EQ(bytesOf({kNan, 5.0f, -1.0f, 1.0f}, PixelFormat::Rgba8, true),
              (Bytes{0, 255, 0, 255}));
    EXPECT_EQ(bytesOf({0.5f, 0.5f, 0.5f, 0.5f}, PixelFormat::Bgra8, true),
              (Bytes{188, 188, 188, 128}));
    // Formats of floats stay linear.
    const auto pixels = std::make_unique<TilePixels>();
    pixels->color[0] = glm::vec4(0.5f);
    float memory[3];
    PixelTarget target{memory, 1, 1, PixelFormat::Rgb32f, 0, true, {}};
    writeTile(target, {0, 0, 1, 1}, *pixels);
    EXPECT_EQ(memory[1], 0.5f);
}

TEST(Framebuffer, TilesGoToTheirPlaceWithRowZeroFirst) {
    constexpr uint32_t kWidth = 50, kHeight = 40;
    constexpr std::size_t kStride = kWidth * 3 + 7;
    const auto pixels = std::make_unique<TilePixels>();
    std::vector<uint8_t> memory(kStride * kHeight, 0xCD);
    std::vector<float> depth(kWidth * kHeight, -1.0f), distance = depth, normal(depth.size() * 3);
    std::vector<uint32_t> ids[3];
    for (auto& list : ids) list.assign(depth.size(), 0);
    PixelTarget target{memory.data(), kWidth, kHeight, PixelFormat::Rgb8, kStride, false, {}};
    target.aux = {depth.data(),  distance.data(), normal.data(),
                  ids[0].data(), ids[1].data(),   ids[2].data()};
    const Tile tile{32, 32, 18, 8};
    for (uint32_t j = 0; j < tile.height; ++j)
        for (uint32_t i = 0; i < tile.width; ++i) {
            const uint32_t entry = j * kTileSize + i;
            pixels->color[entry] = glm::vec4(float(i), float(j), 0, 0) / 255.0f;
            pixels->depth[entry] = float(entry);
            pixels->distance[entry] = float(entry) * 2;
            pixels->normal[entry] = {float(i), float(j), 0.5f};
            pixels->objectId[entry] = entry;
            pixels->instanceId[entry] = entry + 1;
            pixels->primitiveId[entry] = entry + 2;
        }
    writeTile(target, tile, *pixels);
    for (uint32_t y = 0; y < kHeight; ++y)
        for (uint32_t x = 0; x < kWidth; ++x) {
            const uint8_t* p = &memory[y * kStride + x * 3];
            const std::size_t i = std::size_t(y) * kWidth + x;
            if (x < 32 || y < 32) {
                EXPECT_EQ(p[0], 0xCD);
                EXPECT_EQ(depth[i], -1.0f);
                continue;
            }
            const uint32_t entry = (y - 32) * kTileSize + (x - 32);
            EXPECT_EQ(p[0], x - 32);
            EXPECT_EQ(p[1], y - 32);
            EXPECT_EQ(depth[i], float(entry));
            EXPECT_EQ(distance[i], float(entry) * 2);
            EXPECT_EQ(normal[3 * i], float(x - 32));
            EXPECT_EQ(normal[3 * i + 2], 0.5f);
            EXPECT_EQ(ids[0][i], entry);
            EXPECT_EQ(ids[1][i], entry + 1);
            EXPECT_EQ(ids[2][i], entry + 2);
        }
    // The bytes between the rows are not ours.
    for (uint32_t y = 0; y < kHeight; ++y)
        for (std::size_t k = kWidth * 3; k < kStride; ++k) EXPECT_EQ(memory[y * kStride + k], 0xCD);
}

} // namespace
} // namespace smart
