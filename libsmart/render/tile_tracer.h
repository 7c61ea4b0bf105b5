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
          samples_(std::max(frame.samples, 1u)) {}

    void tracePackets();
    /// For frames with a rendering object, which says how pixels are made.
    void tracePixels();

private:
    using RayNumber = HitGroups::RayNumber;
    static constexpr uint32_t kLanes = uint32_t(kPacketSize);

    /// Fills a pixel as one where nothing is; true where the camera sees it.
    bool clear(uint32_t i, uint32_t j);
    uint32_t visibleLanes(uint32_t packet);
    void makeRays(uint32_t packet, uint32_t sample);
    /// Makes the rays of an 8 x 8 block from a packet on, and finds what they hit.
    void traceBlock(uint32_t packet, uint32_t sample);
    void traceSample(uint32_t sample);
    /// Copies sixteen rays, or as many as there are, and returns their lanes.
    uint32_t collect(std::span<const RayNumber> rays, RayGroup& group) const;
    void finish(std::span<const RayNumber> rays, const glm::vec4 (&colors)[kPacketSize]);
    void shadeHits(const ShaderObject* surface, std::span<const RayNumber> rays, uint32_t sample);
    void shadeMisses(std::span<const RayNumber> rays);
    void storeFirst(uint32_t entry, const Ray& ray, const ShadedSample& sample);
    void storeColors();

    const Frame& frame_;
    const Tile& tile_;
    TilePixels& pixels_;
    const CameraRays camera_;
    ShadingServices<Shading> services_;
    const uint32_t samples_;
    const ThreadLoan<TileRays> rays_;
    uint32_t visible_[tile_order::kPackets]; ///< lanes whose pixel the camera sees
};

template <class Shading>
void TileTracer<Shading>::tracePackets() {
    std::fill_n(rays_->sum, TilePixels::kCount, glm::vec4(0.0f));
    std::fill_n(rays_->bad, TilePixels::kCount, false);
    for (uint32_t packet = 0; packet < tile_order::kPackets; ++packet)
        visible_[packet] = visibleLanes(packet);
    for (uint32_t sample = 0; sample < samples_; ++sample) traceSample(sample);
    storeColors();
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
    pixels_.setMiss(entry);
    return camera_.covers(tile_.x + i, tile_.y + j);
}

template <class Shading>
uint32_t TileTracer<Shading>::visibleLanes(uint32_t packet) {
    const tile_order::Corner corner = tile_order::cornerOf(packet);
    uint32_t visible = 0;
    for (uint32_t lane = 0; lane < kLanes; ++lane) {
        const uint32_t i = corner.x + lane % tile_order::kPacketSide;
        const uint32_t j = corner.y + lane / tile_order::kPacketSide;
        if (i < tile_.width && j < tile_.height && clear(i, j)) visible |= 1u << lane;
    }
    return visible;
}

template <class Shading>
void TileTracer<Shading>::makeRays(uint32_t packet, uint32_t sample) {
    const tile_order::Corner corner = tile_order::cornerOf(packet);
    RayGroup& group = rays_->packets[packet];
    uint32_t active = 0;
    forEach(visible_[packet], [&](int i) {
        const uint32_t lane = uint32_t(i), ray = packet * kLanes + lane;
        const uint32_t x = tile_.x + corner.x + lane % tile_order::kPacketSide;
        const uint32_t y = tile_.y + corner.y + lane / tile_order::kPacketSide;
        PixelSample& drawn = rays_->samples[ray];
        drawn = PixelSample(x, y, sample, frame_.seed);
        const glm::vec2 at = samplePosition(x, y, frame_.seed, sample, samples_);
        if (!services_.makeCameraRay(camera_, double(x) + at.x, double(y) + at.y, drawn,
                                     group.ray[i], group.cone[i])) {
            rays_->bad[ray] = true;
            return;
        }
        group.weight[i] = 1.0f;
        group.sample[i] = &drawn;
        active |= 1u << lane;
    });
    rays_->active[packet] = active;
}

