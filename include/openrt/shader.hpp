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
//                     bool opaque() const: transparency is black everywhere (optional)
//   environment       void shade(TraceContext&) const, and
//                     static constexpr ShaderKind kind = ShaderKind::Environment
//   light             bool illuminate(const Vec3& position, Vec3& direction, float& distance,
//                                     Color& radiance) const, or for lights with an extent
//                     bool illuminate(TraceContext&, RTuint i, RTuint n, LightSample&) const,
//                     RTuint lightSamples() const                          (optional)
//   camera            void initPrimaryRay(float x, float y, TraceContext&) const
//   rendering object  Color renderPixel(PixelContext&) const
//
// Surfaces and environments may shade packets of up to sixteen points (packet_context.hpp): with
// `void shadePacket(PacketContext&) const`, or, where `shade` is a template of its context that
// serves packets too, with `static constexpr bool shadesPackets = true`.
//
// A surface may say what it reads of the point, so that nothing else is computed; otherwise it gets
// everything. What it does not name is 0:
//
//   RTuint reads() const { return READS_COLOR | (shiny ? READS_TRACE : 0u); }   (optional, may be
//                                                              static and constexpr)
//
// Per-triangle and per-vertex parameters live in nested structs TriangleParam and VertexParam,
// plain data; VertexParam holds floats only, as it is interpolated. All members run on many
// threads at once. What they throw becomes a fault: the pixel is black and counted.
#pragma once

#include <concepts>
#include <cstddef>
#include <deque>
#include <string>
#include <type_traits>
#include <vector>

#include "openrt/packet_context.hpp"
#include "openrt/trace_context.hpp"

namespace openrt {

inline constexpr RTSscope PER_SHADER = RTS_PER_SHADER;
inline constexpr RTSscope PER_TRIANGLE = RTS_PER_TRIANGLE;
inline constexpr RTSscope PER_VERTEX = RTS_PER_VERTEX;

/// For `reads`: values of the context,
inline constexpr RTuint READS_RAY = RTS_READS_RAY; ///< rayOrigin, rayDirection, rayDistance
inline constexpr RTuint READS_POSITION = RTS_READS_POSITION;
inline constexpr RTuint READS_NORMAL = RTS_READS_NORMAL; ///< geometricNormal, frontFace
inline constexpr RTuint READS_SHADING_NORMAL = RTS_READS_SHADING_NORMAL;
inline constexpr RTuint READS_RAW_NORMAL = RTS_READS_RAW_NORMAL;
inline constexpr RTuint READS_BARYCENTRIC = RTS_READS_BARYCENTRIC;
inline constexpr RTuint READS_TEXCOORD = RTS_READS_TEXCOORD;
inline constexpr RTuint READS_COLOR = RTS_READS_COLOR; ///< color, alpha
inline constexpr RTuint READS_IDS = RTS_READS_IDS;     ///< object, instance, primitive
inline constexpr RTuint READS_PIXEL = RTS_READS_PIXEL; ///< of the state: pixel, sample
inline constexpr RTuint READS_FOOTPRINT = RTS_READS_FOOTPRINT; ///< of the state, with the density
inline constexpr RTuint READS_EVERYTHING = RTS_READS_EVERYTHING;
/// and what its functions read.
inline constexpr RTuint READS_FACING_NORMAL = READS_NORMAL | READS_SHADING_NORMAL;
inline constexpr RTuint READS_REFLECTION = READS_RAY | READS_FACING_NORMAL; ///< reflectedDirection
inline constexpr RTuint READS_REFRACTION = READS_RAY | READS_SHADING_NORMAL;
inline constexpr RTuint READS_LIGHTS = READS_POSITION;    ///< illuminate, environment
inline constexpr RTuint READS_TRACE = RTS_READS_TRACE;     ///< trace, traceHit, shadow
inline constexpr RTuint READS_TEXTURE = RTS_READS_TEXTURE; ///< texture, but for where

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
    /// As trace, with light from random directions at each point: one path of path tracing.
    Vec4 tracePath(const Vec2& at) {
        float rgba[4] = {0, 0, 0, 1};
        pixel_->traceWith(pixel_, at.x, at.y, RTS_INDIRECT, rgba);
        return Vec4(rgba);
    }
    /// Calls function(TraceContext&) for what the camera ray meets, not yet shaded; further rays
    /// start there as in a surface shader. false: it meets nothing.
    template <class Function>
    bool visit(const Vec2& at, Function&& function) {
        RTSstate* const state = pixel_->visit(pixel_, at.x, at.y);
        if (!state) return false;
        TraceContext context(state);
        function(context);
        return true;
    }
    /// Position of the i-th of n samples in the pixel's square.
    Vec2 samplePosition(RTuint i, RTuint n) {
        float xy[2] = {0.5f, 0.5f};
        pixel_->samplePosition(pixel_, i, n, xy);
        return Vec2(xy);
    }
    float random() { return rtsRandom(pixel_->state); }
    /// Radiance of the environment in a direction.
    Color environment(const Vec3& direction) {
        return TraceContext(pixel_->state).environment(direction);
    }
    void setAlpha(float alpha) { alpha_ = alpha; }
    float alpha() const { return alpha_; }

private:
    RTSpixel* pixel_;
    float alpha_ = 1.0f;
};

} // namespace openrt

#include "openrt/shader_class.hpp"
