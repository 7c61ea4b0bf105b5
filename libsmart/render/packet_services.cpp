// SPDX-License-Identifier: MIT
// How RayServices fills packets of points. Lane by lane it does what is done for a point.
#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>
#include <vector>

#include "libsmart/render/point_lanes.h"
#include "libsmart/render/point_values.h"
#include "libsmart/render/ray_services.h"
#include "libsmart/shading/corner_attributes.h"

namespace smart {
namespace {

template <class Value>
VertexValues vertexValues(const std::vector<Value>& values, uint32_t first,
                          const glm::vec4& inherited) {
    const bool stored = !values.empty() && first != ShadingData::kNone;
    return {stored ? &values.front()[0] : nullptr, first, &inherited[0]};
}

SurfaceView surfaceView(const HitChain& chain, uint32_t instance) {
    const ShadingData& shading = chain.model->shading;
    const CornerAttributes attributes(chain);
    const glm::vec4& texCoord = attributes.inheritedValue(&InheritedAttributes::ownTexCoord,
                                                          &InheritedAttributes::texCoord);
    const glm::vec4& color = attributes.inheritedValue(&InheritedAttributes::ownColor,
                                                       &InheritedAttributes::color);
    return {chain.model->triangles.data(),
            &chain.toWorld[0][0],
            chain.levels == 1,
            vertexValues(shading.normals, shading.firstNormal, color),
            vertexValues(shading.texCoords, shading.firstTexCoord, texCoord),
            vertexValues(shading.colors, shading.firstColor, color),
            chain.instances[chain.levels - 1]->objectId,
            instance};
}

} // namespace

void RayServices::findHits(RayGroup& rays, uint32_t lanes) const {
    if (std::has_single_bit(lanes)) {
        const int i = std::countr_zero(lanes);
        rays.setHit(i, findHit(rays.ray(i)));
        return;
    }
    rays.rays.active = lanes;
    kernels_.intersect[precision_](frame_.scene->view(), rays.rays, rays.hits);
}

void RayServices::findTileHits(RayBlock& block, const uint32_t* lanes) const {
    for (uint32_t p = 0; p < kTilePackets; ++p) block.rays[p].active = lanes[p];
    kernels_.intersectTile[precision_](frame_.scene->view(), block.rays, kTilePackets, block.hits);
}

uint32_t RayServices::findOccluded(const RayPacket& rays) const {
    if (rays.active == 0) return 0;
    if (std::has_single_bit(rays.active)) {
        const int i = std::countr_zero(rays.active);
        const Ray ray{{rays.org[0][i], rays.org[1][i], rays.org[2][i]},
                      {rays.dir[0][i], rays.dir[1][i], rays.dir[2][i]},
                      rays.tNear[i],
                      rays.tFar[i]};
        return isOccluded(ray) ? rays.active : 0;
    }
    uint32_t blocked = 0;
    // They may go to a point light.
    kernels_.occludedTile[precision_](frame_.scene->view(), &rays, 1, &blocked);
    return blocked & rays.active;
}

void RayServices::findOccluded(const RayPacket* rays, uint32_t count, uint32_t* blocked) const {
    if (count > 1)
        kernels_.occludedTile[precision_](frame_.scene->view(), rays, count, blocked);
    else if (count == 1)
        blocked[0] = findOccluded(rays[0]);
}

const HitChain& RayServices::chainTo(const Hit& hit) {
    if (recent_.levels != hit.levels ||
        !std::equal(hit.path, hit.path + hit.levels, recentPath_)) {
        recent_ = resolve(*frame_.scene, hit.path, hit.levels, hit.triangle);
        std::copy_n(hit.path, hit.levels, recentPath_);
    }
    recent_.triangle = hit.triangle;
    return recent_;
}

const ShaderObject* RayServices::findSurface(const Hit& hit) { return findSurface(chainTo(hit)); }

void RayServices::findSurfaces(const RayGroup& rays, uint32_t lanes,
                               const ShaderObject* (&surfaces)[kPacketSize]) {
    while (lanes != 0) {
        const uint32_t same = rays.sameWay(lanes);
        HitChain chain = chainTo(rays.hit(std::countr_zero(same)));
        const ShaderObject* surface = findSurface(chain);
        const std::vector<uint32_t>& slots = chain.model->shading.slots;
        uint32_t slot = slots.empty() ? 0 : slots[chain.triangle];
        forEach(same, [&](int i) {
            const uint32_t triangle = rays.hits.triangle[i];
            if (!slots.empty() && slots[triangle] != slot) {
                slot = slots[triangle];
                chain.triangle = triangle;
                surface = findSurface(chain);
            }
            surfaces[i] = surface;
        });
        lanes &= ~same;
    }
}

uint32_t RayServices::fillPoints(const RayGroup& rays, uint32_t lanes, const HitChain& way,
                                 uint32_t instance, uint32_t reads, RTSpacket& points,
                                 float* error) const {
    if (reads == 0) return 0;
    const SurfaceView view = surfaceView(way, instance);
    VertexLanes vertices;
    if (view.asksVertices(reads)) {
        const int some = std::countr_zero(lanes);
        for (int i = 0; i < kPacketSize; ++i) {
            const int lane = (lanes >> i & 1u) != 0 ? i : some;
            const auto corners = way.model->shading.corners[rays.hits.triangle[lane]];
            for (std::size_t k = 0; k < 3; ++k) vertices[k][i] = corners[k];
        }
    }
    return math_.surfacePoints(view, vertices, rays.rays, rays.hits, lanes, reads, points, error);
}

bool RayServices::findSurface(const RayGroup& rays, uint32_t lanes,
                              const ShaderObject*& surface) {
    if (rays.sameWay(lanes) == lanes) {
        const HitChain& chain = chainTo(rays.hit(std::countr_zero(lanes)));
        if (chain.model->shading.slots.empty()) {
            surface = findSurface(chain);
            return true;
        }
    }
    const ShaderObject* surfaces[kPacketSize];
    findSurfaces(rays, lanes, surfaces);
    surface = surfaces[std::countr_zero(lanes)];
    bool same = true;
    forEach(lanes, [&](int i) { same &= surfaces[i] == surface; });
    return same;
}

PointPacket& RayServices::beginPacket(const RayGroup& rays, uint32_t lanes, uint32_t reads,
                                      uint32_t number) {
    PointPacket& packet = pool_->at(rays.depth, number);
    packet.services = this;
    packet.surface = nullptr;
    packet.errorsMissing = 0;
    packet.lightsAhead = 0;
    RTSpacket& points = packet.points;
    points.structSize = sizeof(RTSpacket);
    points.active = lanes;
    points.functions = &packetFunctions_;
    points.tracer = &packet;
    points.depth = rays.depth;
    points.flags = rays.flags;
    for (int k = 0; k < 3; ++k) points.result[k] = {};
    std::fill_n(points.result[3].lane, kPacketSize, 1.0f);
    points.resultSet = 0;
    std::memcpy(points.weight.lane, rays.weight, sizeof rays.weight);
    if (packet.hasBlocks) {
        std::fill_n(points.triangleParam, kPacketSize, nullptr);
        std::fill_n(points.vertexParam, kPacketSize, nullptr);
        packet.hasBlocks = false;
    }
    forEach(lanes, [&](int i) { packet.sample[i] = rays.sample[i]; });
    if (reads & RTS_READS_PIXEL)
        forEach(lanes, [&](int i) {
            const PixelSample& sample = *rays.sample[i];
            points.pixel[0].lane[i] = sample.x;
            points.pixel[1].lane[i] = sample.y;
            points.sample.lane[i] = sample.number;
        });
    return packet;
}

void RayServices::fillLanes(const RayGroup& rays, uint32_t lanes, uint32_t reads,
                            PointPacket& packet) const {
    RTSstate state;
    RTSpacket part;
    forEach(lanes, [&](int i) {
        const HitChain chain = packet.chain(i);
        const Hit hit = rays.hit(i);
        packet.error[i] = -1.0f;
        fillSurfacePoint(chain, hit.path[0], rays.ray(i), hit.t, hit.u, hit.v, state);
        setLane(part.rayOrigin, i, state.rayOrigin);
        setLane(part.rayDirection, i, state.rayDirection);
        part.rayDistance.lane[i] = state.rayDistance;
        setLane(part.position, i, state.position);
        setLane(part.geometricNormal, i, state.geometricNormal);
        setLane(part.shadingNormal, i, state.shadingNormal);
        setLane(part.rawNormal, i, state.rawNormal);
        setLane(part.barycentric, i, state.barycentric);
        setLane(part.texCoord, i, state.texCoord);
        setLane(part.color, i, state.color);
        part.frontFace = state.frontFace ? 1u << i : 0u;
        part.object.lane[i] = state.object;
        part.instance.lane[i] = state.instance;
        part.primitive.lane[i] = state.primitive;
        part.footprint.lane[i] = packet.coneWidth[i];
        part.texCoordDensity.lane[i] = state.texCoordDensity;
        copyValues(part, i, reads & ~RTS_READS_PIXEL, packet.points);
    });
    packet.errorsMissing |= lanes;
}

void RayServices::fillBlocks(uint32_t lanes, PointPacket& packet) const {
    RTSpacket& points = packet.points;
    packet.hasBlocks = true;
    RTSstate state;
    forEach(lanes, [&](int i) {
        getLane(points.barycentric, i, state.barycentric);
        fillParameterBlocks(packet.chain(i), *frame_.shaders, *packet.surface, packet.scratch[i],
                            state);
        points.triangleParam[i] = state.triangleParam;
        points.vertexParam[i] = state.vertexParam;
    });
}

PointPacket& RayServices::packetAtHits(const HitGroup& group, uint32_t lanes,
                                       const ShaderObject& surface, uint32_t reads,
                                       uint32_t number) {
    constexpr int kLeastTogether = 3; // fewer are filled one by one
    const RTshaderclass& functions = surface.functions();
    const RayGroup& rays = *group.rays;
    uint32_t needed = reads;
    if (functions.vertexSize) needed |= RTS_READS_BARYCENTRIC;
    if (group.found) needed |= RTS_READS_SHADING_NORMAL | RTS_READS_IDS;
    needed = filledFor(needed);
    PointPacket& packet = beginPacket(rays, lanes, needed, number);
    packet.surface = &surface;
    RTSpacket& points = packet.points;
    std::memcpy(packet.triangle, rays.hits.triangle, sizeof packet.triangle);
    std::memcpy(packet.u, rays.hits.u, sizeof packet.u);
    std::memcpy(packet.v, rays.hits.v, sizeof packet.v);
    std::memcpy(packet.coneSpread, rays.coneSpread, sizeof packet.coneSpread);
    if (cones_)
        for (int i = 0; i < kPacketSize; ++i)
            packet.coneWidth[i] = rays.coneWidth[i] + rays.coneSpread[i] * rays.hits.t[i];
    else
        std::memcpy(packet.coneWidth, rays.coneWidth, sizeof packet.coneWidth);
    if (needed & RTS_READS_FOOTPRINT)
        std::memcpy(points.footprint.lane, packet.coneWidth, sizeof packet.coneWidth);
    uint32_t single = 0;
    uint8_t ways = 0;
    for (uint32_t rest = lanes; rest != 0; ++ways) {
        const uint32_t same = rays.sameWay(rest);
        const Hit first = rays.hit(std::countr_zero(same));
        const HitChain& way = packet.ways[ways] = chainTo(first);
        forEach(same, [&](int i) { packet.wayOf[i] = ways; });
        if (way.levels > 1) packet.errorsMissing |= same;
        if (same == lanes) {
            single = fillPoints(rays, same, way, first.path[0], needed, points, packet.error);
        } else if (std::popcount(same) < kLeastTogether) {
            single |= same;
        } else {
            RTSpacket part;
            float error[kPacketSize];
            single |= fillPoints(rays, same, way, first.path[0], needed, part, error);
            forEach(same, [&](int i) {
                copyValues(part, i, needed & ~(RTS_READS_PIXEL | RTS_READS_FOOTPRINT), points);
                if (needed & RTS_READS_FOOTPRINT)
                    points.texCoordDensity.lane[i] = part.texCoordDensity.lane[i];
                packet.error[i] = error[i];
            });
        }
        rest &= ~same;
    }
    if ((reads & RTS_READS_TRACE) != RTS_READS_TRACE) packet.errorsMissing = lanes;
    if (single != 0) fillLanes(rays, single, needed, packet);
    if (functions.triangleSize || functions.vertexSize) fillBlocks(lanes, packet);
    if (group.found)
        forEach(lanes, [&](int i) { group.found[i].describe(rays.hits.t[i], points, i); });
    clearValues(points, (packet.filled | needed) & ~reads);
    packet.filled = reads;
    return packet;
}

void RayServices::shadeMisses(const RayGroup& rays, uint32_t lanes,
                              glm::vec4 (&colors)[kPacketSize]) {
    const ShaderObject* environment = frame_.environment.get();
    if (!environment) {
        forEach(lanes, [&](int i) { colors[i] = frame_.clearColor; });
        return;
    }
    const auto oneByOne = [&] {
        forEach(lanes, [&](int i) { colors[i] = shadeMiss(rays.ray(i), rays.path(i)); });
    };
    if (!environment->functions().shadePacket || !asPacket(lanes, rays.depth)) return oneByOne();
    PointPacket& packet = beginPacket(rays, lanes, RTS_READS_EVERYTHING);
    packet.filled = RTS_READS_EVERYTHING;
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
        const Ray ray = rays.ray(i);
        before[i] = *rays.sample[i];
        packet.coneWidth[i] = rays.coneWidth[i];
        packet.coneSpread[i] = rays.coneSpread[i];
        setLane(points.rayOrigin, i, ray.org);
        setLane(points.rayDirection, i, ray.dir);
        points.rayDistance.lane[i] = std::numeric_limits<float>::infinity();
        points.object.lane[i] = points.instance.lane[i] = points.primitive.lane[i] = kNoId;
        points.footprint.lane[i] = rays.coneSpread[i];
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

} // namespace smart