template <class Shading>
void TileTracer<Shading>::traceBlock(uint32_t packet, uint32_t sample) {
    uint32_t some = 0;
    for (uint32_t p = packet; p < packet + kTilePackets; ++p) {
        rays_->active[p] = 0;
        if (visible_[p] != 0) makeRays(p, sample);
        some |= rays_->active[p];
    }
    if (some != 0) services_.findTileHits(&rays_->packets[packet], &rays_->active[packet]);
}

template <class Shading>
void TileTracer<Shading>::traceSample(uint32_t sample) {
    rays_->groups.clear();
    std::size_t misses = 0;
    for (uint32_t packet = 0; packet < tile_order::kPackets; ++packet) {
        if (packet % kTilePackets == 0) traceBlock(packet, sample);
        const uint32_t active = rays_->active[packet];
        if (active == 0) continue;
        RayGroup& group = rays_->packets[packet];
        pixels_.primaryRays += uint64_t(std::popcount(active));
        forEach(active, [&](int i) {
            const auto ray = RayNumber(packet * kLanes + uint32_t(i));
            if (group.hit[i].triangle == kNoHit)
                rays_->misses[misses++] = ray;
            else
                rays_->groups.add(ray, services_.findSurface(group.hit[i]));
        });
    }
    rays_->groups.forEachGroup(
        [&](const ShaderObject* surface, std::span<const RayNumber> rays) {
            for (; !rays.empty(); rays = rays.subspan(std::min<std::size_t>(kLanes, rays.size())))
                shadeHits(surface, rays, sample);
        });
    for (std::span<const RayNumber> rays(rays_->misses, misses); !rays.empty();
         rays = rays.subspan(std::min<std::size_t>(kLanes, rays.size())))
        shadeMisses(rays);
}

template <class Shading>
uint32_t TileTracer<Shading>::collect(std::span<const RayNumber> rays, RayGroup& group) const {
    const auto count = uint32_t(std::min<std::size_t>(kLanes, rays.size()));
    for (uint32_t i = 0; i < count; ++i)
        group.copyLane(int(i), rays_->packets[rays[i] / kLanes], int(rays[i] % kLanes));
    return (1u << count) - 1u;
}

template <class Shading>
void TileTracer<Shading>::shadeHits(const ShaderObject* surface, std::span<const RayNumber> rays,
                                    uint32_t sample) {
    RayGroup group;
    const uint32_t lanes = collect(rays, group);
    glm::vec4 colors[kPacketSize];
    if (sample != 0) {
        services_.shadeGroup(surface, group, lanes, colors, nullptr);
    } else {
        ShadedSample found[kPacketSize];
        services_.shadeGroup(surface, group, lanes, colors, found);
        forEach(lanes, [&](int i) {
            storeFirst(tile_order::entryOf(rays[std::size_t(i)]), group.ray[i], found[i]);
        });
    }
    finish(rays, colors);
}

template <class Shading>
void TileTracer<Shading>::shadeMisses(std::span<const RayNumber> rays) {
    RayGroup group;
    const uint32_t lanes = collect(rays, group);
    glm::vec4 colors[kPacketSize];
    services_.shadeMisses(group, lanes, colors);
    finish(rays, colors);
}

template <class Shading>
void TileTracer<Shading>::finish(std::span<const RayNumber> rays,
                                 const glm::vec4 (&colors)[kPacketSize]) {
    for (std::size_t i = 0; i < std::min<std::size_t>(kLanes, rays.size()); ++i) {
        const RayNumber ray = rays[i];
        ShadedSample shaded;
        shaded.color = colors[i];
        shaded.judge(rays_->samples[ray]);
        rays_->sum[ray] += shaded.color;
        rays_->bad[ray] |= shaded.bad;
    }
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
            const glm::vec4 mean = rays_->sum[ray] / float(samples_);
            // Finite samples may add up to what is not.
            const bool bad = rays_->bad[ray] || !isFinite(mean);
            pixels_.badPixels += bad;
            pixels_.color[tile_order::entryOf(ray)] =
                bad ? glm::vec4(0.0f, 0.0f, 0.0f, 1.0f) : mean;
        });
}

} // namespace smart
