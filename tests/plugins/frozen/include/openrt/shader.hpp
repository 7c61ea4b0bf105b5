// SPDX-License-Identifier: MIT
// The C++ shader interface. A shader is a plain class whose members are found by their form:
//
//   struct Wood {
//       openrt::Color light{0.8f, 0.6f, 0.4f};   // the constructor sets the defaults
//       void registerParams(const openrt::ShaderRegistrator& r) const {
//           r.registerParam<openrt::Color>("light", openrt::PER_SHADER, offsetof(Wood, light));
//       }
//       void shade(openrt::TraceContext& c) const { c.setRadiance(light * c.color()); }
//   };
//   const RTshaderclass* descriptor = openrt::shaderClass<Wood>("Wood");
//
//   surface           void shade(TraceContext&) const
//                     bool or Color transparency(TraceContext&) const      (optional)
//   environment       void shade(TraceContext&) const, and
//                     static constexpr ShaderKind kind = ShaderKind::Environment
//   light             bool illuminate(const Vec3& position, Vec3& direction, float& distance,
//                                     Color& radiance) const
//   camera            void initPrimaryRay(float x, float y, TraceContext&) const
//   rendering object  Color renderPixel(PixelContext&) const
//
// Per-triangle and per-vertex parameters live in nested structs TriangleParam and VertexParam,
// plain data; VertexParam holds floats only, as it is interpolated. All members run on many
// threads at once. What they throw becomes a fault: the pixel is black and counted.
#pragma once

#include <concepts>
#include <cstddef>
#include <deque>
#include <limits>
#include <map>
#include <mutex>
#include <new>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "openrt/rts.h"
#include "openrt/vectors.hpp"

namespace openrt {

inline constexpr RTSscope PER_SHADER = RTS_PER_SHADER;
inline constexpr RTSscope PER_TRIANGLE = RTS_PER_TRIANGLE;
inline constexpr RTSscope PER_VERTEX = RTS_PER_VERTEX;

enum class ShaderKind : RTenum {
    Surface = RT_SURFACE_SHADER,
    Environment = RT_ENV_SHADER,
    Light = RT_LIGHT_SHADER,
    Camera = RT_CAMERA_SHADER,
    RenderingObject = RT_RENDERING_OBJECT_SHADER
};

struct Int2 {
    int x = 0, y = 0;
};
struct Int3 {
    int x = 0, y = 0, z = 0;
};
/// A texture as a parameter; set by rtParameter1i. 0 is no texture and reads as opaque white.
struct TextureId {
    int id = 0;
    constexpr explicit operator bool() const { return id != 0; }
};

/// What registerParams talks to.
class ShaderRegistrator {
public:
    explicit ShaderRegistrator(std::deque<std::string>& names, std::vector<RTSparameter>& list)
        : names_(&names), list_(&list) {}

    /// Makes the member at `offset` of the scope's struct a parameter. T is the member's type:
    /// int, bool, TextureId (all set by 1i), Int2, Int3, float, Vec2, Vec3, Color, Vec4, Mat4,
    /// const char* (per shader only), or any trivially copyable type, set by rtParameterRaw.
    template <class T>
    void registerParam(const char* name, RTSscope scope, std::size_t offset) const {
        static_assert(std::is_trivially_copyable_v<T>, "a parameter is plain data");
        static_assert(!std::is_pointer_v<T> || std::same_as<T, const char*>,
                      "of pointers only const char* can be a parameter");
        names_->emplace_back(name);
        list_->push_back({names_->back().c_str(), scope, typeOf<T>(), RTuint(offset),
                          RTuint(sizeof(T))});
    }

private:
    template <class T>
    static constexpr RTStype typeOf() {
        if constexpr (std::same_as<T, int> || std::same_as<T, bool> || std::same_as<T, TextureId>)
            return RTS_INT1;
        else if constexpr (std::same_as<T, Int2>) return RTS_INT2;
        else if constexpr (std::same_as<T, Int3>) return RTS_INT3;
        else if constexpr (std::same_as<T, float>) return RTS_FLOAT1;
        else if constexpr (std::same_as<T, Vec2>) return RTS_FLOAT2;
        else if constexpr (std::same_as<T, Vec3> || std::same_as<T, Color>) return RTS_FLOAT3;
        else if constexpr (std::same_as<T, Vec4>) return RTS_FLOAT4;
        else if constexpr (std::same_as<T, Mat4>) return RTS_FLOAT16;
        else if constexpr (std::same_as<T, const char*>) return RTS_STRING;
        else return RTS_RAW;
    }

