// SPDX-License-Identifier: MIT
// Built-in surfaces with the names of SMART (2009), and Phong. Each formula gives the radiance
// towards the ray's origin at a point with normal n (length 1, on the ray's side); sums go over
// the lights, l being the direction to one and L the radiance that arrives from it.
#pragma once

#include "libsmart/base/transcendental.h"
#include "openrt/shader.hpp"

namespace smart::builtin {

using namespace openrt;

/// Calls contribution(sample, n.l) for each light in front of a surface with normal n.
template <class Context, class Contribution>
void forEachLight(Context& c, const Vec3& normal, Contribution&& contribution) {
    const RTuint count = c.lightCount();
    for (RTuint i = 0; i < count; ++i) {
        LightSample sample{};
        if (!c.illuminate(i, sample)) continue;
        const float cosine = dot(normal, sample.direction);
        if (cosine > 0) contribution(sample, cosine);
    }
}

/// Share of a light that arrives. Behind the triangle's plane none does, whatever the shading
/// normal says: the surface itself is in between.
template <class Context>
Color visibility(Context& c, const LightSample& sample) {
    if (!(dot(c.facingGeometricNormal(), sample.direction) > 0)) return {};
    return c.shadow(c.position(), sample.direction, sample.distance);
}

inline Color colorOf(const Vec4& rgba) { return {rgba.x, rgba.y, rgba.z}; }

/// The default surface: the current colour, unlit.
struct FixedFunction {
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
    template <class Context>
    void shade(Context& c) const {
        c.setRadiance(value);
    }
};

/// sum of color * (n.l) * L, without shadows
struct DiffuseShader {
    Color color{1.0f};

    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<Color>("color", PER_SHADER, offsetof(DiffuseShader, color));
    }
    template <class Context>
    void shade(Context& c) const {
        Color sum;
        forEachLight(c, c.facingNormal(), [&](const LightSample& light, float cosine) {
            sum += color * light.radiance * cosine;
        });
        c.setRadiance(sum);
    }
};

/// texture * (radiance + sum of (n.l) * L), without shadows
struct TexturedDiffuseShader {
    TextureId texture;
    Color radiance; ///< ambient

    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<TextureId>("texture", PER_SHADER, offsetof(TexturedDiffuseShader, texture));
        r.registerParam<Color>("radiance", PER_SHADER, offsetof(TexturedDiffuseShader, radiance));
    }
    template <class Context>
    void shade(Context& c) const {
        Color sum = radiance;
        forEachLight(c, c.facingNormal(), [&](const LightSample& light, float cosine) {
            sum += light.radiance * cosine;
        });
        c.setRadiance(colorOf(c.texture(texture, c.texCoord())) * sum);
    }
};

/// texture, with its alpha
struct TextureShader {
    TextureId texture;

    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<TextureId>("texture", PER_SHADER, offsetof(TextureShader, texture));
    }
    template <class Context>
    void shade(Context& c) const {
        const Vec4 texel = c.texture(texture, c.texCoord());
        c.setRadiance(colorOf(texel));
        c.setAlpha(texel.w);
    }
};

/// attenuation * what the mirrored ray sees
struct MirrorShader {
    Color attenuation{1.0f};

    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<Color>("attenuation", PER_SHADER, offsetof(MirrorShader, attenuation));
    }
    template <class Context>
    void shade(Context& c) const {
        c.setRadiance(attenuation *
                      c.trace(c.position(), c.reflectedDirection(), attenuation.largest()));
    }
};

/// emissive + texture * ambient
///   + sum of visibility * L * (texture * diffuse * (n.l) + specular * max(r.l, 0)^shininess)
///   + reflection * (mirrored ray) + transmission * (ray straight on);
/// r is the mirrored direction. Shadow rays are attenuated by `transmission`.
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
    template <class Context>
    void shade(Context& c) const {
        const Vec3 normal = c.facingNormal(), mirrored = c.reflectedDirection();
        const Color texel = texture ? colorOf(c.texture(texture, c.texCoord())) : Color(1.0f);
        const Color surface = texel * diffuse;
        Color sum = emissive + texel * ambient;
        forEachLight(c, normal, [&](const LightSample& light, float cosine) {
            Color reflected = surface * cosine;
            const float highlight = dot(mirrored, light.direction);
            if (highlight > 0 && !specular.black())
                reflected += specular * math::pow(highlight, shininess);
            if (!reflected.black()) sum += reflected * light.radiance * visibility(c, light);
        });
        if (!reflection.black())
            sum += reflection * c.trace(c.position(), mirrored, reflection.largest());
        if (!transmission.black())
            sum += transmission * c.trace(c.position(), c.rayDirection(), transmission.largest());
        c.setRadiance(sum);
    }
    template <class Context>
    Color transparency(Context&) const {
        return transmission;
    }
};

} // namespace smart::builtin
