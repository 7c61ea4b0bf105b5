// SPDX-License-Identifier: MIT
// Light that comes from other surfaces and the environment, one random ray a point: what surfaces
// add where RTS_INDIRECT asks for it (path tracing; Kajiya, "The rendering equation", 1986).
#pragma once

#include "libsmart/shading/builtin/directions.h"

namespace smart::builtin {

/// The points that a context holds.
template <class Calls>
bool activeOf(const BasicTraceContext<Calls>&) {
    return true;
}
template <class Calls>
Mask activeOf(const BasicPacketContext<Calls>& c) {
    return c.active();
}

/// Paths with a smaller share of the pixel are ended by chance.
inline constexpr float kRouletteShare = 0.25f;

/// throughput * radiance along a ray from the shaded point. Russian roulette (Arvo and Kirk,
/// "Particle transport and image synthesis", 1990): a path whose share of the pixel falls below
/// kRouletteShare, or below the point's where that is less already, goes on with the probability
/// share / (that limit) and then counts as much more. So a weight cut-off up to kRouletteShare,
/// which would darken the picture, does not act on such rays.
template <class Context>
typename Context::Color continuePath(Context& c, const typename Context::Vec3& direction,
                                     const typename Context::Color& throughput,
                                     typename Context::Condition wanted) {
    using Float = typename Context::Float;
    using Condition = typename Context::Condition;
    const Condition active = activeOf(c), black = throughput.black();
    wanted = wanted & active & !black;
    if (!any(wanted)) return {};
    const Float largest = min(throughput.largest(), Float(1.0f));
    const Float share = largest * c.weight(), least = min(Float(kRouletteShare), c.weight());
    const Condition risky = wanted & (share < least);
    const Float survival = select(risky, share / least, Float(1.0f));
    const Float number = c.random(risky);
    const Condition alive = wanted & !(risky & (number >= survival));
    const Float weight = select(risky, least / c.weight(), largest);
    const typename Context::Color radiance = c.trace(c.position(), direction, weight, alive);
    return select(alive, throughput * radiance / survival, typename Context::Color());
}

/// What a diffuse surface of an albedo reflects from one direction, chosen by the cosine.
template <class Context>
typename Context::Color diffuseBounce(Context& c, const typename Context::Vec3& normal,
                                      const typename Context::Color& albedo,
                                      typename Context::Condition wanted) {
    const typename Context::Condition active = activeOf(c), black = albedo.black();
    wanted = wanted & active & !black;
    if (!any(wanted)) return {};
    const typename Context::Float u = c.random(wanted), v = c.random(wanted);
    const typename Context::Vec3 direction =
        inFrontOf(c.facingGeometricNormal(), cosineDirection(normal, u, v));
    return continuePath(c, direction, albedo, wanted);
}

} // namespace smart::builtin
