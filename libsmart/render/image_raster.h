// SPDX-License-Identifier: MIT
// Which pixels an image at its place in the window covers, and with which of its own (OpenGL 1.5,
// sections 3.6.4 and 3.7).
#pragma once

#include <cmath>
#include <cstdint>

#include "libsmart/render/line_raster.h"
#include "libsmart/render/point_raster.h"
#include "libsmart/render/window_image.h"

namespace smart {

/// One direction of an image: window pixels whose centres the image's pixels cover.
class ImageAxis {
public:
    ImageAxis(double corner, double zoom, uint32_t count)
        : corner_(double(toSubpixels(corner)) / kSubpixels), zoom_(zoom), count_(count) {}

    int64_t low() const { return zoom_ > 0 ? firstFrom(corner_) : firstFrom(far()); }
    int64_t high() const { return zoom_ > 0 ? firstFrom(far()) : firstFrom(corner_); }
    /// Number of the image's pixel that the centre of a window pixel lies in; of two the upper one
    /// in the window.
    uint32_t pixelAt(uint32_t windowPixel) const {
        const double place = (windowPixel + 0.5 - corner_) / zoom_;
        const double number = zoom_ > 0 ? std::floor(place) : std::ceil(place) - 1.0;
        return number > 0.0 ? std::min(uint32_t(number), count_ - 1) : 0u;
    }

private:
    double far() const { return corner_ + zoom_ * count_; }
    /// The first pixel whose centre is not below.
    static int64_t firstFrom(double position) {
        return int64_t(std::ceil(std::min(std::max(position, kWindowMin), kWindowMax) - 0.5));
    }

    double corner_, zoom_;
    uint32_t count_;
};

/// Calls emit(x, y, i, j) for the pixels in the tile that pixel (i, j) of the image covers.
class ImageCoverage {
public:
    explicit ImageCoverage(const WindowImage& image)
        : x_(image.corner.x, image.zoom.x, image.pixels->width),
          y_(image.corner.y, image.zoom.y, image.pixels->height),
          box_{x_.low(), y_.low(), x_.high(), y_.high()} {}

    const PixelBox& box() const { return box_; }

    template <class Emit>
    void forEach(const Tile& tile, Emit&& emit) const {
        box_.forEach(tile, [&](uint32_t x, uint32_t y) {
            emit(x, y, x_.pixelAt(x), y_.pixelAt(y));
        });
    }

private:
    ImageAxis x_, y_;
    PixelBox box_;
};

} // namespace smart
