// SPDX-License-Identifier: MIT
// Distance and barycentrics of the hits that were found, computed again in double from the rays
// as given and rounded once: float decides which triangle is hit, double says where.
#pragma once

#include "libsmart/kernel/search.h"

namespace smart::SMART_ISA {

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

/// Whether all the hits are in one model, in the same place; lane: of some hit.
template <int N>
bool inOneModel(const uint32_t* triangle, const uint32_t* levels, const uint32_t path[][N],
                int lane) {
    uint32_t differ = 0;
    for (int i = 0; i < N; ++i)
        differ |= triangle[i] == kNoHit ? 0 : levels[i] ^ levels[lane];
    if (differ) return false;
    for (uint32_t l = 0; l < levels[lane]; ++l)
        for (int i = 0; i < N; ++i)
            differ |= triangle[i] == kNoHit ? 0 : path[l][i] ^ path[l][lane];
    return !differ;
}

/// Takes all lanes to the model that the path of one leads to.
template <int N>
const ModelView& descendTogether(const ModelView& scene, const uint32_t path[][N], uint32_t levels,
                                 int lane, DoubleRays<N>& rays) {
    const ModelView* model = &scene;
    for (uint32_t l = 0; l < levels; ++l) {
        const InstanceView& instance = model->children[path[l][lane]];
        model = instance.model;
        if (instance.identity) continue;
        const auto& m = instance.toObject;
        for (int i = 0; i < N; ++i) {
            const double x = rays.org[0][i], y = rays.org[1][i], z = rays.org[2][i];
            for (int k = 0; k < 3; ++k)
                rays.org[k][i] = m[k][0] * x + m[k][1] * y + m[k][2] * z + m[k][3];
        }
        for (int i = 0; i < N; ++i) {
            const double x = rays.dir[0][i], y = rays.dir[1][i], z = rays.dir[2][i];
            for (int k = 0; k < 3; ++k)
                rays.dir[k][i] = m[k][0] * x + m[k][1] * y + m[k][2] * z;
        }
    }
    return *model;
}

/// The vertices of what each lane hit.
template <int N>
struct alignas(64) HitVertices {
    float v0[3][N], v1[3][N], v2[3][N];

    void set(int lane, const Triangle& triangle) {
        for (int k = 0; k < 3; ++k) {
            v0[k][lane] = triangle.v0[k];
            v1[k][lane] = triangle.v1[k];
            v2[k][lane] = triangle.v2[k];
        }
    }
};

/// With A the first vertex as seen from the origin, e1 and e2 the edges from it, n = e1 x e2:
/// t = A.n / d.n, u = (A x d).e2 / d.n, v = (d x A).e1 / d.n. Lanes without a hit get any value.
template <int N>
void refineHits(const ModelView& scene, const float* const org[3], const float* const dir[3],
                const float* tNear, const float* tFar, const uint32_t* triangle,
                const uint32_t* levels, const uint32_t path[][N], float* t, float* u, float* v) {
    int some = -1;
    for (int i = 0; i < N; ++i) some = triangle[i] == kNoHit ? some : i;
    if (some < 0) return;
    DoubleRays<N> rays;
    for (int k = 0; k < 3; ++k)
        for (int i = 0; i < N; ++i) {
            rays.org[k][i] = org[k][i];
            rays.dir[k][i] = dir[k][i];
        }
    HitVertices<N> vertices;
    if (inOneModel<N>(triangle, levels, path, some)) {
        const ModelView& model = descendTogether<N>(scene, path, levels[some], some, rays);
        for (int i = 0; i < N; ++i)
            vertices.set(i, model.triangles[triangle[triangle[i] == kNoHit ? some : i]]);
    } else {
        vertices = {};
        for (int i = 0; i < N; ++i)
            if (triangle[i] != kNoHit)
                vertices.set(i, descend<N>(scene, path, levels[i], i, rays).triangles[triangle[i]]);
    }

    const hn::CappedTag<double, (N < 8 ? N : 8)> real;
    const hn::Rebind<float, decltype(real)> narrow;
    using V = hn::Vec<decltype(real)>;
    const auto widen = [&](const float* p) { return hn::PromoteTo(real, hn::LoadU(narrow, p)); };
    const auto cross = [](const V (&a)[3], const V (&b)[3], V (&c)[3]) {
        for (int k = 0; k < 3; ++k) {
            const int x = (k + 1) % 3, y = (k + 2) % 3;
            c[k] = hn::Sub(hn::Mul(a[x], b[y]), hn::Mul(a[y], b[x]));
        }
    };
    const auto dot = [](const V (&a)[3], const V (&b)[3]) {
        return hn::Add(hn::Add(hn::Mul(a[0], b[0]), hn::Mul(a[1], b[1])), hn::Mul(a[2], b[2]));
    };
    // NaN from a plane seen edge-on: the float test met it, exactly it has no distance.
    const auto put = [&](const V& value, const V& low, const V& high, float* to) {
        V inside = hn::IfThenElse(hn::Gt(value, high), high, value);
        inside = hn::IfThenElse(hn::Ge(value, low), inside, low);
        // Not DemoteTo: beyond the largest float it gives that or infinity, by instruction set.
        alignas(64) double values[hn::MaxLanes(real)];
        hn::Store(inside, real, values);
        for (std::size_t i = 0; i < hn::Lanes(real); ++i) to[i] = float(values[i]);
    };
    const V zero = hn::Zero(real), one = hn::Set(real, 1.0);
    for (int i = 0; i < N; i += int(hn::Lanes(real))) {
        V a[3], e1[3], e2[3], d[3], n[3], p[3];
        for (int k = 0; k < 3; ++k) {
            const V v0 = widen(vertices.v0[k] + i);
            a[k] = hn::Sub(v0, hn::LoadU(real, rays.org[k] + i));
            e1[k] = hn::Sub(widen(vertices.v1[k] + i), v0);
            e2[k] = hn::Sub(widen(vertices.v2[k] + i), v0);
            d[k] = hn::LoadU(real, rays.dir[k] + i);
        }
        cross(e1, e2, n);
        cross(d, a, p);
        const V inverse = hn::Div(one, dot(d, n));
        const V from = widen(tNear + i);
        put(hn::Mul(dot(a, n), inverse), hn::IfThenElse(hn::Gt(from, zero), from, zero),
            widen(tFar + i), t + i);
        put(hn::Mul(hn::Neg(dot(p, e2)), inverse), zero, one, u + i);
        put(hn::Mul(dot(p, e1), inverse), zero, one, v + i);
    }
}

} // namespace smart::SMART_ISA
