// SPDX-License-Identifier: MIT
// Models and the instances nested in them: rays go to object space, meet the model there, and
// keep the nearest hit. Recursion is as deep as instances nest.
#pragma once

#include <type_traits>

#include "libsmart/kernel/affine_inverse.h"
#include "libsmart/kernel/intersect.h"
#include "libsmart/kernel/precise.h"
#include "libsmart/kernel/single_lane.h"
#include "libsmart/kernel/wide_rays.h"

namespace smart::SMART_ISA {

/// Rays of an instance's parent in the instance's own space; computed in double, rounded once.
template <int N>
void transformRays(const AffineRows& toObject, const LocalRays<N>& rays, LocalRays<N>& local) {
    for (int k = 0; k < 3; ++k) {
        const double* m = toObject[k];
        for (int i = 0; i < N; ++i) {
            const double x = rays.org[0][i], y = rays.org[1][i], z = rays.org[2][i];
            local.org[k][i] = float(m[0] * x + m[1] * y + m[2] * z + m[3]);
        }
        for (int i = 0; i < N; ++i) {
            const double x = rays.dir[0][i], y = rays.dir[1][i], z = rays.dir[2][i];
            local.dir[k][i] = float(m[0] * x + m[1] * y + m[2] * z);
        }
    }
}
template <int N>
void transformRays(const InstanceView& instance, const LocalRays<N>& rays, LocalRays<N>& local) {
    AffineRows toObject;
    invert(instance, toObject);
    transformRays(toObject, rays, local);
}

/// The model of an instance as rays walk it.
inline const ModelView& reached(const InstanceView& instance) {
    const DeferredView* const deferred = instance.model->deferred;
    return deferred ? *deferred->reach(*deferred) : *instance.model;
}

/// Splits lanes into groups of equal direction signs and dominant axis, the lowest lane's first.
template <int N>
class RayGroups {
public:
    RayGroups(const LocalRays<N>& rays, uint32_t lanes) : rest_(lanes) {
        const Real<N> zero(0.0f);
        const Real<N> d[3] = {Real<N>::load(rays.dir[0]), Real<N>::load(rays.dir[1]),
                              Real<N>::load(rays.dir[2])};
        Real<N> size[3];
        for (int k = 0; k < 3; ++k) {
            negative_[k] = (d[k] < zero).bits();
            size[k] = magnitude(d[k]);
        }
        dominant_[0] = ((size[0] >= size[1]) & (size[0] >= size[2])).bits();
        dominant_[1] = (size[1] >= size[2]).bits() & ~dominant_[0];
        dominant_[2] = ~(dominant_[0] | dominant_[1]);
    }

    bool next(RayGroup& group) {
        if (!rest_) return false;
        const uint32_t first = rest_ & (0u - rest_);
        group.lanes = rest_;
        for (int k = 0; k < 3; ++k) {
            group.negative[k] = (negative_[k] & first) != 0;
            group.lanes &= group.negative[k] ? negative_[k] : ~negative_[k];
            if (dominant_[k] & first) {
                group.dominantAxis = k;
                group.lanes &= dominant_[k];
            }
        }
        rest_ &= ~group.lanes;
        return true;
    }

private:
    uint32_t rest_;
    uint32_t negative_[3], dominant_[3];
};

template <template <int> class Precision, int N, HitMode M, class Counter>
class SceneTraversal {
public:
    using Query = Search<N, M, Counter>;
    using Rays = typename Precision<N>::Rays;

    static void model(const ModelView& model, const Rays& rays, uint32_t lanes,
                      Query& query) {
        const bool wide = model.wide.nodes, kd = model.tree.nodes;
        if (!wide && !kd && !model.childTree.nodes) {
            for (uint32_t i = 0; i < model.childCount; ++i)
                child(model, i, rays, live(query, lanes), query);
            return;
        }
        RayGroups<N> groups(rays, lanes);
        RayGroup group{};
        while (groups.next(group)) {
            if constexpr (N > 1) {
                if (!kd && __builtin_popcount(group.lanes) <= kFewRays) {
                    oneByOne(model, rays, group.lanes, query);
                    continue;
                }
            }
            if (wide)
                wideTriangles(model, rays, group, query);
            else if (kd)
                kdTriangles(model, rays, group, query);
            if (model.childTree.nodes)
                children(model, rays, group, query);
            else
                for (uint32_t i = 0; i < model.childCount; ++i)
                    child(model, i, rays, live(query, group.lanes), query);
        }
    }

