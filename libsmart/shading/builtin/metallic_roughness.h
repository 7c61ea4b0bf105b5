// SPDX-License-Identifier: MIT
#pragma once

#include "libsmart/shading/builtin/indirect.h"
#include "libsmart/shading/builtin/microfacet.h"
#include "libsmart/shading/builtin/surfaces.h"

namespace smart::builtin {

/// The metallic-roughness material of glTF 2.0 (appendix B: a mixture by `metallic` of a metal and
/// of a diffuse surface under a dielectric layer; GGX, Smith's separable masking, Schlick's
/// Fresnel term), times pi: as for the other built-in surfaces a white diffuse surface that faces
/// a light shows the radiance that arrives. Lights cast shadows.
///
/// It keeps energy, which glTF's formulas lose by leaving out light that microfacets reflect more
/// than once. With E, the share of light that one reflection keeps (microfacet_albedo_table.h):
///   specular lobe  D G F / (4 (n.l) (n.v)) * (1 + f0 (1 / E - 1))
///                  (Turquin, "Practical multiple scattering compensation for microfacet models",
///                  2019)
///   diffuse lobe   baseColor / pi * (1 - share of light that the dielectric's specular lobe takes)
///                  in the place of 1 - F.
///
/// Light from the surroundings: in path tracing one ray, in the direction of the specular lobe (by
/// visible normals) or of the diffuse one, by chance. Otherwise the environment adds, unshadowed,
/// diffuse * environment(n) + (share of the specular lobe) * environment(r); r is the mirrored
/// direction. The smoother a metal, the more of environment(r) is replaced by what a mirrored ray
/// sees: by the share metallic * (1 - roughness / kMirrorRoughness).
/// The current colour multiplies baseColor, as glTF's vertex colours do. Unlit, as glTF's
/// KHR_materials_unlit has it, the surface shows that product and nothing else.
struct MetallicRoughness {
    enum AlphaMode { Opaque = 0, Mask = 1, Blend = 2 };
    static constexpr float kMirrorRoughness = 0.3f;
    static constexpr float kDielectricF0 = 0.04f;

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
    bool unlit = false;

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
        r.registerParam<bool>("unlit", PER_SHADER, offsetof(Self, unlit));
    }

    RTuint reads() const {
        return kReadsLit | READS_COLOR | readsTexture(baseColorTexture) |
               readsTexture(metallicRoughnessTexture) | readsTexture(emissiveTexture);
    }
    static constexpr bool shadesPackets = true;
    template <class Context>
    void shade(Context& c) const {
        using Float = typename Context::Float;
        using Condition = typename Context::Condition;
        const auto base = baseAt(c);
        const Float coverage = coverageOf<Float>(base.w);
        Condition through = coverage <= 0.0f;
        if (!doubleSided)
            through = through | (dot(c.shadingNormal(), c.facingGeometricNormal()) < 0.0f);
        const Condition solid = activeOf(c) & !through;
        typename Context::Color radiance;
        if (unlit)
            radiance = colorOf(base) * coverage;
        else if (any(solid))
            radiance = (reflected(c, base, solid) + emission(c)) * coverage;
        radiance = select(solid, radiance, typename Context::Color());
        const Condition seen = activeOf(c) & (through | (coverage < 1.0f));
        if (any(seen)) {
            const Float share = select(through, Float(1.0f), 1.0f - coverage);
            const auto behind = c.trace(c.position(), c.rayDirection(), share, seen);
            radiance = select(seen, radiance + behind * share, radiance);
        }
        c.setRadiance(radiance);
    }
    bool opaque() const { return alphaMode != Mask && alphaMode != Blend; }
    template <class Context>
    Color transparency(Context& c) const {
        if (opaque()) return {};
        return Color(1 - coverageOf<float>(baseAt(c).w));
    }

private:
    /// The surface at the shaded points.
    template <class Context>
    struct Surface {
        typename Context::Vec3 normal, view;
        typename Context::Color base;
        typename Context::Float metal, rough, alpha, alpha2; ///< alpha: roughness squared
        typename Context::Float normalView;
        /// Share of light that the specular lobes take, over what one reflection keeps of it.
        typename Context::Float dielectricGain;
        typename Context::Color metalGain;
        typename Context::Color specularAlbedo, diffuseAlbedo;
    };

    template <class Float>
    Float coverageOf(const Float& alpha) const {
        if (alphaMode == Mask) return select(alpha < alphaCutoff, Float(0.0f), Float(1.0f));
        return alphaMode == Blend ? clampToUnit(alpha) : Float(1.0f);
    }
    template <class Context>
    typename Context::Vec4 baseAt(Context& c) const {
        const auto color = c.color();
        typename Context::Vec4 base{baseColor.x * color.r, baseColor.y * color.g,
                                    baseColor.z * color.b, baseColor.w * c.alpha()};
        if (baseColorTexture) {
            const auto texel = c.texture(baseColorTexture, c.texCoord());
            base = {base.x * texel.x, base.y * texel.y, base.z * texel.z, base.w * texel.w};
        }
        return base;
    }
    template <class Context>
    typename Context::Color emission(Context& c) const {
        if (!emissiveTexture || emissive.black()) return emissive;
        return emissive * colorOf(c.texture(emissiveTexture, c.texCoord()));
    }

