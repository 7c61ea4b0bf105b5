// SPDX-License-Identifier: MIT
// The part of RayServices that deals with packets. Lane by lane it does what is done for a point.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <optional>

#include "libsmart/render/ray_offset.h"
#include "libsmart/render/ray_services.h"

namespace smart {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

void setLane(RTSvectors& to, int lane, const float (&from)[3]) {
    to.x.lane[lane] = from[0];
    to.y.lane[lane] = from[1];
    to.z.lane[lane] = from[2];
}
template <int N>
void setLane(RTSfloats (&to)[N], int lane, const float (&from)[N]) {
    for (int k = 0; k < N; ++k) to[k].lane[lane] = from[k];
}
void getLane(const RTSvectors& from, int lane, float (&to)[3]) {
    to[0] = from.x.lane[lane];
    to[1] = from.y.lane[lane];
    to[2] = from.z.lane[lane];
}
template <int N>
void getLane(const RTSfloats (&from)[N], int lane, float (&to)[N]) {
    for (int k = 0; k < N; ++k) to[k] = from[k].lane[lane];
}

void setBit(RTuint& mask, int lane, bool value) {
    mask = (mask & ~(1u << lane)) | (RTuint(value) << lane);
}

void fillPacket(const RayGroup& rays, uint32_t lanes, RayPacket& packet) {
    forEach(lanes, [&](int i) {
        const Ray& ray = rays.ray[i];
        for (int k = 0; k < 3; ++k) {
            packet.org[k][i] = ray.org[k];
            packet.dir[k][i] = ray.dir[k];
        }
        packet.tNear[i] = ray.tNear;
        packet.tFar[i] = ray.tFar;
    });
    packet.active = lanes;
}

void takeHits(const HitPacket& found, uint32_t lanes, RayGroup& rays) {
    forEach(lanes, [&](int i) {
        Hit& hit = rays.hit[i];
        hit.triangle = found.triangle[i];
        if (hit.triangle == kNoHit) return;
        hit.t = found.t[i];
        hit.u = found.u[i];
        hit.v = found.v[i];
        hit.levels = found.levels[i];
        for (uint32_t level = 0; level < hit.levels; ++level)
            hit.path[level] = found.path[level][i];
    });
}

bool samePath(const Hit& a, const Hit& b) {
    return a.levels == b.levels && std::equal(a.path, a.path + a.levels, b.path);
}

} // namespace

void RayServices::findHits(RayGroup& rays, uint32_t lanes) const {
    if (std::has_single_bit(lanes)) {
        const int i = std::countr_zero(lanes);
        rays.hit[i] = findHit(rays.ray[i]);
        return;
    }
    RayPacket packet{};
    fillPacket(rays, lanes, packet);
    HitPacket found;
    kernels_.intersect[precision_](frame_.scene->view(), packet, found);
    takeHits(found, lanes, rays);
}

void RayServices::findTileHits(RayGroup* groups, const uint32_t* lanes) const {
    if (!frame_.scene->readyForTiles(kTilePackets * uint32_t(kPacketSize))) {
        for (uint32_t p = 0; p < kTilePackets; ++p)
            if (lanes[p]) findHits(groups[p], lanes[p]);
        return;
    }
    RayPacket packets[kTilePackets] = {};
    for (uint32_t p = 0; p < kTilePackets; ++p) fillPacket(groups[p], lanes[p], packets[p]);
    HitPacket found[kTilePackets];
    kernels_.intersectTile[precision_](frame_.scene->view(), packets, kTilePackets, found);
    for (uint32_t p = 0; p < kTilePackets; ++p) takeHits(found[p], lanes[p], groups[p]);
}

uint32_t RayServices::findOccluded(const RayGroup& rays, uint32_t lanes) const {
    if (std::has_single_bit(lanes))
        return isOccluded(rays.ray[std::countr_zero(lanes)]) ? lanes : 0;
    RayPacket packet{};
    fillPacket(rays, lanes, packet);
    uint32_t blocked = 0;
    if (frame_.scene->readyForTiles(0)) // for rays to a point light
        kernels_.occludedTile[precision_](frame_.scene->view(), &packet, 1, &blocked);
    else
        kernels_.occluded[precision_](frame_.scene->view(), packet, blocked);
    return blocked & lanes;
}

const ShaderObject* RayServices::findSurface(const Hit& hit) {
    if (recent_.levels != hit.levels ||
        !std::equal(hit.path, hit.path + hit.levels, recentPath_)) {
        recent_ = resolve(*frame_.scene, hit.path, hit.levels, hit.triangle);
        std::copy_n(hit.path, hit.levels, recentPath_);
    }
    recent_.triangle = hit.triangle;
    return findSurface(recent_);
}

