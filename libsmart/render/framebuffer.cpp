// SPDX-License-Identifier: MIT
#include "libsmart/render/framebuffer.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace smart {
namespace {

// x to the power 2.4, for x in (0, 1]: Newton's method for the fifth root. No library function,
// so that every machine stores the same bytes; and known to the compiler.
constexpr double power2_4(double x) {
    const double square = x * x;
    double root = 1.0; // of square; from above, so that the steps fall until rounding stops them
    for (int i = 0; i < 200; ++i) {
        const double next = (4.0 * root + square / (root * root * root * root)) / 5.0;
        if (!(next < root)) break;
        root = next;
    }
    return square * root;
}

// Linear value of an sRGB-encoded one (IEC 61966-2-1).
constexpr double srgbToLinear(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : power2_4((encoded + 0.055) / 1.055);
}

// Entry i: the linear value from which i + 1 is nearer than i.
constexpr std::array<double, 255> srgbBorders() {
    std::array<double, 255> borders{};
    for (int i = 0; i < 255; ++i) borders[std::size_t(i)] = srgbToLinear((i + 0.5) / 255.0);
    return borders;
}
constexpr std::array<double, 255> kSrgbBorders = srgbBorders();

uint8_t toByte(float value, bool srgb) {
    if (!(value > 0.0f)) return 0; // NaN too
    if (value >= 1.0f) return 255;
    if (srgb)
        return uint8_t(std::upper_bound(kSrgbBorders.begin(), kSrgbBorders.end(), double(value)) -
                       kSrgbBorders.begin());
    return uint8_t(double(value) * 255.0 + 0.5); // in double the product is exact
}

/// A pixel's channels in the order in which they are stored.
template <int first, int second, int third, int count>
struct Order {
    static constexpr int kChannel[4] = {first, second, third, 3};
    static constexpr int kCount = count;
};

template <class Channels>
void storeFloats(std::byte* to, const glm::vec4* from, uint32_t pixels) {
    float row[kTileSize * Channels::kCount];
    for (uint32_t i = 0; i < pixels; ++i)
        for (int k = 0; k < Channels::kCount; ++k)
            row[i * uint32_t(Channels::kCount) + uint32_t(k)] = from[i][Channels::kChannel[k]];
    std::memcpy(to, row, pixels * uint32_t(Channels::kCount) * sizeof(float));
}

static_assert(sizeof(glm::vec4) == 4 * sizeof(float));

template <class Channels>
void storeBytes(std::byte* to, const glm::vec4* from, uint32_t pixels, bool srgb) {
    for (uint32_t i = 0; i < pixels; ++i)
        for (int k = 0; k < Channels::kCount; ++k, ++to) {
            const int channel = Channels::kChannel[k];
            *to = std::byte(toByte(from[i][channel], srgb && channel != 3));
        }
}

/// A row of a tile.
void store(std::byte* to, const glm::vec4* from, uint32_t pixels, PixelFormat format, bool srgb) {
    switch (format) {
        case PixelFormat::Bgr32f:
            return storeFloats<Order<2, 1, 0, 3>>(to, from, pixels);
        case PixelFormat::Rgb32f:
            return storeFloats<Order<0, 1, 2, 3>>(to, from, pixels);
        case PixelFormat::Rgba32f:
            std::memcpy(to, from, pixels * sizeof *from);
            return;
        case PixelFormat::Rgb8:
            return storeBytes<Order<0, 1, 2, 3>>(to, from, pixels, srgb);
        case PixelFormat::Rgba8:
            return storeBytes<Order<0, 1, 2, 4>>(to, from, pixels, srgb);
        case PixelFormat::Bgra8:
            return storeBytes<Order<2, 1, 0, 4>>(to, from, pixels, srgb);
    }
}

// Copies rows of the tile to a packed picture of values of the same type.
template <class Value>
void storeValues(void* memory, const PixelTarget& target, const Tile& tile, const Value* values) {
    if (!memory) return;
    for (uint32_t j = 0; j < tile.height; ++j) {
        const std::size_t first = (std::size_t(tile.y) + j) * target.width + tile.x;
        std::memcpy(static_cast<std::byte*>(memory) + first * sizeof(Value),
                    values + std::size_t(j) * kTileSize, tile.width * sizeof(Value));
    }
}

} // namespace

std::size_t bytesPerPixel(PixelFormat format) {
    switch (format) {
        case PixelFormat::Rgb8:
            return 3;
        case PixelFormat::Rgba8:
        case PixelFormat::Bgra8:
            return 4;
        case PixelFormat::Bgr32f:
        case PixelFormat::Rgb32f:
            return 12;
        case PixelFormat::Rgba32f:
            return 16;
    }
    return 0;
}

void writeTile(const PixelTarget& target, const Tile& tile, const TilePixels& pixels) {
    if (target.memory) {
        const std::size_t pixelSize = bytesPerPixel(target.format);
        const std::size_t stride =
            target.stride != 0 ? target.stride : std::size_t(target.width) * pixelSize;
        for (uint32_t j = 0; j < tile.height; ++j) {
            std::byte* to = static_cast<std::byte*>(target.memory) +
                            (std::size_t(tile.y) + j) * stride + tile.x * pixelSize;
            store(to, &pixels.color[j * kTileSize], tile.width, target.format, target.srgb);
        }
    }
    static_assert(sizeof(glm::vec3) == 3 * sizeof(float));
    storeValues(target.aux.depth, target, tile, pixels.depth);
    storeValues(target.aux.distance, target, tile, pixels.distance);
    storeValues(target.aux.normal, target, tile, pixels.normal);
    storeValues(target.aux.objectId, target, tile, pixels.objectId);
    storeValues(target.aux.instanceId, target, tile, pixels.instanceId);
    storeValues(target.aux.primitiveId, target, tile, pixels.primitiveId);
}

} // namespace smart
