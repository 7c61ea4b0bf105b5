// SPDX-License-Identifier: MIT
// Stored tiles in an order in which they pack better: each byte of the pixels in a plane of its
// own, less the byte of the row before. What varies slowly from row to row becomes runs of equal
// bytes, where interleaved channels, and the exponents and fractions of floats, have none.
#pragma once

#include <cstddef>

#include "libsmart/render/stored_tile.h"

namespace smart {

/// Of a tile of at most kTileSize a side. Both arrays have storedTileSize() bytes.
void splitTile(const StoredLayout& layout, const Tile& tile, const std::byte* stored,
               std::byte* planes);
/// The inverse.
void joinTile(const StoredLayout& layout, const Tile& tile, const std::byte* planes,
              std::byte* stored);

} // namespace smart
