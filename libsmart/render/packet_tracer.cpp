// SPDX-License-Identifier: MIT
#include "libsmart/render/packet_tracer.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "libsmart/kernel/kernels.h"
#include "libsmart/render/camera_rays.h"
#include "libsmart/render/rendering_object.h"
#include "libsmart/render/sampling.h"
#include "libsmart/render/shading_services.h"

namespace smart {
namespace {

constexpr uint32_t kPacketSide = 4;
constexpr uint32_t kBlockSide = 8;
static_assert(kPacketSide * kPacketSide == kPacketSize);
static_assert(kTileSize % kBlockSide == 0 && kBlockSide % kPacketSide == 0);

/// A tile being traced.
class TileTracer {
public:
    TileTracer(const Frame& frame, const Tile& tile, TilePixels& pixels)
        : frame_(frame),
          tile_(tile),
          pixels_(pixels),
          camera_(frame),
          services_(frame, pixels),
          samples_(std::max(frame.samples, 1u)) {}

    void tracePackets() {
        for (uint32_t j = 0; j < tile_.height; j += kBlockSide)
            for (uint32_t i = 0; i < tile_.width; i += kBlockSide)
                for (uint32_t quarter = 0; quarter < 4; ++quarter)
                    tracePacket(i + quarter % 2 * kPacketSide, j + quarter / 2 * kPacketSide);
    }

