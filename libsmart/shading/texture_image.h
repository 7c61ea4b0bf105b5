// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec4.hpp>
#include <memory>
#include <span>
#include <vector>

namespace smart {

/// Byte and Short are unsigned and stand for 0 to 1; Half and Float for themselves.
enum class TexelType : uint8_t { Byte, Short, Half, Float };

std::size_t bytesPerChannel(TexelType type);

/// A rectangle of texels; immutable once made.
class TextureImage {
public:
    static constexpr uint32_t kMaxSide = 1u << 20;

    /// channels: 1 luminance, 2 luminance and alpha, 3 RGB, 4 RGBA; rows from the bottom,
    /// tightly packed, in the machine's byte order. srgb: the texels are sRGB-encoded, but for
    /// alpha. Numbers that are not finite become 0, or the largest of their sign. Throws Error
    /// for a size that does not fit.
    TextureImage(uint32_t width, uint32_t height, uint32_t channels, TexelType type, bool srgb,
                 std::vector<std::byte> texels);

    uint32_t width() const { return width_; }
    uint32_t height() const { return height_; }
    uint32_t channels() const { return channels_; }
    TexelType type() const { return type_; }
    /// Whether the texels are kept encoded. Those of Half and Float are decoded when given.
    bool srgb() const { return srgb_; }
    std::size_t bytes() const { return texels_.size(); }

    /// A texel that read() leaves as it is.
    static constexpr std::size_t kNoTexel = ~std::size_t(0);
    /// RGBA, linear, of the texels with these numbers (row * width + column): what a channel is
    /// missing for is the luminance, or alpha 1.
    void read(std::span<const std::size_t> numbers, glm::vec4* rgba) const;
    /// The channels of a row, linear. `values`: width * channels.
    void readRow(uint32_t row, float* values) const;

    /// Puts another image into a part of this one, converted to its type. Throws Error where it
    /// does not lie inside or has other channels.
    void setPart(uint32_t x, uint32_t y, const TextureImage& part);

private:
    template <class Use>
    auto withReader(Use&& use) const;

    uint32_t width_, height_, channels_;
    TexelType type_;
    bool srgb_;
    std::vector<std::byte> texels_;
    const float* colorTable_ = nullptr; ///< Byte, and encoded Short: by code
};

/// Writes linear channels as an image of this kind has them: rounded to the nearest, Byte and Short
/// limited to 0..1. `count` values, alpha the last of an even number of channels.
void encodeTexels(const double* values, std::size_t count, uint32_t channels, TexelType type,
                  bool srgb, std::byte* texels);

using TextureImagePtr = std::shared_ptr<const TextureImage>;

} // namespace smart
