// SPDX-License-Identifier: MIT
// The precise policy: a float test with a proven error bound, and double or exact arithmetic for
// the lanes that it can not settle. What it finds is what exact arithmetic finds.
//
// The bounds, with u = 2^-24. R is the largest |vertex - origin| component of any vertex in the
// tree, D the largest component of the direction, x and y the errors of origin and direction
// (0 unless an instance transformed the ray).
//
// Sheared coordinates: v - o is off by uR + x; so is the depth. The slope s = dx / dz, |s| <= 1,
// is off by u + 2.3 y/D (y <= D/8), its product with the depth by uR more, the difference by
// u * 2R more. Together: each sheared coordinate is off by at most
//     delta = 7uR + 3x + 3Ry/D.
// Edge functions: with |coordinates| <= L, each of the two products is off by 2 L delta + delta^2
// from its exact value and by u L^2 from rounding, the difference by 2u L^2 more; as L <= 2R,
// 4u L^2 < 1.15 L delta. So the exact edge function lies within
//     B = 6 delta (L + delta)
// of the computed one, and where two are off zero by more than B in opposite directions, the line
// misses for certain; where all three are by more than B in one, it hits.
// Distance: weights are edge functions over their sum S; off by 3B / (|S| - 3B) in sum of either
// sign, which is at most 4.8 B/|S| where |S| > 8B. They move the depth by their error times the
// depth's range Z within the triangle. Evaluation adds 16u Z, and 5uR + x + 1.2 Ry/D that do not
// depend on the weights, which delta covers. So the distance is off by at most
//     |1/dz| (Z (4.8 B/|S| + 16u) + delta).
// Constants in the code are a little larger, for the roundings of the bounds themselves; floors
// of 2^-140 and 2^-125 cover what underflows. Where R is so large that products could overflow,
// or a bound is infinite or NaN, every comparison fails and arbitration decides.
#pragma once

#include "libsmart/kernel/arbitration.h"
#include "libsmart/kernel/block_hits.h"
#include "libsmart/kernel/precise_rays.h"
#include "libsmart/kernel/shear.h"

namespace smart::SMART_ISA {

template <int N>
class Precise {
public:
    using Rays = PreciseRays<N>;

    Precise(const ModelView& model, const Rays& rays, const RayGroup& group)
        : triangles_(model.triangles), shear_(rays, group) {
        const BoxView& tree = triangleBox(model);
        Real<N> reach(0.0f);
        for (int k = 0; k < 3; ++k) {
            const Real<N> org = Real<N>::load(rays.org[k]);
            reach = max(reach, max(magnitude(Real<N>(tree.lo[k]) - org),
                                   magnitude(Real<N>(tree.hi[k]) - org)));
        }
        const Real<N> depthScale = magnitude(shear_.scale());
        const Real<N> orgError = Real<N>::load(rays.orgError);
        const Real<N> dirError = Real<N>::load(rays.dirError);
        Real<N> delta = reach * (Real<N>(0x1.c1p-22f) +
                                 Real<N>(3.1f) * dirError * depthScale) +
                        (Real<N>(3.1f) * orgError + Real<N>(0x1p-140f));
        delta = select(reach <= Real<N>(0x1p60f), delta, Real<N>(__builtin_inff()));
        slope_ = Real<N>(6.1f) * delta;
        floor_ = slope_ * delta + Real<N>(0x1p-125f);
        distanceError_ = Real<N>(1.01f) * delta * depthScale;
        depthScale_ = Real<N>(1.01f) * depthScale;
    }

    /// Of the triangles of a block, those that the one ray may hit within its limits.
    HWY_INLINE void meet(const TriangleBlock& block, const Real<1>& near, const Real<1>& best,
                         BlockHits& hits) const
        requires(N == 1)
    {
        using R = Real<kPacketSize>;
        hits.sure = hits.atStart = hits.unsure = 0;
        const Sheared<kPacketSize> s = shear_(block);
        Filter<kPacketSize> filter(s, R(slope_.v), R(floor_.v));
        const uint32_t open = block.all() & ~filter.missed.bits();
        if (!open) return;
        filter.place(s, R(shear_.scale().v), R(depthScale_.v), R(distanceError_.v));
        const auto irrelevant =
            filter.inside & ((filter.high < R(near.v)) | (filter.low > R(best.v)));
        hits.unsure = open & ~irrelevant.bits();
    }

    static bool apart(float, const Real<1>&) { return false; }
    static bool isBehind(const TriangleBlock&, uint32_t, const Real<1>&, const Real<1>&) {
        return false;
    }

