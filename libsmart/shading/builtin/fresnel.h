// SPDX-License-Identifier: MIT
// Reflection and refraction at a smooth border between two transparent media.
#pragma once

#include "libsmart/shading/builtin/lane_math.h"

namespace smart::builtin {

using namespace openrt;

/// What happens to a ray at the border, by Fresnel's equations. `eta`: index of refraction on the
/// ray's side divided by that behind; `cosine`: of the angle between the ray and the normal on its
/// side, 0 to 1.
template <class Float>
struct Fresnel {
    Float reflectance;       ///< share of unpolarised light that is reflected; 1: total reflection
    Float transmittedCosine; ///< of the angle behind the border, by Snell's law; 0: none

    Fresnel(const Float& eta, const Float& cosine) {
        const Float squared = 1.0f - eta * eta * (1.0f - cosine * cosine);
        transmittedCosine = sqrt(max(squared, Float(0.0f)));
        const Float across = eta * cosine + transmittedCosine;
        const Float along = cosine + eta * transmittedCosine;
        const Float s = (eta * cosine - transmittedCosine) / across;
        const Float p = (cosine - eta * transmittedCosine) / along;
        const auto passes = (squared > 0.0f) & (across > 0.0f) & (along > 0.0f);
        reflectance = select(passes, (s * s + p * p) * 0.5f, Float(1.0f));
    }
};

/// A share w of Schlick's approximation ("An inexpensive BRDF model", 1994):
/// F = f0 + (1 - f0) w, w = (1 - cosine)^5.
template <class Float>
Float schlickWeight(const Float& cosine) {
    const Float x = 1.0f - cosine;
    return x * x * x * x * x;
}

} // namespace smart::builtin
