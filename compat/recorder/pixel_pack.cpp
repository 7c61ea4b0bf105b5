// SPDX-License-Identifier: MIT
#include "compat/recorder/pixel_pack.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "libsmart/base/half.h"

namespace smart::compat {

namespace {

double clamped(double value) {
    return value > 0.0 ? std::min(value, 1.0) : 0.0; // NaN: 0
}

void components(const glm::vec4& c, float depth, PixelOrder order, double (&out)[4]) {
    const auto set = [&](double a, double b = 0, double d = 0, double e = 0) {
        out[0] = a, out[1] = b, out[2] = d, out[3] = e;
    };
    switch (order) {
    case PixelOrder::Red: return set(c.r);
    case PixelOrder::Green: return set(c.g);
    case PixelOrder::Blue: return set(c.b);
    case PixelOrder::Alpha: return set(c.a);
    case PixelOrder::Luminance: return set(clamped(double(c.r) + c.g + c.b));
    case PixelOrder::LuminanceAlpha: return set(clamped(double(c.r) + c.g + c.b), c.a);
    case PixelOrder::Rgb: return set(c.r, c.g, c.b);
    case PixelOrder::Bgr: return set(c.b, c.g, c.r);
    case PixelOrder::Rgba: return set(c.r, c.g, c.b, c.a);
    case PixelOrder::Bgra: return set(c.b, c.g, c.r, c.a);
    case PixelOrder::Depth: return set(depth);
    }
}

/// A component as a whole number of so many bits.
uint32_t toBits(double value, int bits) {
    const double most = double((uint64_t(1) << bits) - 1);
    return uint32_t(uint64_t(clamped(value) * most + 0.5));
}
/// OpenGL's signed numbers: -1 to 1 goes over all of them.
int64_t toSigned(double value, int bits) {
    const double most = double((uint64_t(1) << bits) - 1);
    return int64_t(std::floor((most * clamped(value) - 1.0) / 2.0 + 0.5));
}

template <class Number>
void put(std::byte* to, Number number, bool swap) {
    std::byte bytes[sizeof(Number)];
    std::memcpy(bytes, &number, sizeof number);
    if (swap) std::reverse(bytes, bytes + sizeof number);
    std::memcpy(to, bytes, sizeof number);
}

void putComponent(std::byte* to, double value, PixelType type, bool swap) {
    switch (type) {
    case PixelType::Byte: return put(to, int8_t(toSigned(value, 8)), false);
    case PixelType::UnsignedByte: return put(to, uint8_t(toBits(value, 8)), false);
    case PixelType::Short: return put(to, int16_t(toSigned(value, 16)), swap);
    case PixelType::UnsignedShort: return put(to, uint16_t(toBits(value, 16)), swap);
    case PixelType::Int: return put(to, int32_t(toSigned(value, 32)), swap);
    case PixelType::UnsignedInt: return put(to, toBits(value, 32), swap);
    case PixelType::Half: return put(to, floatToHalf(float(value)), swap);
    default: return put(to, float(value), swap);
    }
}

void putFields(std::byte* to, const double (&values)[4], const PixelFields& fields, bool swap) {
    uint32_t number = 0;
    for (uint32_t i = 0; i < fields.count; ++i)
        number |= toBits(values[i], fields.bitsOf(i)) << fields.shiftOf(i);
    if (fields.bytes == 1) return put(to, uint8_t(number), false);
    if (fields.bytes == 2) return put(to, uint16_t(number), swap);
    put(to, number, swap);
}

} // namespace

void packPixels(const Picture& picture, const ReadArea& area, const PixelLayout& layout,
                const PixelStore& store, const PixelTransfer& transfer, void* to) {
    const std::size_t element = layout.elementBytes(), pixel = layout.pixelBytes();
    const PixelRows rows = rowsOf(layout, area.width, store);
    std::byte* const first = static_cast<std::byte*>(to) + rows.offset;
    const int64_t startX = std::max<int64_t>(area.x, 0), startY = std::max<int64_t>(area.y, 0);
    const int64_t endX = std::min<int64_t>(int64_t(area.x) + area.width, picture.target.width);
    const int64_t endY = std::min<int64_t>(int64_t(area.y) + area.height, picture.target.height);
    for (int64_t y = startY; y < endY; ++y)
        for (int64_t x = startX; x < endX; ++x) {
            std::byte* at = first + std::size_t(y - area.y) * rows.stride +
                            std::size_t(x - area.x) * pixel;
            double values[4];
            if (layout.order == PixelOrder::Depth)
                components({}, picture.depthAt(uint32_t(x), uint32_t(y)), layout.order, values);
            else
                components(transfer(picture.colorAt(uint32_t(x), uint32_t(y))), 0.0f, layout.order,
                           values);
            if (layout.type == PixelType::Fields) {
                putFields(at, values, layout.fields, store.swapBytes);
                continue;
            }
            for (uint32_t i = 0; i < layout.components(); ++i)
                putComponent(at + i * element, values[i], layout.type, store.swapBytes);
        }
}

} // namespace smart::compat
