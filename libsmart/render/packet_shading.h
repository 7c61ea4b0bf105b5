// SPDX-License-Identifier: MIT
// The part of ShadingServices that deals with packets. Lane by lane it does what is done for a
// point. Included by shading_services.h.
#pragma once

#include <algorithm>
#include <bit>

#include "libsmart/render/shading_services.h"

namespace smart {

template <class Shading>
bool ShadingServices<Shading>::shadePacket(PointPacket& packet, const HitGroup& group) {
    RTSpacket& points = packet.points;
    const uint32_t lanes = points.active;
    RandomStream random[kPacketSize];
    uint32_t faults = 0;
    if (!group.rays->fresh)
        forEach(lanes, [&](int i) {
            random[i] = packet.sample[i]->random;
            faults |= packet.sample[i]->fault ? 1u << i : 0u;
        });
    if (Shading::template shadePacket<ShadingServices>(*packet.surface, points) != 0) {
        forEach(lanes, [&](int i) {
            PixelSample& sample = *packet.sample[i];
            if (group.rays->fresh)
                sample = PixelSample(sample.x, sample.y, sample.number, frame_.seed);
            else
                sample.random = random[i];
            sample.fault = (faults >> i & 1u) != 0;
        });
        return false;
    }
    const auto color = [&](int i) {
        group.colors[i] = {points.result[0].lane[i], points.result[1].lane[i],
                           points.result[2].lane[i], points.result[3].lane[i]};
    };
    if (lanes == (1u << kPacketSize) - 1u)
        for (int i = 0; i < kPacketSize; ++i) color(i);
    else
        forEach(lanes, color);
    return true;
}

template <class Shading>
void ShadingServices<Shading>::shadePoints(const HitGroup& group, uint32_t lanes) {
    const RayGroup& rays = *group.rays;
    forEach(lanes, [&](int i) {
        group.colors[i] = shadeHit(rays.ray(i), rays.hit(i), rays.path(i),
                                   group.found ? &group.found[i] : nullptr);
    });
}

// Which of a packet's points was to blame, if it fails, only their scalar form can tell.
template <class Shading>
void ShadingServices<Shading>::shadeLanes(const ShaderObject* surface, const HitGroup& group,
                                          uint32_t lanes) {
    if (surface && Shading::shadesPackets(*surface) && asPacket(lanes, group.rays->depth) &&
        shadePacket(
            packetAtHits(group, lanes, *surface, valuesFor(Shading::reads(*surface))), group))
        return;
    shadePoints(group, lanes);
}

template <class Shading>
void ShadingServices<Shading>::shadeGroup(const ShaderObject* surface, const HitGroup& group) {
    shadeGroups(surface, {&group, 1});
}

template <class Shading>
void ShadingServices<Shading>::shadeGroups(const ShaderObject* surface,
                                           std::span<const HitGroup> groups) {
    if (shading_.fixedFunction) {
        uint32_t fixed[kTilePackets] = {};
        for (std::size_t i = 0; i < groups.size(); ++i)
            fixed[i] = fixedLanes(surface, *groups[i].rays, groups[i].lanes);
        shadeFixed(groups, fixed);
        for (std::size_t i = 0; i < groups.size(); ++i)
            if (const uint32_t rest = groups[i].lanes & ~fixed[i])
                shadeLanes(surface, groups[i], rest);
        return;
    }
    const bool asPackets =
        groups.size() > 1 && surface && !shading_.transparent &&
        Shading::shadesPackets(*surface) && pool_->shadowGuess.expects(surface) &&
        std::ranges::all_of(groups, [&](const HitGroup& group) {
            return group.rays->depth == 0 && asPacket(group.lanes, 0);
        });
    if (!asPackets) {
        for (const HitGroup& group : groups) shadeLanes(surface, group, group.lanes);
        return;
    }
    const uint32_t reads = valuesFor(Shading::reads(*surface));
    PointPacket* packets[kTilePackets];
    for (std::size_t i = 0; i < groups.size(); ++i)
        packets[i] = &packetAtHits(groups[i], groups[i].lanes, *surface, reads, uint32_t(i));
    lookAhead({packets, groups.size()});
    pool_->shadowGuess.learn(surface, false);
    for (std::size_t i = 0; i < groups.size(); ++i)
        if (!shadePacket(*packets[i], groups[i])) shadePoints(groups[i], groups[i].lanes);
}

template <class Shading>
void ShadingServices<Shading>::shadeRays(const RayGroup& rays, uint32_t lanes,
                                         glm::vec4 (&colors)[kPacketSize]) {
    if (shading_.blended) {
        forEach(lanes, [&](int i) {
            colors[i] = shadeRay(rays.ray(i), rays.hit(i), rays.path(i), nullptr);
        });
        return;
    }
    uint32_t hits = 0;
    forEach(lanes, [&](int i) { hits |= rays.hasHit(i) ? 1u << i : 0u; });
    if (lanes != hits) shadeMisses(rays, lanes & ~hits, colors);
    const ShaderObject* surfaces[kPacketSize];
    findSurfaces(rays, hits, surfaces);
    while (hits != 0) {
        const ShaderObject* surface = surfaces[std::countr_zero(hits)];
        uint32_t group = 0;
        forEach(hits, [&](int i) {
            if (surfaces[i] == surface) group |= 1u << i;
        });
        shadeGroup(surface, {&rays, group, colors, nullptr});
        hits &= ~group;
    }
}

template <class Shading>
void ShadingServices<Shading>::attenuate(RayGroup& rays, uint32_t lanes,
                                         glm::vec3 (&products)[kPacketSize]) {
    Crossings crossings[kPacketSize];
    forEach(lanes, [&](int i) { products[i] = glm::vec3(1.0f); });
    for (int step = 0; step < kMaxTransparentHits && lanes != 0; ++step) {
        counters_.shadowRays += uint64_t(std::popcount(lanes));
        findHits(rays, lanes);
        forEach(lanes, [&](int i) {
            const Hit hit = rays.hit(i);
            if (hit.triangle != kNoHit && crossings[i].add(hit))
                products[i] *= transparency(rays.ray(i), hit, rays.path(i));
            if (hit.triangle == kNoHit || products[i] == glm::vec3(0.0f))
                lanes &= ~(1u << i);
            else
                rays.rays.tNear[i] = crossings[i].beyond(hit);
        });
    }
    forEach(lanes, [&](int i) { products[i] = glm::vec3(0.0f); });
}

template <class Shading>
RTuint ShadingServices<Shading>::packetTrace(RTSpacket* packet, RTuint lanes,
                                             const RTSvectors* origin,
                                             const RTSvectors* direction,
                                             const RTSfloats* weight, RTScolors* radiance) {
    PointPacket& from = packetOf(*packet);
    ShadingServices& self = static_cast<ShadingServices&>(*from.services);
    *radiance = {};
    if (packet->flags & RTS_STOPPED) return 0;
    LoneRayGroup rays;
    rays.depth = packet->depth + 1;
    rays.flags = packet->flags;
    uint32_t traced = 0;
    forEach(lanes & packet->active, [&](int i) {
        rays.weight[i] =
            self.shareOf(weight->lane[i], packet->weight.lane[i], packet->depth);
        if (!(rays.weight[i] < 0.0f)) traced |= 1u << i;
    });
    if (traced == 0) return 0;
    self.spawn(from, traced, *origin, *direction, rays);
    self.counters_.secondaryRays += uint64_t(std::popcount(traced));
    self.findHits(rays, traced);
    glm::vec4 colors[kPacketSize];
    self.shadeRays(rays, traced, colors);
    forEach(traced, [&](int i) {
        rays.sample[i]->fault |= !hasFiniteRadiance(colors[i]);
        radiance->r.lane[i] = colors[i].r;
        radiance->g.lane[i] = colors[i].g;
        radiance->b.lane[i] = colors[i].b;
    });
    return traced;
}

template <class Shading>
RTuint ShadingServices<Shading>::packetShadow(RTSpacket* packet, RTuint lanes,
                                              const RTSvectors* origin,
                                              const RTSvectors* direction,
                                              const RTSfloats* distance, RTScolors* attenuation) {
    PointPacket& from = packetOf(*packet);
    ShadingServices& self = static_cast<ShadingServices&>(*from.services);
    lanes &= packet->active;
    if (packet->flags & RTS_STOPPED) {
        *attenuation = {};
        return 0;
    }
    const uint32_t traced = lanesWhere([&](int i) { return distance->lane[i] > 0.0f; }) & lanes;
    const auto pass = [&](uint32_t open) {
        for (int i = 0; i < kPacketSize; ++i)
            attenuation->r.lane[i] = attenuation->g.lane[i] = attenuation->b.lane[i] =
                (open & openrt::detail::kLaneBit[i]) != 0 ? 1.0f : 0.0f;
    };
    if (traced == 0 || self.shading_.transparent) pass(lanes);
    if (traced == 0) return lanes;
    if (self.shading_.transparent) {
        LoneRayGroup rays;
        rays.depth = packet->depth + 1;
        rays.flags = packet->flags;
        self.spawn(from, traced, *origin, *direction, rays);
        glm::vec3 left[kPacketSize];
        forEach(traced, [&](int i) {
            rays.rays.tFar[i] = distance->lane[i] * kBeforeLight;
            rays.weight[i] = packet->weight.lane[i];
        });
        self.attenuate(rays, traced, left);
        forEach(traced, [&](int i) {
            attenuation->r.lane[i] = left[i].r;
            attenuation->g.lane[i] = left[i].g;
            attenuation->b.lane[i] = left[i].b;
        });
        return lanes;
    }
    self.counters_.shadowRays += uint64_t(std::popcount(traced));
    if (from.surface && packet->depth == 0) self.pool_->shadowGuess.learn(from.surface, true);
    uint32_t blocked = 0;
    if (!findAhead(from, traced, *origin, *direction, *distance, blocked)) {
        RayPacket rays;
        self.spawn(from, traced, *origin, *direction, rays);
        for (int i = 0; i < kPacketSize; ++i) rays.tFar[i] = distance->lane[i] * kBeforeLight;
        blocked = self.findOccluded(rays);
    }
    pass(lanes & ~blocked);
    return lanes;
}

} // namespace smart
