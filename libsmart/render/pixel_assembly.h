// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "libsmart/render/frame.h"
#include "libsmart/render/window_image.h"
#include "libsmart/render/window_vertex.h"

namespace smart {

/// Points, lines and images of one layer, clipped, lit and in the window.
struct PixelItems {
    struct Common {
        const FixedState* state = nullptr; ///< nullptr: colour of the vertices, nearest first
        uint64_t order = 0;                ///< Fragment::order
    };
    struct Point : Common {
        WindowVertex at;
        float size = 1.0f;
    };
    struct Line : Common {
        WindowVertex from, to;
        uint32_t stippleStart = 0; ///< steps of its strip before it
    };
    struct Image : Common {
        const WindowImage* image = nullptr;
    };
    enum class Kind : uint8_t { Point, Line, Image };
    struct Item {
        Kind kind;
        uint32_t index;
    };

    std::vector<Point> points;
    std::vector<Line> lines;
    std::vector<Image> images;
    std::vector<Item> items; ///< all of them as submitted
};

/// Whether instances of a scene have something for assemblePixels().
bool drawsPixels(const Scene& scene);

/// Reads the layer's scene, viewport, depth range and, unless a camera shader makes its rays,
/// projection. With a camera shader only images have a place in the window.
PixelItems assemblePixels(const Frame& layer);

} // namespace smart
