// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <vector>

#include "libsmart/shading/fixed_function.h"
#include "libsmart/shading/texture_image.h"

namespace smart {

/// The pixels of a bitmap or of a rectangle of colours, rows from the bottom, as the application
/// gave them.
struct ImagePixels {
    uint32_t width = 0, height = 0;
    bool bitmap = false;
    TexelType type = TexelType::Byte;
    /// Colours: RGBA. A bitmap: rows of whole bytes, the highest bit leftmost.
    std::vector<std::byte> data;

    bool bit(uint32_t x, uint32_t y) const {
        const std::byte byte = data[std::size_t(y) * ((width + 7) / 8) + x / 8];
        return (std::to_integer<unsigned>(byte) >> (7 - x % 8) & 1u) != 0;
    }
    glm::vec4 color(uint32_t x, uint32_t y) const;
};

/// A bitmap or a rectangle of colours at its place in the window.
struct WindowImage {
    std::shared_ptr<const ImagePixels> pixels;
    glm::dvec2 corner{0.0}; ///< of the first pixel; of a bitmap at a whole pixel
    glm::dvec2 zoom{1.0};
    float depth = 0.0f;          ///< in the window
    LitVertex lit;               ///< of the raster position
    glm::vec4 scale{1.0f}, bias{0.0f}; ///< of colours
};

} // namespace smart
