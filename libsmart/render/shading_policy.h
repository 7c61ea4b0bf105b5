// SPDX-License-Identifier: MIT
// How a tracer reaches the surface shaders: through their class's functions, whatever the class,
// or, compiled for one class, directly.
#pragma once

#include "libsmart/render/frame_shading.h"
#include "openrt/shader.hpp"

namespace smart {

/// Surfaces of any class.
struct DynamicShading {
    static bool serves(const FrameShading&) { return true; }
    static bool shadesPackets(const ShaderObject& surface) {
        return surface.functions().shadePacket != nullptr;
    }
    static bool answersTransparency(const ShaderObject& surface) {
        return surface.functions().transparency != nullptr;
    }
    /// RTS_READS_...
    static uint32_t reads(const ShaderObject& surface) { return surface.reads(); }
    template <class Services>
    static int shade(const ShaderObject& surface, RTSstate& state) {
        return surface.functions().shade(surface.block(), &state);
    }
    template <class Services>
    static int shadePacket(const ShaderObject& surface, RTSpacket& packet) {
        return surface.functions().shadePacket(surface.block(), &packet);
    }
    template <class Services>
    static int transparency(const ShaderObject& surface, RTSstate& state, float (&rgb)[3]) {
        return surface.functions().transparency(surface.block(), &state, rgb);
    }
};

/// TableCalls (trace_context.hpp) that go to the services without the table.
template <class Services>
struct DirectCalls {
    static int trace(RTSstate* s, const float (&origin)[3], const float (&direction)[3],
                     float weight, float (&radiance)[3]) {
        return Services::trace(s, origin, direction, weight, radiance);
    }
    static int traceHit(RTSstate* s, const float (&origin)[3], const float (&direction)[3],
                        RTShitinfo* hit) {
        return Services::traceHit(s, origin, direction, hit);
    }
    static int shadow(RTSstate* s, const float (&origin)[3], const float (&direction)[3],
                      float distance, float (&attenuation)[3]) {
        return Services::shadow(s, origin, direction, distance, attenuation);
    }
    static RTuint lightCount(const RTSstate* s) { return Services::lightCount(s); }
    static int illuminate(RTSstate* s, RTuint light, RTSlightsample* sample) {
        return Services::illuminate(s, light, sample);
    }
    static void texture(RTSstate* s, RTuint texture, float u, float v, float (&rgba)[4]) {
        Services::texture(s, texture, u, v, rgba);
    }
    static void environment(RTSstate* s, const float (&direction)[3], float (&radiance)[3]) {
        Services::environment(s, direction, radiance);
    }
    static float random(RTSstate* s) { return Services::random(s); }
};

/// DirectCalls for packets.
template <class Services>
struct PacketDirectCalls {
    static RTuint trace(RTSpacket* p, RTuint lanes, const RTSvectors& origin,
                        const RTSvectors& direction, const RTSfloats& weight,
                        RTScolors& radiance) {
        return Services::packetTrace(p, lanes, &origin, &direction, &weight, &radiance);
    }
    static RTuint traceHit(RTSpacket* p, RTuint lanes, const RTSvectors& origin,
                           const RTSvectors& direction, RTShitpacket& hits) {
        return Services::packetTraceHit(p, lanes, &origin, &direction, &hits);
    }
    static RTuint shadow(RTSpacket* p, RTuint lanes, const RTSvectors& origin,
                         const RTSvectors& direction, const RTSfloats& distance,
                         RTScolors& attenuation) {
        return Services::packetShadow(p, lanes, &origin, &direction, &distance, &attenuation);
    }
    static RTuint lightCount(const RTSpacket* p) { return Services::packetLightCount(p); }
    static RTuint illuminate(RTSpacket* p, RTuint lanes, RTuint light, RTSlightpacket& samples) {
        return Services::packetIlluminate(p, lanes, light, &samples);
    }
    static void texture(RTSpacket* p, RTuint lanes, RTuint texture, const RTSfloats& s,
                        const RTSfloats& t, RTSfloats (&rgba)[4]) {
        Services::packetTexture(p, lanes, texture, &s, &t, rgba);
    }
    static void environment(RTSpacket* p, RTuint lanes, const RTSvectors& direction,
                            RTScolors& radiance) {
        Services::packetEnvironment(p, lanes, &direction, &radiance);
    }
    static void random(RTSpacket* p, RTuint lanes, RTSfloats& numbers) {
        Services::packetRandom(p, lanes, &numbers);
    }
};

/// Surfaces of class S only, whose members are templates of their context. Nothing stands between
/// a hit and them: no table, no descriptor.
template <class S>
struct FixedShading {
    /// Whether all surfaces in use are of the class.
    static bool serves(const FrameShading& frame) {
        return frame.commonShade == openrt::detail::Functions<S>::shade;
    }
    static constexpr bool shadesPackets(const ShaderObject&) {
        return openrt::detail::ShadesPackets<S>;
    }
    static constexpr bool answersTransparency(const ShaderObject&) {
        return openrt::detail::AnswersTransparency<S>;
    }
    /// Known to the compiler where S says it as a constant.
    static uint32_t reads(const ShaderObject& surface) {
        if constexpr (openrt::detail::SaysWhatItReads<S>)
            return openrt::detail::Functions<S>::reads(surface.block());
        else
            return RTS_READS_EVERYTHING;
    }
    template <class Services>
    static int shade(const ShaderObject& surface, RTSstate& state) {
        return guarded([&] {
            openrt::BasicTraceContext<DirectCalls<Services>> context(&state);
            shaderOf(surface).shade(context);
        });
    }
    template <class Services>
    static int shadePacket(const ShaderObject& surface, RTSpacket& packet) {
        if constexpr (openrt::detail::ShadesPackets<S>)
            return guarded([&] {
                openrt::BasicPacketContext<PacketDirectCalls<Services>> context(&packet);
                openrt::detail::shadePacketOf(shaderOf(surface), context);
            });
        else
            return openrt::detail::kThrew;
    }
    template <class Services>
    static int transparency(const ShaderObject& surface, RTSstate& state, float (&rgb)[3]) {
        if constexpr (openrt::detail::AnswersTransparency<S>)
            return guarded([&] {
                openrt::BasicTraceContext<DirectCalls<Services>> context(&state);
                const openrt::Color color = colorOf(shaderOf(surface).transparency(context));
                rgb[0] = color.r;
                rgb[1] = color.g;
                rgb[2] = color.b;
            });
        else
            return openrt::detail::kThrew;
    }

private:
    static const S& shaderOf(const ShaderObject& surface) {
        return *static_cast<const S*>(surface.block());
    }
    template <class Function>
    static int guarded(Function&& function) {
        try {
            function();
            return 0;
        } catch (...) {
            return openrt::detail::kThrew;
        }
    }
    static openrt::Color colorOf(bool transparent) {
        return openrt::Color(transparent ? 1.0f : 0.0f);
    }
    static openrt::Color colorOf(const openrt::Color& color) { return color; }
};

} // namespace smart
