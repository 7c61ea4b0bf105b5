// SPDX-License-Identifier: MIT
#include "tests/support/kernel_runs.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace smart::test {
namespace {

/// Calls trace(packet, lanes, first): lanes[i] is the lane of ray first + i.
template <typename Trace>
void forPackets(std::span<const Ray> rays, Filling filling, const Trace& trace) {
    static constexpr int kScattered[] = {14, 3, 7, 0, 9};
    const std::size_t lanesUsed = filling == Filling::Full ? kPacketSize : std::size(kScattered);
    for (std::size_t first = 0; first < rays.size(); first += lanesUsed) {
        RayPacket packet;
        for (int lane = 0; lane < kPacketSize; ++lane) {
            for (int k = 0; k < 3; ++k) packet.org[k][lane] = packet.dir[k][lane] = NAN;
            packet.tNear[lane] = packet.tFar[lane] = NAN;
        }
        packet.active = 0;
        int lanes[kPacketSize];
        const std::size_t count = std::min(lanesUsed, rays.size() - first);
        for (std::size_t i = 0; i < count; ++i) {
            const int lane = filling == Filling::Full ? int(i) : kScattered[i];
            const Ray& ray = rays[first + i];
            for (int k = 0; k < 3; ++k) {
                packet.org[k][lane] = ray.org[k];
                packet.dir[k][lane] = ray.dir[k];
            }
            packet.tNear[lane] = ray.tNear;
            packet.tFar[lane] = ray.tFar;
            packet.active |= 1u << lane;
            lanes[i] = lane;
        }
        trace(packet, std::span<const int>(lanes, count), first);
    }
}

Hit laneOf(const HitPacket& packet, int lane) {
    Hit hit{packet.t[lane], packet.u[lane], packet.v[lane], packet.triangle[lane], 0, {}};
    if (hit.triangle == kNoHit) return hit;
    hit.levels = packet.levels[lane];
    for (uint32_t level = 0; level < hit.levels && level < uint32_t(kMaxLevels); ++level) {
        hit.path[level] = packet.path[level][lane];
    }
    return hit;
}

} // namespace

std::vector<const KernelTable*> availableKernels() {
    std::vector<const KernelTable*> tables;
    for (const char* name : {"generic", "sse4", "avx2", "avx512", "neon"}) {
        if (const KernelTable* table = findKernels(name)) tables.push_back(table);
    }
    return tables;
}

std::vector<Hit> tracePackets(const KernelTable& kernels, Precision precision,
                              const ModelView& scene, std::span<const Ray> rays, Filling filling) {
    std::vector<Hit> hits(rays.size());
    forPackets(rays, filling,
               [&](const RayPacket& packet, std::span<const int> lanes, std::size_t first) {
                   HitPacket result;
                   kernels.intersect[int(precision)](scene, packet, result);
                   for (std::size_t i = 0; i < lanes.size(); ++i)
                       hits[first + i] = laneOf(result, lanes[i]);
               });
    return hits;
}

std::vector<Hit> traceSingles(const KernelTable& kernels, Precision precision,
                              const ModelView& scene, std::span<const Ray> rays) {
    std::vector<Hit> hits(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        kernels.intersect1[int(precision)](scene, rays[i], hits[i]);
    }
    return hits;
}

std::vector<uint8_t> blockedPackets(const KernelTable& kernels, Precision precision,
                                    const ModelView& scene, std::span<const Ray> rays,
                                    Filling filling) {
    std::vector<uint8_t> blocked(rays.size());
    forPackets(rays, filling,
               [&](const RayPacket& packet, std::span<const int> lanes, std::size_t first) {
                   uint32_t mask = 0;
                   kernels.occluded[int(precision)](scene, packet, mask);
                   for (std::size_t i = 0; i < lanes.size(); ++i) {
                       blocked[first + i] = mask >> lanes[i] & 1;
                   }
               });
    return blocked;
}

std::vector<uint8_t> blockedSingles(const KernelTable& kernels, Precision precision,
                                    const ModelView& scene, std::span<const Ray> rays) {
    std::vector<uint8_t> blocked(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        blocked[i] = kernels.occluded1[int(precision)](scene, rays[i]);
    }
    return blocked;
}

