// SPDX-License-Identifier: MIT
// Distance and barycentrics of the hits that were found, computed again in double from the rays
// as given and rounded once: float decides which triangle is hit, double says where.
#pragma once

#include "libsmart/kernel/search.h"

namespace smart::SMART_ISA {

inline double clamp(double x, double low, double high) {
    return x < low ? low : x > high ? high : x;
}

/// One ray in object space, in double.
struct DoubleRay {
    double org[3], dir[3];
};

/// Follows the path of a hit; returns its model, and leaves the ray in that model's space.
template <int N>
const ModelView& descend(const ModelView& scene, const uint32_t path[][N], uint32_t levels,
                         int lane, DoubleRay& ray) {
    const ModelView* model = &scene;
    for (uint32_t l = 0; l < levels; ++l) {
        const InstanceView& instance = model->children[path[l][lane]];
        if (!instance.identity) {
            DoubleRay local;
            for (int k = 0; k < 3; ++k) {
                const double* m = instance.toObject[k];
                local.org[k] = m[0] * ray.org[0] + m[1] * ray.org[1] + m[2] * ray.org[2] + m[3];
                local.dir[k] = m[0] * ray.dir[0] + m[1] * ray.dir[1] + m[2] * ray.dir[2];
            }
            ray = local;
        }
        model = instance.model;
    }
    return *model;
}

/// t = A.(BxC) / den, u = d.(CxA) / den, v = d.(AxB) / den, with A, B, C the vertices as seen
/// from the origin and den = d.(AxB + BxC + CxA), for the lanes that hit something.
template <int N>
void refineHits(const ModelView& scene, const float* const org[3], const float* const dir[3],
                const float* tNear, const float* tFar, const uint32_t* triangle,
                const uint32_t* levels, const uint32_t path[][N], float* t, float* u, float* v) {
    alignas(64) double a[3][N], b[3][N], c[3][N], d[3][N];
    for (int i = 0; i < N; ++i) {
        if (triangle[i] == kNoHit) {
            for (int k = 0; k < 3; ++k) a[k][i] = b[k][i] = c[k][i] = d[k][i] = 0;
            continue;
        }
        DoubleRay ray;
        for (int k = 0; k < 3; ++k) {
            ray.org[k] = org[k][i];
            ray.dir[k] = dir[k][i];
        }
        const ModelView& model = descend<N>(scene, path, levels[i], i, ray);
        const Triangle& tri = model.triangles[triangle[i]];
        for (int k = 0; k < 3; ++k) {
            a[k][i] = tri.v0[k] - ray.org[k];
            b[k][i] = tri.v1[k] - ray.org[k];
            c[k][i] = tri.v2[k] - ray.org[k];
            d[k][i] = ray.dir[k];
        }
    }
    alignas(64) double distance[N], second[N], third[N];
    for (int i = 0; i < N; ++i) {
        // Edges from the first vertex: products of small differences where the triangle is small.
        const double e1x = b[0][i] - a[0][i], e1y = b[1][i] - a[1][i], e1z = b[2][i] - a[2][i];
        const double e2x = c[0][i] - a[0][i], e2y = c[1][i] - a[1][i], e2z = c[2][i] - a[2][i];
        const double nx = e1y * e2z - e1z * e2y;
        const double ny = e1z * e2x - e1x * e2z;
        const double nz = e1x * e2y - e1y * e2x;
        const double den = d[0][i] * nx + d[1][i] * ny + d[2][i] * nz;
        distance[i] = (a[0][i] * nx + a[1][i] * ny + a[2][i] * nz) / den;
        const double px = d[1][i] * a[2][i] - d[2][i] * a[1][i];
        const double py = d[2][i] * a[0][i] - d[0][i] * a[2][i];
        const double pz = d[0][i] * a[1][i] - d[1][i] * a[0][i];
        second[i] = -(px * e2x + py * e2y + pz * e2z) / den;
        third[i] = (px * e1x + py * e1y + pz * e1z) / den;
    }
    for (int i = 0; i < N; ++i) {
        if (triangle[i] == kNoHit) continue;
        // A plane seen edge-on: the float test accepted it, exact arithmetic has no distance.
        const bool defined = distance[i] == distance[i] && second[i] == second[i];
        t[i] = float(clamp(defined ? distance[i] : double(tNear[i]),
                           tNear[i] > 0 ? tNear[i] : 0.0, tFar[i]));
        u[i] = defined ? float(clamp(second[i], 0, 1)) : 0.0f;
        v[i] = defined ? float(clamp(third[i], 0, 1)) : 0.0f;
    }
}

} // namespace smart::SMART_ISA
