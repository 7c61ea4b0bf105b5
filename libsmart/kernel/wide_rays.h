// SPDX-License-Identifier: MIT
// Traversal of wide nodes by rays that need have nothing in common: one ray against sixteen boxes,
// or the rays of a packet, of equal direction signs, against one box after the other.
//
// No ray may be lost. Boxes are widened by a share of S, the largest coordinate involved, and
// distances are computed as in the kd-tree (kd_traversal.h), which errs by less than 7u S across
// an axis, u = 2^-24 (Ize, "Robust BVH ray traversal", JCGT 2(2), 2013, has the same three
// roundings in relative form). The float test of a triangle errs too: it shears vertices by up to
// 6u R more or less, where R, the largest difference of vertex and origin, is at most 2 S. What it
// takes for a hit is then within 12u S of the triangle, hence of its box. 24u S covers both. The
// precise mode takes nothing for a hit that is none: its padding (PrecisePadding) stays.
//
// In what order boxes are visited differs between rays alone and in packets. Hits do not depend on
// it: see Horizon.
#pragma once

#include <cstddef>

#include "libsmart/kernel/kd_traversal.h"

namespace smart::SMART_ISA {

inline constexpr float kBoxPadding = 0x1.8p-20f;

/// How far away boxes may begin that can still matter, where the best hits are at `best`: the float
/// distance of what is in a box can be less than where the box begins. As much is added as
/// Watertight allows for when it compares distances, and as much again; then what is found does
/// not depend on what was visited first.
template <int N>
class Horizon {
public:
    Horizon(const BoxView& box, const LocalRays<N>& rays, const RayGroup& group) {
        const int axis = group.dominantAxis;
        slack_ = (Real<N>(box.maxAbs) + magnitude(Real<N>::load(rays.org[axis]))) *
                 Real<N>(0x1p-15f) / magnitude(Real<N>::load(rays.dir[axis]));
        slack_ = min(slack_, Real<N>(0x1p126f)); // -infinity must stay that
    }
    Horizon(const BoxView&, const PreciseRays<N>&, const RayGroup&) : slack_(0.0f) {}
    Real<N> operator()(const Real<N>& best) const { return best + slack_; }

private:
    Real<N> slack_;
};

/// Floats before WideNode::child: lo and, as many again, hi.
inline constexpr uint32_t kPlanesOfNode = 6 * kWideChildren;
static_assert(offsetof(WideNode, hi) == kPlanesOfNode / 2 * sizeof(float));

/// The planes of a node's boxes that a ray passes first on an axis, by address: rays that take
/// turns have signs that no branch could predict.
HWY_INLINE const float* nearPlanes(const WideNode& node, int axis, bool negative) {
    return &node.lo[0][0] + uint32_t(axis * kWideChildren) + kPlanesOfNode / 2 * negative;
}

/// Which boxes of a node a ray meets between `near` and `far`, and from what distance on. Places
/// without a child are none of them, whatever the ray.
HWY_INLINE Mask<kPacketSize> meetBoxes(const WideNode& node, const TreeRays<1>& ray, float near,
                                       float far, Real<kPacketSize>& from) {
    using R = Real<kPacketSize>;
    R to(far);
    from = R(near);
    for (int k = 0; k < 3; ++k) {
        const bool negative = ray.group.negative[k];
        const R first = R::load(nearPlanes(node, k, negative));
        const R last = R::load(nearPlanes(node, k, !negative));
        const R reciprocal(ray.reciprocal[k].v);
        from = max(from, (first - R(ray.enterOrg[k].v)) * reciprocal);
        to = min(to, (last - R(ray.leaveOrg[k].v)) * reciprocal);
    }
    const auto used = R::load(node.lo[0]) <= R::load(node.hi[0]);
    return used & (from <= to);
}

/// Visits the leaves that a ray may meet, nearest boxes first. visit(leaf) -> how far the ray looks
/// from then on.
template <class Counter, class Visit>
void traverseWide(const WideNode* nodes, const TreeRays<1>& ray, float near, float far,
                  Counter& counter, const Visit& visit) {
    struct Entry {
        float from;
        uint32_t child;
    };
    Entry stack[kWideMaxDepth * kWideChildren];
    int top = 0;
    uint32_t child = 0;
    while (true) {
        if (child & kWideLeaf) {
            counter.leaf();
            far = visit(child);
        } else {
            counter.node();
            const WideNode& node = nodes[child];
            Real<kPacketSize> entered;
            uint32_t hits = meetBoxes(node, ray, near, far, entered).bits();
            if (hits) {
                const int first = lowestBit(hits);
                hits &= hits - 1;
                if (!hits) {
                    child = node.child[first];
                    continue;
                }
                alignas(64) float from[kPacketSize];
                entered.store(from);
                const int base = top;
                stack[top++] = {from[first], node.child[first]};
                for (; hits; hits &= hits - 1) {
                    const int slot = lowestBit(hits);
                    int at = top++;
                    for (; at > base && stack[at - 1].from < from[slot]; --at)
                        stack[at] = stack[at - 1];
                    stack[at] = {from[slot], node.child[slot]};
                }
            }
        }
        do {
            if (top == 0) return;
            --top;
        } while (!(stack[top].from <= far));
        child = stack[top].child;
    }
}

/// What the rays of a packet span, so that sixteen boxes can be tested against all of them. Every
/// rounding is monotonous: no ray of the packet enters a box earlier, nor leaves it later, than
/// these bounds say.
class PacketSpan {
public:
    static constexpr int N = kPacketSize;
    PacketSpan(const TreeRays<N>& rays) : group_(rays.group) {
        const Mask<N> on = Mask<N>::fromBits(rays.group.lanes);
        const Real<N> inf(__builtin_inff()), none(-__builtin_inff());
        for (int k = 0; k < 3; ++k) {
            const bool negative = group_.negative[k];
            slow_[k] = smallestLane(select(on, rays.reciprocal[k], inf));
            fast_[k] = largestLane(select(on, rays.reciprocal[k], none));
            // The later a ray starts on an axis, the earlier it enters.
            enter_[k] = negative ? smallestLane(select(on, rays.enterOrg[k], inf))
                                 : largestLane(select(on, rays.enterOrg[k], none));
            leave_[k] = negative ? largestLane(select(on, rays.leaveOrg[k], none))
                                 : smallestLane(select(on, rays.leaveOrg[k], inf));
        }
    }

