// SPDX-License-Identifier: MIT
#include "libsmart/shading/texture.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "libsmart/base/transcendental.h"

namespace smart {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLn2 = 0.69314718055994530942;

double powerOfTwo(double exponent) {
    return math::detail::expOf(exponent * kLn2);
}

/// A finite coordinate, brought into [0, 1] where that does not depend on the size of the image,
/// or to where anything beyond is the same. Exact: the fractional part of a double is.
double wrapped(double c, TextureWrap wrap) {
    switch (wrap) {
    case TextureWrap::Repeat: return c - std::floor(c);
    case TextureWrap::Mirror:
        c -= 2 * std::floor(c * 0.5);
        return c > 1 ? 2 - c : c;
    case TextureWrap::ClampToBorder: return std::clamp(c, -1.0, 2.0);
    case TextureWrap::ClampToEdge:
    case TextureWrap::Clamp: break;
    }
    return std::clamp(c, 0.0, 1.0);
}

constexpr int64_t kOutside = -1;

/// The texel of a row or column that stands for number `index`, from [-1, size].
int64_t wrapTexel(int64_t index, int64_t size, TextureWrap wrap) {
    if (index >= 0 && index < size) return index;
    switch (wrap) {
    case TextureWrap::Repeat: return index < 0 ? size - 1 : 0;
    case TextureWrap::Mirror:
    case TextureWrap::ClampToEdge: return index < 0 ? 0 : size - 1;
    case TextureWrap::ClampToBorder:
    case TextureWrap::Clamp: break;
    }
    return kOutside;
}

/// One axis of a look-up with the nearest texel.
int64_t nearestTexel(double unit, uint32_t size, TextureWrap wrap) {
    if (unit == 1 && wrap != TextureWrap::Repeat) return size - 1;
    const double at = std::clamp(std::floor(unit * size), -1.0, double(size));
    return wrapTexel(int64_t(at), size, wrap);
}

/// One axis of a linear look-up: two texels, and the weight of the second.
struct LinearTexels {
    int64_t texels[2];
    double weight;

    LinearTexels(double unit, uint32_t size, TextureWrap wrap) {
        // Texel centres lie at half numbers. Half a texel beyond the border it is the border
        // colour alone.
        const double x = std::clamp(unit * size, -0.5, size + 0.5) - 0.5;
        const double first = std::floor(x);
        weight = x - first;
        texels[0] = wrapTexel(int64_t(first), size, wrap);
        texels[1] = wrapTexel(int64_t(first) + 1, size, wrap);
    }
};

std::size_t texelNumber(int64_t column, int64_t row, uint32_t width) {
    if (column == kOutside || row == kOutside) return TextureImage::kNoTexel;
    return std::size_t(row) * width + std::size_t(column);
}

/// In double, where no product of floats overflows, and which gives a where a equals b.
double mixed(double a, double b, double weight) {
    return a + (b - a) * weight;
}

/// A border colour as texels with these channels are read.
glm::vec4 borderTexel(const TextureOptions& options, const TextureImage& image) {
    glm::vec4 border = options.border;
    for (int k = 0; k < 4; ++k) {
        float& value = border[k];
        if (!std::isfinite(value)) value = 0;
        if (image.type() == TexelType::Byte || image.type() == TexelType::Short)
            value = std::clamp(value, 0.0f, 1.0f);
    }
    if (options.format == TexelFormat::Intensity) return glm::vec4(border.x);
    if (image.channels() < 3) border.y = border.z = border.x;
    if (image.channels() % 2 != 0) border.w = 1;
    return border;
}

TexelFormat formatOf(uint32_t channels) {
    constexpr TexelFormat kFormats[] = {TexelFormat::Luminance, TexelFormat::LuminanceAlpha,
                                        TexelFormat::Rgb, TexelFormat::Rgba};
    return kFormats[channels - 1];
}

} // namespace

/// Where a look-up goes to.
struct Texture::Place {
    double s, t;
};

