// SPDX-License-Identifier: MIT
#include "compat/recorder/pixel_unpack.h"

#include <algorithm>
#include <cstring>

#include "libsmart/base/half.h"

namespace smart::compat {

namespace {

// Instead of a source component:
constexpr int kOne = -1, kZero = -2; ///< these values

struct Places {
    int rgba[4]; ///< of red, green, blue and alpha among the components
};

Places placesOf(PixelOrder order) {
    switch (order) {
    case PixelOrder::Luminance: return {{0, 0, 0, kOne}};
    case PixelOrder::LuminanceAlpha: return {{0, 0, 0, 1}};
    case PixelOrder::Rgb: return {{0, 1, 2, kOne}};
    case PixelOrder::Bgr: return {{2, 1, 0, kOne}};
    case PixelOrder::Bgra: return {{2, 1, 0, 3}};
    case PixelOrder::Red: return {{0, kZero, kZero, kOne}};
    case PixelOrder::Green: return {{kZero, 0, kZero, kOne}};
    case PixelOrder::Blue: return {{kZero, kZero, 0, kOne}};
    case PixelOrder::Alpha: return {{kZero, kZero, kZero, 0}};
    default: return {{0, 1, 2, 3}};
    }
}

/// Which of red, green, blue and alpha fills each channel, or kOne, kZero.
void channelsFrom(TexelFormat format, uint32_t channels, int (&from)[4]) {
    for (int c = 0; c < 4; ++c) from[c] = c;
    if (channels == 2) from[1] = 3;
    if (format == TexelFormat::Alpha) from[0] = from[1] = from[2] = kZero;
    if (format == TexelFormat::Intensity) from[1] = from[2] = from[3] = from[0];
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

/// Whether texels hold the very numbers of the source.
bool isSame(PixelType source, TexelType type) {
    switch (source) {
    case PixelType::UnsignedByte: return type == TexelType::Byte;
    case PixelType::UnsignedShort: return type == TexelType::Short;
    case PixelType::Half: return type == TexelType::Half;
    case PixelType::Float: return type == TexelType::Float;
    default: return false;
    }
}

template <class Number>
Number numberAt(const std::byte* from, bool swap) {
    std::byte bytes[sizeof(Number)];
    std::memcpy(bytes, from, sizeof bytes);
    if (swap) std::reverse(bytes, bytes + sizeof bytes);
    Number number;
    std::memcpy(&number, bytes, sizeof number);
    return number;
}

double fromUnsigned(uint32_t number, int bits) {
    return number / double((uint64_t(1) << bits) - 1);
}
double fromSigned(int32_t number, int bits) {
    return (2.0 * number + 1.0) / double((uint64_t(1) << bits) - 1);
}

uint32_t numberOfFields(const std::byte* pixel, std::size_t bytes, bool swap) {
    switch (bytes) {
    case 1: return numberAt<uint8_t>(pixel, false);
    case 2: return numberAt<uint16_t>(pixel, swap);
    default: return numberAt<uint32_t>(pixel, swap);
    }
}

double valueAt(const std::byte* from, PixelType type, bool swap) {
    switch (type) {
    case PixelType::Byte: return fromSigned(numberAt<int8_t>(from, false), 8);
    case PixelType::UnsignedByte: return fromUnsigned(numberAt<uint8_t>(from, false), 8);
    case PixelType::Short: return fromSigned(numberAt<int16_t>(from, swap), 16);
    case PixelType::UnsignedShort: return fromUnsigned(numberAt<uint16_t>(from, swap), 16);
    case PixelType::Int: return fromSigned(numberAt<int32_t>(from, swap), 32);
    case PixelType::UnsignedInt: return fromUnsigned(numberAt<uint32_t>(from, swap), 32);
    case PixelType::Half: return double(halfToFloat(numberAt<uint16_t>(from, swap)));
    default: return double(numberAt<float>(from, swap));
    }
}

void componentsAt(const std::byte* pixel, const PixelLayout& layout, bool swap,
                  double (&components)[4]) {
    if (layout.type != PixelType::Fields) {
        for (uint32_t i = 0; i < layout.components(); ++i)
            components[i] = valueAt(pixel + i * layout.elementBytes(), layout.type, swap);
        return;
    }
    const PixelFields& fields = layout.fields;
    const uint32_t number = numberOfFields(pixel, fields.bytes, swap);
    for (uint32_t i = 0; i < fields.count; ++i) {
        const uint32_t most = (1u << fields.bitsOf(i)) - 1u;
        components[i] = fromUnsigned(number >> fields.shiftOf(i) & most, fields.bitsOf(i));
    }
}

/// Each pixel by way of its colour.
void convertRow(const std::byte* pixel, const ImageSource& source, bool swap, const int (&from)[4],
                uint32_t channels, TexelType type, const PixelTransfer& transfer, std::byte* out) {
    const Places places = placesOf(source.layout.order);
    const std::size_t pixelBytes = source.layout.pixelBytes();
    for (uint32_t x = 0; x < source.width; ++x, pixel += pixelBytes) {
        double components[4], rgba[4], values[4];
        componentsAt(pixel, source.layout, swap, components);
        for (int k = 0; k < 4; ++k) {
            const int place = places.rgba[k];
            const double given = place >= 0 ? components[place] : place == kOne ? 1.0 : 0.0;
            rgba[k] = given * double(transfer.scale[k]) + double(transfer.bias[k]);
        }
        for (uint32_t c = 0; c < channels; ++c) values[c] = from[c] < 0 ? 0.0 : rgba[from[c]];
        encodeTexels(values, channels, channels, type, false, out);
        out += channels * bytesPerChannel(type);
    }
}

void copyRow(const std::byte* pixel, const ImageSource& source, bool swap, const int (&from)[4],
             uint32_t channels, TexelType type, std::byte* out) {
    const Places places = placesOf(source.layout.order);
    const std::size_t size = bytesPerChannel(type), pixelBytes = source.layout.pixelBytes();
    int place[4];
    for (uint32_t c = 0; c < channels; ++c) place[c] = from[c] < 0 ? kZero : places.rgba[from[c]];
    for (uint32_t x = 0; x < source.width; ++x, pixel += pixelBytes)
        for (uint32_t c = 0; c < channels; ++c, out += size) {
            if (place[c] < 0) { // the texels are zeros as yet
                if (place[c] == kOne) writeOne(type, out);
                continue;
            }
            std::memcpy(out, pixel + std::size_t(place[c]) * size, size);
            if (swap) std::reverse(out, out + size);
        }
}

} // namespace

std::vector<std::byte> unpackImage(const ImageSource& source, const PixelStore& store,
                                   uint32_t channels, TexelType type, TexelFormat format,
                                   const PixelTransfer& transfer) {
    const std::size_t outRow = std::size_t(source.width) * channels * bytesPerChannel(type);
    std::vector<std::byte> texels(outRow * source.height);
    if (!source.pixels) return texels;

    int from[4];
    channelsFrom(format, channels, from);
    const PixelRows rows = rowsOf(source.layout, source.width, store);
    const auto* const first = static_cast<const std::byte*>(source.pixels) + rows.offset;
    const bool copied = isSame(source.layout.type, type) && transfer == PixelTransfer{};
    for (uint32_t y = 0; y < source.height; ++y) {
        const std::byte* const row = first + y * rows.stride;
        std::byte* const out = texels.data() + y * outRow;
        if (copied)
            copyRow(row, source, store.swapBytes, from, channels, type, out);
        else
            convertRow(row, source, store.swapBytes, from, channels, type, transfer, out);
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
