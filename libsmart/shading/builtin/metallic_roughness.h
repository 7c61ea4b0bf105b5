// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "libsmart/shading/builtin/surfaces.h"

namespace smart::builtin {

/// The metallic-roughness material of glTF 2.0, with its BRDF (appendix B: Lambert, GGX, Smith's
/// separable visibility, Schlick's Fresnel term; Walter et al. 2007). As for the other built-in
/// surfaces a white diffuse surface that faces a light shows the radiance that arrives: the BRDF
/// is multiplied by pi. Lights cast shadows.
///
/// The environment adds, unshadowed, diffuse * environment(n) + F * environment(r); r is the
/// mirrored direction. The smoother a metal, the more of environment(r) is replaced by what a
/// mirrored ray sees: by the share metallic * (1 - roughness / kMirrorRoughness).
/// The current colour multiplies baseColor, as glTF's vertex colours do.
struct MetallicRoughness {
    enum AlphaMode { Opaque = 0, Mask = 1, Blend = 2 };
    static constexpr float kMirrorRoughness = 0.3f;
    static constexpr float kLeastRoughness = 0.04f; ///< keeps a point light's highlight finite

    Vec4 baseColor{1, 1, 1, 1};
    float metallic = 1;
    float roughness = 1;
    Color emissive;
    TextureId baseColorTexture;
    TextureId metallicRoughnessTexture; ///< green: roughness, blue: metallic
    TextureId emissiveTexture;
    int alphaMode = Opaque;
    float alphaCutoff = 0.5f;
    /// false: camera and other shaded rays pass through where they come from behind the shading
    /// normal. Both sides cast shadows.
    bool doubleSided = true;

    void registerParams(const ShaderRegistrator& r) const {
        using Self = MetallicRoughness;
        r.registerParam<Vec4>("baseColor", PER_SHADER, offsetof(Self, baseColor));
        r.registerParam<float>("metallic", PER_SHADER, offsetof(Self, metallic));
        r.registerParam<float>("roughness", PER_SHADER, offsetof(Self, roughness));
        r.registerParam<Color>("emissive", PER_SHADER, offsetof(Self, emissive));
        r.registerParam<TextureId>("baseColorTexture", PER_SHADER,
                                   offsetof(Self, baseColorTexture));
        r.registerParam<TextureId>("metallicRoughnessTexture", PER_SHADER,
                                   offsetof(Self, metallicRoughnessTexture));
        r.registerParam<TextureId>("emissiveTexture", PER_SHADER, offsetof(Self, emissiveTexture));
        r.registerParam<int>("alphaMode", PER_SHADER, offsetof(Self, alphaMode));
        r.registerParam<float>("alphaCutoff", PER_SHADER, offsetof(Self, alphaCutoff));
        r.registerParam<bool>("doubleSided", PER_SHADER, offsetof(Self, doubleSided));
    }

    template <class Context>
    void shade(Context& c) const {
        const Vec4 base = baseAt(c);
        const float coverage = coverageOf(base.w);
        const bool culled =
            !doubleSided && dot(c.shadingNormal(), c.facingGeometricNormal()) < 0;
        if (culled || coverage <= 0) {
            c.setRadiance(c.trace(c.position(), c.rayDirection()));
            return;
        }
        Color radiance = reflected(c, base) + emission(c);
        if (coverage < 1)
            radiance = radiance * coverage +
                       c.trace(c.position(), c.rayDirection(), 1 - coverage) * (1 - coverage);
        c.setRadiance(radiance);
    }
    template <class Context>
    Color transparency(Context& c) const {
        if (alphaMode != Mask && alphaMode != Blend) return {};
        return Color(1 - coverageOf(baseAt(c).w));
    }

private:
    struct Point {
        Vec3 normal, view;
        Color diffuse, f0;
        float alpha, normalView; ///< alpha: roughness squared
    };

    static float clamped(float x) { return x > 1 ? 1.0f : x > 0 ? x : 0.0f; }
    static float fifthPower(float x) { return x * x * x * x * x; }