    void tracePixels() {
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

private:
    // Fills a pixel as one where nothing is; true where the camera sees it.
    bool clear(uint32_t i, uint32_t j) {
        const uint32_t entry = j * kTileSize + i;
        pixels_.color[entry] = frame_.clearColor;
        pixels_.depth[entry] = 1.0f;
        pixels_.distance[entry] = std::numeric_limits<float>::infinity();
        pixels_.normal[entry] = glm::vec3(0.0f);
        pixels_.objectId[entry] = kNoId;
        pixels_.instanceId[entry] = kNoId;
        pixels_.primitiveId[entry] = kNoId;
        return camera_.covers(tile_.x + i, tile_.y + j);
    }

    // The pixel's values beside the colour are those of its first sample.
    void storeFirst(uint32_t entry, const Ray& ray, const ShadedSample& sample) {
        if (sample.instance == kNoId) return;
        pixels_.depth[entry] = camera_.depth(ray, sample.distance);
        pixels_.distance[entry] = sample.distance;
        pixels_.normal[entry] = sample.normal;
        pixels_.objectId[entry] = sample.object;
        pixels_.instanceId[entry] = sample.instance;
        pixels_.primitiveId[entry] = sample.primitive;
    }

    // The packet whose lower left pixel is (left, bottom) of the tile.
    void tracePacket(uint32_t left, uint32_t bottom) {
        uint32_t seen = 0; // lanes whose pixel the camera sees
        for (uint32_t lane = 0; lane < kPacketSize; ++lane) {
            const uint32_t i = left + lane % kPacketSide, j = bottom + lane / kPacketSide;
            if (i < tile_.width && j < tile_.height && clear(i, j)) seen |= 1u << lane;
        }
        if (seen == 0) return;

        glm::vec4 sum[kPacketSize];
        std::fill_n(sum, kPacketSize, glm::vec4(0.0f));
        uint32_t bad = 0;
        for (uint32_t sample = 0; sample < samples_; ++sample)
            bad |= traceSample(left, bottom, seen, sample, sum);

        for (uint32_t lanes = seen; lanes != 0; lanes &= lanes - 1) {
            const uint32_t lane = uint32_t(std::countr_zero(lanes));
            const glm::vec4 mean = sum[lane] / float(samples_);
            for (int k = 0; k < 4; ++k) // finite samples may add up to what is not
                if (!std::isfinite(mean[k])) bad |= 1u << lane;
            pixels_.color[entryOf(left, bottom, lane)] =
                bad >> lane & 1 ? glm::vec4(0.0f, 0.0f, 0.0f, 1.0f) : mean;
        }
        pixels_.badPixels += uint64_t(std::popcount(bad));
    }

    static uint32_t entryOf(uint32_t left, uint32_t bottom, uint32_t lane) {
        return (bottom + lane / kPacketSide) * kTileSize + left + lane % kPacketSide;
    }

    // Adds one sample of each lane to its sum; returns the lanes where a shader failed.
    uint32_t traceSample(uint32_t left, uint32_t bottom, uint32_t seen, uint32_t sample,
                         glm::vec4 (&sum)[kPacketSize]) {
        RayPacket packet{};
        RayCone cones[kPacketSize];
        PixelSample samplesOf[kPacketSize];
        uint32_t bad = 0;
        for (uint32_t lanes = seen; lanes != 0; lanes &= lanes - 1) {
            const uint32_t lane = uint32_t(std::countr_zero(lanes));
            const uint32_t x = tile_.x + left + lane % kPacketSide;
            const uint32_t y = tile_.y + bottom + lane / kPacketSide;
            const glm::vec2 position = samplePosition(x, y, frame_.seed, sample, samples_);
            const double column = double(x) + position.x, row = double(y) + position.y;
            Ray ray;
            samplesOf[lane] = PixelSample(x, y, sample, frame_.seed);
            if (!services_.makeCameraRay(camera_, column, row, samplesOf[lane], ray,
                                         cones[lane])) {
                bad |= 1u << lane;
                continue;
            }
            for (int k = 0; k < 3; ++k) {
                packet.org[k][lane] = ray.org[k];
                packet.dir[k][lane] = ray.dir[k];
            }
            packet.tNear[lane] = ray.tNear;
            packet.tFar[lane] = ray.tFar;
            packet.active |= 1u << lane;
        }
        if (packet.active == 0) return bad;

        HitPacket hits;
        kernels().intersect[std::size_t(frame_.scene->precision())](frame_.scene->view(), packet,
                                                                    hits);
        pixels_.primaryRays += uint64_t(std::popcount(packet.active));

        for (uint32_t lanes = packet.active; lanes != 0; lanes &= lanes - 1) {
            const uint32_t lane = uint32_t(std::countr_zero(lanes));
            const Ray ray = rayOf(packet, lane);
            const ShadedSample shaded = services_.shadeCameraRay(
                ray, hitOf(hits, lane), {&samplesOf[lane], 0, 1.0f, 0, cones[lane]});
            if (shaded.bad) bad |= 1u << lane;
            sum[lane] += shaded.color;
            if (sample == 0) storeFirst(entryOf(left, bottom, lane), ray, shaded);
        }
        return bad;
    }

    static Ray rayOf(const RayPacket& packet, uint32_t lane) {
        return {{packet.org[0][lane], packet.org[1][lane], packet.org[2][lane]},
                {packet.dir[0][lane], packet.dir[1][lane], packet.dir[2][lane]},
                packet.tNear[lane],
                packet.tFar[lane]};
    }

    static Hit hitOf(const HitPacket& hits, uint32_t lane) {
        Hit hit{};
        hit.triangle = hits.triangle[lane];
        if (hit.triangle == kNoHit) return hit;
        hit.t = hits.t[lane];
        hit.u = hits.u[lane];
        hit.v = hits.v[lane];
        hit.levels = hits.levels[lane];
        for (uint32_t level = 0; level < hit.levels; ++level)
            hit.path[level] = hits.path[level][lane];
        return hit;
    }

    const Frame& frame_;
    const Tile& tile_;
    TilePixels& pixels_;
    const CameraRays camera_;
    ShadingServices<> services_;
    const uint32_t samples_;
};

} // namespace

void PacketTracer::render(const Frame& frame, const Tile& tile, TilePixels& pixels) const {
    pixels.primaryRays = pixels.shadowRays = pixels.secondaryRays = pixels.badPixels = 0;
    TileTracer tracer(frame, tile, pixels);
    if (frame.renderingObject)
        tracer.tracePixels();
    else
        tracer.tracePackets();
}

} // namespace smart
