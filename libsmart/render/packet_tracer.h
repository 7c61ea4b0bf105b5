// SPDX-License-Identifier: MIT
#pragma once

#include "libsmart/render/tracer.h"

namespace smart {

/// The default tracer. A tile is always traced as blocks of eight by eight pixels, each of four
/// packets of four by four camera rays, whatever the instruction set and the thread; pixels
/// outside the tile or the viewport are lanes without a ray. A frame with a rendering object is
/// traced pixel by pixel instead, as that object asks.
class PacketTracer final : public Tracer {
public:
    void render(const Frame& frame, const Tile& tile, TilePixels& pixels) const override;
};

} // namespace smart
