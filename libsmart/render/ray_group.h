// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>

#include "libsmart/kernel/packet.h"
#include "libsmart/render/ray_cone.h"
#include "libsmart/render/sampling.h"

namespace smart {

/// What a ray brings along to what it meets.
struct PathState {
    PixelSample* sample;
    uint32_t depth = 0;
    float weight = 1.0f;
    uint32_t flags = 0; ///< RTSstate::flags
    RayCone cone{};     ///< where the ray starts
};

/// Up to sixteen rays of different samples and what they met. Which of the lanes hold a ray is
/// said beside; the others hold nothing.
struct RayGroup {
    uint32_t depth = 0, flags = 0; ///< of all
    Ray ray[kPacketSize];
    Hit hit[kPacketSize]; ///< triangle is kNoHit where nothing was met
    RayCone cone[kPacketSize];
    float weight[kPacketSize];
    PixelSample* sample[kPacketSize];

    PathState path(int lane) const {
        return {sample[lane], depth, weight[lane], flags, cone[lane]};
    }
    void copyLane(int to, const RayGroup& from, int lane) {
        ray[to] = from.ray[lane];
        hit[to] = from.hit[lane];
        cone[to] = from.cone[lane];
        weight[to] = from.weight[lane];
        sample[to] = from.sample[lane];
    }
};

/// function(lane) for each of the lanes, from the lowest up.
template <class Function>
inline void forEach(uint32_t lanes, Function&& function) {
    for (; lanes != 0; lanes &= lanes - 1) function(int(std::countr_zero(lanes)));
}

} // namespace smart
