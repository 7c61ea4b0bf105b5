// SPDX-License-Identifier: MIT
// Iterative traversal of a kd-tree by a group of rays with equal direction signs.
//
// No ray may slip through where cells meet, although split distances and the triangle test
// round: every plane is moved against the ray by a pad of a few units in the last place of the
// largest coordinate involved, before a cell for those who leave it and after for those who
// enter, so that neighbouring intervals overlap by more than all roundings together (a distance
// (s - o) / d has a relative error of 3 * 2^-24; the test's shear moves a hit by as little).
// Hits are accepted anywhere in the ray's range, not only inside the cell.
//
// A lane visits the leaves that it would visit alone: what it finds does not depend on the others.
#pragma once

#include "libsmart/kernel/precise_rays.h"
#include "libsmart/kernel/shear.h"

namespace smart::SMART_ISA {

/// 1/x bounded: no infinity, hence no NaN from 0 * infinity; +-0 counts as positive.
template <int N>
Real<N> boundedReciprocal(const Real<N>& x) {
    constexpr float kBound = 0x1p126f;
    const Real<N> r = min(max(Real<N>(1.0f) / x, Real<N>(-kBound)), Real<N>(kBound));
    return select(x == Real<N>(0.0f), Real<N>(kBound), r);
}

/// How far the planes of a kd-tree are moved, as a share of the largest coordinate.
inline constexpr float kSplitPadding = 0x1p-21f;

/// How far planes across an axis are moved.
template <int N>
class PlanePadding {
public:
    PlanePadding(const BoxView& tree, const LocalRays<N>& rays, const RayGroup&, float share) {
        Real<N> scale(tree.maxAbs);
        for (int k = 0; k < 3; ++k) scale = max(scale, magnitude(Real<N>::load(rays.org[k])));
        padding_ = scale * Real<N>(share);
    }
    const Real<N>& operator()(int) const { return padding_; }

private:
    Real<N> padding_;
};

/// With u = 2^-24 and S the largest coordinate on the axis: the computed distance (s - o) / d
/// rounds three times, which is 3u * 2S on the axis, and the padded origin once, by u S; the pad
/// of 8u S covers that. An origin off by x moves a point by x, a direction off by y by t y, where t
/// is at most 2S over the direction on its dominant axis; so does a direction below 2^-126, whose
/// reciprocal was bounded. Where a difference could overflow, every cell is visited.
template <int N>
class PrecisePadding {
public:
    PrecisePadding(const BoxView& tree, const PreciseRays<N>& rays, const RayGroup& group)
        : tree_(tree), rays_(rays) {
        const int axis = group.dominantAxis;
        error_ = Real<N>::load(rays.orgError) * Real<N>(1.25f) + Real<N>(0x1p-144f) +
                 (Real<N>::load(rays.dirError) * Real<N>(2.5f) /
                      magnitude(Real<N>::load(rays.dir[axis])) +
                  Real<N>(0x1p-100f)) *
                     scale(axis);
    }
    Real<N> operator()(int axis) const {
        const Real<N> size = scale(axis);
        return select(size < Real<N>(0x1p126f), size * Real<N>(0x1p-21f) + error_,
                      Real<N>(__builtin_inff()));
    }

private:
    Real<N> scale(int axis) const {
        const Real<N> box(largerOf(__builtin_fabsf(tree_.lo[axis]),
                                   __builtin_fabsf(tree_.hi[axis])));
        return max(box, magnitude(Real<N>::load(rays_.org[axis])));
    }
    const BoxView& tree_;
    const PreciseRays<N>& rays_;
    Real<N> error_;
};

template <int N>
PlanePadding<N> planePadding(const BoxView& tree, const LocalRays<N>& rays, const RayGroup& group,
                             float share) {
    return {tree, rays, group, share};
}
template <int N>
PrecisePadding<N> planePadding(const BoxView& tree, const PreciseRays<N>& rays,
                               const RayGroup& group, float) {
    return {tree, rays, group};
}

/// Rays ready for one tree.
template <int N>
struct TreeRays {
    Real<N> reciprocal[3];
    Real<N> leaveOrg[3]; ///< origins for the distance at which a cell ends: padded to be late
    Real<N> enterOrg[3]; ///< ... begins: padded to be early
    const RayGroup& group;

