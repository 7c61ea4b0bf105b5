// SPDX-License-Identifier: MIT
#include "libsmart/render/layered_tile.h"

#include <algorithm>

#include "libsmart/render/layer_pass.h"

namespace smart {

void LayeredTile::trace() {
    std::fill_n(memory_->sum, TilePixels::kCount, glm::vec4(0.0f));
    std::fill_n(memory_->bad, TilePixels::kCount, false);
    for (uint32_t entry = 0; entry < TilePixels::kCount; ++entry) pixels_.setMiss(entry);
    // A rendering object decides on its samples by itself.
    const uint32_t samples = frame_.renderingObject ? 1 : std::max(frame_.samples, 1u);
    for (uint32_t sample = 0; sample < samples; ++sample) {
        drawLayers(sample, samples);
        for (uint32_t entry = 0; entry < TilePixels::kCount; ++entry) {
            memory_->sum[entry] += memory_->values[entry].color;
            if (sample == 0) pixels_.depth[entry] = memory_->values[entry].depth;
        }
    }
    for (uint32_t j = 0; j < tile_.height; ++j)
        for (uint32_t i = 0; i < tile_.width; ++i) {
            const uint32_t entry = j * kTileSize + i;
            const glm::vec4 mean = memory_->sum[entry] / float(samples);
            const bool bad = memory_->bad[entry] || !isFinite(mean);
            pixels_.badPixels += bad;
            pixels_.color[entry] = bad ? glm::vec4(0.0f, 0.0f, 0.0f, 1.0f) : mean;
        }
}

void LayeredTile::drawLayers(uint32_t sample, uint32_t samples) {
    PixelValue nothing;
    nothing.color = frame_.clearColor;
    nothing.depth = frame_.clearDepth;
    std::fill_n(memory_->values, TilePixels::kCount, nothing);
    bool lowest = true;
    const auto draw = [&](const Frame& layer) {
        LayerPass(layer, lowest, tile_, pixels_, *memory_, form_).draw(sample, samples);
        lowest = false;
    };
    for (const auto& layer : frame_.below) draw(*layer);
    draw(frame_);
}

} // namespace smart
