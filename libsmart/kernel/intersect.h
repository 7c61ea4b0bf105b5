// SPDX-License-Identifier: MIT
// The two float policies: how a group of rays is prepared for a tree, and how it meets a triangle.
#pragma once

#include "libsmart/kernel/block_hits.h"
#include "libsmart/kernel/shear.h"

namespace smart::SMART_ISA {

/// Of a ray and the triangles of a block, sheared into its space, those that `all` names.
HWY_INLINE void meetBlock(const Sheared<kPacketSize>& sheared, float scale, float doubtful,
                          uint32_t all, float near, float best, BlockHits& hits) {
    using R = Real<kPacketSize>;
    hits.sure = hits.atStart = hits.unsure = 0;
    R u, v, w;
    sheared.edgeFunctions(u, v, w);
    const R zero(0.0f), limit(best);
    const auto inside = (min(min(u, v), w) >= zero) | (max(max(u, v), w) <= zero);
    const uint32_t met = inside.bits() & all;
    if (!met) return;
    const R t =
        (u * sheared.a[2] + v * sheared.b[2] + w * sheared.c[2]) * R(scale) / (u + v + w);
    t.store(hits.t);
    const uint32_t inRange = ((t >= R(near)) & (t <= limit)).bits();
    const uint32_t undecided = met & ((u == zero) | (v == zero) | (w == zero)).bits();
    const uint32_t atStart = met & (magnitude(t) <= R(doubtful)).bits();
    const uint32_t close = met & (magnitude(t - limit) <= R(doubtful * 0x1p-6f)).bits();
    hits.unsure = undecided | close;
    hits.atStart = atStart & ~hits.unsure;
    hits.sure = met & inRange & ~(hits.unsure | hits.atStart);
}

/// Woop, Benthin, Wald (2013). An edge function, a float difference of rounded products, has the
/// exact sign unless it is zero, and then double products, which are exact, decide. That needs
/// multiplication and subtraction to stay apart.
template <int N, class RayShear>
class WatertightTest {
public:
    using Rays = LocalRays<N>;

    WatertightTest(const ModelView& model, const LocalRays<N>& rays, const RayGroup& group)
        : WatertightTest(model, rays, group, RayShear(rays, group)) {}
    WatertightTest(const ModelView& model, const LocalRays<N>& rays, const RayGroup& group,
                   const RayShear& shear)
        : triangles_(model.triangles), shear_(shear), rays_(rays) {
        const float maxAbs = triangleBox(model).maxAbs;
        // Weights of slivers err in float, and t with them, by a share of the triangle's depth; by
        // any share where three factors of the test's products, which are coordinates, underflow.
        const float doubt = maxAbs < 0x1p-30f ? __builtin_inff() : 0x1p-10f;
        doubtful_ = magnitude(shear_.scale()) *
                    (Real<N>(maxAbs) + magnitude(shear_.depthOrigin())) * Real<N>(doubt);
        // Beyond this they may overflow.
        const Real<N> largest(0x1p40f);
        large_ = Real<N>(maxAbs) > largest;
        for (int k = 0; k < 3; ++k)
            large_ = large_ | (magnitude(Real<N>::load(rays.org[k])) > largest);
        large_ = large_ & Mask<N>::fromBits(group.lanes);
        someLarge_ = any(large_);
    }

    /// Lanes of `active` that meet the triangle's plane inside it, and where. Limits are not
    /// looked at.
    HWY_INLINE Mask<N> meet(uint32_t number, const Mask<N>& active, Real<N>& t) const {
        return meet(triangles_[number], active, t);
    }
    HWY_INLINE Mask<N> meet(const Triangle& triangle, const Mask<N>& active, Real<N>& t) const {
        return someLarge_ ? meetLarge(triangle, active, t) : meetInFloat(triangle, active, t);
    }

