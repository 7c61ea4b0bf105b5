// SPDX-License-Identifier: MIT
// Built-in surfaces with the names of SMART (2009), and Phong. Each formula gives the radiance
// towards the ray's origin at a point with normal n (length 1, on the ray's side); sums go over
// the lights, l being the direction to one and L the radiance that arrives from it. `shade` serves
// points and packets alike, with the same bits.
#pragma once

#include <utility>

#include "libsmart/shading/builtin/indirect.h"

namespace smart::builtin {

using namespace openrt;

/// Calls contribution(sample, n.l, lit) for each light that is in front of a surface with normal
/// n, or of some of the wanted points of a packet: those that are `lit`.
template <class Context, class Contribution>
void forEachLight(Context& c, const typename Context::Vec3& normal,
                  typename Context::Condition wanted, Contribution&& contribution) {
    const RTuint count = c.lightCount();
    for (RTuint i = 0; i < count; ++i) {
        typename Context::LightSample sample{};
        typename Context::Condition lit = c.illuminate(i, sample, wanted);
        const auto cosine = dot(normal, sample.direction);
        lit = lit & (cosine > 0.0f);
        if (any(lit)) contribution(sample, cosine, lit);
    }
}

template <class Context, class Contribution>
void forEachLight(Context& c, const typename Context::Vec3& normal, Contribution&& contribution) {
    forEachLight(c, normal, activeOf(c), std::forward<Contribution>(contribution));
}

/// Share of a light that arrives, where it is asked for. Behind the triangle's plane none does,
/// whatever the shading normal says: the surface itself is in between.
template <class Context>
auto visibility(Context& c, const typename Context::LightSample& sample,
                const typename Context::Condition& wanted) {
    const auto inFront = dot(c.facingGeometricNormal(), sample.direction) > 0.0f;
    return c.shadow(c.position(), sample.direction, sample.distance, wanted & inFront);
}

inline Color colorOf(const Vec4& rgba) { return {rgba.x, rgba.y, rgba.z}; }
inline PacketColor colorOf(const PacketVec4& rgba) { return {rgba.x, rgba.y, rgba.z}; }

/// What the members of a surface read (see shader.hpp) that shade by the side that is seen, ask
/// lights and trace rays.
inline constexpr RTuint kReadsLit = READS_FACING_NORMAL | READS_LIGHTS | READS_TRACE;

/// What it takes to look up a texture.
constexpr RTuint readsTexture(const TextureId& texture) {
    return texture ? READS_TEXTURE | READS_TEXCOORD : 0;
}

/// The default surface: the current colour, unlit.
struct FixedFunction {
    static constexpr RTuint reads() { return READS_COLOR; }
    static constexpr bool shadesPackets = true;
    template <class Context>
    void shade(Context& c) const {
        c.setRadiance(c.color());
        c.setAlpha(c.alpha());
    }
};

/// value
struct ConstantShader {
    Color value{1.0f};

    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<Color>("value", PER_SHADER, offsetof(ConstantShader, value));
    }
    static constexpr RTuint reads() { return 0; }
    static constexpr bool shadesPackets = true;
    template <class Context>
    void shade(Context& c) const {
        c.setRadiance(value);
    }
};

/// sum of color * (n.l) * L, without shadows; in path tracing also color * (indirect light)
struct DiffuseShader {
    Color color{1.0f};

    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<Color>("color", PER_SHADER, offsetof(DiffuseShader, color));
    }
    static constexpr RTuint reads() { return kReadsLit; }
    static constexpr bool shadesPackets = true;
    template <class Context>
    void shade(Context& c) const {
        typename Context::Color sum;
        forEachLight(c, c.facingNormal(), [&](const auto& light, const auto& cosine, auto lit) {
            sum = select(lit, sum + color * light.radiance * cosine, sum);
        });
        if (c.indirect()) sum += diffuseBounce(c, c.facingNormal(), color, activeOf(c));
        c.setRadiance(sum);
    }
};

/// texture * (radiance + sum of (n.l) * L), without shadows; in path tracing indirect light stands
/// in the place of `radiance`
struct TexturedDiffuseShader {
    TextureId texture;
    Color radiance; ///< ambient

    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<TextureId>("texture", PER_SHADER, offsetof(TexturedDiffuseShader, texture));
        r.registerParam<Color>("radiance", PER_SHADER, offsetof(TexturedDiffuseShader, radiance));
    }
    RTuint reads() const { return kReadsLit | readsTexture(texture); }
    static constexpr bool shadesPackets = true;
    template <class Context>
    void shade(Context& c) const {
        const typename Context::Color texel = colorOf(c.texture(texture, c.texCoord()));
        typename Context::Color sum;
        if (!c.indirect()) sum = radiance;
        forEachLight(c, c.facingNormal(), [&](const auto& light, const auto& cosine, auto lit) {
            sum = select(lit, sum + light.radiance * cosine, sum);
        });
        sum = texel * sum;
        if (c.indirect()) sum += diffuseBounce(c, c.facingNormal(), texel, activeOf(c));
        c.setRadiance(sum);
    }
};

