// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <span>

#include "libsmart/render/rendering_object.h"
#include "libsmart/render/shading_services.h"
#include "libsmart/render/tile_rays.h"

namespace smart {

/// A tile being traced. All camera rays of a sample are traced, in packets of neighbours; then
/// what they hit is shaded shader by shader, sixteen points at a time.
template <class Shading>
class TileTracer {
public:
    TileTracer(const Frame& frame, const Tile& tile, TilePixels& pixels, ShadingForm form)
        : frame_(frame),
          tile_(tile),
          pixels_(pixels),
          camera_(frame),
          services_(frame, pixels, form),
          samples_(std::max(frame.samples, 1u)),
          keepsFirst_(frame.target.aux.any()),
          ofCentres_(samples_ == 1 && !frame.camera) {}

    void tracePackets();
    /// For frames with a rendering object, which says how pixels are made.
    void tracePixels();

private:
    using RayNumber = HitGroups::RayNumber;
    static constexpr uint32_t kLanes = uint32_t(kPacketSize), kAllLanes = (1u << kLanes) - 1u;

    /// Rays of one surface in packets, and the places of their pixels.
    struct Part {
        const ShaderObject* surface;
        const RayGroup* rays;
        uint32_t lanes;
        RayNumber ray[kPacketSize]; ///< of the tile, by lane
        bool inOrder;               ///< and they follow one another
    };

    /// Fills a pixel as one where nothing is; true where the camera sees it.
    bool clear(uint32_t i, uint32_t j);
    uint32_t visibleLanes(uint32_t packet);
    /// What the lens makes of the tile's columns and rows.
    void findCentres();
    void makeRays(uint32_t packet, uint32_t sample);
    /// Makes the rays of an 8 x 8 block from a packet on, and finds what they hit.
    void traceBlock(uint32_t packet, uint32_t sample);
    void traceSample(uint32_t sample);
    /// Shades the packets of the block that hit one surface, and puts aside what the others hit.
    void shadeBlock(uint32_t packet, std::size_t& misses, uint32_t sample);
    /// Copies sixteen rays, or as many as there are, to a packet of their own.
    Part collect(const ShaderObject* surface, std::span<const RayNumber> rays, RayGroup& group);
    void finish(const Part& part, const glm::vec4 (&colors)[kPacketSize]);
    /// Adds what a sample of a ray's pixel sees; with one sample a pixel it is stored at once.
    void add(uint32_t ray, const glm::vec4& color, bool fault);
    void storePixel(uint32_t ray, const glm::vec4& color, bool bad);
    /// Stores the colours of a packet whose pixels have one sample, if all are fine.
    bool storeWhole(uint32_t packet, const glm::vec4 (&colors)[kPacketSize]);
    /// Parts of the same surface are shaded together.
    void shadeHits(std::span<const Part> parts, uint32_t sample);
    void shadeMisses(const Part& part);
    void storeFirst(uint32_t entry, const Ray& ray, const ShadedSample& sample);
    /// Stores the means of several samples.
    void storeColors();

