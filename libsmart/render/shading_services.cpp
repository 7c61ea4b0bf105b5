// SPDX-License-Identifier: MIT
#include "libsmart/render/shading_services.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "libsmart/render/ray_offset.h"
#include "libsmart/shading/surface_point.h"

namespace smart {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
/// Shadow rays end this share of the distance before the light, so as not to meet its own surface.
constexpr float kBeforeLight = 1.0f - 0x1p-20f;
/// Transparent surfaces that a shadow ray passes; what lies behind so many counts as dark.
constexpr int kMaxTransparentHits = 256;

bool isFinite(const glm::vec4& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.w);
}

// Length 1; zero where there is no direction: such rays miss.
glm::vec3 normalized(const float direction[3]) {
    const glm::dvec3 d(direction[0], direction[1], direction[2]);
    const double length = std::sqrt(glm::dot(d, d)); // squares of floats are in double's range
    if (!(length > 0.0) || !std::isfinite(length)) return glm::vec3(0.0f);
    return glm::vec3(d / length);
}

/// The surfaces that a ray passes, each once: the test in float may find a triangle again just
/// behind where it was found, and at an edge it finds both triangles.
class Crossings {
public:
    /// Whether the hit is another surface than those before it.
    bool add(const Hit& hit) {
        for (int i = 0; i < count_; ++i)
            if (hit.triangle == recent_[i].triangle && samePath(hit, recent_[i])) return repeated();
        if (count_ > 0 && samePath(hit, recent_[newest_]) &&
            hit.t <= recent_[newest_].t * (1.0f + kSamePlace))
            return repeated();
        newest_ = (newest_ + 1) % kRecent;
        recent_[newest_] = hit;
        count_ = std::min(count_ + 1, kRecent);
        step_ = 0x1p-23f;
        return true;
    }
    /// Where to look for the next one.
    float beyond(const Hit& hit) const {
        return std::max(std::nextafter(hit.t, kInfinity), hit.t * (1.0f + step_));
    }

private:
    static constexpr int kRecent = 4;
    static constexpr float kSamePlace = 0x1p-20f; ///< hits of one instance, as a share of t

    static bool samePath(const Hit& a, const Hit& b) {
        return a.levels == b.levels && std::equal(a.path, a.path + a.levels, b.path);
    }
    bool repeated() {
        step_ *= 2; // the float test's error is a few units in the last place, seldom more
        return false;
    }

    Hit recent_[kRecent];
    int count_ = 0, newest_ = kRecent - 1;
    float step_ = 0x1p-23f;
};

template <class Vector>
void copy(float (&to)[3], const Vector& from) {
    for (int k = 0; k < 3; ++k) to[k] = from[k];
}

} // namespace

const RTSfunctions ShadingServices::kFunctions = {
    sizeof(RTSfunctions), trace,   traceHit,    shadow, lightCount,
    illuminate,           texture, environment, random};

ShadingServices::ShadingServices(const Frame& frame, TilePixels& counters)
    : frame_(frame),
      counters_(counters),
      kernels_(kernels()),
      precision_(std::size_t(frame.scene->precision())),
      recursionLimit_(std::min(frame.recursionLimit, kMaxRecursion)) {}

void ShadingServices::beginSample(uint32_t x, uint32_t y, uint32_t sample) {
    pixel_[0] = x;
    pixel_[1] = y;
    sample_ = sample;
    random_ = RandomStream(x, y, sample, frame_.seed);
}

ShadedSample ShadingServices::shadeCameraRay(const Ray& ray, const Hit& hit,
                                             const RayCone& cone) {
    ShadedSample sample;
    if (hit.triangle == kNoHit)
        sample.color = shadeMiss(ray, cone, 0, 1.0f);
    else
        sample.color = shadeHit(ray, cone, hit, 0, 1.0f, &sample);
    if (takeFault() || !isFinite(sample.color)) {
        sample.bad = true;
        sample.color = {0.0f, 0.0f, 0.0f, 1.0f};
    }
    return sample;
}

ShadedSample ShadingServices::traceCameraRay(const Ray& ray, const RayCone& cone) {
    ++counters_.primaryRays;
    return shadeCameraRay(ray, findHit(ray), cone);
}

RTSstate ShadingServices::emptyState() {
    return makeState(nowhere_, {{0, 0, 0}, {0, 0, 0}, 0.0f, kInfinity}, 0, 1.0f);
}

bool ShadingServices::takeFault() {
    return std::exchange(fault_, false);
}

RTSstate ShadingServices::makeState(Origin& origin, const Ray& ray, uint32_t depth,
                                    float weight) const {
    RTSstate state{};
    state.functions = &kFunctions;
    state.tracer = &origin;
    copy(state.rayOrigin, ray.org);
    copy(state.rayDirection, ray.dir);
    state.rayDistance = kInfinity;
    state.object = state.instance = state.primitive = kNoId;
    state.depth = depth;
    state.weight = weight;
    state.pixel[0] = pixel_[0];
    state.pixel[1] = pixel_[1];
    state.sample = sample_;
    state.result[3] = 1.0f;
    state.footprint = origin.chain ? origin.cone.width : origin.cone.spread;
    return state;
}

