// SPDX-License-Identifier: MIT
// What a shader sees of the point that it shades, and what it may ask. Included by shader.hpp.
#pragma once

#include <limits>

#include "openrt/rts.h"
#include "openrt/vectors.hpp"

namespace openrt {

/// A texture as a parameter; set by rtParameter1i. 0 is no texture and reads as opaque white.
struct TextureId {
    int id = 0;
    constexpr explicit operator bool() const { return id != 0; }
};

/// A sample of a light at the shaded point.
struct LightSample {
    Vec3 direction; ///< to the light, length 1
    float distance; ///< may be infinite
    Color radiance; ///< arriving if nothing is between
};

/// How a context reaches the library: through the state's function table. A tracer that is
/// compiled for one shader puts its own functions in the place of this.
struct TableCalls {
    static int trace(RTSstate* s, const float (&origin)[3], const float (&direction)[3],
                     float weight, float (&radiance)[3]) {
        return s->functions->trace(s, origin, direction, weight, radiance);
    }
    static int traceHit(RTSstate* s, const float (&origin)[3], const float (&direction)[3],
                        RTShitinfo* hit) {
        return s->functions->traceHit(s, origin, direction, hit);
    }
    static int shadow(RTSstate* s, const float (&origin)[3], const float (&direction)[3],
                      float distance, float (&attenuation)[3]) {
        return s->functions->shadow(s, origin, direction, distance, attenuation);
    }
    static RTuint lightCount(const RTSstate* s) { return s->functions->lightCount(s); }
    static int illuminate(RTSstate* s, RTuint light, RTSlightsample* sample) {
        return s->functions->illuminate(s, light, sample);
    }
    static void texture(RTSstate* s, RTuint texture, float u, float v, float (&rgba)[4]) {
        s->functions->texture(s, texture, u, v, rgba);
    }
    static void environment(RTSstate* s, const float (&direction)[3], float (&radiance)[3]) {
        s->functions->environment(s, direction, radiance);
    }
    static float random(RTSstate* s) { return s->functions->random(s); }
};

/// The point being shaded, or in a camera shader the ray to be set; a view of an RTSstate.
/// Numbers, vectors and conditions go by the names Float, Vec3, Color, Condition ... in shaders
/// that are written for points and packets alike.
template <class Calls>
class BasicTraceContext {
public:
    using Float = float;
    using Vec2 = openrt::Vec2;
    using Vec3 = openrt::Vec3;
    using Vec4 = openrt::Vec4;
    using Color = openrt::Color;
    using LightSample = openrt::LightSample;
    using Condition = bool;

    explicit BasicTraceContext(RTSstate* state) : state_(state) {}
    explicit BasicTraceContext(RTScameraray* ray) : state_(ray->state), ray_(ray) {}

    Vec3 position() const { return Vec3(state_->position); }
    Vec3 shadingNormal() const { return Vec3(state_->shadingNormal); }
    Vec3 rawNormal() const { return Vec3(state_->rawNormal); }
    Vec3 geometricNormal() const { return Vec3(state_->geometricNormal); }
    Vec3 barycentrics() const { return Vec3(state_->barycentric); }
    Vec2 texCoord() const { return Vec2(state_->texCoord); }
    Vec4 texCoord4() const { return Vec4(state_->texCoord); }
    Color color() const { return Color(state_->color); }
    float alpha() const { return state_->color[3]; }
    Vec3 rayOrigin() const { return Vec3(state_->rayOrigin); }
    Vec3 rayDirection() const { return Vec3(state_->rayDirection); }
    float rayDistance() const { return state_->rayDistance; }
    bool frontFace() const { return state_->frontFace != 0; }
    RTuint object() const { return state_->object; }
    RTuint instance() const { return state_->instance; }
    RTuint primitive() const { return state_->primitive; }
    RTuint depth() const { return state_->depth; }
    float weight() const { return state_->weight; }
    RTuint pixelX() const { return state_->pixel[0]; }
    RTuint pixelY() const { return state_->pixel[1]; }
    RTuint sample() const { return state_->sample; }

    /// The geometric normal on the side that the ray came from.
    Vec3 facingGeometricNormal() const {
        return frontFace() ? geometricNormal() : -geometricNormal();
    }
    /// The shading normal, turned to the side of the surface that the ray came from.
    Vec3 facingNormal() const {
        const Vec3 normal = shadingNormal();
        return dot(normal, facingGeometricNormal()) < 0 ? -normal : normal;
    }
    Vec3 reflectedDirection() const { return reflect(rayDirection(), facingNormal()); }

