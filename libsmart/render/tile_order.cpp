// SPDX-License-Identifier: MIT
#include "libsmart/render/tile_order.h"

#include <algorithm>
#include <bit>

namespace smart {
namespace {

struct Grid {
    uint32_t width, height; // of the picture
    uint32_t columns, rows; // tiles
};

// Visits the square of `size` (a power of two) tiles at (x, y) quarter by quarter.
void visit(const Grid& grid, uint32_t x, uint32_t y, uint32_t size, std::vector<Tile>& tiles) {
    if (x >= grid.columns || y >= grid.rows) return;
    if (size == 1) {
        const uint32_t left = x * kTileSize, bottom = y * kTileSize;
        tiles.push_back({left, bottom, std::min(kTileSize, grid.width - left),
                         std::min(kTileSize, grid.height - bottom)});
        return;
    }
    const uint32_t half = size / 2;
    visit(grid, x, y, half, tiles);
    visit(grid, x + half, y, half, tiles);
    visit(grid, x, y + half, half, tiles);
    visit(grid, x + half, y + half, half, tiles);
}

} // namespace

std::vector<Tile> mortonTiles(uint32_t width, uint32_t height) {
    if (width == 0 || height == 0) return {};
    const Grid grid{width, height, (width - 1) / kTileSize + 1, (height - 1) / kTileSize + 1};
    std::vector<Tile> tiles;
    tiles.reserve(std::size_t(grid.columns) * grid.rows);
    visit(grid, 0, 0, std::bit_ceil(std::max(grid.columns, grid.rows)), tiles);
    return tiles;
}

} // namespace smart
