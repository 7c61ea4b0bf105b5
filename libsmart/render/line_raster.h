// SPDX-License-Identifier: MIT
// Which pixels a line covers.
#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/vec2.hpp>

#include "libsmart/render/framebuffer.h"

namespace smart {

/// Window coordinates that are not finite, or not within these, must not reach the rasteriser: its
/// arithmetic is exact in 64 bits.
inline constexpr double kWindowMin = -0x1p20, kWindowMax = 0x1p21;

/// Window coordinates are rounded to this part of a pixel, as RT_SUBPIXEL_BITS says.
inline constexpr int kSubpixels = 256;
int64_t toSubpixels(double coordinate);

/// OpenGL 1.5, section 3.4.1: the diamond-exit rule, with the ends moved by (-e, -e * e) where a
/// tie has to be broken. A line of width w is as many pixels high, or wide where it is steep.
/// Exact for the rounded ends.
class LineCoverage {
public:
    LineCoverage(const glm::dvec2& from, const glm::dvec2& to, uint32_t width);

    /// Steps along the larger of both directions; each has as many pixels as the line is wide.
    uint32_t length() const { return length_; }

    /// Calls emit(x, y, step) for the covered pixels in the tile, steps counted from the start.
    template <class Emit>
    void forEach(const Tile& tile, Emit&& emit) const;

private:
    /// The lowest pixel of a step.
    int64_t lowestAt(int64_t major) const;
    bool diamondHolds(int64_t major, int64_t minor, int64_t pixel) const;

    int64_t fromMajor_, fromMinor_, toMajor_, toMinor_; ///< the minor ones of the lowest pixels
    int64_t first_ = 0;                                 ///< pixel of the first step
    int64_t width_;
    uint32_t length_ = 0;
    bool steep_, forward_;
};

/// Section 3.4.2: the rectangle about a line, of its width and length, for smooth and multisampled
/// lines.
class LineRectangle {
public:
    LineRectangle(const glm::dvec2& from, const glm::dvec2& to, double width);

    /// Calls emit(x, y) for pixels in the tile that the rectangle may touch.
    template <class Emit>
    void forEach(const Tile& tile, Emit&& emit) const;

    double length() const { return length_; }
    /// Of a point along the line, from the start; and to its left.
    double along(const glm::dvec2& point) const;
    double across(const glm::dvec2& point) const;
    /// Share of a pixel's square inside.
    double coverage(int64_t x, int64_t y) const;
    bool contains(const glm::dvec2& point) const;

private:
    glm::dvec2 from_, direction_{0.0};
    double halfWidth_, length_;
    glm::dvec2 corners_[4];
};

// Implementation.

template <class Emit>
void LineCoverage::forEach(const Tile& tile, Emit&& emit) const {
    if (length_ == 0) return;
    const int64_t last = forward_ ? first_ + length_ - 1 : first_ - length_ + 1;
    const int64_t majorMin = steep_ ? tile.y : tile.x, minorMin = steep_ ? tile.x : tile.y;
    const int64_t majorEnd = majorMin + (steep_ ? tile.height : tile.width);
    const int64_t minorEnd = minorMin + (steep_ ? tile.width : tile.height);
    const int64_t begin = std::max(std::min(first_, last), majorMin);
    const int64_t end = std::min(std::max(first_, last) + 1, majorEnd);
    for (int64_t major = begin; major < end; ++major) {
        const int64_t lowest = lowestAt(major);
        const auto step = uint32_t(forward_ ? major - first_ : first_ - major);
        for (int64_t minor = std::max(lowest, minorMin);
             minor < std::min(lowest + width_, minorEnd); ++minor)
            steep_ ? emit(uint32_t(minor), uint32_t(major), step)
                   : emit(uint32_t(major), uint32_t(minor), step);
    }
}

template <class Emit>
void LineRectangle::forEach(const Tile& tile, Emit&& emit) const {
    if (!(length_ > 0)) return;
    glm::dvec2 low = corners_[0], high = corners_[0];
    for (const glm::dvec2& corner : corners_)
        for (int k = 0; k < 2; ++k) {
            low[k] = std::min(low[k], corner[k]);
            high[k] = std::max(high[k], corner[k]);
        }
    const auto begin = [](double value, uint32_t first) {
        return value > first ? uint32_t(std::min(value, double(kWindowMax))) : first;
    };
    const auto end = [](double value, uint32_t last) {
        return value < 0 ? 0u : value + 1 < last ? uint32_t(value) + 1 : last;
    };
    const uint32_t yEnd = end(high.y, tile.y + tile.height);
    for (uint32_t y = begin(low.y, tile.y); y < yEnd; ++y) {
        const uint32_t xEnd = end(high.x, tile.x + tile.width);
        for (uint32_t x = begin(low.x, tile.x); x < xEnd; ++x)
            // Farther off than half of a pixel's diagonal: not touched.
            if (std::abs(across({x + 0.5, y + 0.5})) < halfWidth_ + 0.75) emit(x, y);
    }
}

} // namespace smart