PointPacket& RayServices::beginPacket(const RayGroup& rays, uint32_t lanes) {
    PointPacket& packet = pool_->at(rays.depth);
    packet.services = this;
    RTSpacket& points = packet.points;
    points.structSize = sizeof(RTSpacket);
    points.active = lanes;
    points.functions = &packetFunctions_;
    points.tracer = &packet;
    points.depth = rays.depth;
    points.flags = rays.flags;
    for (RTSfloats& channel : points.result) channel = {};
    std::fill_n(points.result[3].lane, kPacketSize, 1.0f);
    points.resultSet = 0;
    forEach(lanes, [&](int i) {
        PixelSample& sample = *rays.sample[i];
        packet.sample[i] = &sample;
        points.weight.lane[i] = rays.weight[i];
        points.pixel[0].lane[i] = sample.x;
        points.pixel[1].lane[i] = sample.y;
        points.sample.lane[i] = sample.number;
        points.triangleParam[i] = points.vertexParam[i] = nullptr;
    });
    return packet;
}

PointPacket& RayServices::packetAtHits(const RayGroup& rays, uint32_t lanes,
                                       const ShaderObject& surface) {
    PointPacket& packet = beginPacket(rays, lanes);
    packet.atSurface = true;
    RTSpacket& points = packet.points;
    const bool hasBlocks = surface.functions().triangleSize || surface.functions().vertexSize;
    RTSstate state;
    std::optional<SurfaceTriangle> triangle; // of the lane before: neighbours often share it
    const Hit* last = nullptr;
    forEach(lanes, [&](int i) {
        const Hit& hit = rays.hit[i];
        HitChain& chain = packet.chain[i];
        const bool sameWay = last && samePath(hit, *last);
        if (sameWay) {
            chain = triangle->chain();
            chain.triangle = hit.triangle;
        } else {
            chain = resolve(*frame_.scene, hit.path, hit.levels, hit.triangle);
        }
        if (!sameWay || hit.triangle != last->triangle) triangle.emplace(chain);
        last = &hit;
        packet.cone[i] = rays.cone[i].after(hit.t);
        packet.u[i] = hit.u;
        packet.v[i] = hit.v;
        packet.error[i] = -1.0f;
        fillSurfacePoint(*triangle, hit.path[0], rays.ray[i], hit.t, hit.u, hit.v, state);
        setLane(points.rayOrigin, i, state.rayOrigin);
        setLane(points.rayDirection, i, state.rayDirection);
        points.rayDistance.lane[i] = state.rayDistance;
        setLane(points.position, i, state.position);
        setLane(points.geometricNormal, i, state.geometricNormal);
        setLane(points.shadingNormal, i, state.shadingNormal);
        setLane(points.rawNormal, i, state.rawNormal);
        setLane(points.barycentric, i, state.barycentric);
        setLane(points.texCoord, i, state.texCoord);
        setLane(points.color, i, state.color);
        setBit(points.frontFace, i, state.frontFace != 0);
        points.object.lane[i] = state.object;
        points.instance.lane[i] = state.instance;
        points.primitive.lane[i] = state.primitive;
        points.footprint.lane[i] = packet.cone[i].width;
        points.texCoordDensity.lane[i] = state.texCoordDensity;
        if (hasBlocks) {
            fillParameterBlocks(chain, *frame_.shaders, surface, packet.scratch[i], state);
            points.triangleParam[i] = state.triangleParam;
            points.vertexParam[i] = state.vertexParam;
        }
    });
    return packet;
}

void RayServices::shadeMisses(const RayGroup& rays, uint32_t lanes,
                              glm::vec4 (&colors)[kPacketSize]) {
    const auto oneByOne = [&] {
        forEach(lanes, [&](int i) { colors[i] = shadeMiss(rays.ray[i], rays.path(i)); });
    };
    const ShaderObject* environment = frame_.environment.get();
    if (!environment || !environment->functions().shadePacket || !asPacket(lanes, rays.depth))
        return oneByOne();
    PointPacket& packet = beginPacket(rays, lanes);
    packet.atSurface = false;
    RTSpacket& points = packet.points;
    for (RTSvectors* vectors : {&points.position, &points.geometricNormal, &points.shadingNormal,
                                &points.rawNormal})
        *vectors = {};
    for (RTSfloats& floats : points.barycentric) floats = {};
    for (RTSfloats& floats : points.texCoord) floats = {};
    for (RTSfloats& floats : points.color) floats = {};
    points.frontFace = 0;
    points.texCoordDensity = {};
    PixelSample before[kPacketSize];
    forEach(lanes, [&](int i) {
        before[i] = *rays.sample[i];
        packet.cone[i] = rays.cone[i];
        setLane(points.rayOrigin, i, rays.ray[i].org);
        setLane(points.rayDirection, i, rays.ray[i].dir);
        points.rayDistance.lane[i] = kInfinity;
        points.object.lane[i] = points.instance.lane[i] = points.primitive.lane[i] = kNoId;
        points.footprint.lane[i] = rays.cone[i].spread;
    });
    if (environment->functions().shadePacket(environment->block(), &points) != 0) {
        forEach(lanes, [&](int i) { *rays.sample[i] = before[i]; });
        return oneByOne();
    }
    forEach(lanes, [&](int i) {
        colors[i] = {points.result[0].lane[i], points.result[1].lane[i],
                     points.result[2].lane[i], 1.0f};
    });
}

