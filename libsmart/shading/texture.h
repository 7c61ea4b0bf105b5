// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec4.hpp>
#include <memory>
#include <vector>

namespace smart {

enum class TexelType : uint8_t { Byte, Short, Float }; ///< unsigned normalised, except Float
enum class TextureWrap : uint8_t { Repeat, Clamp, Mirror };
enum class TextureFilter : uint8_t { Nearest, Linear };

struct TextureOptions {
    TextureWrap wrapS = TextureWrap::Repeat, wrapT = TextureWrap::Repeat;
    TextureFilter filter = TextureFilter::Linear;
    bool srgb = false; ///< texels of type Byte are sRGB-encoded; alpha is linear
};

/// An image and how it is looked up; immutable once made.
class Texture {
public:
    /// channels: 1 luminance, 2 luminance and alpha, 3 RGB, 4 RGBA; rows from the bottom,
    /// tightly packed, in the machine's byte order. Throws Error for a size that does not fit.
    Texture(uint32_t width, uint32_t height, uint32_t channels, TexelType type,
            std::vector<std::byte> texels, const TextureOptions& options);

    /// RGBA, linear, at texture coordinates (s, t): (0, 0) is the image's lower left corner,
    /// (1, 1) its upper right one. Wrapping leaves no seam. Mirrored images repeat their border
    /// texels. Coordinates that are not finite read as opaque black, texels that are NaN as 0.
    glm::vec4 sample(float s, float t) const;
    /// The same for what covers `footprint` of the unit square's side.
    glm::vec4 sample(float s, float t, float footprint) const;

    uint32_t width() const { return width_; }
    uint32_t height() const { return height_; }
    const TextureOptions& options() const { return options_; }
    std::size_t bytes() const { return texels_.size(); }
    /// The same image, looked up differently.
    Texture withOptions(const TextureOptions& options) const {
        Texture other = *this;
        other.options_ = options;
        return other;
    }

private:
    glm::vec4 texel(uint32_t x, uint32_t y) const;

    uint32_t width_, height_, channels_;
    TexelType type_;
    std::vector<std::byte> texels_;
    TextureOptions options_;
};

/// Textures by id as one frame sees them; index 0 and unknown ids hold nullptr.
using TextureTable = std::vector<std::shared_ptr<const Texture>>;

} // namespace smart
