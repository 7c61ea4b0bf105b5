// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/vec4.hpp>

#include "libsmart/kernel/kernels.h"
#include "libsmart/render/framebuffer.h"
#include "libsmart/render/hit_groups.h"
#include "libsmart/render/ray_services.h"

namespace smart {

/// The rays of a tile always lie as blocks of eight by eight pixels, each of four packets of four
/// by four, whatever the instruction set and the thread. Ray n of the tile is lane n % 16 of
/// packet n / 16.
namespace tile_order {

inline constexpr uint32_t kPacketSide = 4, kBlockSide = 8;
inline constexpr uint32_t kPackets = TilePixels::kCount / uint32_t(kPacketSize);
static_assert(kPacketSide * kPacketSide == kPacketSize);
static_assert(kTileSize % kBlockSide == 0 && kBlockSide == 2 * kPacketSide);

/// Column and row in the tile of a packet's lower left pixel.
struct Corner {
    uint32_t x, y;
};
constexpr Corner cornerOf(uint32_t packet) {
    constexpr uint32_t kBlocksInRow = kTileSize / kBlockSide;
    const uint32_t block = packet / 4, quarter = packet % 4;
    return {block % kBlocksInRow * kBlockSide + quarter % 2 * kPacketSide,
            block / kBlocksInRow * kBlockSide + quarter / 2 * kPacketSide};
}
/// Entry of TilePixels.
constexpr uint32_t entryOf(uint32_t ray) {
    const Corner corner = cornerOf(ray / uint32_t(kPacketSize));
    const uint32_t lane = ray % uint32_t(kPacketSize);
    return (corner.y + lane / kPacketSide) * kTileSize + corner.x + lane % kPacketSide;
}

} // namespace tile_order

/// What a tile needs while one sample of each of its pixels is made.
struct TileRays {
    TileRays() : blocks{}, active{} {
        for (uint32_t ray = 0; ray < TilePixels::kCount; ++ray) {
            RayGroup& group = packet(ray / uint32_t(kPacketSize));
            group.sample[ray % uint32_t(kPacketSize)] = &samples[ray];
            group.weight[ray % uint32_t(kPacketSize)] = 1.0f;
        }
    }
    TileRays(const TileRays&) = delete;
    TileRays& operator=(const TileRays&) = delete;

    RayGroup& packet(uint32_t number) {
        return blocks[number / kTilePackets].groups[number % kTilePackets];
    }

    /// Of camera rays: weights are 1, samples stay.
    RayBlock blocks[tile_order::kPackets / kTilePackets];
    uint32_t active[tile_order::kPackets]; ///< lanes with a ray
    PixelSample samples[TilePixels::kCount];
    HitGroups groups; ///< of packets that do not hit one surface
    HitGroups::RayNumber misses[TilePixels::kCount];
    LoneRayGroup collected[kTilePackets]; ///< rays of different packets
    ShadedSample found[kTilePackets][kPacketSize];

    /// Of pixel centres: by the packets' columns and rows of the tile.
    LensLanes columns[kTileSize / tile_order::kPacketSide],
        rows[kTileSize / tile_order::kPacketSide];

    // By ray, over all samples, where there are several.
    glm::vec4 sum[TilePixels::kCount];
    bool bad[TilePixels::kCount];
};

} // namespace smart
