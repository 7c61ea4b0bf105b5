// SPDX-License-Identifier: MIT
#include "compat/recorder/pixel_unpack.h"

#include <algorithm>
#include <cstring>

#include "libsmart/base/half.h"

namespace smart::compat {

namespace {

// Instead of a source component:
constexpr int kOne = -1, kZero = -2; ///< these values

struct OrderInfo {
    uint32_t components;
    int rgba[4]; ///< where red, green, blue and alpha lie
};

OrderInfo info(PixelOrder order) {
    switch (order) {
    case PixelOrder::Luminance: return {1, {0, 0, 0, kOne}};
    case PixelOrder::LuminanceAlpha: return {2, {0, 0, 0, 1}};
    case PixelOrder::Rgb: return {3, {0, 1, 2, kOne}};
    case PixelOrder::Rgba: return {4, {0, 1, 2, 3}};
    case PixelOrder::Bgr: return {3, {2, 1, 0, kOne}};
    case PixelOrder::Red: return {1, {0, kZero, kZero, kOne}};
    case PixelOrder::Green: return {1, {kZero, 0, kZero, kOne}};
    case PixelOrder::Blue: return {1, {kZero, kZero, 0, kOne}};
    case PixelOrder::Alpha: return {1, {kZero, kZero, kZero, 0}};
    case PixelOrder::Bgra: break;
    }
    return {4, {2, 1, 0, 3}};
}

void writeOne(TexelType type, std::byte* out) {
    const float one = 1.0f;
    const uint16_t half = floatToHalf(one);
    if (type == TexelType::Float)
        std::memcpy(out, &one, sizeof one);
    else if (type == TexelType::Half)
        std::memcpy(out, &half, sizeof half);
    else
        std::memset(out, 0xFF, bytesPerChannel(type));
}

} // namespace

std::vector<std::byte> unpackImage(const ImageSource& source, const PixelStore& store,
                                   uint32_t channels, TexelFormat format) {
    const std::size_t size = bytesPerChannel(source.type);
    std::vector<std::byte> texels(std::size_t(source.width) * source.height * channels * size);
    if (!source.pixels) return texels;

    const OrderInfo order = info(source.order);
    // Which source component fills each channel: luminance [alpha], or red, green, blue [, alpha].
    int from[4];
    for (uint32_t c = 0; c < channels; ++c) from[c] = order.rgba[c];
    if (channels == 2) from[1] = order.rgba[3];
    if (format == TexelFormat::Alpha) from[0] = from[1] = from[2] = kZero;
    if (format == TexelFormat::Intensity) from[1] = from[2] = from[3] = from[0];

    const std::size_t pixelBytes = order.components * size;
    const std::size_t rowPixels = store.rowLength ? store.rowLength : source.width;
    std::size_t rowBytes = rowPixels * pixelBytes;
    if (size < store.alignment)
        rowBytes = (rowBytes + store.alignment - 1) / store.alignment * store.alignment;
    const auto* first = static_cast<const std::byte*>(source.pixels) + store.skipRows * rowBytes +
                        store.skipPixels * pixelBytes;
    std::byte* out = texels.data();
    for (uint32_t y = 0; y < source.height; ++y) {
        const std::byte* pixel = first + y * rowBytes;
        for (uint32_t x = 0; x < source.width; ++x, pixel += pixelBytes) {
            for (uint32_t c = 0; c < channels; ++c, out += size) {
                if (from[c] < 0) { // the texels are zeros as yet
                    if (from[c] == kOne) writeOne(source.type, out);
                    continue;
                }
                std::memcpy(out, pixel + std::size_t(from[c]) * size, size);
                if (store.swapBytes) std::reverse(out, out + size);
            }
        }
    }
    return texels;
}

std::vector<std::byte> unpackBitmap(const void* bits, uint32_t width, uint32_t height,
                                    const PixelStore& store) {
    const std::size_t outBytes = (std::size_t(width) + 7) / 8;
    const std::size_t rowBits = store.rowLength ? store.rowLength : width;
    const std::size_t groups = (rowBits + 8 * store.alignment - 1) / (8 * store.alignment);
    const std::size_t rowBytes = groups * store.alignment;
    const auto* const first = static_cast<const unsigned char*>(bits) + store.skipRows * rowBytes;
    std::vector<std::byte> out(outBytes * height);
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x) {
            const std::size_t bit = std::size_t(store.skipPixels) + x;
            const unsigned in = first[y * rowBytes + bit / 8];
            const unsigned shift = unsigned(store.lsbFirst ? bit % 8 : 7 - bit % 8);
            if ((in >> shift & 1u) != 0) out[y * outBytes + x / 8] |= std::byte(0x80u >> x % 8);
        }
    return out;
}

} // namespace smart::compat
