// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "compat/recorder/pixel_transfer.h"
#include "libsmart/shading/fixed_function.h"

namespace smart::compat {

/// OpenGL's current raster position (OpenGL 1.5, section 2.12): where bitmaps and rectangles of
/// pixels are drawn, and what they have beside their pixels.
struct RasterPosition {
    bool valid = true;
    glm::dvec3 window{0.0};
    double clipW = 1.0;
    LitVertex lit;

    RasterPosition() { lit.primary = glm::vec4(1.0f); }
};

/// State that rectangles of pixels are drawn with.
struct PixelDrawing {
    RasterPosition raster;
    glm::dvec2 zoom{1.0};
    PixelTransfer transfer;
};

} // namespace smart::compat