    std::deque<std::string>* names_;
    std::vector<RTSparameter>* list_;
};

/// A sample of a light at the shaded point.
struct LightSample {
    Vec3 direction; ///< to the light, length 1
    float distance; ///< may be infinite
    Color radiance; ///< arriving if nothing is between
};

/// The point being shaded, or in a camera shader the ray to be set; a view of an RTSstate.
class TraceContext {
public:
    explicit TraceContext(RTSstate* state) : state_(state) {}
    explicit TraceContext(RTScameraray* ray) : ray_(ray) {}

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

    /// Radiance along a ray; black where the recursion limit or the weight cut-off stopped it.
    /// `weight`: the ray's share of this point's radiance, 0 to 1.
    Color trace(const Vec3& origin, const Vec3& direction, float weight = 1.0f) {
        const float o[3] = {origin.x, origin.y, origin.z};
        const float d[3] = {direction.x, direction.y, direction.z};
        float radiance[3] = {0, 0, 0};
        if (!state_->functions->trace(state_, o, d, weight * state_->weight, radiance)) return {};
        return Color(radiance);
    }
    /// What a ray meets, without shading; false: nothing.
    bool traceHit(const Vec3& origin, const Vec3& direction, RTShitinfo& hit) {
        const float o[3] = {origin.x, origin.y, origin.z};
        const float d[3] = {direction.x, direction.y, direction.z};
        return state_->functions->traceHit(state_, o, d, &hit) &&
               hit.distance <= std::numeric_limits<float>::max();
    }
    /// Share of light that passes: 1 nothing in between, 0 opaque.
    Color shadow(const Vec3& origin, const Vec3& direction, float distance) {
        const float o[3] = {origin.x, origin.y, origin.z};
        const float d[3] = {direction.x, direction.y, direction.z};
        float attenuation[3] = {0, 0, 0};
        state_->functions->shadow(state_, o, d, distance, attenuation);
        return Color(attenuation);
    }
    RTuint lightCount() const { return state_->functions->lightCount(state_); }
    bool illuminate(RTuint light, LightSample& sample) {
        RTSlightsample s = {};
        if (!state_->functions->illuminate(state_, light, &s)) return false;
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
        state_->functions->texture(state_, RTuint(texture.id), at.x, at.y, rgba);
        return Vec4(rgba);
    }
    Color environment(const Vec3& direction) {
        const float d[3] = {direction.x, direction.y, direction.z};
        float radiance[3] = {0, 0, 0};
        state_->functions->environment(state_, d, radiance);
        return Color(radiance);
    }
    /// Next number of the pixel's random stream, in [0, 1).
    float random() { return state_->functions->random(state_); }

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

    /// Camera shaders only, and all that they may call: the ray through the point of the picture.
    void setRay(const Vec3& origin, const Vec3& direction, float tnear = 0.0f,
                float tfar = std::numeric_limits<float>::infinity()) {
        *ray_ = {{origin.x, origin.y, origin.z}, {direction.x, direction.y, direction.z},
                 tnear, tfar};
    }

    RTSstate* state() const { return state_; }

private:
    RTSstate* state_ = nullptr;
    RTScameraray* ray_ = nullptr;
};

/// A pixel, for rendering objects.
class PixelContext {
public:
    explicit PixelContext(RTSpixel* pixel) : pixel_(pixel) {}

    RTuint x() const { return pixel_->x; }
    RTuint y() const { return pixel_->y; }
    RTuint samples() const { return pixel_->samples; } ///< what rtSamples asks for
    /// Radiance and alpha through the point of the pixel's square; (0.5, 0.5) is its centre.
    Vec4 trace(const Vec2& at) {
        float rgba[4] = {0, 0, 0, 1};
        pixel_->trace(pixel_, at.x, at.y, rgba);
        return Vec4(rgba);
    }
    /// Position of the i-th of n samples in the pixel's square.
    Vec2 samplePosition(RTuint i, RTuint n) {
        float xy[2] = {0.5f, 0.5f};
        pixel_->samplePosition(pixel_, i, n, xy);
        return Vec2(xy);
    }
    float random() { return pixel_->state->functions->random(pixel_->state); }
    void setAlpha(float alpha) { alpha_ = alpha; }
    float alpha() const { return alpha_; }

private:
    RTSpixel* pixel_;
    float alpha_ = 1.0f;
};

} // namespace openrt

#include "openrt/shader_class.hpp"
