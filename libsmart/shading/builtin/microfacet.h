// SPDX-License-Identifier: MIT
// GGX surfaces (Walter et al., "Microfacet models for refraction through rough surfaces", 2007)
// with Smith's separable masking, and how much light they reflect.
#pragma once

#include "libsmart/shading/builtin/directions.h"
#include "libsmart/shading/builtin/fresnel.h"
#include "libsmart/shading/builtin/microfacet_albedo_table.h"

namespace smart::builtin {

/// 0 for NaN.
inline float clampToUnit(float x) { return x > 1 ? 1.0f : x > 0 ? x : 0.0f; }
inline Floats clampToUnit(const Floats& x) {
    return forEachLane([](float y) { return clampToUnit(y); }, x);
}

/// What a surface reflects of light from everywhere with Fresnel's factor F = 1 (`white`), and
/// with F = Schlick's weight (`grazing`): the directional albedo for f0 is
/// f0 * (white - grazing) + grazing.
template <class Float>
struct MicrofacetAlbedo {
    Float white, grazing;
};

/// By the table; the error is below 0.003. `cosine` and `roughness` from 0 to 1; less than
/// kLeastRoughness counts as that.
inline MicrofacetAlbedo<float> microfacetAlbedo(float cosine, float roughness) {
    const float mu = clampToUnit(cosine);
    const float rough = roughness > kLeastRoughness ? roughness : kLeastRoughness;
    const float alpha = rough * rough;
    const float y = clampToUnit((rough - kLeastRoughness) / (1 - kLeastRoughness)) *
                    float(kAlbedoRows - 1);
    const float x = clampToUnit(math::log(1 + mu / alpha) / math::log(1 + 1 / alpha)) *
                    float(kAlbedoColumns - 1);
    const int i = y < float(kAlbedoRows - 2) ? int(y) : kAlbedoRows - 2;
    const int j = x < float(kAlbedoColumns - 2) ? int(x) : kAlbedoColumns - 2;
    const float dy = y - float(i), dx = x - float(j);
    const auto interpolated = [&](int k) {
        const auto along = [&](int row) {
            return kAlbedoTable[row][j][k] * (1 - dx) + kAlbedoTable[row][j + 1][k] * dx;
        };
        return along(i) * (1 - dy) + along(i + 1) * dy;
    };
    const float white = interpolated(0);
    const float grazing = interpolated(1) + white * schlickWeight(mu);
    return {white, grazing > 0 ? grazing : 0.0f};
}
inline MicrofacetAlbedo<Floats> microfacetAlbedo(const Floats& cosine, const Floats& roughness) {
    MicrofacetAlbedo<Floats> result;
    for (int lane = 0; lane < kLanes; ++lane) {
        const MicrofacetAlbedo<float> one = microfacetAlbedo(cosine[lane], roughness[lane]);
        result.white[lane] = one.white;
        result.grazing[lane] = one.grazing;
    }
    return result;
}

/// Smith's masking G1 for a direction with a cosine above 0; alpha2 = roughness^4.
template <class Float>
Float smithMasking(const Float& cosine, const Float& alpha2) {
    return 2.0f * cosine / (cosine + sqrt(alpha2 + (1.0f - alpha2) * cosine * cosine));
}

/// pi * D * G / (4 (n.l) (n.v)) for the half vector h. 1 - (n.h)^2 is taken as the square of
/// n x h: no cancellation in the highlight's middle.
template <class V, class Float>
Float microfacetPeak(const V& normal, const V& half, const Float& normalLight,
                     const Float& normalView, const Float& alpha2) {
    const Float normalHalf = dot(normal, half);
    const V sine = cross(normal, half);
    const Float spread = alpha2 * normalHalf * normalHalf + dot(sine, sine);
    const auto masking = [&](const Float& cosine) {
        return 1.0f / (cosine + sqrt(alpha2 + (1.0f - alpha2) * cosine * cosine));
    };
    return alpha2 / (spread * spread) * masking(normalLight) * masking(normalView);
}

/// A normal of the microfacets seen from v (both in the frame whose z is the surface's normal),
/// with the density D G1(v) max(v.h, 0) / v.z. Heitz, "Sampling the GGX distribution of visible
/// normals", Journal of Computer Graphics Techniques 7(4), 2018.
template <class V, class Float>
V visibleNormal(const V& view, const Float& alpha, const Float& u1, const Float& u2) {
    const V stretched = normalize(V(alpha * view.x, alpha * view.y, view.z));
    const Float squared = stretched.x * stretched.x + stretched.y * stretched.y;
    const auto slanted = squared > 0.0f;
    const Float scale = 1.0f / sqrt(select(slanted, squared, Float(1.0f)));
    const V first = select(slanted, V(-stretched.y * scale, stretched.x * scale, Float(0.0f)),
                           V(Float(1.0f), Float(0.0f), Float(0.0f)));
    const V second = cross(stretched, first);
    const Float radius = sqrt(u1), angle = kTwoPi * u2;
    const Float t1 = radius * math::cos(angle);
    const Float blend = 0.5f * (1.0f + stretched.z);
    const Float t2 = (1.0f - blend) * sqrt(max(1.0f - t1 * t1, Float(0.0f))) +
                     blend * (radius * math::sin(angle));
    const Float along = sqrt(max(1.0f - t1 * t1 - t2 * t2, Float(0.0f)));
    const V normal = first * t1 + second * t2 + stretched * along;
    return normalize(V(alpha * normal.x, alpha * normal.y, max(normal.z, Float(0.0f))));
}

} // namespace smart::builtin
