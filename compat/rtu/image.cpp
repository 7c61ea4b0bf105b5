// SPDX-License-Identifier: MIT
#include "compat/rtu/image.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <stdexcept>
#include <utility>

#include "openrt/enums.h"

namespace smart::compat {

namespace {

/// Calls visit with a value of the C type of a type token.
template <class Visit>
void withType(RTenum type, Visit&& visit) {
    switch (type) {
    case RT_UNSIGNED_BYTE: return visit(uint8_t());
    case RT_BYTE: return visit(int8_t());
    case RT_UNSIGNED_SHORT: return visit(uint16_t());
    case RT_SHORT: return visit(int16_t());
    case RT_UNSIGNED_INT: return visit(uint32_t());
    case RT_INT: return visit(int32_t());
    default: return visit(float());
    }
}

std::size_t product(std::initializer_list<int> sizes) {
    std::size_t result = 1;
    for (const int size : sizes)
        if (__builtin_mul_overflow(result, std::size_t(size), &result))
            throw std::length_error("an image");
    return result;
}

PixelRows rowsOf(const Image& image, const PixelStore& store) {
    const std::size_t size = bytesOf(image.type);
    const std::size_t pixel = std::size_t(image.components) * size;
    std::size_t stride = (store.rowLength ? store.rowLength : std::size_t(image.width)) * pixel;
    if (size < store.alignment)
        stride = (stride + store.alignment - 1) / store.alignment * store.alignment;
    return {store.skipRows * stride + store.skipPixels * pixel, stride};
}

double truncated(double value, RTenum type) {
    // What should be a whole number is not to lose one to the rounding of the weights.
    return type == RT_FLOAT ? value : std::trunc(value + std::copysign(1e-7, value));
}

double meanOf(double sum, int count, RTenum type) {
    const bool rounds = count == 4 && (type == RT_UNSIGNED_BYTE || type == RT_UNSIGNED_SHORT ||
                                       type == RT_UNSIGNED_INT);
    return truncated((sum + (rounds ? 2 : 0)) / count, type);
}

/// Each pixel from `across` by `down` pixels.
Image halved(const Image& image, int across, int down) {
    Image result(image.type, image.components, image.width / across, image.height / down, 1);
    for (int y = 0; y < result.height; ++y)
        for (int x = 0; x < result.width; ++x)
            for (int c = 0; c < image.components; ++c) {
                double sum = 0;
                for (int k = 0; k < across * down; ++k)
                    sum += image.pixel(x * across + k % across, y * down + k / across, 0)[c];
                result.pixel(x, y, 0)[c] = meanOf(sum, across * down, image.type);
            }
    return result;
}

/// The parts of an axis that one output pixel covers: where from and how much.
using Span = std::vector<std::pair<int, double>>;

/// Beyond the edges the image goes on from the other side.
std::vector<Span> spansOf(int in, int out, Enlarging enlarging) {
    const double step = double(in) / out;
    const double half = in > out || enlarging == Enlarging::Exact ? step / 2 : 0.5;
    std::vector<Span> spans;
    spans.reserve(std::size_t(out));
    for (int i = 0; i < out; ++i) {
        const double low = step * (i + 0.5) - half, high = step * (i + 0.5) + half;
        Span& span = spans.emplace_back();
        for (double at = low; at < high;) {
            const double next = std::floor(at) + 1;
            span.emplace_back(int((int64_t(std::floor(at)) % in + in) % in),
                              std::min(next, high) - at);
            at = next;
        }
    }
    return spans;
}

} // namespace

Image::Image(RTenum imageType, int imageComponents, int w, int h, int d)
    : type(imageType), components(imageComponents), width(w), height(h), depth(d),
      values(product({imageComponents, w, h, d})) {}

int componentsOf(RTenum format) noexcept {
    switch (format) {
    case RT_COLOR_INDEX:
    case RT_STENCIL_INDEX:
    case RT_DEPTH_COMPONENT:
    case RT_RED:
    case RT_GREEN:
    case RT_BLUE:
    case RT_ALPHA:
    case RT_LUMINANCE: return 1;
    case RT_LUMINANCE_ALPHA: return 2;
    case RT_RGB:
    case RT_BGR: return 3;
    case RT_RGBA:
    case RT_BGRA: return 4;
    default: return 0;
    }
}

std::size_t bytesOf(RTenum type) noexcept {
    switch (type) {
    case RT_UNSIGNED_BYTE:
    case RT_BYTE: return 1;
    case RT_UNSIGNED_SHORT:
    case RT_SHORT: return 2;
    case RT_UNSIGNED_INT:
    case RT_INT:
    case RT_FLOAT: return 4;
    default: return 0;
    }
}

Image readImage(const void* data, RTenum type, int components, int width, int height, int depth,
                const PixelStore& store) {
    Image image(type, components, width, height, depth);
    const std::size_t size = bytesOf(type);
    const PixelRows rows = rowsOf(image, store);
    const std::byte* const first = static_cast<const std::byte*>(data) + rows.offset;
    withType(type, [&](auto number) {
        double* out = image.values.data();
        for (std::size_t row = 0; row < image.rows(); ++row) {
            const std::byte* in = first + row * rows.stride;
            for (std::size_t i = 0; i < image.valuesOfRow(); ++i, in += size) {
                std::byte bytes[sizeof number];
                std::memcpy(bytes, in, sizeof number);
                if (store.swapBytes) std::reverse(bytes, bytes + sizeof number);
                std::memcpy(&number, bytes, sizeof number);
                *out++ = double(number);
            }
        }
    });
    return image;
}

std::size_t tightBytes(const Image& image) {
    return image.values.size() * bytesOf(image.type);
}

void writeImage(const Image& image, const PixelStore& store, void* data) {
    const std::size_t size = bytesOf(image.type);
    const PixelRows rows = rowsOf(image, store);
    std::byte* const first = static_cast<std::byte*>(data) + rows.offset;
    withType(image.type, [&](auto number) {
        const double* in = image.values.data();
        for (std::size_t row = 0; row < image.rows(); ++row) {
            std::byte* out = first + row * rows.stride;
            for (std::size_t i = 0; i < image.valuesOfRow(); ++i, out += size) {
                number = decltype(number)(*in++);
                std::memcpy(out, &number, sizeof number);
                if (store.swapBytes) std::reverse(out, out + sizeof number);
            }
        }
    });
}

Image toShorts(const Image& image, bool scaled) {
    Image shorts = image;
    shorts.type = RT_UNSIGNED_SHORT;
    for (double& value : shorts.values) {
        double number = value;
        if (scaled) {
            switch (image.type) {
            case RT_UNSIGNED_BYTE: number *= 257; break;
            case RT_BYTE: number *= 516; break;
            case RT_SHORT: number *= 2; break;
            case RT_UNSIGNED_INT: number /= 65536; break;
            case RT_INT: number /= 32768; break;
            case RT_FLOAT: number *= 65535; break;
            default: break;
            }
        }
        // Also where it is not a number.
        value = number > 0 ? std::trunc(std::min(number, 65535.0)) : 0;
    }
    return shorts;
}

Image fromShorts(const Image& shorts, RTenum type, bool scaled) {
    Image image = shorts;
    image.type = type;
    for (double& value : image.values) {
        switch (type) {
        case RT_UNSIGNED_BYTE: value = scaled ? value / 257 : std::min(value, 255.0); break;
        case RT_BYTE: value = scaled ? value / 516 : std::min(value, 127.0); break;
        case RT_SHORT: value = scaled ? value / 2 : std::min(value, 32767.0); break;
        case RT_UNSIGNED_INT: value *= scaled ? 65537 : 1; break;
        case RT_INT: value = scaled ? value * 65537 / 2 : value; break;
        case RT_FLOAT: value = scaled ? value / 65535 : value; break;
        default: break;
        }
        if (type != RT_FLOAT) value = std::trunc(value);
    }
    return image;
}

Image scaleImage(const Image& image, int width, int height, int depth, Enlarging enlarging) {
    const bool flat = image.depth == 1 && depth == 1;
    if (flat && width == image.width && height == image.height) return image;
    const bool halfWide = image.width == 2 * int64_t(width);
    const bool halfHigh = image.height == 2 * int64_t(height);
    if (flat && halfWide && halfHigh) return halved(image, 2, 2);
    if (flat && halfWide && image.height == 1 && height == 1) return halved(image, 2, 1);
    if (flat && halfHigh && image.width == 1 && width == 1) return halved(image, 1, 2);

    Image result(image.type, image.components, width, height, depth);
    const std::vector<Span> columns = spansOf(image.width, width, enlarging);
    const std::vector<Span> rows = spansOf(image.height, height, enlarging);
    const std::vector<Span> layers = spansOf(image.depth, depth, enlarging);
    for (int z = 0; z < depth; ++z)
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                double total[4] = {}, area = 0;
                for (const auto& [fromZ, deep] : layers[std::size_t(z)])
                    for (const auto& [fromY, high] : rows[std::size_t(y)])
                        for (const auto& [fromX, wide] : columns[std::size_t(x)]) {
                            const double* pixel = image.pixel(fromX, fromY, fromZ);
                            const double weight = deep * high * wide;
                            area += weight;
                            for (int c = 0; c < image.components; ++c)
                                total[c] += pixel[c] * weight;
                        }
                for (int c = 0; c < image.components; ++c)
                    result.pixel(x, y, z)[c] = truncated(total[c] / area, image.type);
            }
    return result;
}

} // namespace smart::compat
