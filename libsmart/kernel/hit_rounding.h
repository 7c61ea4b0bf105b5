// SPDX-License-Identifier: MIT
// Distance and barycentrics of the precise mode: the nearest floats. Computed in double with an
// error bound, in all lanes at once; where both ends of the bound round alike, that is the float.
#pragma once

#include "libsmart/kernel/arbitration.h"
#include "libsmart/kernel/precise_rays.h"

namespace smart::SMART_ISA {

inline double largestOf(double x, double y, double z) {
    x = __builtin_fabs(x);
    y = __builtin_fabs(y);
    z = __builtin_fabs(z);
    return largerOf(largerOf(x, y), z);
}

/// The nearest float to dividend / divisor * scale in `low` and `high`, if they are equal.
inline void roundQuotient(double dividend, double dividendError, double divisor,
                          double divisorError, double scale, float& low, float& high) {
    const double value = dividend / divisor, size = __builtin_fabs(value);
    const double error = (dividendError + size * divisorError) /
                             (__builtin_fabs(divisor) - divisorError) * (1 + 0x1p-50) +
                         0x1p-50 * size;
    low = float((value - error) * scale);
    high = float((value + error) * scale);
}

/// The formulas and bounds of meetInDouble for the hits of a query; lanes without a hit get any
/// value.
template <int N, HitMode M, class Counter>
void placeHits(const ModelView& scene, const WorldRays<N>& world,
               const Search<N, M, Counter>& query, float* t, float* u, float* v) {
    alignas(64) double org[3][N] = {}, dir[3][N] = {}, orgError[N] = {}, dirError[N] = {};
    alignas(64) float v0[3][N] = {}, v1[3][N] = {}, v2[3][N] = {};
    for (int i = 0; i < N; ++i) {
        if (query.triangle[i] == kNoHit) continue;
        TriangleName name;
        nameHit(query, i, name);
        ObjectRay ray;
        const Triangle& triangle = enterModel(scene, worldRay(world, i), name, ray);
        for (int k = 0; k < 3; ++k) {
            org[k][i] = ray.org[k];
            dir[k][i] = ray.dir[k];
            v0[k][i] = triangle.v0[k];
            v1[k][i] = triangle.v1[k];
            v2[k][i] = triangle.v2[k];
        }
        orgError[i] = ray.orgError;
        dirError[i] = ray.dirError;
    }
    alignas(64) float low[3][N], high[3][N];
    alignas(64) double least[N], most[N]; // of the sizes that the bounds rely on
    for (int i = 0; i < N; ++i) {
        const double ax = v0[0][i] - org[0][i];
        const double ay = v0[1][i] - org[1][i];
        const double az = v0[2][i] - org[2][i];
        const double e1x = double(v1[0][i]) - v0[0][i], e2x = double(v2[0][i]) - v0[0][i];
        const double e1y = double(v1[1][i]) - v0[1][i], e2y = double(v2[1][i]) - v0[1][i];
        const double e1z = double(v1[2][i]) - v0[2][i], e2z = double(v2[2][i]) - v0[2][i];
        const double dx = dir[0][i], dy = dir[1][i], dz = dir[2][i];
        const double nx = e1y * e2z - e1z * e2y;
        const double ny = e1z * e2x - e1x * e2z;
        const double nz = e1x * e2y - e1y * e2x;
        const double px = dy * az - dz * ay;
        const double py = dz * ax - dx * az;
        const double pz = dx * ay - dy * ax;
        const double sizeD = largestOf(dx, dy, dz) + 2 * dirError[i];
        const double sizeA = largestOf(ax, ay, az) + 2 * orgError[i];
        const double size1 = largestOf(e1x, e1y, e1z), size2 = largestOf(e2x, e2y, e2z);
        const double area = size1 * size2;
        const double weightError =
            0x1p-47 * sizeD * sizeA + 8 * (sizeD * orgError[i] + sizeA * dirError[i]);
        const double sum = dx * nx + dy * ny + dz * nz;
        const double sumError = (0x1p-47 * sizeD + 8 * dirError[i]) * area;
        roundQuotient(ax * nx + ay * ny + az * nz, (0x1p-47 * sizeA + 8 * orgError[i]) * area, sum,
                      sumError, world.scale[i], low[0][i], high[0][i]);
        roundQuotient(-(px * e2x + py * e2y + pz * e2z), weightError * size2, sum, sumError, 1,
                      low[1][i], high[1][i]);
        roundQuotient(px * e1x + py * e1y + pz * e1z, weightError * size1, sum, sumError, 1,
                      low[2][i], high[2][i]);
        const bool sure = __builtin_fabs(sum) > sumError;
        const double smaller1 = size1 < size2 ? size1 : size2;
        const double smaller2 = sizeA < sizeD ? sizeA : sizeD;
        least[i] = sure ? smaller1 < smaller2 ? smaller1 : smaller2 : 0;
        most[i] = largerOf(largerOf(size1, size2), largerOf(sizeA, sizeD));
    }
    for (int i = 0; i < N; ++i) {
        t[i] = low[0][i];
        u[i] = low[1][i];
        v[i] = low[2][i];
        const bool alike =
            t[i] == high[0][i] && u[i] == high[1][i] && v[i] == high[2][i] && u[i] != 0 &&
            v[i] != 0 && t[i] != 0 && least[i] > 0x1p-250 && most[i] < 0x1p250;
        if (alike || query.triangle[i] == kNoHit) continue;
        TriangleName name;
        nameHit(query, i, name);
        placeHit(scene, worldRay(world, i), name, t[i], u[i], v[i]);
    }
}

} // namespace smart::SMART_ISA