/// texture, with its alpha
struct TextureShader {
    TextureId texture;

    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<TextureId>("texture", PER_SHADER, offsetof(TextureShader, texture));
    }
    RTuint reads() const { return readsTexture(texture); }
    static constexpr bool shadesPackets = true;
    template <class Context>
    void shade(Context& c) const {
        const auto texel = c.texture(texture, c.texCoord());
        c.setRadiance(colorOf(texel));
        c.setAlpha(texel.w);
    }
};

/// The mirrored direction, on the side of the triangle that the ray came from.
template <class Context>
typename Context::Vec3 mirroredInFront(const Context& c) {
    return inFrontOf(c.facingGeometricNormal(), c.reflectedDirection());
}

/// attenuation * what the mirrored ray sees
struct MirrorShader {
    Color attenuation{1.0f};

    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<Color>("attenuation", PER_SHADER, offsetof(MirrorShader, attenuation));
    }
    static constexpr RTuint reads() { return READS_REFLECTION | READS_TRACE; }
    static constexpr bool shadesPackets = true;
    template <class Context>
    void shade(Context& c) const {
        c.setRadiance(attenuation *
                      c.trace(c.position(), mirroredInFront(c), attenuation.largest()));
    }
};

/// emissive + texture * ambient
///   + sum of visibility * L * (texture * diffuse * (n.l) + specular * max(r.l, 0)^shininess)
///   + reflection * (mirrored ray) + transmission * (ray straight on);
/// r is the mirrored direction. Shadow rays are attenuated by `transmission`.
/// In path tracing texture * diffuse * (indirect light) stands in the place of texture * ambient;
/// the highlight, which follows no law of physics, reflects lights only.
struct Phong {
    Color ambient, diffuse{0.8f}, specular, emissive;
    float shininess = 32;
    Color reflection, transmission;
    TextureId texture;

    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<Color>("ambient", PER_SHADER, offsetof(Phong, ambient));
        r.registerParam<Color>("diffuse", PER_SHADER, offsetof(Phong, diffuse));
        r.registerParam<Color>("specular", PER_SHADER, offsetof(Phong, specular));
        r.registerParam<Color>("emissive", PER_SHADER, offsetof(Phong, emissive));
        r.registerParam<float>("shininess", PER_SHADER, offsetof(Phong, shininess));
        r.registerParam<Color>("reflection", PER_SHADER, offsetof(Phong, reflection));
        r.registerParam<Color>("transmission", PER_SHADER, offsetof(Phong, transmission));
        r.registerParam<TextureId>("texture", PER_SHADER, offsetof(Phong, texture));
    }
    RTuint reads() const { return kReadsLit | readsTexture(texture); }
    static constexpr bool shadesPackets = true;
    template <class Context>
    void shade(Context& c) const {
        using PointColor = typename Context::Color;
        const auto normal = c.facingNormal();
        const auto mirrored =
            specular.black() ? typename Context::Vec3() : c.reflectedDirection();
        const PointColor texel = texture ? PointColor(colorOf(c.texture(texture, c.texCoord())))
                                         : PointColor(Color(1.0f));
        const PointColor surface = texel * diffuse;
        PointColor sum = emissive;
        sum += c.indirect() ? diffuseBounce(c, normal, surface, activeOf(c)) : texel * ambient;
        forEachLight(c, normal, [&](const auto& light, const auto& cosine, auto lit) {
            PointColor reflected = surface * cosine;
            if (!specular.black()) {
                const auto highlight = dot(mirrored, light.direction);
                const auto shines = lit & (highlight > 0.0f);
                if (any(shines))
                    reflected = select(
                        shines, reflected + specular * math::pow(highlight, shininess), reflected);
            }
            lit = lit & !reflected.black();
            if (any(lit))
                sum = select(lit, sum + reflected * light.radiance * visibility(c, light, lit),
                             sum);
        });
        if (!reflection.black())
            sum += reflection * c.trace(c.position(), mirroredInFront(c), reflection.largest());
        if (!transmission.black())
            sum += transmission * c.trace(c.position(), c.rayDirection(), transmission.largest());
        c.setRadiance(sum);
    }
    bool opaque() const { return transmission.black(); }
    template <class Context>
    Color transparency(Context&) const {
        return transmission;
    }
};

} // namespace smart::builtin