    /// Rays of a packet that have too little in common.
    [[gnu::noinline]] static void oneByOne(const ModelView& model, const Rays& rays,
                                           uint32_t lanes, Query& query)
        requires(N > 1)
    {
        using Alone = SceneTraversal<Precision, 1, M, Counter>;
        for (lanes = live(query, lanes); lanes; lanes &= lanes - 1) {
            const int lane = lowestBit(lanes);
            typename Alone::Rays ray;
            takeLane(rays, lane, ray);
            LaneQuery<M, Counter> alone(query, lane);
            Alone::model(model, ray, 1, alone.query);
        }
    }

    /// Brings the query up to date with one triangle. Any hit: takes lanes that met it out of
    /// `active`.
    static HWY_INLINE void test(const Precision<N>& precision, uint32_t triangle, Mask<N>& active,
                                Real<N>& best, Query& query) {
        if constexpr (std::is_same_v<Precision<N>, Precise<N>>) {
            precision.test(triangle, active, best, query);
        } else {
            test(precision, triangle, triangle, active, best, query);
        }
    }
    /// The same for a triangle of a block, which need not be looked up.
    static HWY_INLINE void test(const Precision<N>& precision, const TriangleBlock& block,
                                uint32_t i, Mask<N>& active, Real<N>& best, Query& query) {
        if constexpr (std::is_same_v<Precision<N>, Watertight<N>>) {
            Triangle triangle;
            block.load(i, triangle);
            test(precision, triangle, block.number(i), active, best, query);
        } else {
            test(precision, block.number(i), active, best, query);
        }
    }
    /// The same for one ray and all triangles of a block.
    static HWY_INLINE void testBlock(const Precision<N>& precision, const TriangleBlock& block,
                                     Real<N>& best, Query& query)
        requires(N == 1)
    {
        BlockHits hits;
        precision.meet(block, Real<1>(query.tNear[0]), best, hits);
        if (hits.any()) decide(precision, block, hits, best, query);
    }
    [[gnu::noinline]] static void decide(const Precision<N>& precision, const TriangleBlock& block,
                                         const BlockHits& hits, Real<N>& best, Query& query)
        requires(N == 1)
    {
        const Real<1> near(query.tNear[0]);
        if (M == HitMode::Any && hits.sure) {
            query.blocked = 1;
            best = Real<1>(-__builtin_inff());
            return;
        }
        Mask<1> active{true};
        for (uint32_t rest = hits.any(); rest; rest &= rest - 1) {
            const int i = lowestBit(rest);
            const uint32_t bit = rest & (0u - rest);
            if (hits.atStart & bit && precision.isBehind(block, uint32_t(i), near, best)) continue;
            if (M == HitMode::Closest && (hits.sure & bit) && precision.apart(hits.t[i], best)) {
                if (hits.t[i] > best.v) continue;
                best = Real<1>(hits.t[i]);
                query.keepTriangle(active, block.number(uint32_t(i)));
                continue;
            }
            test(precision, block, uint32_t(i), active, best, query);
            if (M == HitMode::Any && !active.m) return;
        }
    }

    /// meetable: a triangle, or its number.
    template <class Meetable>
    static HWY_INLINE void test(const Precision<N>& precision, const Meetable& meetable,
                                uint32_t triangle, Mask<N>& active, Real<N>& best, Query& query) {
        Real<N> t;
        Mask<N> hit = precision.meet(meetable, active, t);
        if (!any(hit)) return;
        if constexpr (std::is_same_v<Precision<N>, Watertight<N>>)
            hit = precision.comparable(triangle, hit, t, best, query);
        hit = hit & (t >= Real<N>::load(query.tNear)) & (t <= best);
        if (!any(hit)) return;
        best = query.accept(hit, t, best, triangle);
        if constexpr (M == HitMode::Any) {
            active = andNot(active, hit);
            best = select(hit, Real<N>(-__builtin_inff()), best);
        }
    }

    /// Records of the fast mode are off by some units in the last place of the coordinates.
    static constexpr float kPadding =
        std::is_same_v<Precision<N>, Fast<N>> ? 0x1p-16f : kBoxPadding;

private:
    /// So few rays of a packet go down wide trees one by one.
    static constexpr int kFewRays = 3;

    static uint32_t live(const Query& query, uint32_t lanes) {
        return M == HitMode::Any ? lanes & ~query.blocked : lanes;
    }

