// SPDX-License-Identifier: MIT
// Woop, Benthin, Wald, "Watertight ray/triangle intersection", JCGT 2(1), 2013: vertices are
// translated and sheared into a space where the ray is the z axis; the signs of three 2D edge
// functions say whether it passes inside. Each vertex is sheared alike in every triangle.
#pragma once

#include "libsmart/kernel/search.h"
#include "libsmart/kernel/triangle_block.h"

namespace smart::SMART_ISA {

/// Rays that share the signs of their direction and its dominant axis.
struct RayGroup {
    uint32_t lanes;
    bool negative[3];
    int dominantAxis;
};

/// A triangle in the space of the rays: x, y sheared, z translated only.
template <int N>
struct Sheared {
    Real<N> a[3], b[3], c[3];

    void edgeFunctions(Real<N>& u, Real<N>& v, Real<N>& w) const {
        u = c[0] * b[1] - c[1] * b[0];
        v = a[0] * c[1] - a[1] * c[0];
        w = b[0] * a[1] - b[1] * a[0];
    }
};

/// A ray's direction over its dominant component, and 1 over that.
struct RaySlopes {
    float x, y, z;
};

template <int N>
class Shear {
public:
    Shear(const LocalRays<N>& rays, const RayGroup& group)
        : kx_((group.dominantAxis + 1) % 3),
          ky_((group.dominantAxis + 2) % 3),
          kz_(group.dominantAxis) {
        ox_ = Real<N>::load(rays.org[kx_]);
        oy_ = Real<N>::load(rays.org[ky_]);
        oz_ = Real<N>::load(rays.org[kz_]);
        sz_ = Real<N>(1.0f) / Real<N>::load(rays.dir[kz_]);
        sx_ = Real<N>::load(rays.dir[kx_]) / Real<N>::load(rays.dir[kz_]);
        sy_ = Real<N>::load(rays.dir[ky_]) / Real<N>::load(rays.dir[kz_]);
    }

    /// One ray, as the other constructor does.
    Shear(const LocalRays<1>& ray, const RayGroup& group, const RaySlopes& slopes)
        requires(N == 1)
        : kx_((group.dominantAxis + 1) % 3),
          ky_((group.dominantAxis + 2) % 3),
          kz_(group.dominantAxis),
          ox_(ray.org[kx_][0]),
          oy_(ray.org[ky_][0]),
          oz_(ray.org[kz_][0]),
          sx_(slopes.x),
          sy_(slopes.y),
          sz_(slopes.z) {}

    HWY_INLINE Sheared<N> operator()(const Triangle& triangle) const {
        Sheared<N> r;
        vertex(triangle.v0, r.a);
        vertex(triangle.v1, r.b);
        vertex(triangle.v2, r.c);
        return r;
    }

    /// The triangles of a block, one a lane, in the space of the one ray.
    HWY_INLINE Sheared<kPacketSize> operator()(const TriangleBlock& block) const
        requires(N == 1)
    {
        Sheared<kPacketSize> r;
        vertices(block, 0, r.a);
        vertices(block, 1, r.b);
        vertices(block, 2, r.c);
        return r;
    }

    /// Distance for each unit of depth (z).
    const Real<N>& scale() const { return sz_; }
    const Real<N>& depthOrigin() const { return oz_; }
    /// Which axis of the model became x, y and z, for a lane.
    int axis(int k, int) const { return k == 0 ? kx_ : k == 1 ? ky_ : kz_; }

private:
    HWY_INLINE void vertex(const float* v, Real<N>* r) const {
        r[2] = Real<N>(v[kz_]) - oz_;
        r[0] = (Real<N>(v[kx_]) - ox_) - sx_ * r[2];
        r[1] = (Real<N>(v[ky_]) - oy_) - sy_ * r[2];
    }

    HWY_INLINE void vertices(const TriangleBlock& block, int vertex, Real<kPacketSize>* r) const {
        using R = Real<kPacketSize>;
        r[2] = block.coordinate(vertex, kz_) - R(oz_.v);
        r[0] = (block.coordinate(vertex, kx_) - R(ox_.v)) - R(sx_.v) * r[2];
        r[1] = (block.coordinate(vertex, ky_) - R(oy_.v)) - R(sy_.v) * r[2];
    }

    int kx_, ky_, kz_;
    Real<N> ox_, oy_, oz_, sx_, sy_, sz_;
};

} // namespace smart::SMART_ISA
