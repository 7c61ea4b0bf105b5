// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "libsmart/kernel/kernels.h"
#include "libsmart/kernel/packet.h"
#include "libsmart/render/ray_cone.h"
#include "libsmart/render/sampling.h"
#include "openrt/lanes.hpp"

namespace smart {

/// What a ray brings along to what it meets.
struct PathState {
    PixelSample* sample;
    uint32_t depth = 0;
    float weight = 1.0f;
    uint32_t flags = 0; ///< RTSstate::flags
    RayCone cone{};     ///< where the ray starts
};

/// Lanes where condition(lane) holds.
template <class Condition>
inline uint32_t lanesWhere(Condition&& condition) {
    uint32_t lanes = 0;
    for (int i = 0; i < kPacketSize; ++i)
        lanes |= condition(i) ? openrt::detail::kLaneBit[i] : 0u;
    return lanes;
}

/// Up to sixteen rays of different samples and what they met. Which of the lanes hold a ray is
/// said beside; the others hold nothing.
struct RayGroup {
    uint32_t depth = 0, flags = 0; ///< of all
    /// Nothing has been drawn from the samples' random numbers, and none of them is a fault.
    bool fresh = false;
    RayPacket& rays; ///< `active` is set by those who trace them
    HitPacket& hits; ///< triangle is kNoHit where nothing was met
    float coneWidth[kPacketSize], coneSpread[kPacketSize];
    float weight[kPacketSize];
    PixelSample* sample[kPacketSize];

    RayGroup(RayPacket& itsRays, HitPacket& itsHits) : rays(itsRays), hits(itsHits) {}
    RayGroup(const RayGroup&) = delete;
    RayGroup& operator=(const RayGroup&) = delete;

    Ray ray(int lane) const {
        return {{rays.org[0][lane], rays.org[1][lane], rays.org[2][lane]},
                {rays.dir[0][lane], rays.dir[1][lane], rays.dir[2][lane]},
                rays.tNear[lane],
                rays.tFar[lane]};
    }
    void setRay(int lane, const Ray& ray) {
        for (int k = 0; k < 3; ++k) {
            rays.org[k][lane] = ray.org[k];
            rays.dir[k][lane] = ray.dir[k];
        }
        rays.tNear[lane] = ray.tNear;
        rays.tFar[lane] = ray.tFar;
    }
    bool hasHit(int lane) const { return hits.triangle[lane] != kNoHit; }
    Hit hit(int lane) const {
        Hit hit;
        hit.triangle = hits.triangle[lane];
        hit.levels = 0;
        if (hit.triangle == kNoHit) return hit;
        hit.t = hits.t[lane];
        hit.u = hits.u[lane];
        hit.v = hits.v[lane];
        hit.levels = hits.levels[lane];
        for (uint32_t level = 0; level < hit.levels; ++level)
            hit.path[level] = hits.path[level][lane];
        return hit;
    }
    void setHit(int lane, const Hit& hit) {
        hits.triangle[lane] = hit.triangle;
        if (hit.triangle == kNoHit) return;
        hits.t[lane] = hit.t;
        hits.u[lane] = hit.u;
        hits.v[lane] = hit.v;
        hits.levels[lane] = hit.levels;
        for (uint32_t level = 0; level < hit.levels; ++level)
            hits.path[level][lane] = hit.path[level];
    }
    RayCone cone(int lane) const { return {coneWidth[lane], coneSpread[lane]}; }
    void setCone(int lane, const RayCone& cone) {
        coneWidth[lane] = cone.width;
        coneSpread[lane] = cone.spread;
    }
    PathState path(int lane) const {
        return {sample[lane], depth, weight[lane], flags, cone(lane)};
    }
    void copyLane(int to, const RayGroup& from, int lane) {
        setRay(to, from.ray(lane));
        setHit(to, from.hit(lane));
        setCone(to, from.cone(lane));
        weight[to] = from.weight[lane];
        sample[to] = from.sample[lane];
    }

    /// Among lanes that hit something, those that took the way that the lowest of them took.
    uint32_t sameWay(uint32_t lanes) const {
        const int first = std::countr_zero(lanes);
        uint32_t differ[kPacketSize];
        for (int i = 0; i < kPacketSize; ++i) differ[i] = hits.levels[i] ^ hits.levels[first];
        for (uint32_t level = 0; level < hits.levels[first]; ++level)
            for (int i = 0; i < kPacketSize; ++i)
                differ[i] |= hits.path[level][i] ^ hits.path[level][first];
        return lanesWhere([&](int i) { return differ[i] == 0; }) & lanes;
    }
    /// Among such lanes, those that hit the triangle of the lowest, on its way.
    uint32_t sameTriangle(uint32_t lanes) const {
        const uint32_t triangle = hits.triangle[std::countr_zero(lanes)];
        return lanesWhere([&](int i) { return hits.triangle[i] == triangle; }) & sameWay(lanes);
    }
    /// Lanes that hit something, if they hold a ray.
    uint32_t hitLanes() const {
        return lanesWhere([&](int i) { return hits.triangle[i] != kNoHit; });
    }
};

/// Memory for the rays of a group and what they met.
struct RayMemory {
    RayPacket ownRays;
    HitPacket ownHits;
};
/// A group by itself. Its memory is 0 at first: lanes without a ray are computed along.
struct LoneRayGroup : private RayMemory, RayGroup {
    LoneRayGroup() : RayMemory{}, RayGroup(ownRays, ownHits) {}
};

/// Groups of neighbours, which are traced as one tile: their rays lie side by side.
struct RayBlock {
    RayPacket rays[kTilePackets];
    HitPacket hits[kTilePackets];
    RayGroup groups[kTilePackets] = {
        {rays[0], hits[0]}, {rays[1], hits[1]}, {rays[2], hits[2]}, {rays[3], hits[3]}};
};

/// function(lane) for each of the lanes, from the lowest up.
template <class Function>
inline void forEach(uint32_t lanes, Function&& function) {
    for (; lanes != 0; lanes &= lanes - 1) function(int(std::countr_zero(lanes)));
}

} // namespace smart
