// SPDX-License-Identifier: MIT
#pragma once

#include "libsmart/shading/builtin/fresnel.h"
#include "libsmart/shading/builtin/indirect.h"

namespace smart::builtin {

/// A smooth border between the outside, the side of the geometric normal, and glass behind it:
///   radiance = A * (R * (mirrored ray) + (1 - R) * color * (refracted ray))
/// R: Fresnel's reflectance of unpolarised light for `index`, the index of refraction of the glass
/// divided by that outside; 1 in total reflection. The refracted direction follows Snell's law.
/// A = exp(-absorption * d), Beer and Lambert's law, for a ray that travelled the distance d in
/// the glass before it came to its inner side; `absorption` per unit of length and channel.
/// In path tracing one of the two rays, by chance. The factor 1 / index^2 by which radiance
/// shrinks in glass is left out, as is usual where camera and lights are outside.
///
/// Shadow rays go straight on: each surface lets (1 - R) * color pass, R for the angle outside the
/// glass; so light meets the floor behind a pane rightly, but is not focussed, and absorption, for
/// which the way through the glass would have to be known, does not act on it.
struct Glass {
    float index = 1.5f; ///< not above 0: taken as 1
    Color absorption;
    Color color{1.0f};

    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<float>("index", PER_SHADER, offsetof(Glass, index));
        r.registerParam<Color>("absorption", PER_SHADER, offsetof(Glass, absorption));
        r.registerParam<Color>("color", PER_SHADER, offsetof(Glass, color));
    }
    static constexpr RTuint reads() { return READS_FACING_NORMAL | READS_TRACE; }
    static constexpr bool shadesPackets = true;
    template <class Context>
    void shade(Context& c) const {
        using Float = typename Context::Float;
        using PointVec3 = typename Context::Vec3;
        using PointColor = typename Context::Color;
        const PointVec3 normal = c.facingNormal(), side = c.facingGeometricNormal(),
                        incoming = c.rayDirection();
        const Float eta = select(c.frontFace(), Float(1.0f / ratio()), Float(ratio()));
        const Float cosine = min(max(-dot(normal, incoming), Float(0.0f)), Float(1.0f));
        const Fresnel<Float> fresnel(eta, cosine);
        const PointVec3 mirrored = inFrontOf(side, reflect(incoming, normal));
        const PointVec3 refracted = inFrontOf(
            -side, incoming * eta + normal * (eta * cosine - fresnel.transmittedCosine));
        const Float transmitted = 1.0f - fresnel.reflectance;
        const PointColor passed = passedOn(c);
        const typename Context::Condition active = activeOf(c);

        if (c.indirect()) {
            const auto reflects = c.random(active) < fresnel.reflectance;
            c.setRadiance(continuePath(c, select(reflects, mirrored, refracted),
                                       select(reflects, passed, passed * color), active));
            return;
        }
        const PointColor through = passed * color * transmitted;
        const PointColor back = passed * fresnel.reflectance;
        const typename Context::Condition noneBack = back.black(), noneThrough = through.black();
        const auto reflects = active & !noneBack, refracts = active & !noneThrough;
        PointColor sum;
        if (any(reflects)) sum += back * c.trace(c.position(), mirrored, back.largest(), reflects);
        if (any(refracts))
            sum += through * c.trace(c.position(), refracted, through.largest(), refracts);
        c.setRadiance(sum);
    }
    template <class Context>
    Color transparency(Context& c) const {
        const float cosine = dot(c.facingNormal(), c.rayDirection());
        const float outside = cosine < -1 ? 1.0f : cosine < 0 ? -cosine : 0.0f;
        return color * (1 - Fresnel<float>(1 / ratio(), outside).reflectance);
    }

private:
    float ratio() const { return index > 0 ? index : 1.0f; }

    /// Share of light that reaches the ray's origin from here.
    template <class Context>
    typename Context::Color passedOn(Context& c) const {
        using Float = typename Context::Float;
        using PointColor = typename Context::Color;
        if (absorption.black()) return PointColor(Float(1.0f));
        const Float way = c.rayDistance();
        const PointColor left(math::exp(-absorption.r * way), math::exp(-absorption.g * way),
                              math::exp(-absorption.b * way));
        return select(c.frontFace(), PointColor(Float(1.0f)), left);
    }
};

} // namespace smart::builtin
