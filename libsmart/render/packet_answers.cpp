// SPDX-License-Identifier: MIT
// What RayServices answers to packet shaders. Lane by lane it does what is done for a point.
#include <algorithm>
#include <bit>
#include <limits>

#include "libsmart/render/point_lanes.h"
#include "libsmart/render/ray_offset.h"
#include "libsmart/render/ray_services.h"

namespace smart {

void RayServices::spawn(PointPacket& from, uint32_t lanes, const RTSvectors& origin,
                        const RTSvectors& direction, RayPacket& rays) const {
    forEach(lanes & from.errorsMissing, [&](int i) {
        float position[3];
        getLane(from.points.position, i, position);
        from.error[i] = surfaceError(from.chain(i), position, from.u[i], from.v[i]);
    });
    from.errorsMissing &= ~lanes;
    math_.spawn(from.points, from.atSurface() ? from.error : nullptr, origin, direction, rays);
    rays.active = lanes;
}

void RayServices::spawn(PointPacket& from, uint32_t lanes, const RTSvectors& origin,
                        const RTSvectors& direction, RayGroup& rays) const {
    spawn(from, lanes, origin, direction, rays.rays);
    std::copy_n(from.coneWidth, kPacketSize, rays.coneWidth);
    std::copy_n(from.coneSpread, kPacketSize, rays.coneSpread);
    forEach(lanes, [&](int i) { rays.sample[i] = from.sample[i]; });
}

// The lane as a point by itself, for shaders that know no packets.
void RayServices::gatherState(PointPacket& packet, int lane, RTSstate& state, RayStart& start,
                              HitChain& chain) const {
    const RTSpacket& points = packet.points;
    start = {packet.services, packet.sample[lane], packet.cone(lane)};
    if (packet.atSurface()) {
        chain = packet.chain(lane);
        start.chain = &chain;
        start.u = packet.u[lane];
        start.v = packet.v[lane];
        start.error = packet.errorsMissing >> lane & 1u ? -1.0f : packet.error[lane];
    }
    state = {};
    state.functions = &functions_;
    state.tracer = &start;
    getLane(points.rayOrigin, lane, state.rayOrigin);
    getLane(points.rayDirection, lane, state.rayDirection);
    state.rayDistance = points.rayDistance.lane[lane];
    getLane(points.position, lane, state.position);
    getLane(points.geometricNormal, lane, state.geometricNormal);
    getLane(points.shadingNormal, lane, state.shadingNormal);
    getLane(points.rawNormal, lane, state.rawNormal);
    getLane(points.barycentric, lane, state.barycentric);
    getLane(points.texCoord, lane, state.texCoord);
    getLane(points.color, lane, state.color);
    state.frontFace = points.frontFace >> lane & 1u;
    state.object = points.object.lane[lane];
    state.instance = points.instance.lane[lane];
    state.primitive = points.primitive.lane[lane];
    state.depth = points.depth;
    state.weight = points.weight.lane[lane];
    state.triangleParam = points.triangleParam[lane];
    state.vertexParam = points.vertexParam[lane];
    state.pixel[0] = points.pixel[0].lane[lane];
    state.pixel[1] = points.pixel[1].lane[lane];
    state.sample = points.sample.lane[lane];
    getLane(points.result, lane, state.result);
    state.flags = points.flags;
    state.footprint = points.footprint.lane[lane];
    state.texCoordDensity = points.texCoordDensity.lane[lane];
}

RTuint RayServices::packetTraceHit(RTSpacket* packet, RTuint lanes, const RTSvectors* origin,
                                   const RTSvectors* direction, RTShitpacket* found) {
    PointPacket& from = packetOf(*packet);
    RayServices& self = *from.services;
    lanes &= packet->active;
    *found = {};
    std::fill_n(found->distance.lane, kPacketSize, std::numeric_limits<float>::infinity());
    for (RTSids* ids : {&found->object, &found->instance, &found->primitive})
        std::fill_n(ids->lane, kPacketSize, kNoId);
    if (lanes == 0 || (packet->flags & RTS_STOPPED)) return 0;
    LoneRayGroup rays;
    self.spawn(from, lanes, *origin, *direction, rays);
    self.counters_.secondaryRays += uint64_t(std::popcount(lanes));
    self.findHits(rays, lanes);
    RTSstate point;
    forEach(lanes, [&](int i) {
        const Hit hit = rays.hit(i);
        if (hit.triangle == kNoHit) return;
        const HitChain chain = resolve(*self.frame_.scene, hit.path, hit.levels, hit.triangle);
        fillSurfacePoint(chain, hit.path[0], rays.ray(i), hit.t, hit.u, hit.v, point);
        found->distance.lane[i] = hit.t;
        setLane(found->position, i, point.position);
        setLane(found->normal, i, point.geometricNormal);
        found->object.lane[i] = point.object;
        found->instance.lane[i] = point.instance;
        found->primitive.lane[i] = point.primitive;
    });
    return lanes;
}

RTuint RayServices::packetLightCount(const RTSpacket* packet) {
    return RTuint(packetOf(*packet).services->shading_.lights.size());
}

RTuint RayServices::packetIlluminate(RTSpacket* packet, RTuint lanes, RTuint light,
                                     RTSlightpacket* samples) {
    PointPacket& from = packetOf(*packet);
    const RayServices& self = *from.services;
    if (light >= self.shading_.lights.size()) return 0;
    lanes &= packet->active;
    if (light < from.lightsAhead) {
        *samples = from.ahead[light].sample;
        return from.ahead[light].lit & lanes;
    }
    const LightPart& part = self.shading_.lights[light];
    if (part.point) return self.samplePointLight(*part.point, packet->position, *samples) & lanes;
    const RTshaderclass& functions = part.light->functions();
    RTuint lit = 0;
    *samples = {};
    forEach(lanes, [&](int i) {
        RTSlightsample sample = {};
        int answer = 0;
        if (functions.illuminateSample) {
            RTSstate state;
            RayStart start;
            HitChain chain;
            self.gatherState(from, i, state, start, chain);
            start.asksLight = true;
            answer = functions.illuminateSample(part.light->block(), &state, part.sample,
                                                part.samples, &sample);
        } else {
            float position[3];
            getLane(packet->position, i, position);
            answer = functions.illuminate(part.light->block(), position, &sample);
        }
        if (!finishLight(part, answer, *from.sample[i], sample)) return;
        lit |= 1u << i;
        setLane(samples->direction, i, sample.direction);
        samples->distance.lane[i] = sample.distance;
        samples->radiance.r.lane[i] = sample.radiance[0];
        samples->radiance.g.lane[i] = sample.radiance[1];
        samples->radiance.b.lane[i] = sample.radiance[2];
    });
    return lit;
}

void RayServices::packetTexture(RTSpacket* packet, RTuint lanes, RTuint texture,
                                const RTSfloats* s, const RTSfloats* t, RTSfloats rgba[4]) {
    const Frame& frame = packetOf(*packet).services->frame_;
    const Texture* image = nullptr;
    if (frame.textures && texture < frame.textures->size())
        image = (*frame.textures)[texture].get();
    forEach(lanes & packet->active, [&](int i) {
        glm::vec4 texel(1.0f);
        if (image) {
            float normal[3], direction[3];
            getLane(packet->geometricNormal, i, normal);
            getLane(packet->rayDirection, i, direction);
            const float footprint = textureFootprint(
                packet->footprint.lane[i], packet->texCoordDensity.lane[i],
                {normal[0], normal[1], normal[2]}, {direction[0], direction[1], direction[2]});
            texel = image->sample(s->lane[i], t->lane[i], footprint);
        }
        for (int k = 0; k < 4; ++k) rgba[k].lane[i] = texel[k];
    });
}

void RayServices::packetEnvironment(RTSpacket* packet, RTuint lanes, const RTSvectors* direction,
                                    RTScolors* radiance) {
    PointPacket& from = packetOf(*packet);
    RayServices& self = *from.services;
    lanes &= packet->active;
    *radiance = {};
    // Environment shaders that ask the environment would go on for ever.
    if (lanes == 0 || packet->depth > self.recursionLimit_) return;
    LoneRayGroup rays;
    rays.depth = packet->depth + 1;
    rays.flags = packet->flags;
    forEach(lanes, [&](int i) {
        Ray ray{};
        float towards[3];
        getLane(packet->position, i, ray.org);
        getLane(*direction, i, towards);
        const glm::vec3 unit = unitDirection(towards);
        for (int k = 0; k < 3; ++k) ray.dir[k] = unit[k];
        rays.setRay(i, ray);
        rays.setCone(i, from.cone(i));
        rays.weight[i] = packet->weight.lane[i];
        rays.sample[i] = from.sample[i];
    });
    glm::vec4 colors[kPacketSize];
    self.shadeMisses(rays, lanes, colors);
    forEach(lanes, [&](int i) {
        rays.sample[i]->fault |= !hasFiniteRadiance(colors[i]);
        radiance->r.lane[i] = colors[i].r;
        radiance->g.lane[i] = colors[i].g;
        radiance->b.lane[i] = colors[i].b;
    });
}

void RayServices::packetRandom(RTSpacket* packet, RTuint lanes, RTSfloats* numbers) {
    const PointPacket& from = packetOf(*packet);
    forEach(lanes & packet->active,
            [&](int i) { numbers->lane[i] = from.sample[i]->random.next(); });
}

} // namespace smart