    /// What `meet` and `comparable` would say of the triangles of a block; the same arithmetic.
    HWY_INLINE void meet(const TriangleBlock& block, const Real<1>& near, const Real<1>& best,
                         BlockHits& hits) const
        requires(N == 1)
    {
        if (someLarge_) {
            hits.sure = hits.atStart = 0;
            hits.unsure = block.all();
            return;
        }
        meetBlock(shear_(block), shear_.scale().v, doubtful_.v, block.all(), near.v, best.v, hits);
    }
    /// How close, lane by lane, to its start or to its best hit float can not place one.
    const Real<N>& doubtful() const { return doubtful_; }
    bool someLarge() const { return someLarge_; }
    /// Whether float can compare t with `best`.
    bool apart(float t, const Real<1>& best) const
        requires(N == 1)
    {
        return !(magnitude(Real<1>(t) - best) <= doubtful_ * Real<1>(0x1p-6f)).m;
    }
    /// Whether the ray starts behind triangle i of a block, which it meets, or more than `near`
    /// before its start, for certain.
    bool isBehind(const TriangleBlock& block, uint32_t i, const Real<1>& near,
                  const Real<1>& best) const
        requires(N == 1)
    {
        Triangle triangle;
        block.load(i, triangle);
        const double exact = distance(Plane(triangle), 0, 0x1p1000);
        const float t = float(exact);
        return exact < 0x1p1000 && t < near.v && apart(t, best);
    }

    /// Of the lanes that meet the triangle at t, those for which float can compare t with `best`:
    /// the others are compared in double. Those whose far limit it passes are dropped, those for
    /// which it is the nearest of this model's triangles are brought up to date.
    template <HitMode M, class Counter>
    HWY_INLINE Mask<N> comparable(uint32_t number, const Mask<N>& hit, Real<N>& t, Real<N>& best,
                                  Search<N, M, Counter>& query) const {
        const Mask<N> close = hit & (magnitude(t - best) <= doubtful_ * Real<N>(0x1p-6f));
        if (!any(close)) return hit;
        return compareInDouble(number, close.bits(), hit, t, best, query);
    }

private:
    HWY_INLINE Mask<N> meetInFloat(const Triangle& triangle, const Mask<N>& active,
                                   Real<N>& t) const {
        const Sheared<N> sheared = shear_(triangle);
        Real<N> u, v, w;
        sheared.edgeFunctions(u, v, w);
        const Real<N> lowest = min(min(u, v), w);
        const Real<N> highest = max(max(u, v), w);
        const Real<N> zero(0.0f);
        Mask<N> inside = active & ((lowest >= zero) | (highest <= zero));
        if (!any(inside)) return inside;

        const Real<N> determinant = u + v + w;
        t = (u * sheared.a[2] + v * sheared.b[2] + w * sheared.c[2]) * shear_.scale() / determinant;
        const Mask<N> undecided = inside & ((u == zero) | (v == zero) | (w == zero));
        inside = andNot(inside, undecided) & (determinant != zero);
        if (any(undecided)) decideExactly(triangle, undecided.bits(), inside, t);
        const Mask<N> atStart = inside & (magnitude(t) <= doubtful_);
        if (any(atStart)) placeExactly(triangle, atStart.bits(), t);
        return inside;
    }

    /// The same test; the lanes with large coordinates in double, whose exponents suffice. A
    /// double edge function of zero counts as inside, on both sides of the edge.
    [[gnu::noinline]] Mask<N> meetLarge(const Triangle& triangle, const Mask<N>& active,
                                        Real<N>& t) const {
        t = Real<N>(0.0f);
        uint32_t accepted = meetInFloat(triangle, andNot(active, large_), t).bits();
        alignas(64) float result[N];
        t.store(result);
        for (uint32_t lanes = (active & large_).bits(); lanes; lanes &= lanes - 1) {
            const int i = lowestBit(lanes);
            if (meetInDouble(triangle, i, result[i])) accepted |= 1u << i;
        }
        t = Real<N>::load(result);
        return Mask<N>::fromBits(accepted);
    }