    const Frame& frame_;
    const Tile& tile_;
    TilePixels& pixels_;
    const CameraRays camera_;
    ShadingServices<Shading> services_;
    const uint32_t samples_;
    const bool keepsFirst_; ///< more of a pixel is wanted than its colour
    const bool ofCentres_;  ///< the lens makes the rays, one through each pixel's centre
    const ThreadLoan<TileRays> rays_;
    uint32_t visible_[tile_order::kPackets]; ///< lanes whose pixel the camera sees
};

template <class Shading>
void TileTracer<Shading>::tracePackets() {
    if (samples_ > 1) {
        std::fill_n(rays_->sum, TilePixels::kCount, glm::vec4(0.0f));
        std::fill_n(rays_->bad, TilePixels::kCount, false);
    }
    if (ofCentres_) findCentres();
    for (uint32_t packet = 0; packet < tile_order::kPackets; ++packet)
        visible_[packet] = visibleLanes(packet);
    for (uint32_t sample = 0; sample < samples_; ++sample) traceSample(sample);
    if (samples_ > 1) storeColors();
}

template <class Shading>
void TileTracer<Shading>::tracePixels() {
    for (uint32_t j = 0; j < tile_.height; ++j)
        for (uint32_t i = 0; i < tile_.width; ++i) {
            if (!clear(i, j)) continue;
            const PixelResult result =
                renderPixel(frame_, camera_, services_, tile_.x + i, tile_.y + j);
            const uint32_t entry = j * kTileSize + i;
            pixels_.color[entry] = result.color;
            pixels_.badPixels += result.bad;
            if (result.hasFirst) storeFirst(entry, result.firstRay, result.first);
        }
}

template <class Shading>
bool TileTracer<Shading>::clear(uint32_t i, uint32_t j) {
    const uint32_t entry = j * kTileSize + i;
    pixels_.color[entry] = frame_.clearColor;
    if (keepsFirst_) pixels_.setMiss(entry);
    return camera_.covers(tile_.x + i, tile_.y + j);
}

template <class Shading>
uint32_t TileTracer<Shading>::visibleLanes(uint32_t packet) {
    const tile_order::Corner corner = tile_order::cornerOf(packet);
    constexpr uint32_t kFar = tile_order::kPacketSide - 1;
    const uint32_t left = tile_.x + corner.x, bottom = tile_.y + corner.y;
    if (!keepsFirst_ && corner.x + kFar < tile_.width && corner.y + kFar < tile_.height &&
        camera_.covers(left, bottom) && camera_.covers(left + kFar, bottom + kFar))
        return kAllLanes;
    uint32_t visible = 0;
    for (uint32_t lane = 0; lane < kLanes; ++lane) {
        const uint32_t i = corner.x + lane % tile_order::kPacketSide;
        const uint32_t j = corner.y + lane / tile_order::kPacketSide;
        if (i < tile_.width && j < tile_.height && clear(i, j)) visible |= 1u << lane;
    }
    return visible;
}

template <class Shading>
void TileTracer<Shading>::findCentres() {
    constexpr uint32_t kSide = tile_order::kPacketSide, kSides = kTileSize / kSide;
    double x[kSides * kLanes], y[kSides * kLanes];
    for (uint32_t i = 0; i < kSides * kLanes; ++i) {
        const uint32_t corner = i / kLanes * kSide, lane = i % kLanes;
        x[i] = double(tile_.x + corner) + 0.5 + double(lane % kSide);
        y[i] = double(tile_.y + corner) + 0.5 + double(lane / kSide);
    }
    services_.findColumns(camera_, x, kSides, rays_->columns);
    services_.findRows(camera_, y, kSides, rays_->rows);
}

template <class Shading>
void TileTracer<Shading>::makeRays(uint32_t packet, uint32_t sample) {
    const tile_order::Corner corner = tile_order::cornerOf(packet);
    RayGroup& group = rays_->packet(packet);
    const uint32_t left = tile_.x + corner.x, bottom = tile_.y + corner.y;
    PixelSample* const samples = &rays_->samples[packet * kLanes];
    for (uint32_t lane = 0; lane < kLanes; ++lane)
        samples[lane] = PixelSample(left + lane % tile_order::kPacketSide,
                                    bottom + lane / tile_order::kPacketSide, sample, frame_.seed);
    const uint32_t lanes = visible_[packet];
    group.fresh = !frame_.camera;
    if (ofCentres_) {
        rays_->active[packet] =
            services_.makeCameraRays(camera_, rays_->columns[corner.x / tile_order::kPacketSide],
                                     rays_->rows[corner.y / tile_order::kPacketSide], group) &
            lanes;
    } else {
        double atX[kPacketSize], atY[kPacketSize];
        for (uint32_t lane = 0; lane < kLanes; ++lane) {
            const PixelSample& drawn = samples[lane];
            const glm::vec2 at =
                samplePosition(drawn.x, drawn.y, frame_.seed, sample, samples_);
            atX[lane] = double(drawn.x) + at.x;
            atY[lane] = double(drawn.y) + at.y;
        }
        rays_->active[packet] = services_.makeCameraRays(camera_, atX, atY, lanes, group);
    }
    forEach(lanes & ~rays_->active[packet],
            [&](int i) { add(packet * kLanes + uint32_t(i), glm::vec4(0.0f), true); });
}

template <class Shading>
void TileTracer<Shading>::traceBlock(uint32_t packet, uint32_t sample) {
    uint32_t some = 0;
    for (uint32_t p = packet; p < packet + kTilePackets; ++p) {
        rays_->active[p] = 0;
        if (visible_[p] != 0) makeRays(p, sample);
        some |= rays_->active[p];
    }
    if (some != 0)
        services_.findTileHits(rays_->blocks[packet / kTilePackets], &rays_->active[packet]);
}

template <class Shading>
void TileTracer<Shading>::traceSample(uint32_t sample) {
    rays_->groups.clear();
    std::size_t misses = 0;
    for (uint32_t packet = 0; packet < tile_order::kPackets; packet += kTilePackets) {
        traceBlock(packet, sample);
        shadeBlock(packet, misses, sample);
    }
    rays_->groups.forEachGroup(
        [&](const ShaderObject* surface, std::span<const RayNumber> rays) {
            while (!rays.empty()) {
                Part parts[kTilePackets];
                uint32_t count = 0;
                for (; count < kTilePackets && !rays.empty(); ++count) {
                    parts[count] = collect(surface, rays, rays_->collected[count]);
                    rays = rays.subspan(std::min<std::size_t>(kLanes, rays.size()));
                }
                shadeHits({parts, count}, sample);
            }
        });
    for (std::span<const RayNumber> rays(rays_->misses, misses); !rays.empty();
         rays = rays.subspan(std::min<std::size_t>(kLanes, rays.size())))
        shadeMisses(collect(nullptr, rays, rays_->collected[0]));
}

template <class Shading>
void TileTracer<Shading>::shadeBlock(uint32_t packet, std::size_t& misses, uint32_t sample) {
    constexpr int kLeastTogether = 12; // of fewer hits of a packet more are collected first
    Part parts[kTilePackets];
    std::size_t count = 0;
    for (uint32_t p = packet; p < packet + kTilePackets; ++p) {
        const uint32_t active = rays_->active[p];
        if (active == 0) continue;
        const RayGroup& group = rays_->packet(p);
        pixels_.primaryRays += uint64_t(std::popcount(active));
        const uint32_t hits = group.hitLanes() & active;
        forEach(active & ~hits, [&](int i) {
            const auto ray = RayNumber(p * kLanes + uint32_t(i));
            if (frame_.environment)
                rays_->misses[misses++] = ray;
            else
                add(ray, frame_.clearColor, false);
        });
        if (hits == 0) continue;
        const ShaderObject* surface = nullptr;
        if (std::popcount(hits) < kLeastTogether || !services_.findSurface(group, hits, surface)) {
            const ShaderObject* surfaces[kPacketSize];
            services_.findSurfaces(group, hits, surfaces);
            forEach(hits, [&](int i) {
                rays_->groups.add(RayNumber(p * kLanes + uint32_t(i)), surfaces[i]);
            });
            continue;
        }
        Part& part = parts[count++];
        part.surface = surface;
        part.rays = &group;
        part.lanes = hits;
        for (uint32_t lane = 0; lane < kLanes; ++lane)
            part.ray[lane] = RayNumber(p * kLanes + lane);
        part.inOrder = true;
    }
    std::size_t first = 0;
    for (std::size_t i = 1; i <= count; ++i) {
        if (i < count && parts[i].surface == parts[first].surface) continue;
        shadeHits({parts + first, i - first}, sample);
        first = i;
    }
}

template <class Shading>
typename TileTracer<Shading>::Part TileTracer<Shading>::collect(const ShaderObject* surface,
                                                                std::span<const RayNumber> rays,
                                                                RayGroup& group) {
    const auto count = uint32_t(std::min<std::size_t>(kLanes, rays.size()));
    Part part;
    part.surface = surface;
    part.rays = &group;
    part.lanes = (1u << count) - 1u;
    part.inOrder = false;
    group.fresh = !frame_.camera;
    for (uint32_t i = 0; i < count; ++i) {
        group.copyLane(int(i), rays_->packet(rays[i] / kLanes), int(rays[i] % kLanes));
        part.ray[i] = rays[i];
    }
    return part;
}

template <class Shading>
void TileTracer<Shading>::shadeHits(std::span<const Part> parts, uint32_t sample) {
    if (parts.empty()) return;
    glm::vec4 colors[kTilePackets][kPacketSize];
    const bool describes = sample == 0 && keepsFirst_;
    auto& found = rays_->found;
    const auto group = [&](std::size_t i) {
        const std::size_t n = std::min(i, parts.size() - 1);
        return HitGroup{parts[n].rays, parts[n].lanes, colors[n], describes ? found[n] : nullptr};
    };
    const HitGroup groups[kTilePackets] = {group(0), group(1), group(2), group(3)};
    services_.shadeGroups(parts[0].surface, {groups, parts.size()});
    for (std::size_t i = 0; i < parts.size(); ++i) {
        finish(parts[i], colors[i]);
        if (describes)
            forEach(parts[i].lanes, [&](int lane) {
                storeFirst(tile_order::entryOf(parts[i].ray[lane]), parts[i].rays->ray(lane),
                           found[i][lane]);
            });
    }
}

template <class Shading>
void TileTracer<Shading>::shadeMisses(const Part& part) {
    glm::vec4 colors[kPacketSize];
    services_.shadeMisses(*part.rays, part.lanes, colors);
    finish(part, colors);
}

template <class Shading>
void TileTracer<Shading>::finish(const Part& part, const glm::vec4 (&colors)[kPacketSize]) {
    const bool whole = part.inOrder && part.lanes == kAllLanes;
    if (whole && samples_ == 1 && storeWhole(part.ray[0] / kLanes, colors)) return;
    forEach(part.lanes, [&](int lane) {
        add(part.ray[lane], colors[lane], rays_->samples[part.ray[lane]].fault);
    });
}

template <class Shading>
void TileTracer<Shading>::add(uint32_t ray, const glm::vec4& color, bool fault) {
    if (samples_ == 1) return storePixel(ray, color + 0.0f, fault); // + 0: no negative zero
    rays_->sum[ray] += color; // a bad pixel's is no matter
    rays_->bad[ray] |= fault;
}

template <class Shading>
void TileTracer<Shading>::storePixel(uint32_t ray, const glm::vec4& color, bool bad) {
    bad |= !isFinite(color);
    pixels_.badPixels += bad;
    pixels_.color[tile_order::entryOf(ray)] = bad ? glm::vec4(0.0f, 0.0f, 0.0f, 1.0f) : color;
}

template <class Shading>
bool TileTracer<Shading>::storeWhole(uint32_t packet, const glm::vec4 (&colors)[kPacketSize]) {
    const PixelSample* const samples = &rays_->samples[packet * kLanes];
    glm::vec4 none(0.0f); // NaN where a colour is not finite
    bool fault = false;
    for (uint32_t lane = 0; lane < kLanes; ++lane) {
        none += colors[lane] - colors[lane];
        fault |= samples[lane].fault;
    }
    if (fault || none != glm::vec4(0.0f)) return false;
    glm::vec4* to = &pixels_.color[tile_order::entryOf(packet * kLanes)];
    for (uint32_t row = 0; row < tile_order::kPacketSide; ++row, to += kTileSize)
        for (uint32_t column = 0; column < tile_order::kPacketSide; ++column)
            to[column] = colors[row * tile_order::kPacketSide + column] + 0.0f;
    return true;
}

// The pixel's values beside the colour are those of its first sample.
template <class Shading>
void TileTracer<Shading>::storeFirst(uint32_t entry, const Ray& ray, const ShadedSample& sample) {
    if (sample.instance == kNoId) return;
    pixels_.depth[entry] = camera_.depth(ray, sample.distance);
    pixels_.distance[entry] = sample.distance;
    pixels_.normal[entry] = sample.normal;
    pixels_.objectId[entry] = sample.object;
    pixels_.instanceId[entry] = sample.instance;
    pixels_.primitiveId[entry] = sample.primitive;
}

template <class Shading>
void TileTracer<Shading>::storeColors() {
    for (uint32_t packet = 0; packet < tile_order::kPackets; ++packet)
        forEach(visible_[packet], [&](int i) {
            const uint32_t ray = packet * kLanes + uint32_t(i);
            // Finite samples may add up to what is not.
            storePixel(ray, rays_->sum[ray] / float(samples_), rays_->bad[ray]);
        });
}

} // namespace smart
