// SPDX-License-Identifier: MIT
// The precision policies: how a group of rays is prepared for a tree, and how it meets a triangle.
#pragma once

#include "libsmart/kernel/search.h"

namespace smart::SMART_ISA {

/// Rays that share the signs of their direction and its dominant axis.
struct RayGroup {
    uint32_t lanes;
    bool negative[3];
    int dominantAxis;
};

/// Woop, Benthin, Wald, "Watertight ray/triangle intersection", JCGT 2(1), 2013: vertices are
/// sheared into a space where the ray is the z axis; the signs of the 2D edge functions decide.
/// A float difference of rounded products has the exact sign unless it is zero, and then double
/// products, which are exact, decide. That needs multiplication and subtraction to stay apart.
template <int N>
class Watertight {
public:
    Watertight(const ModelView& model, const LocalRays<N>& rays, const RayGroup& group)
        : triangles_(model.triangles),
          kx_((group.dominantAxis + 1) % 3),
          ky_((group.dominantAxis + 2) % 3),
          kz_(group.dominantAxis),
          rays_(rays) {
        const Real<N> one(1.0f);
        ox_ = Real<N>::load(rays.org[kx_]);
        oy_ = Real<N>::load(rays.org[ky_]);
        oz_ = Real<N>::load(rays.org[kz_]);
        sz_ = one / Real<N>::load(rays.dir[kz_]);
        sx_ = Real<N>::load(rays.dir[kx_]) / Real<N>::load(rays.dir[kz_]);
        sy_ = Real<N>::load(rays.dir[ky_]) / Real<N>::load(rays.dir[kz_]);
        // Weights of slivers err in float, and t with them, by a share of the triangle's depth.
        doubtful_ = magnitude(sz_) * (Real<N>(model.tree.maxAbs) + magnitude(oz_)) *
                    Real<N>(0x1p-10f);
    }

    /// Lanes of `active` that meet the triangle's plane inside it, and where. Limits are not
    /// looked at.
    HWY_INLINE Mask<N> meet(uint32_t number, const Mask<N>& active, Real<N>& t) const {
        const Triangle& triangle = triangles_[number];
        const Real<N> az = Real<N>(triangle.v0[kz_]) - oz_;
        const Real<N> bz = Real<N>(triangle.v1[kz_]) - oz_;
        const Real<N> cz = Real<N>(triangle.v2[kz_]) - oz_;
        const Real<N> ax = (Real<N>(triangle.v0[kx_]) - ox_) - sx_ * az;
        const Real<N> ay = (Real<N>(triangle.v0[ky_]) - oy_) - sy_ * az;
        const Real<N> bx = (Real<N>(triangle.v1[kx_]) - ox_) - sx_ * bz;
        const Real<N> by = (Real<N>(triangle.v1[ky_]) - oy_) - sy_ * bz;
        const Real<N> cx = (Real<N>(triangle.v2[kx_]) - ox_) - sx_ * cz;
        const Real<N> cy = (Real<N>(triangle.v2[ky_]) - oy_) - sy_ * cz;

        const Real<N> u = cx * by - cy * bx;
        const Real<N> v = ax * cy - ay * cx;
        const Real<N> w = bx * ay - by * ax;
        const Real<N> lowest = min(min(u, v), w);
        const Real<N> highest = max(max(u, v), w);
        const Real<N> zero(0.0f);
        Mask<N> inside = active & ((lowest >= zero) | (highest <= zero));
        if (!any(inside)) return inside;

        const Real<N> determinant = u + v + w;
        t = (u * az + v * bz + w * cz) * sz_ / determinant;
        const Mask<N> undecided = inside & ((u == zero) | (v == zero) | (w == zero));
        inside = andNot(inside, undecided) & (determinant != zero);
        if (any(undecided)) {
            const Sheared sheared = {{ax, ay, az}, {bx, by, bz}, {cx, cy, cz}};
            decideExactly(sheared, undecided.bits(), inside, t);
        }
        const Mask<N> atStart = inside & (magnitude(t) <= doubtful_);
        if (any(atStart)) placeExactly(triangle, atStart.bits(), t);
        return inside;
    }

private:
    struct Sheared {
        Real<N> a[3], b[3], c[3];
    };

    /// Repeats the test in double for the given lanes.
    [[gnu::noinline]] void decideExactly(const Sheared& sheared, uint32_t lanes, Mask<N>& inside,
                                         Real<N>& t) const {
        alignas(64) float a[3][N], b[3][N], c[3][N], scale[N], result[N];
        for (int k = 0; k < 3; ++k) {
            sheared.a[k].store(a[k]);
            sheared.b[k].store(b[k]);
            sheared.c[k].store(c[k]);
        }
        sz_.store(scale);
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

    /// Distances of the given lanes again in double: whether the surface lies before or behind
    /// the start of the ray must not be left to float, or surfaces shadow themselves.
    [[gnu::noinline]] void placeExactly(const Triangle& triangle, uint32_t lanes,
                                        Real<N>& t) const {
        double e1[3], e2[3], n[3];
        for (int k = 0; k < 3; ++k) {
            e1[k] = double(triangle.v1[k]) - triangle.v0[k];
            e2[k] = double(triangle.v2[k]) - triangle.v0[k];
        }
        for (int k = 0; k < 3; ++k) {
            const int i = (k + 1) % 3, j = (k + 2) % 3;
            n[k] = e1[i] * e2[j] - e1[j] * e2[i];
        }
        alignas(64) float result[N];
        t.store(result);
        for (; lanes; lanes &= lanes - 1) {
            const int i = lowestBit(lanes);
            double depth = 0, slope = 0;
            for (int k = 0; k < 3; ++k) {
                depth += (double(triangle.v0[k]) - rays_.org[k][i]) * n[k];
                slope += rays_.dir[k][i] * n[k];
            }
            if (slope != 0) result[i] = float(depth / slope);
        }
        t = Real<N>::load(result);
    }

    const Triangle* triangles_;
    int kx_, ky_, kz_;
    const LocalRays<N>& rays_;
    Real<N> ox_, oy_, oz_, sx_, sy_, sz_, doubtful_;
};

/// Wald, "Realtime ray tracing and interactive global illumination", PhD thesis 2004, section
/// 7.1: plane first, then two projected edges from a precomputed record. Edges may leak.
template <int N>
class Fast {
public:
    Fast(const ModelView& model, const LocalRays<N>& rays, const RayGroup&)
        : records_(model.records) {
        for (int k = 0; k < 3; ++k) {
            org_[k] = Real<N>::load(rays.org[k]);
            dir_[k] = Real<N>::load(rays.dir[k]);
        }
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
