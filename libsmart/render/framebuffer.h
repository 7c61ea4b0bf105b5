// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <limits>

namespace smart {

enum class PixelFormat : uint8_t { Bgr32f, Rgb8, Rgba8, Bgra8, Rgb32f, Rgba32f };
std::size_t bytesPerPixel(PixelFormat format);

/// Which further values of a pixel are wanted; each points to packed memory of the caller, the
/// picture's size, row 0 at the bottom; nullptr = not wanted.
struct AuxBuffers {
    float* depth = nullptr;    ///< window depth 0..1; a miss is 1
    float* distance = nullptr; ///< along the ray, world units; a miss is infinite
    float* normal = nullptr;   ///< three floats: shading normal, length 1; a miss is 0
    uint32_t* objectId = nullptr;
    uint32_t* instanceId = nullptr;
    uint32_t* primitiveId = nullptr; ///< a miss of the three is 0xFFFFFFFF

    bool any() const {
        return depth || distance || normal || objectId || instanceId || primitiveId;
    }
};

/// Memory of the caller that a frame is written to, tile by tile.
struct PixelTarget {
    void* memory = nullptr;
    uint32_t width = 0, height = 0;
    PixelFormat format = PixelFormat::Bgr32f;
    std::size_t stride = 0; ///< bytes between rows; 0: packed
    bool srgb = false;      ///< 8-bit formats are sRGB-encoded
    AuxBuffers aux;
};

inline constexpr uint32_t kTileSize = 32; ///< pixels; eight by eight packets

/// A rectangle of the picture, at most kTileSize a side.
struct Tile {
    uint32_t x = 0, y = 0, width = 0, height = 0;
};

/// What a tracer computes for a tile. Pixel (i, j) of the tile is entry j * kTileSize + i. Only the
/// colours are sure to be set where the target has no AuxBuffers.
struct TilePixels {
    static constexpr uint32_t kCount = kTileSize * kTileSize;
    glm::vec4 color[kCount];
    float depth[kCount];
    float distance[kCount];
    glm::vec3 normal[kCount];
    uint32_t objectId[kCount], instanceId[kCount], primitiveId[kCount];
    /// As where no ray hits anything; the colour stays.
    void setMiss(uint32_t entry) {
        depth[entry] = 1.0f;
        distance[entry] = std::numeric_limits<float>::infinity();
        normal[entry] = glm::vec3(0.0f);
        objectId[entry] = instanceId[entry] = primitiveId[entry] = 0xFFFFFFFFu;
    }

    uint64_t primaryRays = 0, shadowRays = 0, secondaryRays = 0; ///< of this tile
    uint64_t badPixels = 0; ///< pixels of faulty shaders or with radiance that is not finite
};

/// Writes a tile to its place, converted to the target's format. Tiles are disjoint: any threads
/// may write different ones at once.
void writeTile(const PixelTarget& target, const Tile& tile, const TilePixels& pixels);

} // namespace smart
