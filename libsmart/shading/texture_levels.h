// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <vector>

#include "libsmart/shading/texture_image.h"

namespace smart {

/// Sides of the next level: half as long, rounded down, at least 1 (OpenGL's rule).
constexpr uint32_t nextLevelSide(uint32_t side) {
    return side > 1 ? side / 2 : 1;
}

/// Number of levels down to a single texel.
uint32_t levelCount(uint32_t width, uint32_t height);

/// The next smaller level: each texel is the mean, in linear light and channel by channel, of what
/// it covers; where a side is odd, texels of the image count for the part of them that is
/// covered. Guthe, Heckbert: "Non-Power-of-Two Mipmapping", NVIDIA, 2005.
TextureImage reducedImage(const TextureImage& image);

/// The images that a texture consists of, each half as large as the one before. Those that are
/// not given are made from the first when they are first asked for. Thread-safe.
class TextureLevels {
public:
    /// images[0] is the largest, of `count` levels; where nullptr or nothing is given, a level is
    /// made. Given ones have the sizes and channels of the levels that they stand for, else
    /// Error is thrown.
    TextureLevels(std::vector<TextureImagePtr> images, uint32_t count);
    explicit TextureLevels(TextureImagePtr image) : TextureLevels({std::move(image)}, 1) {}

    uint32_t count() const { return count_; }
    const TextureImage& first() const { return *given_[0]; }
    /// `number` below count(). If there is no memory to make levels: the first one.
    const TextureImage& operator[](uint32_t number) const noexcept;
    /// Memory held now.
    std::size_t bytes() const;

private:
    void make() const;

    uint32_t count_;
    std::vector<TextureImagePtr> given_;
    bool complete_; ///< nothing has to be made
    mutable std::vector<TextureImagePtr> all_; ///< complete, or empty; not read before tried_
    mutable std::once_flag once_;
    mutable std::atomic<bool> tried_{false};
};

} // namespace smart
