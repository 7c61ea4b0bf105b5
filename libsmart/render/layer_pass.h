// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "libsmart/render/layered_tile.h"
#include "libsmart/render/polygon_raster.h"
#include "libsmart/render/rendering_object.h"
#include "libsmart/render/shading_services.h"

namespace smart {

/// A hit of a camera ray on its way to be a fragment.
struct LayerHit {
    Hit hit;
    uint32_t lane = 0;
    const FixedState* state = nullptr; ///< of the scene's instance
    RasterTriangle triangle;
    bool counts = true; ///< false: culled, clipped, or the neighbour's
    // To be kept beside the colour.
    uint32_t objectId = kNoId;
    glm::vec3 normal{0.0f};
};

/// A fragment of a packet's pixels that is to be shaded.
struct WantedColor {
    uint32_t fragment = 0, entry = 0;
    const ShaderObject* surface = nullptr;
};

/// Memory that a pass uses again for one packet of pixels after the other.
struct LayerPassMemory {
    RayGroup rays;
    PixelSample samples[kPacketSize];
    std::vector<PixelFragment> covered; ///< by pixel primitives: by entry, then in order
    std::vector<Hit> met;
    // Of the packet, lane after lane, each lane's in order.
    std::vector<LayerHit> hits;
    std::vector<Fragment> fragments;
    std::vector<WantedColor> wanted;
    std::vector<uint8_t> needed; ///< of one lane's fragments: whether the colour may matter
};

/// Draws one layer of one sample of a tile's pixels, packet by packet.
class LayerPass {
public:
    /// `lowest`: below the layer is nothing but the clear colour, or its environment.
    LayerPass(const Frame& layer, bool lowest, const Tile& tile, TilePixels& pixels,
              LayeredPixels& memory, ShadingForm form);

    void draw(uint32_t sample, uint32_t samples);

private:
    static constexpr uint32_t kLanes = uint32_t(kPacketSize);
    /// Of a lane: fragments from `first` up to `end`.
    struct LaneRange {
        uint32_t first = 0, end = 0;
    };

    void coverPixels();
    std::span<const PixelFragment> coveredAt(uint32_t entry) const;
    void drawPacket(uint32_t packet);
    void clear(uint32_t packet, uint32_t lanes);
    uint32_t makeRays(uint32_t packet, uint32_t lanes);
    void showEnvironment(uint32_t packet, uint32_t active);
    void drawPixelsOfObject(uint32_t packet, uint32_t lanes);
    bool needsAll(std::span<const PixelFragment> covered) const;
    /// Finds the fragments of the `open` lanes, of which the `active` ones have a ray.
    void gather(uint32_t packet, uint32_t open, uint32_t active);
    void keepHits(uint32_t lane, std::span<const Hit> met);
    bool isDrawn(const LayerHit& kept) const;
    void keepOwned(std::span<LayerHit> hits, const glm::dvec2& at) const;
    void addFragments(uint32_t lane, std::size_t firstHit, uint32_t entry);
    void shade(uint32_t packet);
    void shadeGroup(const ShaderObject* surface, std::span<const WantedColor> wanted);
    void keepColor(uint32_t entry, uint32_t lane, glm::vec4& color);
    void merge(uint32_t packet, uint32_t open);
    void storeFirst(uint32_t entry, const LayerHit& kept);

    const Frame& layer_;
    const bool lowest_;
    const Tile& tile_;
    TilePixels& pixels_;
    LayeredPixels& memory_;
    const CameraRays camera_;
    const PolygonRaster raster_;
    ShadingServices<DynamicShading> services_;
    const ThreadLoan<LayerPassMemory> pass_;
    uint32_t sample_ = 0, samples_ = 1;
    LaneRange lanes_[kPacketSize];
    glm::dvec2 at_[kPacketSize]; ///< where in the picture the lanes' samples are
};

} // namespace smart
