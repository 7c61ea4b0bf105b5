// SPDX-License-Identifier: MIT
// Fixed function for what neighbouring camera rays hit: their points are found sixteen at a time,
// and the shadow rays to a light are one tile for several packets. Lane by lane it does what
// FixedFunctionShader::shade does for a point.
#include <algorithm>
#include <bit>
#include <optional>

#include "libsmart/render/ray_services.h"

namespace smart {
namespace {

constexpr uint32_t kNothingHidden[kPacketSize] = {};

} // namespace

/// What is lit together, and by which lights.
struct RayServices::FixedPacket {
    const HitGroup* group;
    PointPacket* packet;
    uint32_t lights[kPacketSize] = {}; ///< by lane: those whose shadow rays matter
    uint32_t hidden[kPacketSize] = {}; ///< of those, by lane
};

uint32_t RayServices::lanesTogether(const HitGroup& group, uint32_t lanes, uint32_t& alone) const {
    const RayGroup& rays = *group.rays;
    alone = 0;
    if (rays.depth != 0) return 0;
    const bool wantsNormals = group.found && frame_.target.aux.normal;
    uint32_t together = 0;
    while (lanes != 0) {
        const uint32_t instance = rays.hits.path[0][std::countr_zero(lanes)];
        const uint32_t same =
            lanesWhere([&](int i) { return rays.hits.path[0][i] == instance; }) & lanes;
        lanes &= ~same;
        const FixedState& state = *stateOf(instance);
        if (!wantsNormals && fixed_.dependsOnHitAlone(state))
            alone |= same;
        else if (fixed_.dependsOnLight(state))
            together |= same;
    }
    return asPacket(together, 0) && !(rays.flags & RTS_STOPPED) ? together : 0;
}

void RayServices::shadeTriangles(const RayGroup& rays, uint32_t lanes,
                                 const uint32_t (&hidden)[kPacketSize],
                                 glm::vec4 (&colors)[kPacketSize]) {
    while (lanes != 0) {
        const uint32_t same = rays.sameTriangle(lanes);
        fixed_.shadeAlone(rays, same, hidden, colors);
        lanes &= ~same;
    }
}

void RayServices::shadeFixed(std::span<const HitGroup> groups, const uint32_t* lanes) {
    FixedPacket packets[kTilePackets];
    std::size_t count = 0;
    for (std::size_t g = 0; g < groups.size(); ++g) {
        const HitGroup& group = groups[g];
        if (lanes[g] == 0) continue;
        uint32_t alone = 0;
        const uint32_t together = lanesTogether(group, lanes[g], alone);
        shadeTriangles(*group.rays, alone, kNothingHidden, group.colors);
        if (group.found)
            forEach(alone, [&](int i) { describe(group.rays->hit(i), group.found[i]); });
        if (const uint32_t rest = lanes[g] & ~(alone | together)) shadeFixedPoints(group, rest);
        if (together == 0) continue;
        const ShaderObject& surface = *frame_.shaders->front();
        packets[count] = {&group, &packetAtHits(group, together, surface, RTS_READS_TRACE,
                                                  uint32_t(count))};
        ++count;
    }
    if (count != 0) shadeFixedPackets({packets, count});
}

void RayServices::shadeFixedPackets(std::span<FixedPacket> packets) {
    uint32_t lights = 0;
    for (FixedPacket& fixed : packets) {
        const RayGroup& rays = *fixed.group->rays;
        for (uint32_t rest = fixed.packet->points.active; rest != 0;) {
            const uint32_t same = rays.sameTriangle(rest);
            rest &= ~same;
            const FixedState& state = *stateOf(rays.hits.path[0][std::countr_zero(same)]);
            if (FixedFunctionShader::asksForShadows(state))
                fixed_.findLights(rays, same, fixed.lights);
        }
        for (const uint32_t ofLane : fixed.lights) lights |= ofLane;
    }
    if (shading_.transparent) {
        for (const FixedPacket& fixed : packets) shadeThroughOthers(fixed, lights);
        return;
    }
    forEach(lights, [&](int light) { findHidden(packets, light); });
    for (const FixedPacket& fixed : packets) {
        const RayGroup& rays = *fixed.group->rays;
        const RTSpacket& points = fixed.packet->points;
        shadeTriangles(rays, points.active, fixed.hidden, fixed.group->colors);
    }
}

uint32_t RayServices::aimAtLight(const FixedPacket& fixed, int light, RTSvectors& direction,
                                 RTSfloats& distance) const {
    const RTSpacket& points = fixed.packet->points;
    const RayGroup& rays = *fixed.group->rays;
    const uint32_t asking =
        lanesWhere([&](int i) { return (fixed.lights[i] >> light & 1u) != 0; }) & points.active;
    direction = {};
    distance = {};
    uint32_t instance = kNoId;
    std::optional<FixedFunctionShader::ToLight> way; // of the instance
    forEach(asking, [&](int i) {
        if (instance != rays.hits.path[0][i]) {
            instance = rays.hits.path[0][i];
            way.emplace(stateOf(instance)->lighting.lights[light]);
        }
        float towards[3];
        distance.lane[i] = way->from({points.position.x.lane[i], points.position.y.lane[i],
                                      points.position.z.lane[i]},
                                     towards);
        direction.x.lane[i] = towards[0];
        direction.y.lane[i] = towards[1];
        direction.z.lane[i] = towards[2];
    });
    return asking;
}

void RayServices::findHidden(std::span<FixedPacket> packets, int light) {
    RayPacket rays[kTilePackets] = {};
    for (std::size_t p = 0; p < packets.size(); ++p) {
        PointPacket& packet = *packets[p].packet;
        RTSvectors direction;
        RTSfloats distance;
        const uint32_t asking = aimAtLight(packets[p], light, direction, distance);
        const uint32_t traced = lanesWhere([&](int i) { return distance.lane[i] > 0.0f; }) & asking;
        spawn(packet, traced, packet.points.position, direction, rays[p]);
        for (int i = 0; i < kPacketSize; ++i) rays[p].tFar[i] = distance.lane[i] * kBeforeLight;
        counters_.shadowRays += uint64_t(std::popcount(traced));
    }
    uint32_t blocked[kTilePackets] = {};
    findOccluded(rays, uint32_t(packets.size()), blocked);
    for (std::size_t p = 0; p < packets.size(); ++p)
        forEach(blocked[p] & rays[p].active,
                [&](int i) { packets[p].hidden[i] |= 1u << light; });
}

// Some surfaces let light pass: every light may arrive in part.
void RayServices::shadeThroughOthers(const FixedPacket& fixed, uint32_t lights) {
    RTSpacket& points = fixed.packet->points;
    const RayGroup& rays = *fixed.group->rays;
    glm::vec3 shares[kPacketSize][kFixedLights];
    FixedArrival arrival[kPacketSize];
    for (auto& ofLane : shares) std::fill_n(ofLane, kFixedLights, glm::vec3(1.0f));
    forEach(lights, [&](int light) {
        RTSvectors direction;
        RTSfloats distance;
        RTScolors left;
        const uint32_t asking = aimAtLight(fixed, light, direction, distance);
        const uint32_t answered = packetFunctions_.shadow(&points, asking, &points.position,
                                                          &direction, &distance, &left);
        forEach(answered, [&](int i) {
            shares[i][light] = {left.r.lane[i], left.g.lane[i], left.b.lane[i]};
            arrival[i].add(light, shares[i]);
        });
    });
    forEach(points.active, [&](int i) {
        fixed.group->colors[i] = fixed_.shadeAlone(rays.ray(i), rays.hit(i), arrival[i]);
    });
}

} // namespace smart