    HWY_INLINE Mask<N> meetBoxes(const WideNode& node, float near, float far,
                                 Real<N>& from) const {
        Real<N> to(far);
        from = Real<N>(near);
        for (int k = 0; k < 3; ++k) {
            const bool negative = group_.negative[k];
            const Real<N> slow(slow_[k]), fast(fast_[k]);
            const Real<N> first =
                Real<N>::load(negative ? node.hi[k] : node.lo[k]) - Real<N>(enter_[k]);
            const Real<N> last =
                Real<N>::load(negative ? node.lo[k] : node.hi[k]) - Real<N>(leave_[k]);
            from = max(from, min(first * slow, first * fast));
            to = min(to, max(last * slow, last * fast));
        }
        const auto used = Real<N>::load(node.lo[0]) <= Real<N>::load(node.hi[0]);
        return used & (from <= to);
    }

private:
    const RayGroup& group_;
    float slow_[3], fast_[3]; ///< least and largest reciprocal
    float enter_[3], leave_[3];
};

/// Which rays of a packet meet a box between `near` and `far`.
HWY_INLINE Mask<kPacketSize> meetBox(const WideNode& node, uint32_t slot,
                                     const TreeRays<kPacketSize>& rays,
                                     const Real<kPacketSize>& near, const Real<kPacketSize>& far) {
    using R = Real<kPacketSize>;
    R from = near, to = far;
    for (int k = 0; k < 3; ++k) {
        const bool negative = rays.group.negative[k];
        const float first = negative ? node.hi[k][slot] : node.lo[k][slot];
        const float last = negative ? node.lo[k][slot] : node.hi[k][slot];
        from = max(from, rays.enterDistance(first, k));
        to = min(to, rays.leaveDistance(last, k));
    }
    return from <= to;
}

/// The same for a group of a packet: visit(leaf, rays that meet its box) -> how far the rays look
/// from then on, -infinity for those that do not, nor are in the group.
template <class Counter, class Visit>
void traverseWide(const WideNode* nodes, const TreeRays<kPacketSize>& rays,
                  const Real<kPacketSize>& near, Real<kPacketSize> far, Counter& counter,
                  const Visit& visit) {
    constexpr int N = kPacketSize;
    struct Entry {
        float from;
        uint32_t child;
        uint32_t node; ///< whose child it is
        uint32_t slot;
    };
    const PacketSpan span(rays);
    const float nearest = smallestLane(
        select(Mask<N>::fromBits(rays.group.lanes), near, Real<N>(__builtin_inff())));
    float farthest = largestLane(far);
    Entry stack[kWideMaxDepth * kWideChildren];
    int top = 0;
    const auto open = [&](uint32_t index) HWY_ATTR {
        counter.node();
        const WideNode& node = nodes[index];
        Real<N> entered;
        alignas(64) float from[N];
        uint32_t hits = span.meetBoxes(node, nearest, farthest, entered).bits();
        entered.store(from);
        const int base = top;
        for (; hits; hits &= hits - 1) {
            const uint32_t slot = uint32_t(lowestBit(hits));
            int at = top++;
            for (; at > base && stack[at - 1].from < from[slot]; --at) stack[at] = stack[at - 1];
            stack[at] = {from[slot], node.child[slot], index, slot};
        }
    };
    open(0);
    while (top > 0) {
        const Entry entry = stack[--top];
        if (!(entry.from <= farthest)) continue;
        const Mask<N> active = meetBox(nodes[entry.node], entry.slot, rays, near, far);
        if (!any(active)) continue;
        if (entry.child & kWideLeaf) {
            counter.leaf();
            far = visit(entry.child, active);
            farthest = largestLane(far);
        } else {
            open(entry.child);
        }
    }
}

} // namespace smart::SMART_ISA
