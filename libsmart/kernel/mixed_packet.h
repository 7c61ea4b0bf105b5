// SPDX-License-Identifier: MIT
// The rays of a packet, whatever their directions: each against sixteen boxes, and all of them
// against a triangle.
#pragma once

#include "libsmart/kernel/wide_rays.h"

namespace smart::SMART_ISA {

/// Rays of one packet in a model's space, with their queries' limits.
struct alignas(64) PacketRays {
    LocalRays<kPacketSize> rays;
    alignas(64) float near[kPacketSize], far[kPacketSize];
    uint32_t lanes; ///< those that carry a ray
};

/// Whether rays start close to each other, by the size of what they may meet: most of it they then
/// have in common, and none goes alone for long.
inline bool startTogether(const LocalRays<kPacketSize>& rays, uint32_t lanes, const BoxView& box) {
    using R = Real<kPacketSize>;
    constexpr float kSpread = 0x1p-4f;
    const Mask<kPacketSize> on = Mask<kPacketSize>::fromBits(lanes);
    const R inf(__builtin_inff()), none(-__builtin_inff());
    float spread = 0, size = 0;
    for (int k = 0; k < 3; ++k) {
        const R org = R::load(rays.org[k]);
        const float extent =
            largestLane(select(on, org, none)) - smallestLane(select(on, org, inf));
        spread = largerOf(spread, extent);
        size = largerOf(size, box.hi[k] - box.lo[k]);
    }
    return spread <= kSpread * size;
}

/// What Shear is to rays of one dominant axis, lane by lane the same arithmetic.
class MixedShear {
public:
    static constexpr int N = kPacketSize;

    explicit MixedShear(const LocalRays<N>& rays) {
        Real<N> dir[3], size[3];
        for (int k = 0; k < 3; ++k) {
            org_[k] = Real<N>::load(rays.org[k]);
            dir[k] = Real<N>::load(rays.dir[k]);
            size[k] = magnitude(dir[k]);
        }
        first_ = (size[0] >= size[1]) & (size[0] >= size[2]);
        second_ = andNot(size[1] >= size[2], first_);
        secondBits_ = second_.bits();
        thirdBits_ = ~(secondBits_ | first_.bits());
        const Real<N> z = turned(dir, 2);
        slopes_[0] = turned(dir, 0) / z;
        slopes_[1] = turned(dir, 1) / z;
        slopes_[2] = Real<N>(1.0f) / z;
        depthOrigin_ = turned(org_, 2);
    }

    HWY_INLINE Sheared<N> operator()(const Triangle& triangle) const {
        Sheared<N> r;
        vertex(triangle.v0, r.a);
        vertex(triangle.v1, r.b);
        vertex(triangle.v2, r.c);
        return r;
    }

    const Real<N>& scale() const { return slopes_[2]; }
    const Real<N>& depthOrigin() const { return depthOrigin_; }
    int axis(int k, int lane) const { return (dominantAxis(lane) + 1 + k) % 3; }
    int dominantAxis(int lane) const {
        return int((secondBits_ >> lane & 1) + 2 * (thirdBits_ >> lane & 1));
    }
    /// x and y over z, and 1 over z, of the directions.
    const Real<N>& slope(int k) const { return slopes_[k]; }

private:
    /// Axis k of the rays' own spaces: their dominant axis is z.
    HWY_INLINE Real<N> turned(const Real<N> (&v)[3], int k) const {
        return select(first_, v[(k + 1) % 3], select(second_, v[(k + 2) % 3], v[k]));
    }
    HWY_INLINE void vertex(const float* v, Real<N>* r) const {
        const Real<N> seen[3] = {Real<N>(v[0]) - org_[0], Real<N>(v[1]) - org_[1],
                                 Real<N>(v[2]) - org_[2]};
        r[2] = turned(seen, 2);
        r[0] = turned(seen, 0) - slopes_[0] * r[2];
        r[1] = turned(seen, 1) - slopes_[1] * r[2];
    }

