// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "libsmart/render/layered_tile.h"
#include "libsmart/render/polygon_raster.h"
#include "libsmart/render/rendering_object.h"
#include "libsmart/render/shading_services.h"
#include "libsmart/render/way_cache.h"

namespace smart {

/// What the hits of camera rays at one triangle have in common.
struct LayerSurface {
    RasterTriangle triangle;
    PolygonRaster::Plane plane;
    const FixedState* state = nullptr; ///< of the scene's instance
    const ShaderObject* shader = nullptr;
    uint32_t objectId = kNoId;
    bool isShown = true; ///< false: culled, or drawn as points or lines; not with a camera shader
    bool hasHoles = false; ///< clip planes or a stipple
};

/// A hit of a camera ray on its way to be a fragment.
struct LayerHit {
    Hit hit;
    uint32_t lane = 0;
    const FixedState* state = nullptr; ///< of the scene's instance
    const ShaderObject* shader = nullptr;
    float depth = 1.0f; ///< in the window
    bool counts = true; ///< false: culled, clipped, or the neighbour's
    // To be kept beside the colour.
    uint32_t objectId = kNoId;
    glm::vec3 normal{0.0f};
};

/// What belongs to the camera rays of a packet.
struct LayerLanes {
    PixelSample samples[kPacketSize];
    glm::dvec2 at[kPacketSize]; ///< where in the picture the samples are
    uint32_t open = 0;          ///< lanes whose pixels the layer may change
    uint32_t active = 0;        ///< those of them that have a ray
    uint32_t all = 0;           ///< active ones whose pixels need all hits
    // Of the active ones that met something:
    uint32_t alone = 0;   ///< those of which the nearest hit is enough
    uint32_t limited = 0; ///< of the others, those which are enough up to what hides the rest
};

/// A fragment of a packet's pixels that is to be shaded.
struct WantedColor {
    uint32_t fragment = 0, entry = 0;
    const ShaderObject* surface = nullptr;
};

/// Memory that a pass uses again for one packet of pixels after the other.
struct LayerPassMemory {
    RayBlock rays;
    LayerLanes lanes[kTilePackets]; ///< of the rays
    WayCache<LayerSurface> surfaces;
    std::vector<PixelFragment> covered; ///< by pixel primitives: by entry, then in order
    AllHits met, beyond, around;
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
    /// kTilePackets packets from a number on.
    void drawBlock(uint32_t packet);
    /// Makes the rays, and shows what lies below the layer's primitives.
    void begin(uint32_t packet);
    void clear(uint32_t packet, uint32_t lanes);
    uint32_t makeRays(uint32_t packet, uint32_t lanes);
    void showEnvironment(uint32_t packet, uint32_t active);
    void drawPixelsOfObject(uint32_t packet, uint32_t lanes);
    static bool needsAll(std::span<const PixelFragment> covered);
    /// Finds the fragments of the open lanes, whose nearest hits are known.
    void gather(uint32_t packet);
    /// Finds all hits of the rays that need more than the nearest.
    void collect();
    /// Keeps the hits of a ray that matter.
    void gatherHits(uint32_t lane);
    /// Whether what lies behind a ray's nearest hit is not to be seen;
    bool hidesOthers(uint32_t lane, const Hit& nearest);
    /// nor anything at its own place.
    bool decidesAlone(uint32_t lane, const Hit& nearest);
    /// The end of what can be seen of a ray's hits where the nearest of them hides the others.
    float farthestSeen(uint32_t lane, const Hit& nearest);
    /// `complete`: these are all hits of the ray. Else one on an edge whose owner is not among
    /// them is not kept.
    void keepHits(uint32_t lane, std::span<const Hit> met, bool complete);
    const LayerSurface& surfaceOf(const Hit& hit);
    bool isShown(const RasterTriangle& triangle, const FixedState& state, const Ray& ray) const;
    bool isDrawn(const LayerSurface& surface, const Hit& hit, uint32_t lane) const;
    /// In the window, with the polygon's offset.
    float depthOf(const LayerSurface& surface, const Hit& hit, uint32_t lane) const;
    void keepOwned(std::span<LayerHit> hits, const glm::dvec2& at, bool complete);
    /// Whether a triangle that owns a place is met close by, but is not among all the hits there.
    bool missesOwner(std::span<const LayerHit> hits, const glm::dvec2& at);
    void addFragments(std::size_t firstHit, uint32_t entry);
    void shade(uint32_t packet);
    void shadeGroup(const ShaderObject* surface, std::span<const WantedColor> wanted);
    void keepColor(uint32_t entry, const PixelSample& sample, glm::vec4& color);
    void merge(uint32_t packet);
    void storeFirst(uint32_t entry, const LayerHit& kept);

    const Frame& layer_;
    const LayerNeeds& needs_;
    const bool lowest_;
    const bool keepsNormals_;
    const Tile& tile_;
    TilePixels& pixels_;
    LayeredPixels& memory_;
    const CameraRays camera_;
    const PolygonRaster raster_;
    ShadingServices<DynamicShading> services_;
    const ThreadLoan<LayerPassMemory> pass_;
    uint32_t sample_ = 0, samples_ = 1;
    RayGroup* rays_ = nullptr; ///< of the packet under way
    LayerLanes* of_ = nullptr; ///< beside them
    LaneRange lanes_[kPacketSize];
};

} // namespace smart
