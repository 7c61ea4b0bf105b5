// SPDX-License-Identifier: MIT
#include "libsmart/render/tile_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace smart {
namespace {

uint64_t mortonCode(uint32_t x, uint32_t y) {
    uint64_t code = 0;
    for (int bit = 0; bit < 32; ++bit) {
        code |= uint64_t(x >> bit & 1) << (2 * bit);
        code |= uint64_t(y >> bit & 1) << (2 * bit + 1);
    }
    return code;
}

TEST(TileOrder, CoversEveryPixelOnceInMortonOrder) {
    const uint32_t sizes[][2] = {{1, 1}, {32, 32}, {33, 31}, {640, 480}, {7, 1000}, {1000, 3}};
    for (const auto& [width, height] : sizes) {
        const std::vector<Tile> tiles = mortonTiles(width, height);
        std::vector<int> covered(std::size_t(width) * height, 0);
        for (const Tile& tile : tiles) {
            EXPECT_LE(tile.width, kTileSize);
            EXPECT_LE(tile.height, kTileSize);
            for (uint32_t y = tile.y; y < tile.y + tile.height; ++y)
                for (uint32_t x = tile.x; x < tile.x + tile.width; ++x)
                    ++covered.at(std::size_t(y) * width + x);
        }
        EXPECT_TRUE(std::ranges::all_of(covered, [](int count) { return count == 1; }));
        EXPECT_TRUE(std::ranges::is_sorted(
            tiles, {},
            [](const Tile& tile) { return mortonCode(tile.x / kTileSize, tile.y / kTileSize); }))
            << width << " x " << height;
    }
}

TEST(TileOrder, EmptyPicturesHaveNoTiles) {
    EXPECT_TRUE(mortonTiles(0, 0).empty());
    EXPECT_TRUE(mortonTiles(0, 10).empty());
    EXPECT_TRUE(mortonTiles(10, 0).empty());
}

} // namespace
} // namespace smart
