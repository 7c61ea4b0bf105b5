// SPDX-License-Identifier: MIT
#include "compat/recorder/pixel_pack.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace smart::compat {

namespace {

double clamped(double value) {
    return value > 0.0 ? std::min(value, 1.0) : 0.0; // NaN: 0
}

uint32_t componentsOf(PackOrder order) {
    switch (order) {
    case PackOrder::LuminanceAlpha: return 2;
    case PackOrder::Rgb:
    case PackOrder::Bgr: return 3;
    case PackOrder::Rgba:
    case PackOrder::Bgra: return 4;
    default: return 1;
    }
}

std::size_t bytesOf(PackType type) {
    switch (type) {
    case PackType::Byte:
    case PackType::UnsignedByte: return 1;
    case PackType::Short:
    case PackType::UnsignedShort: return 2;
    default: return 4;
    }
}

void components(const glm::vec4& c, float depth, PackOrder order, double (&out)[4]) {
    const auto set = [&](double a, double b = 0, double d = 0, double e = 0) {
        out[0] = a, out[1] = b, out[2] = d, out[3] = e;
    };
    switch (order) {
    case PackOrder::Red: return set(c.r);
    case PackOrder::Green: return set(c.g);
    case PackOrder::Blue: return set(c.b);
    case PackOrder::Alpha: return set(c.a);
    case PackOrder::Luminance: return set(clamped(double(c.r) + c.g + c.b));
    case PackOrder::LuminanceAlpha: return set(clamped(double(c.r) + c.g + c.b), c.a);
    case PackOrder::Rgb: return set(c.r, c.g, c.b);
    case PackOrder::Bgr: return set(c.b, c.g, c.r);
    case PackOrder::Rgba: return set(c.r, c.g, c.b, c.a);
    case PackOrder::Bgra: return set(c.b, c.g, c.r, c.a);
    case PackOrder::Depth: return set(depth);
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

void putComponent(std::byte* to, double value, PackType type, bool swap) {
    switch (type) {
    case PackType::Byte: return put(to, int8_t(toSigned(value, 8)), false);
    case PackType::UnsignedByte: return put(to, uint8_t(toBits(value, 8)), false);
    case PackType::Short: return put(to, int16_t(toSigned(value, 16)), swap);
    case PackType::UnsignedShort: return put(to, uint16_t(toBits(value, 16)), swap);
    case PackType::Int: return put(to, int32_t(toSigned(value, 32)), swap);
    case PackType::UnsignedInt: return put(to, toBits(value, 32), swap);
    default: return put(to, float(value), swap);
    }
}

void putFields(std::byte* to, const double (&values)[4], const PackFields& fields, bool swap) {
    uint32_t number = 0;
    int shift = fields.bytes * 8;
    for (int i = 0; i < fields.count; ++i) { // from the highest field down
        const int component = fields.reversed ? fields.count - 1 - i : i;
        shift -= fields.bits[i];
        number |= toBits(values[component], fields.bits[i]) << shift;
    }
    if (fields.bytes == 1) return put(to, uint8_t(number), false);
    if (fields.bytes == 2) return put(to, uint16_t(number), swap);
    put(to, number, swap);
}

} // namespace

void packPixels(const Picture& picture, const ReadArea& area, const PackFormat& format,
                const PixelStore& store, const glm::vec4& scale, const glm::vec4& bias, void* to) {
    const bool fields = format.type == PackType::Fields;
    const std::size_t element = fields ? format.fields.bytes : bytesOf(format.type);
    const std::size_t pixel = fields ? element : element * componentsOf(format.order);
    const std::size_t row = (store.rowLength != 0 ? store.rowLength : area.width) * pixel;
    const std::size_t alignment = std::max<std::size_t>(store.alignment, 1);
    const std::size_t stride =
        element >= alignment ? row : (row + alignment - 1) / alignment * alignment;
    std::byte* const first =
        static_cast<std::byte*>(to) + store.skipRows * stride + store.skipPixels * pixel;
    const int64_t startX = std::max<int64_t>(area.x, 0), startY = std::max<int64_t>(area.y, 0);
    const int64_t endX = std::min<int64_t>(int64_t(area.x) + area.width, picture.target.width);
    const int64_t endY = std::min<int64_t>(int64_t(area.y) + area.height, picture.target.height);
    for (int64_t y = startY; y < endY; ++y)
        for (int64_t x = startX; x < endX; ++x) {
            std::byte* at = first + std::size_t(y - area.y) * stride +
                            std::size_t(x - area.x) * pixel;
            double values[4];
            if (format.order == PackOrder::Depth)
                components({}, picture.depthAt(uint32_t(x), uint32_t(y)), format.order, values);
            else
                components(picture.colorAt(uint32_t(x), uint32_t(y)) * scale + bias, 0.0f,
                           format.order, values);
            if (fields) {
                putFields(at, values, format.fields, store.swapBytes);
                continue;
            }
            for (uint32_t i = 0; i < componentsOf(format.order); ++i)
                putComponent(at + i * element, values[i], format.type, store.swapBytes);
        }
}

} // namespace smart::compat
