// SPDX-License-Identifier: MIT
// Distance and barycentrics of the hits that were found, computed again in double from the rays
// as given and rounded once: float decides which triangle is hit, double says where.
#pragma once

#include "libsmart/kernel/affine_inverse.h"
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
        AffineRows toObject;
        invert(instance, toObject);
        const double org[3] = {rays.org[0][lane], rays.org[1][lane], rays.org[2][lane]};
        const double dir[3] = {rays.dir[0][lane], rays.dir[1][lane], rays.dir[2][lane]};
        for (int k = 0; k < 3; ++k) {
            const double* m = toObject[k];
            rays.org[k][lane] = m[0] * org[0] + m[1] * org[1] + m[2] * org[2] + m[3];
            rays.dir[k][lane] = m[0] * dir[0] + m[1] * dir[1] + m[2] * dir[2];
        }
    }
    return *model;
}

/// Whether the words of the lanes given are equal to that of one.
template <int N>
bool allEqual(const Mask<N>& lanes, const uint32_t* words, int lane) {
    return !any(lanes & (Word<N>::load(words) != Word<N>(words[lane])));
}

/// Whether all the hits are in one model, in the same place; lane: of some hit.
template <int N>
bool inOneModel(const Mask<N>& hits, const uint32_t* levels, const uint32_t path[][N], int lane) {
    bool same = allEqual<N>(hits, levels, lane);
    for (uint32_t l = 0; same && l < levels[lane]; ++l) same = allEqual<N>(hits, path[l], lane);
    return same;
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
        AffineRows m;
        invert(instance, m);
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

/// The vertices of what each lane hit: the three of v0, those of v1, of v2.
template <int N>
struct alignas(64) HitVertices {
    float of[9][N];

    void set(int lane, const Triangle& triangle) {
        for (int k = 0; k < 3; ++k) {
            of[k][lane] = triangle.v0[k];
            of[3 + k][lane] = triangle.v1[k];
            of[6 + k][lane] = triangle.v2[k];
        }
    }

    /// Lane i from triangles[number[i]], `otherwise` in place of kNoHit.
    void gather(const Triangle* triangles, const uint32_t* number, uint32_t otherwise) {
        for (int i = 0; i < N; ++i)
            set(i, triangles[number[i] == kNoHit ? otherwise : number[i]]);
    }
};

#if HWY_TARGET != HWY_SCALAR
/// Four coordinates of a triangle at a time, then transposed.
template <>
inline void HitVertices<kPacketSize>::gather(const Triangle* triangles, const uint32_t* number,
                                             uint32_t otherwise) {
    constexpr int kQuads = 4, kFirst[3] = {0, 4, 5}; // the last four again
    // Lane 4 g + r is quad g of row r.
    alignas(64) float rows[3][4][kQuads][4];
    for (int i = 0; i < kPacketSize; ++i) {
        const uint32_t at = number[i] == kNoHit ? otherwise : number[i];
        const char* const from = reinterpret_cast<const char*>(triangles + at);
        for (int b = 0; b < 3; ++b)
            __builtin_memcpy(rows[b][i % 4][i / 4], from + sizeof(float) * unsigned(kFirst[b]),
                             4 * sizeof(float));
    }
    const Tag tag;
    for (int g = 0; g < kQuads; g += kRegisterLanes / 4) {
        for (int b = 0; b < 3; ++b) {
            const auto row = [&](int r) { return hn::Load(tag, rows[b][r][g]); };
            const auto put = [&](int k, hn::Vec<Tag> v) { hn::Store(v, tag, of[k] + 4 * g); };
            const auto upper02 = hn::InterleaveUpper(tag, row(0), row(2));
            const auto upper13 = hn::InterleaveUpper(tag, row(1), row(3));
            if (b == 2) {
                put(8, hn::InterleaveUpper(tag, upper02, upper13));
                continue;
            }
            const auto lower02 = hn::InterleaveLower(tag, row(0), row(2));
            const auto lower13 = hn::InterleaveLower(tag, row(1), row(3));
            put(4 * b, hn::InterleaveLower(tag, lower02, lower13));
            put(4 * b + 1, hn::InterleaveUpper(tag, lower02, lower13));
            put(4 * b + 2, hn::InterleaveLower(tag, upper02, upper13));
            put(4 * b + 3, hn::InterleaveUpper(tag, upper02, upper13));
        }
    }
}
#endif

/// The hits of a packet. In two steps, so that what the first one stores has reached the cache
/// when the second one reads it in other portions: of several packets, first all of the first.
template <int N>
class HitRefinement {
public:
    /// Fetches the triangles.
    void fetch(const ModelView& scene, const float* const org[3], const float* const dir[3],
               const uint32_t* triangle, const uint32_t* levels, const uint32_t path[][N]) {
        const Mask<N> hits = Word<N>::load(triangle) != Word<N>(kNoHit);
        kind_ = Kind::NoHit;
        if (!any(hits)) return;
        const int some = lowestBit(hits.bits());
        for (int k = 0; k < 3; ++k) {
            org_[k] = org[k];
            dir_[k] = dir[k];
        }
        moved_ = false;
        if (inOneModel<N>(hits, levels, path, some)) {
            const ModelView* model = &scene;
            for (uint32_t l = 0; l < levels[some]; ++l) {
                const InstanceView& instance = model->children[path[l][some]];
                model = instance.model;
                moved_ = moved_ || !instance.identity;
            }
            if (moved_) {
                widenRays();
                descendTogether<N>(scene, path, levels[some], some, rays_);
            }
            if (allEqual<N>(hits, triangle, some)) {
                kind_ = Kind::OneTriangle;
                only_ = model->triangles + triangle[some];
            } else {
                kind_ = Kind::Several;
                vertices_.gather(model->triangles, triangle, triangle[some]);
            }
        } else {
            kind_ = Kind::Several;
            moved_ = true;
            widenRays();
            vertices_ = {};
            for (int i = 0; i < N; ++i)
                if (triangle[i] != kNoHit)
                    vertices_.set(
                        i, descend<N>(scene, path, levels[i], i, rays_).triangles[triangle[i]]);
        }
    }

    /// With A the first vertex as seen from the origin, e1 and e2 the edges from it, n = e1 x e2:
    /// t = A.n / d.n, u = (A x d).e2 / d.n, v = (d x A).e1 / d.n. Lanes without a hit get any
    /// value.
    void place(const float* tNear, const float* tFar, float* t, float* u, float* v) const {
        if (kind_ == Kind::NoHit) return;
        const auto corner = [this](int k, int i) { return widen(vertices_.of[k] + i); };
        if (kind_ == Kind::OneTriangle) {
            float shared[9];
            __builtin_memcpy(shared, only_, sizeof shared);
            const Plane plane([&](int k) { return hn::Set(real, double(shared[k])); });
            for (int i = 0; i < N; i += kLanes) placeSome(plane, i, tNear, tFar, t, u, v);
        } else {
            for (int i = 0; i < N; i += kLanes)
                placeSome(Plane([&](int k) { return corner(k, i); }), i, tNear, tFar, t, u, v);
        }
    }

private:
    static constexpr hn::CappedTag<double, (N < 8 ? N : 8)> real{};
    static constexpr hn::Rebind<float, hn::CappedTag<double, (N < 8 ? N : 8)>> narrow{};
    using V = hn::Vec<hn::CappedTag<double, (N < 8 ? N : 8)>>;
    static constexpr int kLanes = int(hn::MaxLanes(hn::CappedTag<double, (N < 8 ? N : 8)>()));

    static V widen(const float* p) { return hn::PromoteTo(real, hn::LoadU(narrow, p)); }
    static void cross(const V (&a)[3], const V (&b)[3], V (&c)[3]) {
        for (int k = 0; k < 3; ++k) {
            const int x = (k + 1) % 3, y = (k + 2) % 3;
            c[k] = hn::Sub(hn::Mul(a[x], b[y]), hn::Mul(a[y], b[x]));
        }
    }
    static V dot(const V (&a)[3], const V (&b)[3]) {
        return hn::Add(hn::Add(hn::Mul(a[0], b[0]), hn::Mul(a[1], b[1])), hn::Mul(a[2], b[2]));
    }

    struct Plane {
        template <class Corner>
        HWY_INLINE explicit Plane(const Corner& corner) {
            for (int k = 0; k < 3; ++k) {
                v0[k] = corner(k);
                e1[k] = hn::Sub(corner(3 + k), v0[k]);
                e2[k] = hn::Sub(corner(6 + k), v0[k]);
            }
            cross(e1, e2, n);
        }
        V v0[3], e1[3], e2[3], n[3];
    };

    void widenRays() {
        for (int k = 0; k < 3; ++k)
            for (int i = 0; i < N; ++i) {
                rays_.org[k][i] = org_[k][i];
                rays_.dir[k][i] = dir_[k][i];
            }
    }

    HWY_INLINE void placeSome(const Plane& plane, int i, const float* tNear, const float* tFar,
                              float* t, float* u, float* v) const {
        V a[3], d[3], p[3];
        for (int k = 0; k < 3; ++k) {
            a[k] = hn::Sub(plane.v0[k],
                           moved_ ? hn::Load(real, rays_.org[k] + i) : widen(org_[k] + i));
            d[k] = moved_ ? hn::Load(real, rays_.dir[k] + i) : widen(dir_[k] + i);
        }
        cross(d, a, p);
        const V zero = hn::Zero(real), one = hn::Set(real, 1.0);
        const V inverse = hn::Div(one, dot(d, plane.n));
        const V from = widen(tNear + i);
        put(hn::Mul(dot(a, plane.n), inverse), hn::IfThenElse(hn::Gt(from, zero), from, zero),
            widen(tFar + i), t + i);
        put(hn::Mul(hn::Neg(dot(p, plane.e2)), inverse), zero, one, u + i);
        put(hn::Mul(dot(p, plane.e1), inverse), zero, one, v + i);
    }

    /// NaN comes from a plane seen edge-on: the float test met it, exactly it has no distance.
    HWY_INLINE static void put(const V& value, const V& low, const V& high, float* to) {
        V inside = hn::IfThenElse(hn::Gt(value, high), high, value);
        inside = hn::IfThenElse(hn::Ge(value, low), inside, low);
#if HWY_TARGET == HWY_SCALAR // whose DemoteTo never gives infinity, unlike the others'
        *to = float(hn::GetLane(inside));
#else
        hn::StoreU(hn::DemoteTo(narrow, inside), narrow, to);
#endif
    }

    enum class Kind { NoHit, OneTriangle, Several } kind_;
    bool moved_; ///< the rays went to another space: rays_
    const float *org_[3], *dir_[3];
    const Triangle* only_;
    DoubleRays<N> rays_;
    HitVertices<N> vertices_;
};

template <int N>
void refineHits(const ModelView& scene, const float* const org[3], const float* const dir[3],
                const float* tNear, const float* tFar, const uint32_t* triangle,
                const uint32_t* levels, const uint32_t path[][N], float* t, float* u, float* v) {
    HitRefinement<N> hits;
    hits.fetch(scene, org, dir, triangle, levels, path);
    hits.place(tNear, tFar, t, u, v);
}

} // namespace smart::SMART_ISA