    bool meetInDouble(const Triangle& triangle, int lane, float& t) const {
        const int kx = shear_.axis(0, lane), ky = shear_.axis(1, lane), kz = shear_.axis(2, lane);
        const double scale = 1.0 / double(rays_.dir[kz][lane]);
        const double sx = rays_.dir[kx][lane] * scale, sy = rays_.dir[ky][lane] * scale;
        const float* const vertices[3] = {triangle.v0, triangle.v1, triangle.v2};
        double x[3], y[3], z[3];
        for (int c = 0; c < 3; ++c) {
            z[c] = double(vertices[c][kz]) - rays_.org[kz][lane];
            x[c] = (double(vertices[c][kx]) - rays_.org[kx][lane]) - sx * z[c];
            y[c] = (double(vertices[c][ky]) - rays_.org[ky][lane]) - sy * z[c];
        }
        const double u = x[2] * y[1] - y[2] * x[1];
        const double v = x[0] * y[2] - y[0] * x[2];
        const double w = x[1] * y[0] - y[1] * x[0];
        const double determinant = u + v + w;
        if (((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) || determinant == 0)
            return false;
        t = float((u * z[0] + v * z[1] + w * z[2]) / determinant * scale);
        return magnitude(Real<1>(t)).v <= 0x1.fffffep127f;
    }

    /// Repeats the test in double for the given lanes.
    [[gnu::noinline]] void decideExactly(const Triangle& triangle, uint32_t lanes,
                                         Mask<N>& inside, Real<N>& t) const {
        const Sheared<N> sheared = shear_(triangle);
        alignas(64) float a[3][N], b[3][N], c[3][N], scale[N], result[N];
        for (int k = 0; k < 3; ++k) {
            sheared.a[k].store(a[k]);
            sheared.b[k].store(b[k]);
            sheared.c[k].store(c[k]);
        }
        shear_.scale().store(scale);
        t.store(result);
        uint32_t accepted = inside.bits();
        for (; lanes; lanes &= lanes - 1) {
            const int i = lowestBit(lanes);
            const double u = double(c[0][i]) * b[1][i] - double(c[1][i]) * b[0][i];
            const double v = double(a[0][i]) * c[1][i] - double(a[1][i]) * c[0][i];
            const double w = double(b[0][i]) * a[1][i] - double(b[1][i]) * a[0][i];
            const bool outside = (u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0);
            const double determinant = u + v + w;
            if (outside || determinant == 0) continue;
            result[i] = float((u * a[2][i] + v * b[2][i] + w * c[2][i]) * scale[i] / determinant);
            accepted |= 1u << i;
        }
        inside = Mask<N>::fromBits(accepted);
        t = Real<N>::load(result);
    }

    /// A triangle's plane in double.
    struct Plane {
        explicit Plane(const Triangle& triangle) : point(triangle.v0) {
            double e1[3], e2[3];
            for (int k = 0; k < 3; ++k) {
                e1[k] = double(triangle.v1[k]) - triangle.v0[k];
                e2[k] = double(triangle.v2[k]) - triangle.v0[k];
            }
            for (int k = 0; k < 3; ++k) {
                const int i = (k + 1) % 3, j = (k + 2) % 3;
                n[k] = e1[i] * e2[j] - e1[j] * e2[i];
            }
        }
        const float* point;
        double n[3];
    };

    /// `otherwise` where the plane is seen edge-on.
    double distance(const Plane& plane, int lane, double otherwise) const {
        double depth = 0, slope = 0;
        for (int k = 0; k < 3; ++k) {
            depth += (double(plane.point[k]) - rays_.org[k][lane]) * plane.n[k];
            slope += rays_.dir[k][lane] * plane.n[k];
        }
        return slope != 0 ? depth / slope : otherwise;
    }

    /// Distances of the given lanes again in double: whether the surface lies before or behind
    /// the start of the ray must not be left to float, or surfaces shadow themselves.
    [[gnu::noinline]] void placeExactly(const Triangle& triangle, uint32_t lanes,
                                        Real<N>& t) const {
        const Plane plane(triangle);
        alignas(64) float exact[N];
        for (int i = 0; i < N; ++i) { // as `distance` does
            double depth = 0, slope = 0;
            for (int k = 0; k < 3; ++k) {
                depth += (double(plane.point[k]) - rays_.org[k][i]) * plane.n[k];
                slope += rays_.dir[k][i] * plane.n[k];
            }
            lanes &= ~(uint32_t(slope == 0) << i); // edge-on: as it is
            exact[i] = float(depth / slope);
        }
        t = select(Mask<N>::fromBits(lanes), Real<N>::load(exact), t);
    }

    template <HitMode M, class Counter>
    [[gnu::noinline]] Mask<N> compareInDouble(uint32_t number, uint32_t lanes, const Mask<N>& hit,
                                              Real<N>& t, Real<N>& best,
                                              Search<N, M, Counter>& query) const {
        const Plane plane(triangles_[number]);
        alignas(64) float distances[N], limits[N];
        t.store(distances);
        best.store(limits);
        uint32_t open = hit.bits();
        for (; lanes; lanes &= lanes - 1) {
            const int i = lowestBit(lanes);
            const uint32_t bit = 1u << i;
            if (query.holds(number, i)) { // met in another leaf
                open &= ~bit;
                continue;
            }
            const double candidate = distance(plane, i, distances[i]);
            if (query.triangle[i] == kNoHit) {
                if (candidate > limits[i]) open &= ~bit;
                distances[i] = distances[i] < limits[i] ? distances[i] : limits[i];
                continue;
            }
            if (!query.sharesModel(i)) continue;
            open &= ~bit;
            const Plane holder(triangles_[query.triangle[i]]);
            const double stored = distance(holder, i, limits[i]);
            if (distances[i] < query.tNear[i] || candidate > stored) continue;
            if (candidate == stored && !query.precedes(number, i)) continue;
            query.keepTriangle(Mask<N>::fromBits(bit), number);
            // The float distance of a triangle, whatever it was compared with: what other instances
            // are compared with must not depend on the order of the tests.
            limits[i] = distances[i];
        }
        t = Real<N>::load(distances);
        best = Real<N>::load(limits);
        return Mask<N>::fromBits(open);
    }

    const Triangle* triangles_;
    RayShear shear_;
    const LocalRays<N>& rays_;
    Mask<N> large_;
    bool someLarge_;
    Real<N> doubtful_;
};

template <int N>
using Watertight = WatertightTest<N, Shear<N>>;

/// Wald, "Realtime ray tracing and interactive global illumination", PhD thesis 2004, section
/// 7.1: plane first, then two projected edges from a precomputed record. Edges may leak.
template <int N>
class Fast {
public:
    using Rays = LocalRays<N>;

