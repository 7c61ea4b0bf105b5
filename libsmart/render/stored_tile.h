// SPDX-License-Identifier: MIT
// A tile's pixels in the formats of the picture that it belongs to, as they travel between
// machines.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "libsmart/render/framebuffer.h"

namespace smart {

/// What a stored tile is made of: parts one after the other, each with all pixels of the tile.
struct StoredLayout {
    std::array<uint8_t, 7> pixelSize{}; ///< bytes of a pixel in each part: 3, 4, 12 or 16
    unsigned parts = 0;
};
StoredLayout storedLayout(const PixelTarget& target);

/// Of the colours and of all auxiliary values that the target asks for.
std::size_t storedTileSize(const PixelTarget& target, const Tile& tile);
/// `bytes`: storedTileSize() of them, aligned as floats are.
void storeTile(const PixelTarget& target, const Tile& tile, const TilePixels& pixels,
               std::byte* bytes);
/// Puts what storeTile() made of the same tile to its place, as writeTile() would.
void placeTile(const PixelTarget& target, const Tile& tile, const std::byte* bytes);

/// What storeTile() made of what is in that place.
void gatherTile(const PixelTarget& target, const Tile& tile, std::byte* bytes);

} // namespace smart