// A ray with a direction of length 1. Only where it starts exactly at the shaded point is its
// origin moved off the surface: another origin is the shader's own choice.
Ray ShadingServices::spawn(const RTSstate& state, const float origin[3],
                           const float direction[3]) const {
    const Origin& from = *static_cast<const Origin*>(state.tracer);
    const glm::vec3 towards = normalized(direction);
    glm::vec3 start(origin[0], origin[1], origin[2]);
    if (from.chain && std::equal(origin, origin + 3, state.position))
        start = leaveSurface(state.position, state.geometricNormal, state.rayDirection, towards,
                             surfaceError(*from.chain, state.position, from.u, from.v));
    Ray ray{};
    copy(ray.org, start);
    copy(ray.dir, towards);
    ray.tFar = kInfinity;
    return ray;
}

Hit ShadingServices::findHit(const Ray& ray) const {
    Hit hit;
    kernels_.intersect1[precision_](frame_.scene->view(), ray, hit);
    return hit;
}

HitChain ShadingServices::chainOf(const Hit& hit) const {
    return resolve(*frame_.scene, hit.path, hit.levels, hit.triangle);
}

const ShaderObject* ShadingServices::findSurface(const HitChain& chain) const {
    const uint32_t index = effectiveShader(chain);
    if (index >= frame_.shaders->size()) return nullptr;
    const ShaderObject* shader = (*frame_.shaders)[index].get();
    return shader && shader->shaderClass().kind() == RT_SURFACE_SHADER ? shader : nullptr;
}

glm::vec4 ShadingServices::shadeHit(const Ray& ray, const RayCone& cone, const Hit& hit,
                                    uint32_t depth, float weight, ShadedSample* camera) {
    const HitChain chain = chainOf(hit);
    Origin origin{this, &chain, hit.u, hit.v, cone.after(hit.t)};
    RTSstate state = makeState(origin, ray, depth, weight);
    fillSurfacePoint(chain, hit.path[0], ray, hit.t, hit.u, hit.v, state);
    if (camera) {
        camera->distance = hit.t;
        camera->normal = {state.shadingNormal[0], state.shadingNormal[1], state.shadingNormal[2]};
        camera->object = state.object;
        camera->instance = state.instance;
        camera->primitive = state.primitive;
    }
    VertexScratch scratch;
    const ShaderObject* shader = findSurface(chain);
    if (shader) fillParameterBlocks(chain, *frame_.shaders, *shader, scratch, state);
    if (!shader || shader->functions().shade(shader->block(), &state) != 0) {
        fault_ = true;
        return {0.0f, 0.0f, 0.0f, 1.0f};
    }
    return {state.result[0], state.result[1], state.result[2], state.result[3]};
}

glm::vec4 ShadingServices::shadeMiss(const Ray& ray, const RayCone& cone, uint32_t depth,
                                     float weight) {
    if (!frame_.environment) return frame_.clearColor;
    Origin origin{this, nullptr, 0.0f, 0.0f, cone};
    RTSstate state = makeState(origin, ray, depth, weight);
    const ShaderObject& shader = *frame_.environment;
    if (shader.functions().shade(shader.block(), &state) != 0) {
        fault_ = true;
        return {0.0f, 0.0f, 0.0f, 1.0f};
    }
    return {state.result[0], state.result[1], state.result[2], 1.0f};
}

// What transparent surfaces leave of the light: the nearest hits one after the other.
glm::vec3 ShadingServices::attenuate(Ray ray, const RTSstate& from) {
    glm::vec3 product(1.0f);
    Crossings crossings;
    for (int i = 0; i < kMaxTransparentHits; ++i) {
        ++counters_.shadowRays;
        const Hit hit = findHit(ray);
        if (hit.triangle == kNoHit) return product;
        if (crossings.add(hit)) product *= transparency(ray, hit, from);
        if (product == glm::vec3(0.0f)) return product;
        ray.tNear = crossings.beyond(hit);
    }
    return glm::vec3(0.0f);
}

glm::vec3 ShadingServices::transparency(const Ray& ray, const Hit& hit, const RTSstate& from) {
    const HitChain chain = chainOf(hit);
    const ShaderObject* shader = findSurface(chain);
    if (!shader || !shader->functions().transparency) return glm::vec3(0.0f);
    const RayCone& cone = static_cast<const Origin*>(from.tracer)->cone;
    Origin origin{this, &chain, hit.u, hit.v, cone.after(hit.t), false};
    RTSstate state = makeState(origin, ray, from.depth + 1, from.weight);
    fillSurfacePoint(chain, hit.path[0], ray, hit.t, hit.u, hit.v, state);
    VertexScratch scratch;
    fillParameterBlocks(chain, *frame_.shaders, *shader, scratch, state);
    float rgb[3] = {0.0f, 0.0f, 0.0f};
    const int result = shader->functions().transparency(shader->block(), &state, rgb);
    if (result != 0 || !isFinite({rgb[0], rgb[1], rgb[2], 0.0f})) {
        fault_ = true;
        return glm::vec3(0.0f);
    }
    return {std::clamp(rgb[0], 0.0f, 1.0f), std::clamp(rgb[1], 0.0f, 1.0f),
            std::clamp(rgb[2], 0.0f, 1.0f)};
}