    /// Far limits of the lanes given: none for the others, nor for blocked ones.
    static Real<N> limits(const Query& query, uint32_t lanes) {
        return select(Mask<N>::fromBits(live(query, lanes)), Real<N>::load(query.best),
                      Real<N>(-__builtin_inff()));
    }

    static void keepBest(const Real<N>& best, uint32_t lanes, Query& query) {
        if constexpr (M == HitMode::Closest)
            select(Mask<N>::fromBits(lanes), best, Real<N>::load(query.best)).store(query.best);
    }

    static void kdTriangles(const ModelView& model, const Rays& rays, const RayGroup& group,
                            Query& query) {
        const TreeRays<N> treeRays(model.tree, rays, group, kSplitPadding);
        const Horizon<N> horizon(model.tree, rays, group);
        const Precision<N> precision(model, rays, group);
        Real<N> best = limits(query, group.lanes);
        const auto leaf = [&](uint32_t first, uint32_t count, Mask<N> active) HWY_ATTR {
            const uint32_t* prims = model.tree.prims + first;
            for (uint32_t i = 0; i < count; ++i) {
                query.counter.triangle();
                test(precision, prims[i], active, best, query);
                if (M == HitMode::Any && !any(active)) break;
            }
            return horizon(best);
        };
        traverseKd(model.tree, treeRays, Real<N>::load(query.tNear), horizon(best), query.counter,
                   leaf);
        keepBest(best, group.lanes, query);
    }

    static void wideTriangles(const ModelView& model, const Rays& rays, const RayGroup& group,
                              Query& query) {
        const TreeRays<N> treeRays(model.wide, rays, group, kPadding);
        const Horizon<N> horizon(model.wide, rays, group);
        const Precision<N> precision(model, rays, group);
        Real<N> best = limits(query, group.lanes);
        if constexpr (N == 1) {
            const auto leaf = [&](uint32_t reference) HWY_ATTR {
                const TriangleBlock block(model.wide.blocks, reference);
                query.counter.triangle(block.count());
                testBlock(precision, block, best, query);
                return horizon(best).v;
            };
            traverseWide(model.wide.nodes, treeRays, query.tNear[0], horizon(best).v,
                         query.counter, leaf);
        } else {
            const auto leaf = [&](uint32_t reference, Mask<N> active) HWY_ATTR {
                const TriangleBlock block(model.wide.blocks, reference);
                for (uint32_t i = 0; i < block.count(); ++i) {
                    query.counter.triangle();
                    test(precision, block, i, active, best, query);
                    if (M == HitMode::Any && !any(active)) break;
                }
                return horizon(best);
            };
            traverseWide(model.wide.nodes, treeRays, Real<N>::load(query.tNear), horizon(best),
                         query.counter, leaf);
        }
        keepBest(best, group.lanes, query);
    }

    static void children(const ModelView& model, const Rays& rays, const RayGroup& group,
                         Query& query) {
        const WideView& tree = model.childTree;
        const TreeRays<N> treeRays(tree, rays, group, kPadding);
        const Horizon<N> horizon(tree, rays, group);
        const auto enter = [&](uint32_t leaf, uint32_t lanes) HWY_ATTR {
            const uint32_t first = (leaf & ~kWideLeaf) >> 4, count = (leaf & 15u) + 1;
            for (uint32_t i = first; i < first + count; ++i)
                child(model, tree.prims[i], rays, live(query, lanes), query);
            return horizon(limits(query, group.lanes));
        };
        const Real<N> far = horizon(limits(query, group.lanes));
        if constexpr (N == 1) {
            const auto visit = [&](uint32_t leaf) HWY_ATTR { return enter(leaf, 1).v; };
            traverseWide(tree.nodes, treeRays, query.tNear[0], far.v, query.counter, visit);
        } else {
            const auto visit = [&](uint32_t leaf, Mask<N> active) HWY_ATTR {
                return enter(leaf, active.bits());
            };
            traverseWide(tree.nodes, treeRays, Real<N>::load(query.tNear), far, query.counter,
                         visit);
        }
    }

    static void child(const ModelView& parent, uint32_t number, const Rays& rays,
                      uint32_t lanes, Query& query) {
        if (!lanes) return;
        query.counter.instance();
        const InstanceView& instance = parent.children[number];
        query.currentPath[query.currentLevels++] = number;
        if (instance.identity) {
            model(reached(instance), rays, lanes, query);
        } else {
            Rays local;
            transformRays(instance, rays, local);
            model(reached(instance), local, lanes, query);
        }
        --query.currentLevels;
    }
};

} // namespace smart::SMART_ISA