Texture::Texture(std::shared_ptr<const TextureLevels> levels, const TextureOptions& options)
    : levels_(std::move(levels)), options_(options),
      border_(borderTexel(options, levels_->first())) {
    TextureOptions& o = options_;
    if (o.format == TexelFormat::ByChannels) o.format = formatOf(levels_->first().channels());
    if (std::isnan(o.minLevel)) o.minLevel = TextureOptions().minLevel;
    if (std::isnan(o.maxLevel)) o.maxLevel = TextureOptions().maxLevel;
    if (std::isnan(o.levelBias)) o.levelBias = 0;
    o.firstLevel = std::min(o.firstLevel, levels_->count() - 1);
    o.lastLevel = std::clamp(o.lastLevel, o.firstLevel, levels_->count() - 1);
    double width = levels_->first().width(), height = levels_->first().height();
    for (uint32_t level = 0; level < o.firstLevel; ++level) {
        width = std::max(1.0, std::floor(width / 2));
        height = std::max(1.0, std::floor(height / 2));
    }
    const double bias = double(std::clamp(o.levelBias, -o.kMaxBias, o.kMaxBias));
    scale_ = std::sqrt(width * height) * powerOfTwo(bias);

    // OpenGL 1.5, 3.8.9: these two filters together would jump where one follows the other.
    const bool late = o.magnification == TextureFilter::Linear &&
                      o.minification.filter == TextureFilter::Nearest &&
                      o.minification.levels != LevelChoice::First;
    const float from = late ? 0.5f : 0.0f;
    if (o.minLevel > from) minified_ = -1;
    else if (o.maxLevel <= from) minified_ = kInfinity;
    else minified_ = powerOfTwo(from) / scale_;
    if (o.minification.filter == o.magnification && o.minification.levels == LevelChoice::First)
        minified_ = kInfinity; // the same look-up
}

Texture::Texture(uint32_t width, uint32_t height, uint32_t channels, TexelType type,
                 std::vector<std::byte> texels, const TextureOptions& options)
    : Texture(std::make_shared<const TextureLevels>(std::make_shared<const TextureImage>(
                  width, height, channels, type, false, std::move(texels))),
              options) {}

glm::vec4 Texture::sample(float s, float t, float footprint) const noexcept {
    if (!std::isfinite(s) || !std::isfinite(t)) return {0.0f, 0.0f, 0.0f, 1.0f};
    const Place place{wrapped(s, options_.wrapS), wrapped(t, options_.wrapT)};
    if (footprint > minified_) return sampleMinified(place, footprint);
    return sampleLevel((*levels_)[options_.firstLevel], place, options_.magnification);
}

glm::vec4 Texture::sampleMinified(const Place& place, float footprint) const {
    const TextureLevels& levels = *levels_;
    const uint32_t first = options_.firstLevel, last = options_.lastLevel;
    const MinificationFilter how = options_.minification;
    if (how.levels == LevelChoice::First || first == last)
        return sampleLevel(levels[first], place, how.filter);

    // Down to -1100 or so, far beyond what limits and levels leave; infinite: the last level.
    const double texels = std::max(double(footprint) * scale_, 0x1p-1000);
    double detail = texels < kInfinity ? math::detail::logOf(texels) / kLn2 : 2000.0;
    detail = std::max(double(options_.minLevel), std::min(double(options_.maxLevel), detail));
    const double highest = last - first;
    if (how.levels == LevelChoice::Nearest) {
        const double level = std::clamp(std::ceil(detail + 0.5) - 1, 0.0, highest);
        return sampleLevel(levels[first + uint32_t(level)], place, how.filter);
    }
    detail = std::clamp(detail, 0.0, highest);
    const double level = std::floor(detail), weight = detail - level;
    const glm::vec4 fine = sampleLevel(levels[first + uint32_t(level)], place, how.filter);
    if (weight == 0) return fine;
    const glm::vec4 coarse = sampleLevel(levels[first + uint32_t(level) + 1], place, how.filter);
    glm::vec4 result;
    for (int k = 0; k < 4; ++k) result[k] = float(mixed(fine[k], coarse[k], weight));
    return result;
}

glm::vec4 Texture::sampleLevel(const TextureImage& image, const Place& place,
                               TextureFilter filter) const {
    const uint32_t width = image.width(), height = image.height();
    const TextureWrap wrapS = options_.wrapS, wrapT = options_.wrapT;
    if (filter == TextureFilter::Nearest) {
        const std::size_t number[1] = {texelNumber(nearestTexel(place.s, width, wrapS),
                                                   nearestTexel(place.t, height, wrapT), width)};
        glm::vec4 texel = border_;
        image.read(number, &texel);
        return texel;
    }
    const LinearTexels x(place.s, width, wrapS), y(place.t, height, wrapT);
    std::size_t numbers[4];
    for (int i = 0; i < 4; ++i)
        numbers[i] = texelNumber(x.texels[i % 2], y.texels[i / 2], width);
    glm::vec4 texels[4] = {border_, border_, border_, border_};
    image.read(numbers, texels);
    glm::vec4 result;
    for (int k = 0; k < 4; ++k)
        result[k] = float(mixed(mixed(texels[0][k], texels[1][k], x.weight),
                                mixed(texels[2][k], texels[3][k], x.weight), y.weight));
    return result;
}

} // namespace smart