int ShadingServices::trace(RTSstate* state, const float origin[3], const float direction[3],
                           float weight, float radiance[3]) {
    const Origin& from = *static_cast<const Origin*>(state->tracer);
    ShadingServices& self = *from.services;
    std::fill_n(radiance, 3, 0.0f);
    const float share = weight < state->weight ? weight : state->weight;
    if (!from.mayTrace || state->depth >= self.recursionLimit_ || std::isnan(weight) ||
        share < self.frame_.weightCutoff)
        return 0;
    const Ray ray = self.spawn(*state, origin, direction);
    ++self.counters_.secondaryRays;
    const Hit hit = self.findHit(ray);
    const uint32_t depth = state->depth + 1;
    const glm::vec4 color = hit.triangle == kNoHit
                                ? self.shadeMiss(ray, from.cone, depth, share)
                                : self.shadeHit(ray, from.cone, hit, depth, share, nullptr);
    for (int k = 0; k < 3; ++k) radiance[k] = color[k];
    return 1;
}

// Shades nothing, so that it can not go on for ever: the recursion limit does not stop it.
int ShadingServices::traceHit(RTSstate* state, const float origin[3], const float direction[3],
                              RTShitinfo* found) {
    const Origin& from = *static_cast<const Origin*>(state->tracer);
    ShadingServices& self = *from.services;
    *found = {kInfinity, {0, 0, 0}, {0, 0, 0}, kNoId, kNoId, kNoId};
    if (!from.mayTrace) return 0;
    const Ray ray = self.spawn(*state, origin, direction);
    ++self.counters_.secondaryRays;
    const Hit hit = self.findHit(ray);
    if (hit.triangle == kNoHit) return 1;
    const HitChain chain = self.chainOf(hit);
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

int ShadingServices::shadow(RTSstate* state, const float origin[3], const float direction[3],
                            float distance, float attenuation[3]) {
    const Origin& from = *static_cast<const Origin*>(state->tracer);
    ShadingServices& self = *from.services;
    std::fill_n(attenuation, 3, from.mayTrace ? 1.0f : 0.0f);
    if (!from.mayTrace) return 0;
    if (!(distance > 0.0f)) return 1;
    Ray ray = self.spawn(*state, origin, direction);
    ray.tFar = distance * kBeforeLight;
    if (self.frame_.hasTransparency()) {
        const glm::vec3 left = self.attenuate(ray, *state);
        for (int k = 0; k < 3; ++k) attenuation[k] = left[k];
        return 1;
    }
    ++self.counters_.shadowRays;
    if (self.kernels_.occluded1[self.precision_](self.frame_.scene->view(), ray))
        std::fill_n(attenuation, 3, 0.0f);
    return 1;
}

RTuint ShadingServices::lightCount(const RTSstate* state) {
    return RTuint(static_cast<const Origin*>(state->tracer)->services->frame_.lights.size());
}

int ShadingServices::illuminate(RTSstate* state, RTuint light, RTSlightsample* sample) {
    ShadingServices& self = *static_cast<const Origin*>(state->tracer)->services;
    *sample = {};
    if (light >= self.frame_.lights.size()) return 0;
    const ShaderObject& shader = *self.frame_.lights[light];
    const int answer = shader.functions().illuminate(shader.block(), state->position, sample);
    if (answer < 0) self.fault_ = true;
    if (answer <= 0) return 0;
    const glm::vec3 direction = normalized(sample->direction);
    if (direction == glm::vec3(0.0f)) return 0; // the light is at the point
    copy(sample->direction, direction);
    return 1;
}

void ShadingServices::texture(RTSstate* state, RTuint texture, float s, float t, float rgba[4]) {
    const Frame& frame = static_cast<const Origin*>(state->tracer)->services->frame_;
    glm::vec4 texel(1.0f);
    if (frame.textures && texture < frame.textures->size() && (*frame.textures)[texture])
        texel = (*frame.textures)[texture]->sample(s, t, textureFootprint(*state));
    for (int k = 0; k < 4; ++k) rgba[k] = texel[k];
}

void ShadingServices::environment(RTSstate* state, const float direction[3], float radiance[3]) {
    const Origin& from = *static_cast<const Origin*>(state->tracer);
    ShadingServices& self = *from.services;
    glm::vec4 color(0.0f);
    // Environment shaders that ask the environment would go on for ever.
    if (state->depth <= self.recursionLimit_) {
        Ray ray{};
        copy(ray.org, state->position);
        copy(ray.dir, normalized(direction));
        color = self.shadeMiss(ray, from.cone, state->depth + 1, state->weight);
    }
    for (int k = 0; k < 3; ++k) radiance[k] = color[k];
}

float ShadingServices::random(RTSstate* state) {
    return static_cast<const Origin*>(state->tracer)->services->random_.next();
}

} // namespace smart
