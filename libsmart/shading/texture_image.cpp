// SPDX-License-Identifier: MIT
#include "libsmart/shading/texture_image.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "libsmart/base/error.h"
#include "libsmart/base/half.h"
#include "libsmart/base/transcendental.h"

namespace smart {

namespace {

constexpr double kLargestHalf = 65504.0;
constexpr double kLargestFloat = std::numeric_limits<float>::max();

/// sRGB's transfer function in double, for 0 to 1.
double decoded(double encoded) {
    if (encoded <= 0.04045) return encoded / 12.92;
    return math::detail::expOf(2.4 * math::detail::logOf((encoded + 0.055) / 1.055));
}

struct ByteTables {
    std::array<float, 256> linear, srgb;
    std::array<double, 255> srgbMiddles; ///< between what codes i and i + 1 stand for, encoded
    /// The code of i / kSteps, or less: where to begin to search for that of a value above.
    static constexpr std::size_t kSteps = 4096;
    std::array<unsigned char, kSteps + 1> srgbFrom;
    ByteTables() {
        for (std::size_t i = 0; i < 256; ++i) {
            linear[i] = float(double(i) / 255.0);
            srgb[i] = float(decoded(double(i) / 255.0));
        }
        for (std::size_t i = 0; i < 255; ++i) srgbMiddles[i] = decoded((double(i) + 0.5) / 255.0);
        std::size_t code = 0;
        for (std::size_t i = 0; i <= kSteps; ++i) {
            while (code < 255 && srgbMiddles[code] <= double(i) / kSteps) ++code;
            srgbFrom[i] = (unsigned char)(code);
        }
    }
};

const ByteTables& byteTables() {
    static const ByteTables tables;
    return tables;
}

const float* srgbShortTable() {
    // Never destroyed: workers may still read it when the process ends.
    static const auto& table = *new const std::vector<float>([] {
        std::vector<float> values(65536);
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = float(decoded(double(i) / 65535.0));
        return values;
    }());
    return table.data();
}

/// Linear filtering multiplies texels by 0: none may be infinite or NaN.
template <class Load, class Store>
void replaceNonFinite(std::vector<std::byte>& texels, float largest, Load&& load, Store&& store) {
    using Number = decltype(store(0.0f));
    for (std::size_t i = 0; i + sizeof(Number) <= texels.size(); i += sizeof(Number)) {
        Number number;
        std::memcpy(&number, texels.data() + i, sizeof number);
        const float value = load(number);
        if (std::isfinite(value)) continue;
        number = store(std::isnan(value) ? 0.0f : value > 0 ? largest : -largest);
        std::memcpy(texels.data() + i, &number, sizeof number);
    }
}

// Readers: the value of the i-th channel of all texels, as colour or as alpha.

struct ByteReader {
    const unsigned char* codes;
    const float *colors, *alphas;
    float color(std::size_t i) const { return colors[codes[i]]; }
    float alpha(std::size_t i) const { return alphas[codes[i]]; }
};

struct ShortReader {
    const std::byte* texels;
    float color(std::size_t i) const { return float(code(i)) / 65535.0f; }
    float alpha(std::size_t i) const { return color(i); }

protected:
    uint16_t code(std::size_t i) const {
        uint16_t value;
        std::memcpy(&value, texels + i * sizeof value, sizeof value);
        return value;
    }
};

struct SrgbShortReader : ShortReader {
    const float* colors;
    SrgbShortReader(const std::byte* t, const float* table) : ShortReader{t}, colors(table) {}
    float color(std::size_t i) const { return colors[code(i)]; }
};

struct HalfReader : ShortReader {
    explicit HalfReader(const std::byte* t) : ShortReader{t} {}
    float color(std::size_t i) const { return halfToFloat(code(i)); }
    float alpha(std::size_t i) const { return color(i); }
};

struct FloatReader {
    const std::byte* texels;
    float color(std::size_t i) const {
        float value;
        std::memcpy(&value, texels + i * sizeof value, sizeof value);
        return value;
    }
    float alpha(std::size_t i) const { return color(i); }
};

/// Between 0 and 1; NaN is 0.
double share(double value) {
    return value > 0.0 ? std::min(value, 1.0) : 0.0;
}

uint32_t codeOf(double value, double largest) {
    return uint32_t(share(value) * largest + 0.5);
}

/// The code whose value lies nearest, both encoded.
unsigned char srgbByteOf(double linear) {
    const ByteTables& tables = byteTables();
    const double value = share(linear);
    std::size_t code = tables.srgbFrom[std::size_t(value * double(ByteTables::kSteps))];
    while (code < 255 && tables.srgbMiddles[code] <= value) ++code;
    return (unsigned char)(code);
}

double encoded(double linear) {
    if (!(linear > 0.0031308)) return linear * 12.92;
    return 1.055 * math::detail::expOf(math::detail::logOf(linear) / 2.4) - 0.055;
}

} // namespace

std::size_t bytesPerChannel(TexelType type) {
    switch (type) {
    case TexelType::Byte: return 1;
    case TexelType::Short:
    case TexelType::Half: return 2;
    case TexelType::Float: break;
    }
    return 4;
}

TextureImage::TextureImage(uint32_t width, uint32_t height, uint32_t channels, TexelType type,
                           bool srgb, std::vector<std::byte> texels)
    : width_(width), height_(height), channels_(channels), type_(type), srgb_(srgb),
      texels_(std::move(texels)) {
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
    switch (type) {
    case TexelType::Byte:
        colorTable_ = srgb ? byteTables().srgb.data() : byteTables().linear.data();
        break;
    case TexelType::Short:
        if (srgb) colorTable_ = srgbShortTable();
        break;
    case TexelType::Half:
        replaceNonFinite(texels_, float(kLargestHalf), halfToFloat, floatToHalf);
        break;
    case TexelType::Float:
        replaceNonFinite(
            texels_, float(kLargestFloat), [](float v) { return v; },
            [](float v) { return v; });
        break;
    }
    if (!srgb || type == TexelType::Byte || type == TexelType::Short) return;

    // Numbers without bounds have no table: they are decoded here, once.
    std::vector<float> row(std::size_t(width) * channels);
    std::vector<double> values(row.size());
    srgb_ = false;
    for (uint32_t y = 0; y < height; ++y) {
        readRow(y, row.data());
        for (std::size_t i = 0; i < row.size(); ++i) {
            const bool alpha = channels % 2 == 0 && (i + 1) % channels == 0;
            values[i] = alpha ? row[i] : math::decodeSrgb(row[i]);
        }
        encodeTexels(values.data(), row.size(), channels, type, false,
                     texels_.data() + y * row.size() * bytesPerChannel(type));
    }
}

template <class Use>
auto TextureImage::withReader(Use&& use) const {
    switch (type_) {
    case TexelType::Byte:
        return use(ByteReader{reinterpret_cast<const unsigned char*>(texels_.data()), colorTable_,
                              byteTables().linear.data()});
    case TexelType::Short:
        if (colorTable_) return use(SrgbShortReader(texels_.data(), colorTable_));
        return use(ShortReader{texels_.data()});
    case TexelType::Half: return use(HalfReader(texels_.data()));
    case TexelType::Float: break;
    }
    return use(FloatReader{texels_.data()});
}

void TextureImage::read(std::span<const std::size_t> numbers, glm::vec4* rgba) const {
    withReader([&](const auto& reader) {
        for (std::size_t k = 0; k < numbers.size(); ++k) {
            if (numbers[k] == kNoTexel) continue;
            const std::size_t first = numbers[k] * channels_;
            glm::vec4& to = rgba[k];
            to.x = to.y = to.z = reader.color(first);
            to.w = 1.0f;
            if (channels_ == 2) to.w = reader.alpha(first + 1);
            if (channels_ < 3) continue;
            to.y = reader.color(first + 1);
            to.z = reader.color(first + 2);
            if (channels_ == 4) to.w = reader.alpha(first + 3);
        }
    });
}

void TextureImage::readRow(uint32_t row, float* values) const {
    const std::size_t count = std::size_t(width_) * channels_, first = row * count;
    withReader([&](const auto& reader) {
        if (channels_ % 2 != 0) {
            for (std::size_t i = 0; i < count; ++i) values[i] = reader.color(first + i);
            return;
        }
        for (std::size_t i = 0; i < count; i += channels_) {
            const std::size_t last = i + channels_ - 1;
            for (std::size_t k = i; k < last; ++k) values[k] = reader.color(first + k);
            values[last] = reader.alpha(first + last);
        }
    });
}

void TextureImage::setPart(uint32_t x, uint32_t y, const TextureImage& part) {
    if (x > width_ || y > height_ || part.width_ > width_ - x || part.height_ > height_ - y)
        throw Error(ErrorCode::InvalidValue, "the part does not lie inside the image");
    if (part.channels_ != channels_)
        throw Error(ErrorCode::InvalidOperation, "the part has other channels than the image");
    const std::size_t count = std::size_t(part.width_) * channels_;
    const std::size_t channelBytes = bytesPerChannel(type_);
    const bool same = part.type_ == type_ && part.srgb_ == srgb_;
    std::vector<float> row(same ? 0 : count);
    std::vector<double> values(row.size());
    for (uint32_t j = 0; j < part.height_; ++j) {
        std::byte* to = texels_.data() +
                        ((std::size_t(y) + j) * width_ + x) * channels_ * channelBytes;
        if (same) {
            std::memcpy(to, part.texels_.data() + j * count * channelBytes, count * channelBytes);
            continue;
        }
        part.readRow(j, row.data());
        std::copy(row.begin(), row.end(), values.begin());
        encodeTexels(values.data(), count, channels_, type_, srgb_, to);
    }
}

void encodeTexels(const double* values, std::size_t count, uint32_t channels, TexelType type,
                  bool srgb, std::byte* texels) {
    const auto store = [&](std::size_t i, auto value) {
        std::memcpy(texels + i * sizeof value, &value, sizeof value);
    };
    for (std::size_t i = 0; i < count; ++i) {
        const bool color = channels % 2 != 0 || (i + 1) % channels != 0;
        const double value = values[i];
        switch (type) {
        case TexelType::Byte:
            store(i, srgb && color ? srgbByteOf(value) : (unsigned char)codeOf(value, 255.0));
            break;
        case TexelType::Short:
            store(i, uint16_t(codeOf(srgb && color ? encoded(value) : value, 65535.0)));
            break;
        case TexelType::Half:
            store(i, floatToHalf(float(std::clamp(value, -kLargestHalf, kLargestHalf))));
            break;
        case TexelType::Float:
            store(i, float(std::clamp(value, -kLargestFloat, kLargestFloat)));
            break;
        }
    }
}

} // namespace smart
