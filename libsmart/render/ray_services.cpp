// SPDX-License-Identifier: MIT
#include "libsmart/render/ray_services.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "libsmart/render/ray_offset.h"

namespace smart {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

template <class Vector>
void copy(float (&to)[3], const Vector& from) {
    for (int k = 0; k < 3; ++k) to[k] = from[k];
}

} // namespace

glm::vec3 unitDirection(const float direction[3]) {
    const Real3 unit = unitOf({direction[0], direction[1], direction[2]});
    return glm::vec3(float(unit.x), float(unit.y), float(unit.z));
}

RayServices::RayServices(const Frame& frame, TilePixels& counters, ShadingForm form,
                         const RTSfunctions& functions, const RTSpacketfunctions& packetFunctions)
    : frame_(frame),
      shading_(frame.shading()),
      counters_(counters),
      fixed_(frame),
      kernels_(kernels()),
      math_(packetMathOf(kernels_)),
      precision_(std::size_t(frame.scene->precision())),
      recursionLimit_(std::min(frame.recursionLimit, kMaxRecursion)),
      cones_(shading_.readsFootprints || frame.environment || frame.renderingObject ||
             frame.camera),
      functions_(functions),
      packetFunctions_(packetFunctions),
      form_(form) {
    recent_.levels = 0;
}

void RayServices::beginState(const Ray& ray, const PathState& path, PointState& point) {
    point.start = {this, path.sample, path.cone};
    RTSstate& state = point.state;
    state = {};
    state.functions = &functions_;
    state.tracer = &point.start;
    copy(state.rayOrigin, ray.org);
    copy(state.rayDirection, ray.dir);
    state.rayDistance = kInfinity;
    state.object = state.instance = state.primitive = kNoId;
    state.depth = path.depth;
    state.weight = path.weight;
    state.pixel[0] = path.sample->x;
    state.pixel[1] = path.sample->y;
    state.sample = path.sample->number;
    state.result[3] = 1.0f;
    state.flags = path.flags;
    state.footprint = path.cone.spread;
}

void RayServices::atNoSurface(PixelSample& sample, PointState& point) {
    beginState({{0, 0, 0}, {0, 0, 0}, 0.0f, kInfinity}, {&sample}, point);
}

void RayServices::atHit(const Ray& ray, const Hit& hit, const PathState& path, PointState& point) {
    point.chain = resolve(*frame_.scene, hit.path, hit.levels, hit.triangle);
    SurfaceTriangle triangle(point.chain);
    placeAt(ray, hit, path, triangle, point);
}

void RayServices::placeAt(const Ray& ray, const Hit& hit, const PathState& path,
                          SurfaceTriangle& triangle, PointState& point) {
    beginState(ray, path, point);
    point.start.cone = path.cone.after(hit.t);
    point.start.chain = &point.chain;
    point.start.u = hit.u;
    point.start.v = hit.v;
    point.state.footprint = point.start.cone.width;
    fillSurfacePoint(triangle, hit.path[0], ray, hit.t, hit.u, hit.v, point.state);
}

bool RayServices::makeCameraRay(const CameraRays& camera, double x, double y, PixelSample& sample,
                                Ray& ray, RayCone& cone) {
    PointState nowhere;
    CameraSample given;
    if (frame_.camera) {
        atNoSurface(sample, nowhere);
        given = {&nowhere.state, &sample};
    }
    if (!camera.make(x, y, ray, given)) return false;
    cone = camera.cone(x, y, ray, given);
    return true;
}

uint32_t RayServices::makeCameraRays(const CameraRays& camera, const double (&x)[kPacketSize],
                                     const double (&y)[kPacketSize], uint32_t lanes,
                                     RayGroup& rays) {
    if (!frame_.camera) return camera.makePacket(math_, x, y, cones_, rays) & lanes;
    uint32_t made = 0;
    forEach(lanes, [&](int i) {
        Ray ray;
        RayCone cone;
        if (!makeCameraRay(camera, x[i], y[i], *rays.sample[i], ray, cone)) return;
        rays.setRay(i, ray);
        rays.setCone(i, cone);
        made |= 1u << i;
    });
    return made;
}

void RayServices::findColumns(const CameraRays& camera, const double* x, uint32_t packets,
                              LensLanes* columns) const {
    math_.lensColumns(camera.lens(), x, packets, columns);
}

void RayServices::findRows(const CameraRays& camera, const double* y, uint32_t packets,
                           LensLanes* rows) const {
    math_.lensRows(camera.lens(), y, packets, rows);
}

uint32_t RayServices::makeCameraRays(const CameraRays& camera, const LensLanes& columns,
                                     const LensLanes& rows, RayGroup& rays) const {
    return camera.makePacket(math_, columns, rows, cones_, rays);
}

bool RayServices::visit(const Ray& ray, const PathState& path, PointState& point,
                        ShadedSample& found) {
    ++counters_.primaryRays;
    const Hit hit = findHit(ray);
    if (hit.triangle == kNoHit) return false;
    atHit(ray, hit, path, point);
    found.describe(hit, point.state);
    const ShaderObject* shader = findSurface(point.chain);
    if (shader)
        fillParameterBlocks(point.chain, *frame_.shaders, *shader, point.scratch, point.state);
    return true;
}

float RayServices::shareOf(float weight, float ofPoint, uint32_t depth) const {
    if (depth >= recursionLimit_ || std::isnan(weight)) return -1.0f;
    const float share = weight < ofPoint ? weight : ofPoint;
    return share < frame_.weightCutoff ? -1.0f : share;
}