    Real<N> org_[3], slopes_[3], depthOrigin_;
    Mask<N> first_, second_;
    uint32_t secondBits_, thirdBits_;
};

/// The rays of a packet as one after the other meets boxes: what TreeRays and Horizon are to rays
/// of equal signs, lane by lane.
struct alignas(64) MixedRays {
    static constexpr int N = kPacketSize;

    float reciprocal[3][N], enterOrg[3][N], leaveOrg[3][N];
    float slack[N]; ///< of the horizon
    /// Where in a node the planes lie that a ray passes first, as nearPlanes says.
    uint32_t nearAt[3][N];
    uint32_t negative[3]; ///< bits of lanes
    Real<N> reachPad; ///< twice what boxes are widened by

    MixedRays(const BoxView& box, const LocalRays<N>& rays, float padding) {
        Real<N> scale(box.maxAbs), largest(0.0f);
        for (int k = 0; k < 3; ++k) {
            scale = max(scale, magnitude(Real<N>::load(rays.org[k])));
            largest = max(largest, magnitude(Real<N>::load(rays.dir[k])));
        }
        const Real<N> widened = scale * Real<N>(padding);
        reachPad = widened + widened;
        for (int k = 0; k < 3; ++k) {
            const Real<N> dir = Real<N>::load(rays.dir[k]), org = Real<N>::load(rays.org[k]);
            const Mask<N> down = dir < Real<N>(0.0f);
            negative[k] = down.bits();
            const uint32_t lowAt = uint32_t(k * kWideChildren);
            select(down, Word<N>(lowAt + kPlanesOfNode / 2), Word<N>(lowAt)).store(nearAt[k]);
            boundedReciprocal(dir).store(reciprocal[k]);
            const Real<N> late = org + widened, early = org - widened;
            select(down, early, late).store(enterOrg[k]);
            select(down, late, early).store(leaveOrg[k]);
        }
        min((Real<N>(box.maxAbs) + scale) * Real<N>(0x1p-15f) / largest, Real<N>(0x1p126f))
            .store(slack);
    }

    /// One lane of them.
    void take(int lane, RayGroup& group, TreeRays<1>& ray) const {
        for (int k = 0; k < 3; ++k) {
            group.negative[k] = (negative[k] >> lane & 1) != 0;
            ray.reciprocal[k].v = reciprocal[k][lane];
            ray.enterOrg[k].v = enterOrg[k][lane];
            ray.leaveOrg[k].v = leaveOrg[k][lane];
        }
    }

    /// See meetBoxes of a ray alone. Places without a child may be among them.
    HWY_INLINE Mask<N> meetBoxes(const WideNode& node, int lane, float near, float far,
                                 Real<N>& from) const {
        Real<N> to(far);
        from = Real<N>(near);
        const float* const planes = &node.lo[0][0];
        for (int k = 0; k < 3; ++k) {
            const uint32_t at = nearAt[k][lane];
            const uint32_t both = uint32_t(2 * k * kWideChildren) + kPlanesOfNode / 2;
            const Real<N> first = Real<N>::load(planes + at);
            const Real<N> last = Real<N>::load(planes + (both - at));
            const Real<N> inverse(reciprocal[k][lane]);
            from = max(from, (first - Real<N>(enterOrg[k][lane])) * inverse);
            to = min(to, (last - Real<N>(leaveOrg[k][lane])) * inverse);
        }
        return from <= to;
    }

    /// Which rays of the packet meet one box.
    Mask<N> meet(const WideNode& node, uint32_t slot, const Real<N>& near,
                 const Real<N>& far) const {
        Real<N> from = near, to = far;
        for (int k = 0; k < 3; ++k) {
            const Mask<N> down = Mask<N>::fromBits(negative[k]);
            const Real<N> lo(node.lo[k][slot]), hi(node.hi[k][slot]);
            const Real<N> inverse = Real<N>::load(reciprocal[k]);
            from = max(from, (select(down, hi, lo) - Real<N>::load(enterOrg[k])) * inverse);
            to = min(to, (select(down, lo, hi) - Real<N>::load(leaveOrg[k])) * inverse);
        }
        return from <= to;
    }
};

} // namespace smart::SMART_ISA
