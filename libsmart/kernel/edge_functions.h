// SPDX-License-Identifier: MIT
// Up to sixteen triangles of leaves as a beam sees them: linear functions of a ray's slopes, with
// bounds of their errors. Where they can not decide, the exact test of the single ray does.
#pragma once

#include "libsmart/kernel/leaf_group.h"

namespace smart::SMART_ISA {

/// With A, B, C the vertices as seen from the apex, sheared by the beam's centre, and D = (x, y, 1)
/// a ray's slopes less the centre's: its edge functions (Woop, Benthin, Wald 2013)
/// are (B x C).D, (C x A).D and (A x B).D; the ray passes inside where all have the sign of their
/// sum. With M = (B - A) x (C - A) and det = M.A, the plane is met at z = det / M.D. All are scaled
/// here so that the inside is positive, and 1/w is stored for the plane.
///
/// Bound of the edge functions. Let u = 2^-24; m the largest sheared x or y plus the beam's half
/// width times Z, no smaller than any coordinate sheared by a ray of the beam; Z the largest |z|;
/// slopes are at most 1. The exact test decides by the sign of
///   E(a, b) = a_x b_y - a_y b_x,  with vertices sheared by the ray's slope.
/// Both ways start from the same float differences v - o, if rays start at the apex. From there a
/// sheared coordinate is off by
///   exact test:  u Z (rounded slope) + u Z (product) + u m (difference)        = 2 u Z + u m,
///   here:        u Z (product) + u m, and for the slopes 2 u Z + u m           = 3 u Z + 2 u m.
/// An error d of all coordinates changes E by at most 4 m d + 2 d^2: together 20 u Z m + 12 u m^2.
/// Computing B x C rounds each of its components by 4 u times the product of its factors, at most
/// 4 u m (m + h Z) <= 4 u m^2 a term after scaling with D; the dot product adds 6 u m^2. So
///   bound = m (24 u Z + 40 u m), the square terms included.
/// Where rays head for the apex, v - o is another difference for each ray: that adds
/// 4 m (2 u (F + Z) + 2 u R + s) with F <= Z + m the largest |x| or |y|, R the reach of the origins
/// and s the stray of the lines, so bound = m (40 u Z + 16 u R + 5 s + 48 u m). A tiny constant
/// covers underflow.
///
/// Bound of 1/w. The edge errors move the plane by no more than bound * T / |det| of w, T being the
/// triangle's own depth: the sum of the weighted depths is det. Rounding of M and of both products,
/// with L the largest edge across: 24 u L (T m + L Z) / |det|. The sum, times two, is the relative
/// error that depths are compared with; where it exceeds 2^-4, the exact test decides about depth,
/// and where not even the sign of det is certain, about all rays. The float distance that the exact
/// test finds for rays that are surely inside is off by no more, as its edge functions err by less.
struct alignas(64) EdgeFunctions {
    static constexpr int N = kPacketSize;

    float x[3][N], y[3][N], z[3][N];
    float depthX[N], depthY[N], depthZ[N]; ///< 1/w; +infinity where it is not known
    float bound[N];                        ///< below minus this: outside
    float sure[N];                         ///< from this on: inside, if the depth decides too
    float nearer[N], farther[N]; ///< 1/w times these: its bounds, the larger one first

    /// Which packets may meet which triangles of those leaves nearer than 1 / farthest[v]: bit
    /// 16 v + i for packet v and triangle i. Slack widens the triangles.
    HWY_INLINE uint64_t setUp(const Beam& beam, const LeafGroup& leaves, const float* farthest,
                              float slack) {
        uint64_t candidates = 0;
        for (uint32_t first = 0; first < (kAtOnce < N ? leaves.count() : 1u); first += kAtOnce)
            candidates |= setUpSome(beam, leaves, first, farthest, slack);
        return candidates & leaves.pairs();
    }

    /// 1 / depth at which rays of those slopes meet the plane of triangle i.
    HWY_INLINE Real<N> inverseDepth(int i, const Real<N>& slopeX, const Real<N>& slopeY) const {
        return Real<N>(depthZ[i]) + Real<N>(depthX[i]) * slopeX + Real<N>(depthY[i]) * slopeY;
    }

private:
    /// A register of triangles: most leaves hold fewer than sixteen.
    static constexpr int kAtOnce = kRegisterLanes;