    /// The index of refraction on the ray's side divided by that behind; false: total reflection.
    bool refractedDirection(float eta, Vec3& direction) const {
        float d[3] = {0, 0, 0};
        if (!rtsRefractedDirection(state_, eta, d)) return false;
        direction = Vec3(d);
        return true;
    }
    /// Whether to add light from one random direction: path tracing asks for it.
    bool indirect() const { return rtsIndirect(state_) != 0; }
    /// No further rays from this point.
    void stopRayRecursion() { rtsStopRayRecursion(state_); }

    /// Radiance along a ray; black where the recursion limit or the weight cut-off stopped it, or
    /// where `wanted` is false. `weight`: the ray's share of this point's radiance, 0 to 1.
    Color trace(const Vec3& origin, const Vec3& direction, float weight = 1.0f,
                bool wanted = true) {
        const float o[3] = {origin.x, origin.y, origin.z};
        const float d[3] = {direction.x, direction.y, direction.z};
        float radiance[3] = {0, 0, 0};
        if (!wanted || !Calls::trace(state_, o, d, weight * state_->weight, radiance)) return {};
        return Color(radiance);
    }
    /// What a ray meets, without shading; false: nothing.
    bool traceHit(const Vec3& origin, const Vec3& direction, RTShitinfo& hit) {
        const float o[3] = {origin.x, origin.y, origin.z};
        const float d[3] = {direction.x, direction.y, direction.z};
        return Calls::traceHit(state_, o, d, &hit) &&
               hit.distance <= std::numeric_limits<float>::max();
    }
    /// Share of light that passes: 1 nothing in between, 0 opaque, or not `wanted`.
    Color shadow(const Vec3& origin, const Vec3& direction, float distance, bool wanted = true) {
        const float o[3] = {origin.x, origin.y, origin.z};
        const float d[3] = {direction.x, direction.y, direction.z};
        float attenuation[3] = {0, 0, 0};
        if (wanted) Calls::shadow(state_, o, d, distance, attenuation);
        return Color(attenuation);
    }
    RTuint lightCount() const { return Calls::lightCount(state_); }
    bool illuminate(RTuint light, LightSample& sample, bool wanted = true) {
        RTSlightsample s = {};
        if (!wanted || !Calls::illuminate(state_, light, &s)) return false;
        sample = {Vec3(s.direction), s.distance, Color(s.radiance)};
        return true;
    }
    bool illuminate(RTuint light, Vec3& direction, float& distance, Color& radiance) {
        LightSample s{};
        if (!illuminate(light, s)) return false;
        direction = s.direction;
        distance = s.distance;
        radiance = s.radiance;
        return true;
    }
    /// RGBA, linear.
    Vec4 texture(TextureId texture, const Vec2& at) const {
        float rgba[4] = {1, 1, 1, 1};
        Calls::texture(state_, RTuint(texture.id), at.x, at.y, rgba);
        return Vec4(rgba);
    }
    Color environment(const Vec3& direction, bool wanted = true) {
        const float d[3] = {direction.x, direction.y, direction.z};
        float radiance[3] = {0, 0, 0};
        if (wanted) Calls::environment(state_, d, radiance);
        return Color(radiance);
    }
    /// Next number of the pixel's random stream, in [0, 1). Not drawn where `wanted` is false.
    float random(bool wanted = true) { return wanted ? Calls::random(state_) : 0.0f; }

    void setRadiance(const Color& radiance) {
        rtsResultColor(state_, radiance.r, radiance.g, radiance.b);
    }
    void setAlpha(float alpha) { state_->result[3] = alpha; }

    /// The triangle's block of the class's per-triangle parameters, the interpolated block of its
    /// per-vertex ones.
    template <class T>
    const T& triangleParam() const {
        return *static_cast<const T*>(state_->triangleParam);
    }
    template <class T>
    const T& vertexParam() const {
        return *static_cast<const T*>(state_->vertexParam);
    }
    /// One of their numbers, as packets have it: c.vertexParam(&VertexParam::heat).
    template <class T>
    float triangleParam(float T::*member) const {
        return triangleParam<T>().*member;
    }
    template <class T>
    float vertexParam(float T::*member) const {
        return vertexParam<T>().*member;
    }

    /// Camera shaders only: the ray through the point of the picture. Besides, those may ask for
    /// pixel, sample and random numbers.
    void setRay(const Vec3& origin, const Vec3& direction, float tnear = 0.0f,
                float tfar = std::numeric_limits<float>::infinity()) {
        *ray_ = {{origin.x, origin.y, origin.z}, {direction.x, direction.y, direction.z},
                 tnear, tfar, ray_->state};
    }

    RTSstate* state() const { return state_; }

private:
    RTSstate* state_ = nullptr;
    RTScameraray* ray_ = nullptr;
};

using TraceContext = BasicTraceContext<TableCalls>;

} // namespace openrt
