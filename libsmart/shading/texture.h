// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec4.hpp>
#include <limits>
#include <memory>
#include <vector>

#include "libsmart/shading/texture_levels.h"

namespace smart {

/// What lies outside the unit square.
enum class TextureWrap : uint8_t {
    Repeat,
    Mirror,       ///< repeated, every other copy mirrored; no texel is left out at the border
    ClampToEdge,  ///< the texels of the border
    ClampToBorder,///< the border colour
    Clamp         ///< halfway between those two: at the border linear filters mix both
};

enum class TextureFilter : uint8_t { Nearest, Linear };

/// OpenGL's six minification filters: how a level is looked up, and which one.
enum class LevelChoice : uint8_t { First, Nearest, Linear };
struct MinificationFilter {
    TextureFilter filter = TextureFilter::Linear;
    LevelChoice levels = LevelChoice::Linear;
    bool operator==(const MinificationFilter&) const = default;
};

/// OpenGL's base internal formats: what the components of a texel stand for.
enum class TexelFormat : uint8_t {
    ByChannels, ///< luminance, luminance and alpha, RGB, or RGBA, as many as there are
    Alpha,      ///< of images with four channels, the others 0
    Intensity,  ///< of images with four equal channels
    Luminance, LuminanceAlpha, Rgb, Rgba
};

struct TextureOptions {
    TextureWrap wrapS = TextureWrap::Repeat, wrapT = TextureWrap::Repeat;
    TextureFilter magnification = TextureFilter::Linear;
    MinificationFilter minification{};
    glm::vec4 border{0.0f};                   ///< linear RGBA
    float levelBias = 0.0f;                   ///< added to the level of detail; within +-kMaxBias
    float minLevel = -1000.0f, maxLevel = 1000.0f; ///< limits of the level of detail
    uint32_t firstLevel = 0, lastLevel = 1000;     ///< of the levels, those that are used
    TexelFormat format = TexelFormat::ByChannels;

    static constexpr float kMaxBias = 16.0f;
    bool operator==(const TextureOptions&) const = default;
};

/// Images and how they are looked up; immutable once made.
class Texture {
public:
    Texture(std::shared_ptr<const TextureLevels> levels, const TextureOptions& options);
    /// A single linear image, without smaller levels.
    Texture(uint32_t width, uint32_t height, uint32_t channels, TexelType type,
            std::vector<std::byte> texels, const TextureOptions& options);

    /// RGBA, linear, at texture coordinates (s, t): (0, 0) is the image's lower left corner,
    /// (1, 1) its upper right one. Coordinates that are not finite read as opaque black.
    ///
    /// `footprint`: side, in texture coordinates, of what the result is to stand for. As in OpenGL
    /// 1.5, section 3.8.8, with the level of detail
    ///   log2(footprint * sqrt(width * height)) + levelBias, limited to minLevel..maxLevel,
    /// of which 0 and less are magnification. The memory of levels that are made is the only
    /// thing that may be lacking; then it is the first level.
    glm::vec4 sample(float s, float t, float footprint = 0.0f) const noexcept;
    /// False: all footprints give the same.
    bool asksForFootprint() const { return minified_ < std::numeric_limits<double>::infinity(); }

    const TextureLevels& levels() const { return *levels_; }
    const TextureOptions& options() const { return options_; }
    /// Never ByChannels.
    TexelFormat format() const { return options_.format; }
    /// Memory held now; textures that share levels each count them.
    std::size_t bytes() const { return levels_->bytes(); }
    /// The same images, looked up differently.
    Texture withOptions(const TextureOptions& options) const { return {levels_, options}; }

private:
    struct Place; // texture coordinates, wrapped

    glm::vec4 sampleMinified(const Place& place, float footprint) const;
    glm::vec4 sampleLevel(const TextureImage& image, const Place& place,
                          TextureFilter filter) const;

    std::shared_ptr<const TextureLevels> levels_;
    TextureOptions options_;
    glm::vec4 border_; ///< as a texel of the image would be
    double scale_;     ///< from footprints to texels of the first level, levelBias included
    double minified_;  ///< footprints above this are minified
};

/// Textures by id as one frame sees them; index 0 and unknown ids hold nullptr.
using TextureTable = std::vector<std::shared_ptr<const Texture>>;

} // namespace smart