    template <class Context>
    Surface<Context> surfaceAt(Context& c, const typename Context::Vec4& base) const {
        using Float = typename Context::Float;
        using PointColor = typename Context::Color;
        Float metal = metallic, rough = roughness;
        if (metallicRoughnessTexture) {
            const auto texel = c.texture(metallicRoughnessTexture, c.texCoord());
            rough = rough * texel.y;
            metal = metal * texel.z;
        }
        Surface<Context> s;
        s.metal = clampToUnit(metal);
        s.rough = clampToUnit(rough);
        s.normal = c.facingNormal();
        s.view = -c.rayDirection();
        s.base = colorOf(base);
        const Float least = max(s.rough, Float(kLeastRoughness));
        s.alpha = least * least;
        s.alpha2 = s.alpha * s.alpha;
        s.normalView = clampToUnit(dot(s.normal, s.view));
        const auto albedo = microfacetAlbedo(s.normalView, s.rough);
        const Float lost = 1.0f / albedo.white - 1.0f;
        s.dielectricGain = 1.0f + kDielectricF0 * lost;
        s.metalGain = PointColor(Float(1.0f)) + s.base * lost;
        const Float once = albedo.white - albedo.grazing;
        const Float dielectric = (kDielectricF0 * once + albedo.grazing) * s.dielectricGain;
        const PointColor metalAlbedo =
            (s.base * once + PointColor(albedo.grazing)) * s.metalGain;
        s.specularAlbedo = PointColor(dielectric * (1.0f - s.metal)) + metalAlbedo * s.metal;
        s.diffuseAlbedo = s.base * ((1.0f - s.metal) * (1.0f - dielectric));
        return s;
    }

    template <class Context>
    typename Context::Color reflected(Context& c, const typename Context::Vec4& base,
                                      typename Context::Condition wanted) const {
        using PointColor = typename Context::Color;
        const Surface<Context> s = surfaceAt(c, base);
        PointColor sum;
        forEachLight(c, s.normal, wanted, [&](const auto& light, const auto& cosine, auto lit) {
            const PointColor arriving = light.radiance * visibility(c, light, lit);
            lit = lit & !arriving.black();
            if (any(lit))
                sum = select(lit, sum + brdf(s, light.direction, cosine) * arriving * cosine, sum);
        });
        return sum + (c.indirect() ? bounce(c, s, wanted) : fromEnvironment(c, s, wanted));
    }

    /// Fresnel's factor of both specular lobes, with what further reflections add.
    template <class Context>
    static typename Context::Color fresnel(const Surface<Context>& s,
                                           const typename Context::Float& viewHalf) {
        using PointColor = typename Context::Color;
        const auto weight = schlickWeight(clampToUnit(viewHalf));
        const auto dielectric = (kDielectricF0 + (1.0f - kDielectricF0) * weight) *
                                s.dielectricGain * (1.0f - s.metal);
        const PointColor metal =
            (s.base * (1.0f - weight) + PointColor(weight)) * s.metalGain * s.metal;
        return PointColor(dielectric) + metal;
    }

    /// The BRDF times pi.
    template <class Context>
    static typename Context::Color brdf(const Surface<Context>& s,
                                        const typename Context::Vec3& light,
                                        const typename Context::Float& normalLight) {
        const auto half = normalize(s.view + light);
        return s.diffuseAlbedo +
               fresnel(s, dot(s.view, half)) *
                   microfacetPeak(s.normal, half, normalLight, s.normalView, s.alpha2);
    }

    template <class Context>
    typename Context::Color bounce(Context& c, const Surface<Context>& s,
                                   typename Context::Condition wanted) const {
        using Float = typename Context::Float;
        using PointVec3 = typename Context::Vec3;
        using PointColor = typename Context::Color;
        const Float u0 = c.random(wanted), u1 = c.random(wanted), u2 = c.random(wanted);
        const Float specular = s.specularAlbedo.largest();
        const Float probability = clampToUnit(specular / (specular + s.diffuseAlbedo.largest()));
        const auto glossy = u0 < probability;

        const Basis<PointVec3> frame(s.normal);
        PointVec3 view = frame.toLocal(s.view);
        view.z = max(view.z, Float(0.0f)); // shading normals may lie behind the ray
        const PointVec3 half = visibleNormal(normalize(view), s.alpha, u1, u2);
        const PointVec3 mirrored = reflect(-view, half);
        const PointColor mirroredShare =
            fresnel(s, dot(view, half)) * (smithMasking(mirrored.z, s.alpha2) / probability);
        const auto scattered = glossy & (mirrored.z > 0.0f);
        const PointColor throughput =
            select(scattered, mirroredShare,
                   select(glossy, PointColor(), s.diffuseAlbedo / (1.0f - probability)));
        const PointVec3 direction =
            select(glossy, frame.toWorld(mirrored), cosineDirection(s.normal, u1, u2));
        return continuePath(c, inFrontOf(c.facingGeometricNormal(), direction), throughput,
                            wanted);
    }

    template <class Context>
    typename Context::Color fromEnvironment(Context& c, const Surface<Context>& s,
                                            typename Context::Condition wanted) const {
        using Float = typename Context::Float;
        using PointColor = typename Context::Color;
        const auto mirrored = inFrontOf(c.facingGeometricNormal(), reflect(-s.view, s.normal));
        const Float mirror = s.metal * clampToUnit(1.0f - s.rough / kMirrorRoughness);
        const auto smooth = wanted & (mirror > 0.0f);
        PointColor seen = c.environment(mirrored, wanted & (mirror < 1.0f)) * (1.0f - mirror);
        if (any(smooth))
            seen += c.trace(c.position(), mirrored, mirror * s.specularAlbedo.largest(), smooth) *
                    mirror;
        return s.specularAlbedo * seen +
               s.diffuseAlbedo *
                   c.environment(s.normal, wanted & !s.diffuseAlbedo.black());
    }
};

} // namespace smart::builtin
