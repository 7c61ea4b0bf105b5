// SPDX-License-Identifier: MIT
#pragma once

#include "libsmart/render/frame.h"

namespace smart {

/// What turns a tile of a frame into pixels. Stateless: any number of threads share one.
class Tracer {
public:
    virtual ~Tracer() = default;
    /// Fills all pixels of the tile, and the counters.
    virtual void render(const Frame& frame, const Tile& tile, TilePixels& pixels) const = 0;
};

} // namespace smart
