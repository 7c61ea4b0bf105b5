// SPDX-License-Identifier: MIT
#pragma once

#include "libsmart/render/fragments.h"
#include "libsmart/render/ray_services.h"
#include "libsmart/render/thread_loan.h"

namespace smart {

/// Of the pixels of a tile, by TilePixels' entries.
struct LayeredPixels {
    PixelValue values[TilePixels::kCount]; ///< of the sample under way
    glm::vec4 sum[TilePixels::kCount];     ///< over the samples
    bool bad[TilePixels::kCount];
};

/// A tile of a frame whose pixels are made as OpenGL does: layer by layer, each of fragments in the
/// order of submission. Where a layer's state blocks are opaque a ray has one fragment, its nearest
/// hit that counts.
class LayeredTile {
public:
    LayeredTile(const Frame& frame, const Tile& tile, TilePixels& pixels, ShadingForm form)
        : frame_(frame), tile_(tile), pixels_(pixels), form_(form) {}

    void trace();

private:
    void drawLayers(uint32_t sample, uint32_t samples);

    const Frame& frame_;
    const Tile& tile_;
    TilePixels& pixels_;
    const ShadingForm form_;
    const ThreadLoan<LayeredPixels> memory_;
};

} // namespace smart
