// SPDX-License-Identifier: MIT
// Distance and barycentrics of the hits that were found, computed again in double from the rays
// as given and rounded once: float decides which triangle is hit, double says where.
#pragma once

#include "libsmart/kernel/search.h"

namespace smart::SMART_ISA {

inline double clamp(double x, double low, double high) {
    return x < low ? low : x > high ? high : x;
}

/// Rays in the space of the triangle that each hit, in double.
template <int N>
struct alignas(64) DoubleRays {
    double org[3][N], dir[3][N];
};

/// Follows the path of one lane's hit to its model, taking the lane's ray along.
template <int N>
const ModelView& descend(const ModelView& scene, const uint32_t path[][N], uint32_t levels,
                         int lane, DoubleRays<N>& rays) {
    const ModelView* model = &scene;
    for (uint32_t l = 0; l < levels; ++l) {
        const InstanceView& instance = model->children[path[l][lane]];
        model = instance.model;
        if (instance.identity) continue;
        const double org[3] = {rays.org[0][lane], rays.org[1][lane], rays.org[2][lane]};
        const double dir[3] = {rays.dir[0][lane], rays.dir[1][lane], rays.dir[2][lane]};
        for (int k = 0; k < 3; ++k) {
            const double* m = instance.toObject[k];
            rays.org[k][lane] = m[0] * org[0] + m[1] * org[1] + m[2] * org[2] + m[3];
            rays.dir[k][lane] = m[0] * dir[0] + m[1] * dir[1] + m[2] * dir[2];
        }
    }
    return *model;
}

/// With A the first vertex as seen from the origin, e1 and e2 the edges from it, n = e1 x e2:
/// t = A.n / d.n, u = (A x d).e2 / d.n, v = (d x A).e1 / d.n. Lanes without a hit get any value.
template <int N>
void refineHits(const ModelView& scene, const float* const org[3], const float* const dir[3],
                const float* tNear, const float* tFar, const uint32_t* triangle,
                const uint32_t* levels, const uint32_t path[][N], float* t, float* u, float* v) {
    DoubleRays<N> rays;
    for (int k = 0; k < 3; ++k)
        for (int i = 0; i < N; ++i) {
            rays.org[k][i] = org[k][i];
            rays.dir[k][i] = dir[k][i];
        }
    alignas(64) float v0[3][N] = {}, v1[3][N] = {}, v2[3][N] = {};
    for (int i = 0; i < N; ++i) {
        if (triangle[i] == kNoHit) continue;
        const Triangle& found = descend<N>(scene, path, levels[i], i, rays).triangles[triangle[i]];
        for (int k = 0; k < 3; ++k) {
            v0[k][i] = found.v0[k];
            v1[k][i] = found.v1[k];
            v2[k][i] = found.v2[k];
        }
    }
    alignas(64) double distance[N], second[N], third[N];
    for (int i = 0; i < N; ++i) {
        const double ax = v0[0][i] - rays.org[0][i];
        const double ay = v0[1][i] - rays.org[1][i];
        const double az = v0[2][i] - rays.org[2][i];
        const double e1x = double(v1[0][i]) - v0[0][i], e2x = double(v2[0][i]) - v0[0][i];
        const double e1y = double(v1[1][i]) - v0[1][i], e2y = double(v2[1][i]) - v0[1][i];
        const double e1z = double(v1[2][i]) - v0[2][i], e2z = double(v2[2][i]) - v0[2][i];
        const double dx = rays.dir[0][i], dy = rays.dir[1][i], dz = rays.dir[2][i];
        const double nx = e1y * e2z - e1z * e2y;
        const double ny = e1z * e2x - e1x * e2z;
        const double nz = e1x * e2y - e1y * e2x;
        const double px = dy * az - dz * ay;
        const double py = dz * ax - dx * az;
        const double pz = dx * ay - dy * ax;
        const double inverse = 1 / (dx * nx + dy * ny + dz * nz);
        distance[i] = (ax * nx + ay * ny + az * nz) * inverse;
        second[i] = -(px * e2x + py * e2y + pz * e2z) * inverse;
        third[i] = (px * e1x + py * e1y + pz * e1z) * inverse;
    }
    for (int i = 0; i < N; ++i) {
        // NaN from a plane seen edge-on: the float test met it, exactly it has no distance.
        const double from = tNear[i] > 0 ? tNear[i] : 0;
        t[i] = float(distance[i] == distance[i] ? clamp(distance[i], from, tFar[i]) : from);
        u[i] = float(second[i] == second[i] ? clamp(second[i], 0, 1) : 0);
        v[i] = float(third[i] == third[i] ? clamp(third[i], 0, 1) : 0);
    }
}

} // namespace smart::SMART_ISA
