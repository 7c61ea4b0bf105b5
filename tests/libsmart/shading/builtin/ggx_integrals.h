// SPDX-License-Identifier: MIT
// Integrals over the GGX distribution in double, by the distribution of normals itself.
#pragma once

#include <algorithm>
#include <cmath>

namespace smart::test {

struct GgxAlbedo {
    double white = 0, grazing = 0;
};

inline double ggxMasking(double cosine, double a2) {
    return 2 * cosine / (cosine + std::sqrt(a2 + (1 - a2) * cosine * cosine));
}

/// Calls visit(share, h.z, v.h, l.z) for half vectors h with density D (n.h), of which `share` is
/// the probability: tan^2 = alpha^2 u / (1 - u) for u in [0, 1).
template <class Visit>
void forHalfVectors(double mu, double alpha, Visit&& visit) {
    constexpr int kSteps = 500, kAngles = 120;
    const double sine = std::sqrt(1 - mu * mu), pi = 3.14159265358979323846;
    for (int i = 0; i < kSteps; ++i) {
        const double w = (i + 0.5) / kSteps; // 1 - u = w^4: the tail is long
        const double rest = w * w * w * w;
        const double tangent2 = alpha * alpha * (1 - rest) / rest;
        const double hz = 1 / std::sqrt(1 + tangent2), hs = std::sqrt(tangent2) * hz;
        for (int j = 0; j < kAngles; ++j) {
            const double vh = sine * hs * std::cos(pi * (j + 0.5) / kAngles) + mu * hz;
            visit(4 * w * w * w / kSteps / kAngles, hz, vh, 2 * vh * hz - mu);
        }
    }
}

/// Shares of light from direction mu that a white surface, and one with Schlick's weight as
/// Fresnel term, reflect once: the BRDF D G F / (4 (n.l) (n.v)) of glTF 2.0 integrated.
inline GgxAlbedo ggxAlbedo(double mu, double roughness) {
    const double alpha = roughness * roughness, a2 = alpha * alpha;
    GgxAlbedo sum;
    forHalfVectors(mu, alpha, [&](double share, double hz, double vh, double lz) {
        if (vh <= 0 || lz <= 0) return;
        // dl = 4 (v.h) dh
        const double reflected =
            share * ggxMasking(mu, a2) * ggxMasking(lz, a2) * vh / (mu * hz);
        sum.white += reflected;
        sum.grazing += reflected * std::pow(1 - std::min(vh, 1.0), 5);
    });
    return sum;
}

/// Probability that a visible normal has a cosine above `least`.
inline double visibleWithin(double mu, double alpha, double least) {
    double sum = 0;
    forHalfVectors(mu, alpha, [&](double share, double hz, double vh, double) {
        if (vh > 0 && hz > least)
            sum += share * ggxMasking(mu, alpha * alpha) * vh / (mu * hz);
    });
    return sum;
}

} // namespace smart::test
