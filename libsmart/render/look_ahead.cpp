// SPDX-License-Identifier: MIT
// Shadow rays before a shader asks for them: to a point light they are one tile for the points of
// several packets, while each packet's shader would ask for its own only.
#include <algorithm>
#include <bit>

#include "libsmart/render/ray_services.h"

namespace smart {
namespace {

float dotOf(const RTSvectors& a, const RTSvectors& b, int lane) {
    return a.x.lane[lane] * b.x.lane[lane] + a.y.lane[lane] * b.y.lane[lane] +
           a.z.lane[lane] * b.z.lane[lane];
}

/// Points that show the light both their geometric and their shading normal's side. Shaders may
/// ask about others; those are traced when they do.
uint32_t facing(const RTSpacket& points, const RTSvectors& light) {
    return lanesWhere([&](int i) {
        const float incoming = dotOf(points.geometricNormal, points.rayDirection, i);
        const float geometric = dotOf(points.geometricNormal, light, i);
        const float turned = dotOf(points.shadingNormal, points.geometricNormal, i) *
                             dotOf(points.shadingNormal, light, i);
        // Of one sign: the light is on the side of both normals that the ray came from.
        return (incoming * geometric < 0.0f) & (turned * geometric > 0.0f);
    });
}

/// The bits in which numbers of the lanes differ: the same bits are the same number, and what
/// shaders hand back of what they were given has them.
struct Differences {
    uint32_t of[kPacketSize] = {};

    void add(const RTSfloats& a, const RTSfloats& b) {
        for (int i = 0; i < kPacketSize; ++i)
            of[i] |= std::bit_cast<uint32_t>(a.lane[i]) ^ std::bit_cast<uint32_t>(b.lane[i]);
    }
    void add(const RTSvectors& a, const RTSvectors& b) {
        add(a.x, b.x);
        add(a.y, b.y);
        add(a.z, b.z);
    }
    bool any(uint32_t lanes) const {
        return (lanes & ~lanesWhere([&](int i) { return of[i] == 0; })) != 0;
    }
};

} // namespace

void RayServices::lookAhead(std::span<PointPacket* const> packets) {
    const auto lights = uint32_t(std::min<std::size_t>(shading_.lights.size(), kLightsAhead));
    for (uint32_t light = 0; light < lights; ++light) {
        const LightPart& part = shading_.lights[light];
        if (!part.point) return;
        RayPacket rays[kTilePackets];
        for (std::size_t p = 0; p < packets.size(); ++p) {
            PointPacket& packet = *packets[p];
            const RTSpacket& points = packet.points;
            LightAhead& ahead = packet.ahead[light];
            ahead.lit = samplePointLight(*part.point, points.position, ahead.sample);
            ahead.traced = ahead.lit & points.active & facing(points, ahead.sample.direction);
            spawn(packet, ahead.traced, points.position, ahead.sample.direction, rays[p]);
            for (int i = 0; i < kPacketSize; ++i)
                rays[p].tFar[i] = ahead.sample.distance.lane[i] * kBeforeLight;
        }
        uint32_t blocked[kTilePackets] = {};
        findOccluded(rays, uint32_t(packets.size()), blocked);
        for (std::size_t p = 0; p < packets.size(); ++p) {
            packets[p]->ahead[light].blocked = blocked[p];
            packets[p]->lightsAhead = light + 1;
        }
    }
}

bool RayServices::findAhead(const PointPacket& from, uint32_t lanes, const RTSvectors& origin,
                            const RTSvectors& direction, const RTSfloats& distance,
                            uint32_t& blocked) {
    for (uint32_t light = 0; light < from.lightsAhead; ++light) {
        const LightAhead& ahead = from.ahead[light];
        if ((lanes & ~ahead.traced) != 0) continue;
        Differences differ;
        differ.add(origin, from.points.position);
        differ.add(distance, ahead.sample.distance);
        differ.add(direction, ahead.sample.direction);
        if (differ.any(lanes)) continue;
        blocked = ahead.blocked & lanes;
        return true;
    }
    return false;
}

uint32_t RayServices::samplePointLight(const builtin::PointLight& light,
                                       const RTSvectors& position, RTSlightpacket& samples) const {
    return math_.pointLight(&light.position.x, &light.radiance.r, position, samples);
}

} // namespace smart
