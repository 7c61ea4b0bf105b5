// SPDX-License-Identifier: MIT
// One ray of a packet on its own, with all that its query knows.
#pragma once

#include "libsmart/kernel/precise_rays.h"

namespace smart::SMART_ISA {

inline void takeLane(const LocalRays<kPacketSize>& rays, int lane, LocalRays<1>& ray) {
    for (int k = 0; k < 3; ++k) {
        ray.org[k][0] = rays.org[k][lane];
        ray.dir[k][0] = rays.dir[k][lane];
    }
}

inline void takeLane(const PreciseRays<kPacketSize>& rays, int lane, PreciseRays<1>& ray) {
    takeLane(rays, lane, static_cast<LocalRays<1>&>(ray));
    for (int k = 0; k < 3; ++k) {
        ray.wideOrg[k][0] = rays.wideOrg[k][lane];
        ray.wideDir[k][0] = rays.wideDir[k][lane];
    }
    ray.wideOrgError[0] = rays.wideOrgError[lane];
    ray.wideDirError[0] = rays.wideDirError[lane];
    ray.orgError[0] = rays.orgError[lane];
    ray.dirError[0] = rays.dirError[lane];
}

/// The query of one lane; what it finds goes back to the packet's when it is destroyed.
template <HitMode M, class Counter>
class LaneQuery {
public:
    using Packet = Search<kPacketSize, M, Counter>;

    LaneQuery(Packet& packet, int lane) : packet_(packet), lane_(lane) {
        query.tNear[0] = packet.tNear[lane];
        query.best[0] = packet.best[lane];
        query.low[0] = packet.low[lane];
        query.triangle[0] = packet.triangle[lane];
        query.levels[0] = 0;
        if (query.triangle[0] != kNoHit) {
            query.levels[0] = packet.levels[lane];
            for (uint32_t l = 0; l < query.levels[0]; ++l) query.path[l][0] = packet.path[l][lane];
        }
        if (packet.world) {
            const WorldRays<kPacketSize>& from = *packet.world;
            for (int k = 0; k < 3; ++k) {
                world_.org[k][0] = from.org[k][lane];
                world_.dir[k][0] = from.dir[k][lane];
            }
            world_.tNear[0] = from.tNear[lane];
            world_.tFar[0] = from.tFar[lane];
            world_.scale[0] = from.scale[lane];
            world_.scene = from.scene;
            query.world = &world_;
        }
        query.lastOfEqual = packet.lastOfEqual;
        query.currentLevels = packet.currentLevels;
        for (uint32_t l = 0; l < packet.currentLevels; ++l)
            query.currentPath[l] = packet.currentPath[l];
        query.counter = packet.counter;
        query.all = packet.all;
        query.firstLane = uint32_t(lane);
    }
    LaneQuery(const LaneQuery&) = delete;
    LaneQuery& operator=(const LaneQuery&) = delete;

    ~LaneQuery() {
        packet_.blocked |= query.blocked << lane_;
        if (query.deepest == 0) return; // nothing was found
        packet_.best[lane_] = query.best[0];
        packet_.low[lane_] = query.low[0];
        packet_.triangle[lane_] = query.triangle[0];
        packet_.levels[lane_] = query.levels[0];
        for (uint32_t l = 0; l < query.levels[0]; ++l)
            packet_.path[l][lane_] = query.path[l][0];
        packet_.deepest = packet_.deepest > query.deepest ? packet_.deepest : query.deepest;
    }

    Search<1, M, Counter> query;

private:
    Packet& packet_;
    const int lane_;
    WorldRays<1> world_;
};

} // namespace smart::SMART_ISA
