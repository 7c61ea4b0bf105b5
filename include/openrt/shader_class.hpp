// SPDX-License-Identifier: MIT
// From a plain C++ class to the C descriptor that the library knows. Included by shader.hpp.
#pragma once

#include <deque>
#include <mutex>
#include <new>
#include <stdexcept>

#include "openrt/shader.hpp"

namespace openrt {

namespace detail {

template <class T>
concept Shades = requires(const T& s, TraceContext& c) { s.shade(c); };
template <class T>
concept AnswersTransparency = requires(const T& s, TraceContext& c) { s.transparency(c); };
template <class T>
concept Illuminates = requires(const T& s, const Vec3& p, Vec3& d, float& t, Color& r) {
    { s.illuminate(p, d, t, r) } -> std::convertible_to<bool>;
};
template <class T>
concept IlluminatesBySamples =
    requires(const T& s, TraceContext& c, LightSample& sample) {
        { s.illuminate(c, 0u, 1u, sample) } -> std::convertible_to<bool>;
    };
template <class T>
concept SplitsLight = requires(const T& s) {
    { s.lightSamples() } -> std::convertible_to<RTuint>;
};
template <class T>
concept PromisesOpacity = requires(const T& s) {
    { s.opaque() } -> std::convertible_to<bool>;
};
template <class T>
concept SaysWhatItReads = requires(const T& s) {
    { s.reads() } -> std::convertible_to<RTuint>;
};
template <class T>
concept ShadesPacketsByShade = requires { requires T::shadesPackets; };
template <class T>
concept ShadesPackets = ShadesPacketsByShade<T> ||
                        requires(const T& s, PacketContext& c) { s.shadePacket(c); };
template <class T>
concept InitsRays = requires(const T& s, TraceContext& c) { s.initPrimaryRay(0.5f, 0.5f, c); };
template <class T>
concept RendersPixels = requires(const T& s, PixelContext& c) {
    { s.renderPixel(c) } -> std::convertible_to<Color>;
};
template <class T>
concept RegistersParams = requires(const T& s, const ShaderRegistrator& r) { s.registerParams(r); };
template <class T>
concept HasTriangleParam = requires { typename T::TriangleParam; };
template <class T>
concept HasVertexParam = requires { typename T::VertexParam; };

struct Nothing {};
template <class T>
struct TriangleParamOf {
    using Type = Nothing;
};
template <HasTriangleParam T>
struct TriangleParamOf<T> {
    using Type = typename T::TriangleParam;
};
template <class T>
struct VertexParamOf {
    using Type = Nothing;
};
template <HasVertexParam T>
struct VertexParamOf<T> {
    using Type = typename T::VertexParam;
};

template <class T>
constexpr ShaderKind kindOf() {
    if constexpr (requires { { T::kind } -> std::convertible_to<ShaderKind>; }) {
        return T::kind;
    } else {
        constexpr bool isLight = Illuminates<T> || IlluminatesBySamples<T>;
        constexpr int forms =
            int(Shades<T>) + int(isLight) + int(InitsRays<T>) + int(RendersPixels<T>);
        static_assert(forms == 1, "a shader class has exactly one of shade, illuminate, "
                                  "initPrimaryRay and renderPixel as const members, or says its "
                                  "`kind`");
        if constexpr (isLight) return ShaderKind::Light;
        else if constexpr (InitsRays<T>) return ShaderKind::Camera;
        else if constexpr (RendersPixels<T>) return ShaderKind::RenderingObject;
        else return ShaderKind::Surface;
    }
}

/// The form of T that serves packets, by whichever name.
template <ShadesPackets T, class Context>
void shadePacketOf(const T& shader, Context& context) {
    if constexpr (ShadesPacketsByShade<T>) shader.shade(context);
    else shader.shadePacket(context);
}

inline constexpr int kThrew = -1; ///< what a function of the descriptor returns for an exception

/// The functions of the descriptor: no exception passes them. Hidden, as is what else belongs to T:
/// libraries whose classes share a name must not meet.
template <class T>
struct [[gnu::visibility("hidden")]] Functions {
    using Triangle = typename TriangleParamOf<T>::Type;
    using Vertex = typename VertexParamOf<T>::Type;

