// SPDX-License-Identifier: MIT
// Surface shaders that do what they should not, for the tests in which the rest of the picture
// has to come out as if they were not there. They serve linked into a program, and as a plug-in.
#pragma once

#include <cmath>
#include <limits>
#include <stdexcept>

#include "openrt/shader.hpp"

namespace misbehaving {

using namespace openrt;

inline constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
inline constexpr float kInf = std::numeric_limits<float>::infinity();
inline constexpr float kMax = std::numeric_limits<float>::max();

struct ThrowsNumber {
    void shade(TraceContext&) const { throw 1; }
};
struct ThrowsException {
    void shade(TraceContext& c) const {
        c.setRadiance(Color(1.0f));
        throw std::runtime_error("after the result was set");
    }
};
struct ThrowsInPacket {
    void shade(TraceContext&) const { throw 1; }
    void shadePacket(PacketContext&) const { throw 1; }
};
struct NanRadiance {
    void shade(TraceContext& c) const { c.setRadiance({0, kNan, 0}); }
};
struct InfiniteRadiance {
    void shade(TraceContext& c) const { c.setRadiance({0, 0, -kInf}); }
};
struct NanAlpha {
    void shade(TraceContext& c) const {
        c.setRadiance(Color(0.5f));
        c.setAlpha(kNan);
    }
};
struct NanInPacket {
    static constexpr bool shadesPackets = true;
    template <class Context>
    void shade(Context& c) const {
        c.setRadiance(typename Context::Color(typename Context::Float(kNan)));
    }
};
/// Each of its rays brings what a float holds; two of them bring more.
struct OverflowsInTrace {
    void shade(TraceContext& c) const {
        if (c.depth() > 0) return c.setRadiance(Color(kMax));
        c.setRadiance(c.trace(c.rayOrigin(), c.rayDirection()) +
                      c.trace(c.rayOrigin(), c.rayDirection()));
    }
};

// What follows is odd but yields colours that are numbers.

struct NeverWrites {
    void shade(TraceContext&) const {}
};
/// Meets itself again and again, twice at each point.
struct TracesForever {
    void shade(TraceContext& c) const {
        const Color ahead = c.trace(c.rayOrigin(), c.rayDirection(), 1) +
                            c.trace(c.rayOrigin(), c.rayDirection(), 1);
        c.setRadiance(ahead * 0.5f + Color(0.25f));
    }
};
struct TracesForeverInPackets {
    static constexpr bool shadesPackets = true;
    template <class Context>
    void shade(Context& c) const {
        const typename Context::Color ahead = c.trace(c.rayOrigin(), c.rayDirection());
        c.setRadiance(ahead * 0.5f + typename Context::Color(Color(0.25f)));
    }
};
struct TracesNonsense {
    void shade(TraceContext& c) const {
        const Vec3 bad[] = {{0, 0, 0},    {kNan, 0, 1}, {kInf, 0, 0},        {-kInf, kInf, 1},
                            {kMax, 0, 0}, {0, 1e-45f, 0}, {kNan, kNan, kNan}};
        Color sum;
        for (const Vec3& v : bad) {
            RTShitinfo hit;
            sum += c.trace(c.position(), v) + c.trace(v, {0, 0, 1}) + c.environment(v);
            if (c.traceHit(v, v, hit)) sum += Color(1.0f);
            for (const float distance : {0.0f, -1.0f, 1.0f, kInf, kNan})
                sum += c.shadow(c.position(), v, distance) + c.shadow(v, {0, 0, 1}, distance);
        }
        c.setRadiance(sum);
    }
};
struct StrangeWeights {
    void shade(TraceContext& c) const {
        Color sum;
        for (const float weight : {0.0f, -1.0f, 1e30f, kInf, -kInf, kNan})
            sum += c.trace(c.position(), {0, 0, 1}, weight);
        c.setRadiance(sum);
    }
};
struct AsksAbsentLights {
    void shade(TraceContext& c) const {
        Color sum(0.25f);
        for (const RTuint light : {c.lightCount(), c.lightCount() + 1, 4'000'000'000u, ~0u}) {
            LightSample sample{};
            if (c.illuminate(light, sample)) sum += Color(1.0f);
        }
        c.setRadiance(sum);
    }
};
struct UnknownTextures {
    void shade(TraceContext& c) const {
        float all = 1;
        for (const int id : {0, -1, 12345, std::numeric_limits<int>::max(),
                             std::numeric_limits<int>::min()})
            for (const float at : {0.5f, -kMax, kInf, kNan}) {
                const Vec4 texel = c.texture(TextureId{id}, {at, at});
                if (!(texel == Vec4(1, 1, 1, 1))) all = 0;
            }
        c.setRadiance(Color(all));
    }
};
/// Writes, and asks for, lanes that hold no point.
struct WritesForeignLanes {
    void shade(TraceContext& c) const { c.setRadiance({0.25f, 0.5f, 0.75f}); }
    void shadePacket(PacketContext& c) const {
        RTSpacket& packet = *c.packet();
        const RTuint all = ~0u;
        RTSvectors nowhere;
        RTSfloats one;
        for (int i = 0; i < RTS_PACKET_SIZE; ++i) {
            const bool active = (packet.active >> i & 1) != 0;
            nowhere.x.lane[i] = nowhere.y.lane[i] = nowhere.z.lane[i] = active ? 1.0f : kNan;
            one.lane[i] = active ? 1.0f : kNan;
        }
        RTScolors colors;
        RTShitpacket hits;
        RTSlightpacket light;
        RTSfloats rgba[4];
        packet.functions->trace(&packet, all, &nowhere, &nowhere, &one, &colors);
        packet.functions->traceHit(&packet, all, &nowhere, &nowhere, &hits);
        packet.functions->shadow(&packet, all, &nowhere, &nowhere, &one, &colors);
        packet.functions->illuminate(&packet, all, 0, &light);
        packet.functions->illuminate(&packet, all, 4'000'000'000u, &light);
        packet.functions->texture(&packet, all, 4'000'000'000u, &one, &one, rgba);
        packet.functions->environment(&packet, all, &nowhere, &colors);
        packet.functions->random(&packet, all, &one);
        packet.functions->trace(&packet, 0, &nowhere, &nowhere, &one, &colors);
        for (int i = 0; i < RTS_PACKET_SIZE; ++i) {
            const bool active = (packet.active >> i & 1) != 0;
            for (int k = 0; k < 3; ++k)
                packet.result[k].lane[i] = active ? 0.25f * float(k + 1) : kNan;
            packet.result[3].lane[i] = active ? 1.0f : kNan;
        }
        packet.resultSet = all;
    }
};

} // namespace misbehaving
