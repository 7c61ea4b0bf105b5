// SPDX-License-Identifier: MIT
#include "libsmart/shading/texture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "libsmart/base/error.h"
#include "libsmart/base/transcendental.h"

namespace smart {

namespace {

constexpr uint32_t kMaxSide = 1u << 20;

std::size_t bytesPerChannel(TexelType type) {
    switch (type) {
    case TexelType::Byte: return 1;
    case TexelType::Short: return 2;
    case TexelType::Float: return 4;
    }
    return 0;
}

struct ByteTables {
    std::array<float, 256> linear, srgb;
    ByteTables() {
        for (int i = 0; i < 256; ++i) {
            linear[std::size_t(i)] = float(i / 255.0);
            const double encoded = i / 255.0;
            srgb[std::size_t(i)] = float(
                encoded <= 0.04045
                    ? encoded / 12.92
                    : math::detail::expOf(2.4 * math::detail::logOf((encoded + 0.055) / 1.055)));
        }
    }
};

const ByteTables& byteTables() {
    static const ByteTables tables;
    return tables;
}

/// Linear filtering multiplies texels by 0: none may be infinite or NaN.
void replaceNonFinite(std::vector<std::byte>& texels) {
    for (std::size_t i = 0; i + sizeof(float) <= texels.size(); i += sizeof(float)) {
        float value = 0;
        std::memcpy(&value, texels.data() + i, sizeof(value));
        if (std::isfinite(value)) continue;
        constexpr float kLargest = std::numeric_limits<float>::max();
        value = std::isnan(value) ? 0.0f : value > 0 ? kLargest : -kLargest;
        std::memcpy(texels.data() + i, &value, sizeof(value));
    }
}

/// A finite texture coordinate in texels along one axis. Exact up to the last product: the
/// fractional part of a double is.
double toTexels(float coordinate, uint32_t size, TextureWrap wrap) {
    double c = coordinate;
    switch (wrap) {
    case TextureWrap::Repeat: c -= std::floor(c); break;
    case TextureWrap::Clamp: c = std::clamp(c, 0.0, 1.0); break;
    case TextureWrap::Mirror:
        c -= 2 * std::floor(c * 0.5);
        if (c > 1) c = 2 - c;
        break;
    }
    return c * size;
}

/// Brings a texel number from [-1, size] into the image. Mirroring repeats the border texel.
uint32_t wrapTexel(int64_t index, uint32_t size, TextureWrap wrap) {
    if (wrap == TextureWrap::Repeat) {
        if (index < 0) return size - 1;
        return index >= int64_t(size) ? 0 : uint32_t(index);
    }
    return uint32_t(std::clamp<int64_t>(index, 0, int64_t(size) - 1));
}

} // namespace

Texture::Texture(uint32_t width, uint32_t height, uint32_t channels, TexelType type,
                 std::vector<std::byte> texels, const TextureOptions& options)
    : width_(width), height_(height), channels_(channels), type_(type),
      texels_(std::move(texels)), options_(options) {
    const std::string size = std::to_string(width) + " x " + std::to_string(height);
    if (width == 0 || height == 0 || width > kMaxSide || height > kMaxSide)
        throw Error(ErrorCode::InvalidValue,
                    "texture of " + size + " texels; each side must have 1 to 1048576");
    if (channels < 1 || channels > 4)
        throw Error(ErrorCode::InvalidValue, "texture with " + std::to_string(channels) +
                                                 " channels; there may be 1 to 4");
    const std::size_t wanted = std::size_t(width) * height * channels * bytesPerChannel(type);
    if (texels_.size() != wanted)
        throw Error(ErrorCode::InvalidValue, "texture of " + size + " texels needs " +
                                                 std::to_string(wanted) + " bytes, not " +
                                                 std::to_string(texels_.size()));
    if (type == TexelType::Float) replaceNonFinite(texels_);
}

glm::vec4 Texture::texel(uint32_t x, uint32_t y) const {
    const std::size_t first = (std::size_t(y) * width_ + x) * channels_;
    const bool hasAlpha = channels_ % 2 == 0;
    float v[4];
    switch (type_) {
    case TexelType::Byte: {
        const ByteTables& tables = byteTables();
        const auto* bytes = reinterpret_cast<const unsigned char*>(texels_.data()) + first;
        const auto& colors = options_.srgb ? tables.srgb : tables.linear;
        for (uint32_t i = 0; i < channels_; ++i)
            v[i] = hasAlpha && i + 1 == channels_ ? tables.linear[bytes[i]] : colors[bytes[i]];
        break;
    }
    case TexelType::Short:
        for (uint32_t i = 0; i < channels_; ++i) {
            uint16_t value = 0;
            std::memcpy(&value, texels_.data() + (first + i) * sizeof(value), sizeof(value));
            v[i] = float(value) / 65535.0f;
        }
        break;
    case TexelType::Float:
        std::memcpy(v, texels_.data() + first * sizeof(float), channels_ * sizeof(float));
        break;
    }
    switch (channels_) {
    case 1: return {v[0], v[0], v[0], 1.0f};
    case 2: return {v[0], v[0], v[0], v[1]};
    case 3: return {v[0], v[1], v[2], 1.0f};
    default: return {v[0], v[1], v[2], v[3]};
    }
}

glm::vec4 Texture::sample(float s, float t, float) const {
    return sample(s, t);
}

glm::vec4 Texture::sample(float s, float t) const {
    if (!std::isfinite(s) || !std::isfinite(t)) return {0.0f, 0.0f, 0.0f, 1.0f};
    const double x = toTexels(s, width_, options_.wrapS), y = toTexels(t, height_, options_.wrapT);
    const auto column = [&](double i) { return wrapTexel(int64_t(i), width_, options_.wrapS); };
    const auto row = [&](double i) { return wrapTexel(int64_t(i), height_, options_.wrapT); };
    if (options_.filter == TextureFilter::Nearest)
        return texel(column(std::floor(x)), row(std::floor(y)));

    // Texel centres lie at half numbers. In double no product of floats overflows, and between
    // equal texels the result is that texel exactly.
    const double left = std::floor(x - 0.5), bottom = std::floor(y - 0.5);
    const double fx = x - 0.5 - left, fy = y - 0.5 - bottom;
    const uint32_t x0 = column(left), x1 = column(left + 1);
    const uint32_t y0 = row(bottom), y1 = row(bottom + 1);
    const glm::vec4 t00 = texel(x0, y0), t10 = texel(x1, y0);
    const glm::vec4 t01 = texel(x0, y1), t11 = texel(x1, y1);
    glm::vec4 result;
    for (int i = 0; i < 4; ++i) {
        const double low = t00[i] + (double(t10[i]) - t00[i]) * fx;
        const double high = t01[i] + (double(t11[i]) - t01[i]) * fx;
        result[i] = float(low + (high - low) * fy);
    }
    return result;
}

} // namespace smart
