// SPDX-License-Identifier: MIT
// Surfaces that shade packets, one of them as it should; the others give something else than for a
// point, each in another way.
#include <openrt/plugin.hpp>

#include <cmath>

namespace {

using namespace openrt;

/// Asks everything that there is to ask.
struct Honest {
    float scale = 0.7f;
    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<float>("scale", PER_SHADER, offsetof(Honest, scale));
    }
    static constexpr bool shadesPackets = true;
    template <class Context>
    void shade(Context& c) const {
        typename Context::Color sum = c.color() * scale;
        for (RTuint i = 0; i < c.lightCount(); ++i) {
            typename Context::LightSample light{};
            auto lit = c.illuminate(i, light);
            const auto cosine = dot(c.facingNormal(), light.direction);
            lit = lit & (cosine > 0.0f);
            if (!any(lit)) continue;
            const auto open = c.shadow(c.position(), light.direction, light.distance, lit);
            sum = select(lit, sum + light.radiance * open * cosine, sum);
        }
        const auto texel = c.texture(TextureId{2}, c.texCoord());
        const auto dull = c.random() < 0.5f;
        const auto mirrored = c.trace(c.position(), c.reflectedDirection(), 0.5f, dull);
        const auto around = c.environment(c.facingNormal());
        sum = sum * texel.x + mirrored * 0.5f + around * c.random();
        c.setRadiance(sum);
        c.setAlpha(texel.w);
    }
};

struct Ulp {
    void shade(TraceContext& c) const { c.setRadiance(c.color()); }
    void shadePacket(PacketContext& c) const {
        PacketColor color = c.color();
        color.g[9] = std::nextafter(color.g[9], 2.0f);
        c.setRadiance(color);
    }
};

struct Silent {
    void shade(TraceContext& c) const { c.setRadiance({}); }
    void shadePacket(PacketContext&) const {}
};

struct Unstable {
    void shade(TraceContext& c) const { c.setRadiance(Color(1)); }
    void shadePacket(PacketContext&) const { throw 1; }
};

/// Draws for all lanes what the point draws under a condition.
struct Gambler {
    void shade(TraceContext& c) const {
        float number = 0.5f;
        if (c.color().r < 0.5f) number = c.random();
        c.setRadiance(Color(number * c.random()));
    }
    void shadePacket(PacketContext& c) const {
        const auto dark = c.color().r < 0.5f;
        const auto drawn = c.random();
        const auto second = c.random();
        const auto value = select(dark, drawn, Floats(0.5f)) * second;
        c.setRadiance({value, value, value});
    }
};

OPENRT_PLUGIN(Honest, "Honest")
OPENRT_PLUGIN(Ulp, "Ulp")
OPENRT_PLUGIN(Silent, "Silent")
OPENRT_PLUGIN(Unstable, "Unstable")
OPENRT_PLUGIN(Gambler, "Gambler")

} // namespace