void RayServices::spawn(PointPacket& from, uint32_t lanes, const RTSvectors& origin,
                        const RTSvectors& direction, RayGroup& rays) {
    const RTSpacket& points = from.points;
    forEach(lanes, [&](int i) {
        float start[3], towards[3], position[3];
        getLane(origin, i, start);
        getLane(direction, i, towards);
        const glm::vec3 unit = unitDirection(towards);
        Ray& ray = rays.ray[i];
        std::copy_n(start, 3, ray.org);
        for (int k = 0; k < 3; ++k) ray.dir[k] = unit[k];
        ray.tNear = 0.0f;
        ray.tFar = kInfinity;
        rays.cone[i] = from.cone[i];
        rays.sample[i] = from.sample[i];
        getLane(points.position, i, position);
        if (!from.atSurface || !std::equal(start, start + 3, position)) return;
        float normal[3], incoming[3];
        getLane(points.geometricNormal, i, normal);
        getLane(points.rayDirection, i, incoming);
        if (from.error[i] < 0.0f)
            from.error[i] = surfaceError(from.chain[i], position, from.u[i], from.v[i]);
        const glm::vec3 moved = leaveSurface(position, normal, incoming, unit, from.error[i]);
        for (int k = 0; k < 3; ++k) ray.org[k] = moved[k];
    });
}

// The lane as a point by itself, for shaders that know no packets.
void RayServices::gatherState(PointPacket& packet, int lane, RTSstate& state,
                              RayStart& start) const {
    const RTSpacket& points = packet.points;
    start = {packet.services, packet.sample[lane], packet.cone[lane]};
    if (packet.atSurface) {
        start.chain = &packet.chain[lane];
        start.u = packet.u[lane];
        start.v = packet.v[lane];
        start.error = packet.error[lane];
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
    std::fill_n(found->distance.lane, kPacketSize, kInfinity);
    for (RTSids* ids : {&found->object, &found->instance, &found->primitive})
        std::fill_n(ids->lane, kPacketSize, kNoId);
    if (lanes == 0 || (packet->flags & RTS_STOPPED)) return 0;
    RayGroup rays;
    spawn(from, lanes, *origin, *direction, rays);
    self.counters_.secondaryRays += uint64_t(std::popcount(lanes));
    self.findHits(rays, lanes);
    RTSstate point;
    forEach(lanes, [&](int i) {
        const Hit& hit = rays.hit[i];
        if (hit.triangle == kNoHit) return;
        const HitChain chain = resolve(*self.frame_.scene, hit.path, hit.levels, hit.triangle);
        fillSurfacePoint(chain, hit.path[0], rays.ray[i], hit.t, hit.u, hit.v, point);
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
    *samples = {};
    if (light >= self.shading_.lights.size()) return 0;
    const LightPart& part = self.shading_.lights[light];
    const RTshaderclass& functions = part.light->functions();
    RTuint lit = 0;
    forEach(lanes & packet->active, [&](int i) {
        RTSlightsample sample = {};
        int answer = 0;
        if (functions.illuminateSample) {
            RTSstate state;
            RayStart start;
            self.gatherState(from, i, state, start);
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
    RayGroup rays;
    rays.depth = packet->depth + 1;
    rays.flags = packet->flags;
    forEach(lanes, [&](int i) {
        Ray& ray = rays.ray[i];
        ray = {};
        float towards[3];
        getLane(packet->position, i, ray.org);
        getLane(*direction, i, towards);
        const glm::vec3 unit = unitDirection(towards);
        for (int k = 0; k < 3; ++k) ray.dir[k] = unit[k];
        rays.cone[i] = from.cone[i];
        rays.weight[i] = packet->weight.lane[i];
        rays.sample[i] = from.sample[i];
    });
    glm::vec4 colors[kPacketSize];
    self.shadeMisses(rays, lanes, colors);
    forEach(lanes, [&](int i) {
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