    /// From triangle `first` on; bits beyond the last triangle are of any value.
    HWY_INLINE uint64_t setUpSome(const Beam& beam, const LeafGroup& leaves, uint32_t first,
                                  const float* farthest, float slack);
};

HWY_INLINE uint64_t EdgeFunctions::setUpSome(const Beam& beam, const LeafGroup& leaves,
                                             uint32_t first, const float* farthest, float slack) {
    using R = Real<kAtOnce>;
    R px[3], py[3], pz[3];
    R m(0.0f), deep(0.0f);
    for (int c = 0; c < 3; ++c) {
        const auto seen = [&](int k) {
            return R::load(leaves.coordinates(c, beam.axis(k)) + first) - R(beam.apex(k));
        };
        pz[c] = seen(2);
        px[c] = seen(0) - R(beam.centre(0)) * pz[c];
        py[c] = seen(1) - R(beam.centre(1)) * pz[c];
        m = max(m, max(magnitude(px[c]), magnitude(py[c])));
        deep = max(deep, magnitude(pz[c]));
    }
    const R e1x = px[1] - px[0], e1y = py[1] - py[0], e1z = pz[1] - pz[0];
    const R e2x = px[2] - px[0], e2y = py[2] - py[0], e2z = pz[2] - pz[0];
    const R mx = e1y * e2z - e1z * e2y;
    const R my = e1z * e2x - e1x * e2z;
    const R mz = e1x * e2y - e1y * e2x;
    const R det = mx * px[0] + my * py[0] + mz * pz[0];

    const R thick = max(magnitude(e1z), max(magnitude(e2z), magnitude(e1z - e2z)));
    const R wide = max(max(magnitude(e1x), magnitude(e2x)), max(magnitude(e1y), magnitude(e2y)));
    m = m + R(largerOf(beam.half(0), beam.half(1))) * deep;
    const R limit = m * (R(0x28p-24f) * deep + R(0x30p-24f) * m + R(slack)) + R(0x1p-120f);
    const R doubt = R(0x1p2f) * limit * thick + R(0x1p-18f) * wide * (thick * m + wide * deep);
    const R least(0x1p-110f), infinity(__builtin_inff()), zero(0.0f); // below: underflow
    const R size = magnitude(det), inverse = R(1.0f) / max(size, least);
    const R unknown(0x1p100f);
    const R error = select(size >= least, min(doubt * inverse + R(0x1p-20f), unknown), unknown);
    const Mask<kAtOnce> regular = error <= R(0x1p-4f);
    const R one = select(det < R(0.0f), R(-beam.depthSign()), R(beam.depthSign()));
    // 0: the sign is not known. As error <= 1/4, without waiting for the division.
    const R flip = select((size >= least) & (doubt <= size * R(0.25f - 0x1p-18f)), one, R(0.0f));
    const R scale = flip * inverse;
    const R dx = select(regular, mx * scale, zero), dy = select(regular, my * scale, zero);
    const R dz = select(regular, mz * scale, infinity);
    dx.store(depthX + first);
    dy.store(depthY + first);
    dz.store(depthZ + first);
    limit.store(bound + first);
    select(regular, limit, infinity).store(sure + first);
    const R up = R(1.0f) + error;
    up.store(nearer + first);
    (R(1.0f) - error).store(farther + first);

    const R halfX(beam.packetHalf(0)), halfY(beam.packetHalf(1));
    R nx[3], ny[3], nz[3], reach[3];
    for (int e = 0; e < 3; ++e) {
        const int b = (e + 1) % 3, c = (e + 2) % 3;
        nx[e] = (py[b] * pz[c] - pz[b] * py[c]) * flip;
        ny[e] = (pz[b] * px[c] - px[b] * pz[c]) * flip;
        nz[e] = (px[b] * py[c] - py[b] * px[c]) * flip;
        nx[e].store(x[e] + first);
        ny[e].store(y[e] + first);
        nz[e].store(z[e] + first);
        reach[e] = nz[e] + magnitude(nx[e]) * halfX + magnitude(ny[e]) * halfY + limit;
    }
    const R nearest = (dz + magnitude(dx) * halfX + magnitude(dy) * halfY) * up;
    uint64_t candidates = 0;
    for (uint32_t rest = leaves.packets(); rest; rest &= rest - 1) {
        const int v = lowestBit(rest);
        const R cx(beam.packetCentre(0, v)), cy(beam.packetCentre(1, v));
        Mask<kAtOnce> in = nearest + (dx * cx + dy * cy) * up >= R(farthest[v]);
        for (int e = 0; e < 3; ++e) in = in & (reach[e] + nx[e] * cx + ny[e] * cy >= zero);
        candidates |= uint64_t(in.bits()) << (16 * v + int(first));
    }
    return candidates;
}

} // namespace smart::SMART_ISA