    static int construct(void* shader, void* triangleBlock, void* vertexBlock) noexcept {
        try {
            if (triangleBlock) new (triangleBlock) Triangle();
            if (vertexBlock) new (vertexBlock) Vertex();
            new (shader) T();
            return 0;
        } catch (...) {
            return kThrew;
        }
    }
    static void destroy(void* shader) noexcept { static_cast<T*>(shader)->~T(); }

    static int shade(const void* shader, RTSstate* state) noexcept {
        try {
            TraceContext context(state);
            static_cast<const T*>(shader)->shade(context);
            return 0;
        } catch (...) {
            return kThrew;
        }
    }
    static int shadePacket(const void* shader, RTSpacket* packet) noexcept {
        try {
            PacketContext context(packet);
            shadePacketOf(*static_cast<const T*>(shader), context);
            return 0;
        } catch (...) {
            return kThrew;
        }
    }
    static int opaque(const void* shader) noexcept {
        try {
            return static_cast<const T*>(shader)->opaque() ? 1 : 0;
        } catch (...) {
            return 0;
        }
    }
    static RTuint reads(const void* shader) noexcept {
        try {
            return RTuint(static_cast<const T*>(shader)->reads());
        } catch (...) {
            return RTS_READS_EVERYTHING;
        }
    }
    static RTuint lightSamples(const void* shader) noexcept {
        try {
            return RTuint(static_cast<const T*>(shader)->lightSamples());
        } catch (...) {
            return 1;
        }
    }
    static int illuminateSample(const void* shader, RTSstate* state, RTuint i, RTuint n,
                                RTSlightsample* sample) noexcept {
        try {
            TraceContext context(state);
            LightSample answer{};
            if (!static_cast<const T*>(shader)->illuminate(context, i, n, answer)) return 0;
            *sample = plain(answer.direction, answer.distance, answer.radiance);
            return 1;
        } catch (...) {
            return kThrew;
        }
    }
    static int transparency(const void* shader, RTSstate* state, float rgb[3]) noexcept {
        try {
            TraceContext context(state);
            const auto answer = static_cast<const T*>(shader)->transparency(context);
            const Color color = colorOf(answer);
            rgb[0] = color.r;
            rgb[1] = color.g;
            rgb[2] = color.b;
            return 0;
        } catch (...) {
            return kThrew;
        }
    }
    static int illuminate(const void* shader, const float position[3],
                          RTSlightsample* sample) noexcept {
        try {
            Vec3 direction;
            float distance = 0;
            Color radiance;
            if (!static_cast<const T*>(shader)->illuminate(Vec3(position), direction, distance,
                                                           radiance))
                return 0;
            *sample = plain(direction, distance, radiance);
            return 1;
        } catch (...) {
            return kThrew;
        }
    }
    static int cameraRay(const void* shader, float x, float y, RTScameraray* ray) noexcept {
        try {
            TraceContext context(ray);
            static_cast<const T*>(shader)->initPrimaryRay(x, y, context);
            return 0;
        } catch (...) {
            return kThrew;
        }
    }
    static int renderPixel(const void* shader, RTSpixel* pixel, float rgba[4]) noexcept {
        try {
            PixelContext context(pixel);
            const Color color = static_cast<const T*>(shader)->renderPixel(context);
            rgba[0] = color.r;
            rgba[1] = color.g;
            rgba[2] = color.b;
            rgba[3] = context.alpha();
            return 0;
        } catch (...) {
            return kThrew;
        }
    }

private:
    static RTSlightsample plain(const Vec3& direction, float distance, const Color& radiance) {
        return {{direction.x, direction.y, direction.z},
                distance,
                {radiance.r, radiance.g, radiance.b}};
    }
    static Color colorOf(bool transparent) { return Color(transparent ? 1.0f : 0.0f); }
    static Color colorOf(const Color& color) { return color; }
};

/// A descriptor and the memory it points to.
struct [[gnu::visibility("hidden")]] Descriptor {
    std::string name;
    std::deque<std::string> names;
    std::vector<RTSparameter> parameters;
    RTshaderclass shaderClass = {};
};

template <class T, ShaderKind kind>
void describe(Descriptor& descriptor) {
    using Triangle = typename TriangleParamOf<T>::Type;
    using Vertex = typename VertexParamOf<T>::Type;
    static_assert(std::is_default_constructible_v<T>, "the default constructor sets the defaults");
    static_assert(std::is_nothrow_destructible_v<T>);
    static_assert(std::is_trivially_copyable_v<Triangle> && alignof(Triangle) <= 16,
                  "TriangleParam is plain data, aligned to 16 bytes at most");
    static_assert(std::is_trivially_copyable_v<Vertex> && alignof(Vertex) <= 16 &&
                      (!HasVertexParam<T> || sizeof(Vertex) % sizeof(float) == 0) &&
                      sizeof(Vertex) <= 256 * sizeof(float),
                  "VertexParam is plain data, at most 256 floats and nothing else");
    static_assert(alignof(T) <= 64);

    if constexpr (RegistersParams<T>) {
        const T defaults{};
        defaults.registerParams(ShaderRegistrator(descriptor.names, descriptor.parameters));
    }
    RTshaderclass& c = descriptor.shaderClass;
    c.structSize = sizeof(RTshaderclass);
    c.interfaceVersion = RTS_INTERFACE_VERSION;
    c.kind = RTenum(kind);
    c.shaderSize = sizeof(T);
    c.triangleSize = HasTriangleParam<T> ? sizeof(Triangle) : 0;
    c.vertexSize = HasVertexParam<T> ? sizeof(Vertex) : 0;
    c.alignment = alignof(T);
    c.parameters = descriptor.parameters.data();
    c.parameterCount = RTuint(descriptor.parameters.size());
    c.construct = Functions<T>::construct;
    c.destroy = Functions<T>::destroy;
    if constexpr (kind == ShaderKind::Surface || kind == ShaderKind::Environment) {
        static_assert(Shades<T>,
                      "surfaces and environments have `void shade(TraceContext&) const`");
        c.shade = Functions<T>::shade;
    }
    if constexpr (kind == ShaderKind::Surface && AnswersTransparency<T>)
        c.transparency = Functions<T>::transparency;
    if constexpr ((kind == ShaderKind::Surface || kind == ShaderKind::Environment) &&
                  ShadesPackets<T>)
        c.shadePacket = Functions<T>::shadePacket;
    if constexpr (kind == ShaderKind::Surface && PromisesOpacity<T>)
        c.opaque = Functions<T>::opaque;
    if constexpr (kind == ShaderKind::Surface && SaysWhatItReads<T>) c.reads = Functions<T>::reads;
    if constexpr (kind == ShaderKind::Light && Illuminates<T>)
        c.illuminate = Functions<T>::illuminate;
    if constexpr (kind == ShaderKind::Light && IlluminatesBySamples<T>) {
        c.illuminateSample = Functions<T>::illuminateSample;
        if constexpr (SplitsLight<T>) c.lightSamples = Functions<T>::lightSamples;
    }
    if constexpr (kind == ShaderKind::Camera) c.cameraRay = Functions<T>::cameraRay;
    if constexpr (kind == ShaderKind::RenderingObject) c.renderPixel = Functions<T>::renderPixel;
}

} // namespace detail

/// The C descriptor of class T under a name, made at the first call, valid to the program's end.
/// Throws what T's constructor and registerParams throw. From any thread.
template <class T, ShaderKind kind = detail::kindOf<T>()>
[[gnu::visibility("hidden")]] const RTshaderclass* shaderClass(const char* name) {
    if (!name) throw std::invalid_argument("a shader class needs a name");
    static std::mutex mutex;
    // No map: its header has objects that keep g++ from ever unloading a library without -O.
    static std::deque<detail::Descriptor> made;
    const std::lock_guard lock(mutex);
    for (const detail::Descriptor& descriptor : made)
        if (descriptor.name == name) return &descriptor.shaderClass;
    detail::Descriptor& descriptor = made.emplace_back();
    try {
        descriptor.name = name;
        detail::describe<T, kind>(descriptor);
    } catch (...) {
        made.pop_back();
        throw;
    }
    descriptor.shaderClass.name = descriptor.name.c_str();
    return &descriptor.shaderClass;
}

} // namespace openrt