    /// Brings the query up to date with a triangle; `active` and `best` as in traversal. Any hit:
    /// takes lanes out of `active` that met something.
    template <HitMode M, class Counter>
    HWY_INLINE void test(uint32_t number, Mask<N>& active, Real<N>& best,
                         Search<N, M, Counter>& query) const {
        const Sheared<N> s = shear_(triangles_[number]);
        Filter<N> filter(s, slope_, floor_);
        const Mask<N> open = andNot(active, filter.missed);
        if (!any(open)) return;
        filter.place(s, shear_.scale(), depthScale_, distanceError_);
        const Mask<N> inside = filter.inside;
        const Real<N> low = filter.low, high = filter.high;
        const Real<N> near = Real<N>::load(query.tNear), bestLow = Real<N>::load(query.low);
        const Mask<N> irrelevant = inside & ((high < near) | (low > best));
        const Mask<N> clear = open & inside & (low > near) & (high < bestLow);
        if (any(clear)) {
            if constexpr (M == HitMode::Any) {
                query.blocked |= clear.bits();
                active = andNot(active, clear);
                best = select(clear, Real<N>(-__builtin_inff()), best);
            } else if constexpr (M == HitMode::All) {
                query.append(clear.bits(), number);
            } else {
                query.keepTriangle(clear, number);
                best = select(clear, high, best);
                select(clear, low, bestLow).store(query.low);
            }
        }
        const Mask<N> unclear = andNot(andNot(open, irrelevant), clear);
        if (any(unclear)) arbitrateLanes(number, unclear.bits(), active, best, query);
    }

private:
    /// What float can say of L rays and a triangle, or of one ray and L triangles.
    template <int L>
    struct Filter {
        Mask<L> missed;
        // Known once placed:
        Mask<L> inside;
        Real<L> low, high; ///< of the distance

        HWY_INLINE Filter(const Sheared<L>& s, const Real<L>& slope, const Real<L>& floor) {
            s.edgeFunctions(u, v, w);
            const Real<L> size =
                max(max(max(magnitude(s.a[0]), magnitude(s.a[1])),
                        max(magnitude(s.b[0]), magnitude(s.b[1]))),
                    max(magnitude(s.c[0]), magnitude(s.c[1])));
            bound = slope * size + floor;
            minusBound = Real<L>(0.0f) - bound;
            lowest = min(min(u, v), w);
            highest = max(max(u, v), w);
            missed = (lowest < minusBound) & (highest > bound);
        }

        HWY_INLINE void place(const Sheared<L>& s, const Real<L>& scale, const Real<L>& depthScale,
                              const Real<L>& distanceError) {
            const Real<L> sum = u + v + w;
            const Real<L> inverse = Real<L>(1.0f) / sum;
            const Real<L> share = bound * magnitude(inverse);
            inside = ((lowest > bound) | (highest < minusBound)) & (share < Real<L>(0.124f));
            const Real<L> toSecond = s.b[2] - s.a[2], toThird = s.c[2] - s.a[2];
            const Real<L> t =
                (s.a[2] + ((v * inverse) * toSecond + (w * inverse) * toThird)) * scale;
            const Real<L> range =
                max(max(s.a[2], s.b[2]), s.c[2]) - min(min(s.a[2], s.b[2]), s.c[2]);
            const Real<L> error =
                depthScale * range * (Real<L>(4.9f) * share + Real<L>(0x1p-19f)) + distanceError;
            low = t - error;
            high = t + error;
        }

    private:
        Real<L> u, v, w, bound, minusBound, lowest, highest;
    };

    template <HitMode M, class Counter>
    [[gnu::noinline]] static void arbitrateLanes(uint32_t number, uint32_t lanes, Mask<N>& active,
                                                 Real<N>& best, Search<N, M, Counter>& query) {
        alignas(64) float limits[N];
        best.store(limits);
        const WorldRays<N>& world = *query.world;
        uint32_t blocked = 0;
        TriangleName candidate, holder;
        candidate.triangle = number;
        candidate.levels = query.currentLevels;
        for (uint32_t l = 0; l < query.currentLevels; ++l) candidate.path[l] = query.currentPath[l];
        for (; lanes; lanes &= lanes - 1) {
            const int i = lowestBit(lanes);
            if (query.holds(number, i)) continue; // met in another leaf
            const WorldRay ray = worldRay(world, i);
            holder.triangle = query.triangle[i];
            holder.levels = 0;
            if (holder.triangle != kNoHit) nameHit(query, i, holder);
            Ruling ruling;
            arbitrate(*world.scene, ray, candidate, holder, query.low[i], limits[i], ruling);
            query.counter.arbitration(ruling.exact != 0);
            if (ruling.order == Order::Nothing) continue;
            if constexpr (M == HitMode::Any) {
                blocked |= 1u << i;
                limits[i] = -__builtin_inff();
            } else if constexpr (M == HitMode::All) {
                query.append(1u << i, number);
            } else {
                if (ruling.order == Order::Equal && !query.precedes(number, i)) continue;
                query.keepTriangle(Mask<N>::fromBits(1u << i), number);
                limits[i] = ruling.high;
                query.low[i] = ruling.low;
            }
        }
        if constexpr (M == HitMode::Any) {
            query.blocked |= blocked;
            active = andNot(active, Mask<N>::fromBits(blocked));
        }
        best = Real<N>::load(limits);
    }

    const Triangle* triangles_;
    Shear<N> shear_;
    Real<N> slope_, floor_, distanceError_, depthScale_;
};

} // namespace smart::SMART_ISA