    /// To be filled in.
    explicit TreeRays(const RayGroup& g) : group(g) {}
    /// share: see PlanePadding
    template <class Rays>
    TreeRays(const BoxView& tree, const Rays& rays, const RayGroup& g, float share) : group(g) {
        const auto paddings = planePadding(tree, rays, g, share);
        for (int k = 0; k < 3; ++k) {
            const Real<N> padding = paddings(k);
            const Real<N> org = Real<N>::load(rays.org[k]);
            reciprocal[k] = boundedReciprocal(Real<N>::load(rays.dir[k]));
            leaveOrg[k] = g.negative[k] ? org + padding : org - padding;
            enterOrg[k] = g.negative[k] ? org - padding : org + padding;
        }
    }

    Real<N> leaveDistance(float plane, int axis) const {
        return (Real<N>(plane) - leaveOrg[axis]) * reciprocal[axis];
    }
    Real<N> enterDistance(float plane, int axis) const {
        return (Real<N>(plane) - enterOrg[axis]) * reciprocal[axis];
    }

    void clip(const BoxView& tree, Real<N>& tNear, Real<N>& tFar) const {
        for (int k = 0; k < 3; ++k) {
            const float first = group.negative[k] ? tree.hi[k] : tree.lo[k];
            const float last = group.negative[k] ? tree.lo[k] : tree.hi[k];
            tNear = max(tNear, enterDistance(first, k));
            tFar = min(tFar, leaveDistance(last, k));
        }
    }
};

/// Visits the leaves of a tree front to back. visit(firstPrim, count, active lanes) -> the lanes'
/// far limits from then on. A lane takes part while its near distance is at most its far one.
template <int N, class Counter, class Visit>
void traverseKd(const KdView& tree, const TreeRays<N>& rays, const Real<N>& rangeNear,
                Real<N> limit, Counter& counter, const Visit& visit) {
    struct Entry {
        Real<N> tNear, tFar;
        uint32_t node;
    };
    Entry stack[kKdMaxDepth];
    int top = 0;

    Real<N> tNear = rangeNear, tFar = limit;
    rays.clip(tree, tNear, tFar);
    if (!any(tNear <= tFar)) return;
    uint32_t index = 0;
    while (true) {
        KdNode node = tree.nodes[index];
        while ((node.bits & 3) != kKdLeaf) {
            counter.node();
            const int axis = int(node.bits & 3);
            const uint32_t left = node.bits >> 2;
            const uint32_t nearChild = left + (rays.group.negative[axis] ? 1 : 0);
            const uint32_t farChild = left + (rays.group.negative[axis] ? 0 : 1);
            const Real<N> nearEnd = min(tFar, rays.leaveDistance(node.split, axis));
            const Real<N> farStart = max(tNear, rays.enterDistance(node.split, axis));
            const bool visitNear = any(tNear <= nearEnd);
            const bool visitFar = any(farStart <= tFar);
            if (visitNear) {
                if (visitFar) {
                    stack[top++] = {farStart, tFar, farChild};
                    tFar = nearEnd;
                }
                index = nearChild;
            } else {
                if (!visitFar) break;
                index = farChild;
            }
            node = tree.nodes[index];
        }
        if ((node.bits & 3) == kKdLeaf && (node.bits >> 2) != 0) {
            counter.leaf();
            limit = visit(node.firstPrim, node.bits >> 2, tNear <= tFar);
        }
        do {
            if (top == 0) return;
            --top;
            tNear = stack[top].tNear;
            tFar = min(stack[top].tFar, limit);
            index = stack[top].node;
        } while (!any(tNear <= tFar));
    }
}

} // namespace smart::SMART_ISA
