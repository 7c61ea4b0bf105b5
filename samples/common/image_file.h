// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "samples/common/scene_description.h"

namespace samples {

/// Pixels that may still be decoded, so that a small file can not ask for all memory.
struct PixelBudget {
    uint64_t pixelsLeft = uint64_t(256) << 20;
};

/// Takes the pixels of an image from the budget; throws LoadError if they are none or too many.
void takePixels(PixelBudget& budget, uint64_t width, uint64_t height);

/// A PNG or JPEG in memory; throws LoadError.
Image decodeImage(std::span<const uint8_t> bytes, PixelBudget& budget);

/// PNG of 8-bit RGB or RGBA pixels, rows from the bottom as frame buffers have them.
std::vector<uint8_t> encodePng(uint32_t width, uint32_t height, uint32_t channels,
                               std::span<const uint8_t> pixels);

/// OpenEXR (half floats, ZIP) of linear RGBA, rows from the bottom.
std::vector<uint8_t> encodeExr(uint32_t width, uint32_t height, std::span<const float> rgba);

} // namespace samples
