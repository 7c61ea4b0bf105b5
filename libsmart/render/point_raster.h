// SPDX-License-Identifier: MIT
// Which pixels a point covers (OpenGL 1.5, section 3.3).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "libsmart/render/framebuffer.h"
#include "libsmart/shading/fixed_state.h"

namespace smart {

/// Pixels from `low` to below `high`; anything outside of a tile may be cut off.
struct PixelBox {
    int64_t xLow, yLow, xHigh, yHigh;

    template <class Emit>
    void forEach(const Tile& tile, Emit&& emit) const {
        const int64_t yEnd = std::min<int64_t>(yHigh, tile.y + tile.height);
        const int64_t xEnd = std::min<int64_t>(xHigh, tile.x + tile.width);
        for (int64_t y = std::max<int64_t>(yLow, tile.y); y < yEnd; ++y)
            for (int64_t x = std::max<int64_t>(xLow, tile.x); x < xEnd; ++x)
                emit(uint32_t(x), uint32_t(y));
    }
};

/// Of an aliased point: a square of so many pixels, about the centre of the point's pixel where the
/// size is odd, about the nearest corner of pixels where it is even.
PixelBox pointSquare(const glm::dvec2& at, float size);

/// Of a smooth or multisampled point.
class PointDisc {
public:
    PointDisc(const glm::dvec2& at, float size);

    PixelBox box() const;
    bool contains(const glm::dvec2& point) const;
    /// Share of a pixel's square inside, to a 256th.
    double coverage(uint32_t x, uint32_t y) const;

private:
    glm::dvec2 center_;
    double radius_;
};

/// A size or width as lines and points have it: 1 to kMaxPixelSize; NaN: 1. Aliased ones have it
/// rounded.
double limitedSize(float size);
uint32_t wholePixels(float size);

/// The size of a point at a place in eye space, attenuated with the distance from the eye and
/// limited (equation 3.1).
float pointSizeAt(const FixedRaster& raster, const glm::dvec3& eye);

} // namespace smart