namespace {

/// Calls trace(packets, how many, where each one's rays are).
struct PacketRays {
    std::vector<int> lanes;
    std::size_t first;
};
template <typename Trace>
void forTiles(std::span<const Ray> rays, Filling filling, const Trace& trace,
              std::size_t most = kTilePackets) {
    std::vector<RayPacket> packets;
    std::vector<PacketRays> where;
    forPackets(rays, filling,
               [&](const RayPacket& packet, std::span<const int> lanes, std::size_t first) {
                   packets.push_back(packet);
                   where.push_back({{lanes.begin(), lanes.end()}, first});
               });
    for (std::size_t p = 0; p < packets.size(); p += most) {
        const auto count = std::min(most, packets.size() - p);
        trace(&packets[p], uint32_t(count), std::span<const PacketRays>(&where[p], count));
    }
}
constexpr std::size_t kNoLimit = std::size_t(-1) / 2;

} // namespace

std::vector<Hit> traceTiles(const KernelTable& kernels, Precision precision,
                            const ModelView& scene, std::span<const Ray> rays, Filling filling) {
    std::vector<Hit> hits(rays.size());
    forTiles(rays, filling,
             [&](const RayPacket* packets, uint32_t count, std::span<const PacketRays> where) {
                 HitPacket result[kTilePackets];
                 kernels.intersectTile[int(precision)](scene, packets, count, result);
                 for (uint32_t p = 0; p < count; ++p)
                     for (std::size_t i = 0; i < where[p].lanes.size(); ++i)
                         hits[where[p].first + i] = laneOf(result[p], where[p].lanes[i]);
             });
    return hits;
}

std::vector<uint8_t> blockedTiles(const KernelTable& kernels, Precision precision,
                                  const ModelView& scene, std::span<const Ray> rays,
                                  Filling filling) {
    std::vector<uint8_t> blocked(rays.size());
    forTiles(rays, filling,
             [&](const RayPacket* packets, uint32_t count, std::span<const PacketRays> where) {
                 uint32_t masks[kTilePackets] = {};
                 kernels.occludedTile[int(precision)](scene, packets, count, masks);
                 for (uint32_t p = 0; p < count; ++p)
                     for (std::size_t i = 0; i < where[p].lanes.size(); ++i)
                         blocked[where[p].first + i] = masks[p] >> where[p].lanes[i] & 1;
             });
    return blocked;
}

std::vector<Hit> traceStream(const KernelTable& kernels, Precision precision,
                             const ModelView& scene, std::span<const Ray> rays, Filling filling) {
    std::vector<Hit> hits(rays.size());
    forTiles(
        rays, filling,
        [&](const RayPacket* packets, uint32_t count, std::span<const PacketRays> where) {
            std::vector<HitPacket> result(count);
            kernels.intersectStream[int(precision)](scene, packets, count, result.data());
            for (uint32_t p = 0; p < count; ++p)
                for (std::size_t i = 0; i < where[p].lanes.size(); ++i)
                    hits[where[p].first + i] = laneOf(result[p], where[p].lanes[i]);
        },
        kNoLimit);
    return hits;
}

std::vector<uint8_t> blockedStream(const KernelTable& kernels, Precision precision,
                                   const ModelView& scene, std::span<const Ray> rays,
                                   Filling filling) {
    std::vector<uint8_t> blocked(rays.size());
    forTiles(
        rays, filling,
        [&](const RayPacket* packets, uint32_t count, std::span<const PacketRays> where) {
            std::vector<uint32_t> masks(count);
            kernels.occludedStream[int(precision)](scene, packets, count, masks.data());
            for (uint32_t p = 0; p < count; ++p)
                for (std::size_t i = 0; i < where[p].lanes.size(); ++i)
                    blocked[where[p].first + i] = masks[p] >> where[p].lanes[i] & 1;
        },
        kNoLimit);
    return blocked;
}

bool sameHit(const Hit& a, const Hit& b) {
    if (a.triangle != b.triangle) return false;
    if (a.triangle == kNoHit) return true;
    const auto bits = [](float x) { return std::bit_cast<uint32_t>(x); };
    return bits(a.t) == bits(b.t) && bits(a.u) == bits(b.u) && bits(a.v) == bits(b.v) &&
           a.levels == b.levels && a.levels <= uint32_t(kMaxLevels) &&
           std::equal(a.path, a.path + a.levels, b.path);
}

std::size_t differences(std::span<const Hit> a, std::span<const Hit> b) {
    std::size_t count = a.size() == b.size() ? 0 : 1;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) count += !sameHit(a[i], b[i]);
    return count;
}

} // namespace smart::test