    float coverageOf(float alpha) const {
        if (alphaMode == Mask) return alpha < alphaCutoff ? 0.0f : 1.0f;
        return alphaMode == Blend ? clamped(alpha) : 1.0f;
    }
    template <class Context>
    Vec4 baseAt(Context& c) const {
        const Color color = c.color();
        Vec4 base{baseColor.x * color.r, baseColor.y * color.g, baseColor.z * color.b,
                  baseColor.w * c.alpha()};
        if (baseColorTexture) {
            const Vec4 texel = c.texture(baseColorTexture, c.texCoord());
            base = {base.x * texel.x, base.y * texel.y, base.z * texel.z, base.w * texel.w};
        }
        return base;
    }
    template <class Context>
    Color emission(Context& c) const {
        if (!emissiveTexture || emissive.black()) return emissive;
        return emissive * colorOf(c.texture(emissiveTexture, c.texCoord()));
    }

    template <class Context>
    Color reflected(Context& c, const Vec4& base) const {
        float metal = metallic, rough = roughness;
        if (metallicRoughnessTexture) {
            const Vec4 texel = c.texture(metallicRoughnessTexture, c.texCoord());
            rough *= texel.y;
            metal *= texel.z;
        }
        metal = clamped(metal);
        rough = clamped(rough);
        const float least = rough > kLeastRoughness ? rough : kLeastRoughness;
        Point p;
        p.normal = c.facingNormal();
        p.view = -c.rayDirection();
        p.diffuse = colorOf(base) * (1 - metal);
        p.f0 = Color(0.04f) * (1 - metal) + colorOf(base) * metal;
        p.alpha = least * least;
        p.normalView = clamped(dot(p.normal, p.view));

        Color sum = fromEnvironment(c, p, metal, rough);
        forEachLight(c, p.normal, [&](const LightSample& light, float cosine, bool lit) {
            const Color arriving = light.radiance * visibility(c, light, lit);
            if (!arriving.black()) sum += brdf(p, light.direction, cosine) * arriving * cosine;
        });
        return sum;
    }

    /// glTF's BRDF times pi.
    static Color brdf(const Point& p, const Vec3& light, float normalLight) {
        const Vec3 half = normalize(p.view + light);
        const Color fresnel =
            p.f0 + (Color(1.0f) - p.f0) * fifthPower(1 - clamped(dot(p.view, half)));
        // 1 - (n.h)^2 as the square of n x h: no cancellation in the highlight's middle.
        const float normalHalf = dot(p.normal, half);
        const Vec3 sine = cross(p.normal, half);
        const float a2 = p.alpha * p.alpha;
        const float spread = a2 * normalHalf * normalHalf + dot(sine, sine);
        const auto masking = [&](float cosine) {
            return 1 / (cosine + std::sqrt(a2 + (1 - a2) * cosine * cosine));
        };
        const float specular =
            a2 / (spread * spread) * masking(normalLight) * masking(p.normalView);
        return (Color(1.0f) - fresnel) * p.diffuse + fresnel * specular;
    }

    template <class Context>
    Color fromEnvironment(Context& c, const Point& p, float metal, float rough) const {
        const Vec3 mirrored = reflect(-p.view, p.normal);
        const float grazing = 1 - rough;
        const auto schlick = [&](float f0) {
            return f0 + ((grazing > f0 ? grazing : f0) - f0) * fifthPower(1 - p.normalView);
        };
        const Color fresnel{schlick(p.f0.r), schlick(p.f0.g), schlick(p.f0.b)};
        const float mirror = metal * clamped(1 - rough / kMirrorRoughness);
        Color seen;
        if (mirror < 1) seen += c.environment(mirrored) * (1 - mirror);
        if (mirror > 0)
            seen += c.trace(c.position(), mirrored, mirror * fresnel.largest()) * mirror;
        Color sum = fresnel * seen;
        if (!p.diffuse.black()) sum += p.diffuse * c.environment(p.normal);
        return sum;
    }
};

} // namespace smart::builtin
