// SPDX-License-Identifier: MIT
// Rays of the precise mode: in float for traversal and filter, with bounds of what they are off by.
#pragma once

#include "libsmart/kernel/exact_meeting.h"
#include "libsmart/kernel/ray_preparation.h"

namespace smart::SMART_ISA {

/// Rays in one model's space. `wide` are what matrices make of the application's rays in double,
/// `org` and `dir` the same in float; no component is off by more than the errors. Where float can
/// not hold the ray, org and dir are any ray and orgError is infinite.
template <int N>
struct PreciseRays : LocalRays<N> {
    double wideOrg[3][N], wideDir[3][N];
    double wideOrgError[N], wideDirError[N];
    alignas(4 * N) float orgError[N];
    alignas(4 * N) float dirError[N];
};

/// As prepareRays for LocalRays; limits are rounded outward.
template <int N, HitMode M, class Counter>
uint32_t preparePreciseRays(const ModelView& scene, const float* const org[3],
                            const float* const dir[3], const float* tNear, const float* tFar,
                            uint32_t active, PreciseRays<N>& rays, WorldRays<N>& world,
                            Search<N, M, Counter>& query) {
    const uint32_t legal = prepareRays<N>(org, dir, tNear, tFar, active,
                                          static_cast<LocalRays<N>&>(rays), world.scale, query);
    world.scene = &scene;
    query.world = &world;
    for (int i = 0; i < N; ++i) {
        rays.wideOrgError[i] = rays.wideDirError[i] = 0;
        rays.orgError[i] = rays.dirError[i] = 0;
    }
    for (int k = 0; k < 3; ++k)
        for (int i = 0; i < N; ++i) {
            world.org[k][i] = rays.wideOrg[k][i] = rays.org[k][i];
            world.dir[k][i] = rays.wideDir[k][i] = rays.dir[k][i];
        }
    for (int i = 0; i < N; ++i) {
        world.tNear[i] = query.tNear[i];
        world.tFar[i] = query.best[i];
    }
    for (uint32_t rest = legal; rest; rest &= rest - 1) {
        const int i = lowestBit(rest);
        const double scale = world.scale[i];
        if (scale == 1) continue;
        for (int k = 0; k < 3; ++k) world.dir[k][i] = rays.wideDir[k][i] = dir[k][i] * scale;
        rays.dirError[i] = 0x1p-149f;
        world.tNear[i] = (tNear[i] > 0 ? double(tNear[i]) : 0) / scale;
        world.tFar[i] = double(tFar[i]) / scale;
        // One unit in the last place is 2^-23 at most.
        query.tNear[i] = float(world.tNear[i] * (1 - 0x1p-23)) - 0x1p-149f;
        query.best[i] = float(world.tFar[i] * (1 + 0x1p-23)) + 0x1p-149f;
    }
    __builtin_memcpy(query.low, query.best, sizeof query.low);
    return legal;
}

template <int N>
WorldRay worldRay(const WorldRays<N>& world, int lane) {
    WorldRay ray;
    for (int k = 0; k < 3; ++k) {
        ray.org[k] = world.org[k][lane];
        ray.dir[k] = world.dir[k][lane];
    }
    ray.tNear = world.tNear[lane];
    ray.tFar = world.tFar[lane];
    ray.scale = world.scale[lane];
    return ray;
}

/// The triangle stored for a lane that met one.
template <int N, HitMode M, class Counter>
void nameHit(const Search<N, M, Counter>& query, int lane, TriangleName& name) {
    name.triangle = query.triangle[lane];
    name.levels = query.levels[lane];
    for (uint32_t l = 0; l < name.levels; ++l) name.path[l] = query.path[l][lane];
}

template <class T>
T largerOf(T a, T b) {
    return a > b ? a : b;
}

/// Rays of an instance's parent in the instance's own space; double adds less than 8 units of
/// 2^-53 of the terms to the origin and 4 to the direction, float one of 2^-24 of the result.
template <int N>
void transformRays(const InstanceView& instance, const PreciseRays<N>& rays,
                   PreciseRays<N>& local) {
    AffineRows toObject;
    invert(instance, toObject);
    const InverseBound inverse = boundInverse(instance.toParent, toObject);
    alignas(64) double orgSize[N], dirSize[N];
    for (int i = 0; i < N; ++i) orgSize[i] = dirSize[i] = 0;
    for (int k = 0; k < 3; ++k) {
        const double* m = toObject[k];
        for (int i = 0; i < N; ++i) {
            const double x = rays.wideOrg[0][i], y = rays.wideOrg[1][i], z = rays.wideOrg[2][i];
            local.wideOrg[k][i] = m[0] * x + m[1] * y + m[2] * z + m[3];
            local.org[k][i] = float(local.wideOrg[k][i]);
            orgSize[i] = largerOf(orgSize[i], __builtin_fabs(rays.wideOrg[k][i]));
        }
        for (int i = 0; i < N; ++i) {
            const double x = rays.wideDir[0][i], y = rays.wideDir[1][i], z = rays.wideDir[2][i];
            local.wideDir[k][i] = m[0] * x + m[1] * y + m[2] * z;
            local.dir[k][i] = float(local.wideDir[k][i]);
            dirSize[i] = largerOf(dirSize[i], __builtin_fabs(rays.wideDir[k][i]));
        }
    }
    for (int i = 0; i < N; ++i) {
        double org = 0, dir = 0; // the new sizes
        double sum = 0;
        for (int k = 0; k < 3; ++k) {
            org = largerOf(org, __builtin_fabs(local.wideOrg[k][i]));
            dir = largerOf(dir, __builtin_fabs(local.wideDir[k][i]));
            sum += __builtin_fabs(local.wideOrg[k][i]) + __builtin_fabs(local.wideDir[k][i]);
        }
        double orgError =
            inverse.norm * (rays.wideOrgError[i] + 10 * 0x1p-53 * (orgSize[i] + inverse.offset));
        double dirError = inverse.norm * (rays.wideDirError[i] + 5 * 0x1p-53 * dirSize[i]);
        orgError += inverse.relative * (org + orgError);
        dirError += inverse.relative * (dir + dirError);
        local.wideOrgError[i] = orgError;
        local.wideDirError[i] = dirError;
        orgError += 0x1.1p-24 * org + 0x1p-140;
        dirError += 0x1.1p-24 * dir + 0x1p-140;
        local.orgError[i] = float(orgError * (1 + 0x1p-22));
        local.dirError[i] = float(dirError * (1 + 0x1p-22));
        const bool holds = sum < 0x1p102 && org < 0x1p100 && dir > 0x1p-60 && dir < 0x1p60 &&
                           orgError < 0x1p100 && dirError < 0.125 * dir; // false for NaN
        if (holds) continue;
        for (int k = 0; k < 3; ++k) {
            local.org[k][i] = 0;
            local.dir[k][i] = 1;
        }
        local.orgError[i] = __builtin_inff();
        local.dirError[i] = 0;
    }
}

} // namespace smart::SMART_ISA
