// SPDX-License-Identifier: MIT
// A control: all triangles by the watertight test, with or without contracted edge functions.
// Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection", JCGT 2(1), 2013.
#pragma once

#include <cmath>
#include <span>
#include <utility>

#include "tests/support/verdict.h"

namespace smart::test {

/// Contracted: ab - cd as fma(a, b, -(cd)), which is not antisymmetric any more.
template <bool Contracted>
float edgeFunction(float a, float b, float c, float d) {
    if constexpr (Contracted) return std::fma(a, b, -(c * d));
    const volatile float first = a * b, second = c * d; // no compiler may contract these
    return first - second;
}

template <bool Contracted>
Claim woopNearest(std::span<const Triangle> triangles, const Ray& ray) {
    int kz = 0;
    for (int k = 1; k < 3; ++k) {
        if (std::abs(ray.dir[k]) > std::abs(ray.dir[kz])) kz = k;
    }
    int kx = (kz + 1) % 3, ky = (kz + 2) % 3;
    if (ray.dir[kz] < 0) std::swap(kx, ky);
    const float sx = ray.dir[kx] / ray.dir[kz], sy = ray.dir[ky] / ray.dir[kz];
    Claim claim;
    claim.t = INFINITY;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const float* const corners[3] = {triangles[i].v0, triangles[i].v1, triangles[i].v2};
        float x[3], y[3], z[3];
        for (int c = 0; c < 3; ++c) {
            z[c] = corners[c][kz] - ray.org[kz];
            const volatile float shearX = sx * z[c], shearY = sy * z[c];
            x[c] = (corners[c][kx] - ray.org[kx]) - shearX;
            y[c] = (corners[c][ky] - ray.org[ky]) - shearY;
        }
        double w[3];
        for (int c = 0; c < 3; ++c) {
            const int a = (c + 1) % 3, b = (c + 2) % 3;
            w[c] = edgeFunction<Contracted>(x[b], y[a], y[b], x[a]);
            if (w[c] == 0) w[c] = double(x[b]) * y[a] - double(y[b]) * x[a];
        }
        const bool negative = w[0] < 0 || w[1] < 0 || w[2] < 0;
        const bool positive = w[0] > 0 || w[1] > 0 || w[2] > 0;
        const double sum = w[0] + w[1] + w[2];
        if ((negative && positive) || sum == 0) continue;
        const double depth = w[0] * z[0] + w[1] * z[1] + w[2] * z[2];
        const float t = float(depth / (sum * ray.dir[kz]));
        if (!(t >= ray.tNear && t <= ray.tFar && t < claim.t)) continue;
        claim = {uint32_t(i), t, float(w[1] / sum), float(w[2] / sum)};
    }
    return claim;
}

} // namespace smart::test