    Fast(const ModelView& model, const LocalRays<N>& rays, const RayGroup&)
        : records_(model.records) {
        for (int k = 0; k < 3; ++k) {
            org_[k] = Real<N>::load(rays.org[k]);
            dir_[k] = Real<N>::load(rays.dir[k]);
        }
    }

    template <class RayShear>
    Fast(const ModelView& model, const LocalRays<N>& rays, const RayGroup& group, const RayShear&)
        : Fast(model, rays, group) {}

    void meet(const TriangleBlock& block, const Real<1>&, const Real<1>&, BlockHits& hits) const {
        hits.sure = hits.atStart = 0;
        hits.unsure = block.all();
    }
    static bool apart(float, const Real<1>&) { return false; }
    static bool isBehind(const TriangleBlock&, uint32_t, const Real<1>&, const Real<1>&) {
        return false;
    }

    HWY_INLINE Mask<N> meet(uint32_t number, const Mask<N>& active, Real<N>& t) const {
        const TriangleRecord& r = records_[number];
        const uint32_t k = r.axis, ku = (k + 1) % 3, kv = (k + 2) % 3;
        if (k > 2) return Mask<N>::fromBits(0);
        const Real<N> nu(r.nu), nv(r.nv);
        t = (Real<N>(r.nd) - org_[k] - nu * org_[ku] - nv * org_[kv]) /
            (dir_[k] + nu * dir_[ku] + nv * dir_[kv]);
        const Real<N> hu = org_[ku] + t * dir_[ku];
        const Real<N> hv = org_[kv] + t * dir_[kv];
        const Real<N> u = Real<N>(r.bu) * hu + Real<N>(r.bv) * hv + Real<N>(r.bd);
        const Real<N> v = Real<N>(r.cu) * hu + Real<N>(r.cv) * hv + Real<N>(r.cd);
        const Real<N> zero(0.0f);
        return active & (u >= zero) & (v >= zero) & (u + v <= Real<N>(1.0f));
    }

private:
    const TriangleRecord* records_;
    Real<N> org_[3], dir_[3];
};

} // namespace smart::SMART_ISA