Ray RayServices::spawn(const RTSstate& state, const float origin[3], const float direction[3]) {
    RayStart& from = startOf(state);
    const glm::vec3 towards = unitDirection(direction);
    glm::vec3 start(origin[0], origin[1], origin[2]);
    if (from.chain && std::equal(origin, origin + 3, state.position)) {
        if (from.error < 0.0f)
            from.error = surfaceError(*from.chain, state.position, from.u, from.v);
        start = leaveSurface(state.position, state.geometricNormal, state.rayDirection, towards,
                             from.error);
    }
    Ray ray{};
    copy(ray.org, start);
    copy(ray.dir, towards);
    ray.tFar = kInfinity;
    return ray;
}

PathState RayServices::onward(const RTSstate& state, float weight) {
    const RayStart& from = startOf(state);
    return {from.sample, state.depth + 1, weight, state.flags, from.cone};
}

Hit RayServices::findHit(const Ray& ray) const {
    Hit hit;
    kernels_.intersect1[precision_](frame_.scene->view(), ray, hit);
    return hit;
}

void RayServices::findAllHits(const RayPacket& rays, AllHits& found) const {
    found.find(kernels_.intersectAll[precision_], frame_.scene->view(), rays);
}

bool RayServices::isOccluded(const Ray& ray) const {
    return kernels_.occluded1[precision_](frame_.scene->view(), ray);
}

const ShaderObject* RayServices::findSurface(const HitChain& chain) const {
    const uint32_t index = effectiveShader(chain);
    if (index >= frame_.shaders->size()) return nullptr;
    const ShaderObject* shader = (*frame_.shaders)[index].get();
    return shader && shader->shaderClass().kind() == RT_SURFACE_SHADER ? shader : nullptr;
}

glm::vec4 RayServices::shadeMiss(const Ray& ray, const PathState& path) {
    if (!frame_.environment) return frame_.clearColor;
    PointState point;
    beginState(ray, path, point);
    const ShaderObject& shader = *frame_.environment;
    const RTSstate& state = point.state;
    if (shader.functions().shade(shader.block(), &point.state) != 0) {
        path.sample->fault = true;
        return {0.0f, 0.0f, 0.0f, 1.0f};
    }
    return {state.result[0], state.result[1], state.result[2], 1.0f};
}

// Shades nothing, so that it can not go on for ever: the recursion limit does not stop it.
int RayServices::traceHit(RTSstate* state, const float origin[3], const float direction[3],
                          RTShitinfo* found) {
    const RayStart& from = startOf(*state);
    RayServices& self = *from.services;
    *found = {kInfinity, {0, 0, 0}, {0, 0, 0}, kNoId, kNoId, kNoId};
    if (!mayTrace(*state)) return 0;
    const Ray ray = spawn(*state, origin, direction);
    ++self.counters_.secondaryRays;
    const Hit hit = self.findHit(ray);
    if (hit.triangle == kNoHit) return 1;
    const HitChain chain = resolve(*self.frame_.scene, hit.path, hit.levels, hit.triangle);
    RTSstate point{};
    fillSurfacePoint(chain, hit.path[0], ray, hit.t, hit.u, hit.v, point);
    found->distance = hit.t;
    copy(found->position, point.position);
    copy(found->normal, point.geometricNormal);
    found->object = point.object;
    found->instance = point.instance;
    found->primitive = point.primitive;
    return 1;
}

RTuint RayServices::lightCount(const RTSstate* state) {
    return RTuint(startOf(*state).services->shading_.lights.size());
}

int RayServices::illuminate(RTSstate* state, RTuint light, RTSlightsample* sample) {
    RayStart& from = startOf(*state);
    const FrameShading& shading = from.services->shading_;
    *sample = {};
    if (light >= shading.lights.size() || from.asksLight) return 0;
    const LightPart& part = shading.lights[light];
    const RTshaderclass& functions = part.light->functions();
    from.asksLight = true;
    const int answer =
        functions.illuminateSample
            ? functions.illuminateSample(part.light->block(), state, part.sample, part.samples,
                                         sample)
            : functions.illuminate(part.light->block(), state->position, sample);
    from.asksLight = false;
    return finishLight(part, answer, *from.sample, *sample);
}

int RayServices::finishLight(const LightPart& part, int answer, PixelSample& asked,
                             RTSlightsample& sample) {
    if (answer < 0) asked.fault = true;
    if (answer <= 0) return 0;
    if (part.point) return 1; // nothing is left to be done
    const glm::vec3 direction = unitDirection(sample.direction);
    if (direction == glm::vec3(0.0f)) return 0; // the light is at the point
    copy(sample.direction, direction);
    if (part.samples > 1)
        for (float& radiance : sample.radiance) radiance /= float(part.samples);
    return 1;
}

void RayServices::texture(RTSstate* state, RTuint texture, float s, float t, float rgba[4]) {
    const Frame& frame = startOf(*state).services->frame_;
    glm::vec4 texel(1.0f);
    if (frame.textures && texture < frame.textures->size() && (*frame.textures)[texture])
        texel = (*frame.textures)[texture]->sample(s, t, textureFootprint(*state));
    for (int k = 0; k < 4; ++k) rgba[k] = texel[k];
}

void RayServices::environment(RTSstate* state, const float direction[3], float radiance[3]) {
    RayServices& self = *startOf(*state).services;
    glm::vec4 color(0.0f);
    // Environment shaders that ask the environment would go on for ever.
    if (state->depth <= self.recursionLimit_) {
        Ray ray{};
        copy(ray.org, state->position);
        copy(ray.dir, unitDirection(direction));
        const PathState path = onward(*state, state->weight);
        color = self.shadeMiss(ray, path);
        path.sample->fault |= !hasFiniteRadiance(color);
    }
    for (int k = 0; k < 3; ++k) radiance[k] = color[k];
}

float RayServices::random(RTSstate* state) {
    return startOf(*state).sample->random.next();
}

} // namespace smart
