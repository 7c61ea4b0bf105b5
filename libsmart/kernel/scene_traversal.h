// SPDX-License-Identifier: MIT
// Models and the instances nested in them: rays go to object space, meet the model there, and
// keep the nearest hit. Recursion is as deep as instances nest.
#pragma once

#include <type_traits>

#include "libsmart/kernel/intersect.h"
#include "libsmart/kernel/kd_traversal.h"
#include "libsmart/kernel/precise.h"

namespace smart::SMART_ISA {

/// Rays of an instance's parent in the instance's own space; computed in double, rounded once.
template <int N>
void transformRays(const InstanceView& instance, const LocalRays<N>& rays, LocalRays<N>& local) {
    for (int k = 0; k < 3; ++k) {
        const double* m = instance.toObject[k];
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
        if (!model.tree.nodes && !model.childTree.nodes) {
            for (uint32_t i = 0; i < model.childCount; ++i)
                child(model, i, rays, live(query, lanes), query);
            return;
        }
        RayGroups<N> groups(rays, lanes);
        RayGroup group{};
        while (groups.next(group)) {
            if (model.tree.nodes) triangles(model, rays, group, query);
            if (model.childTree.nodes)
                children(model, rays, group, query);
            else
                for (uint32_t i = 0; i < model.childCount; ++i)
                    child(model, i, rays, live(query, group.lanes), query);
        }
    }

private:
    static uint32_t live(const Query& query, uint32_t lanes) {
        return M == HitMode::Any ? lanes & ~query.blocked : lanes;
    }

    /// Far limits of the lanes given: none for the others, nor for blocked ones.
    static Real<N> limits(const Query& query, uint32_t lanes) {
        return select(Mask<N>::fromBits(live(query, lanes)), Real<N>::load(query.best),
                      Real<N>(-__builtin_inff()));
    }

    /// Brings the query up to date with one triangle. Any hit: takes lanes that met it out of
    /// `active`.
    static HWY_INLINE void test(const Precision<N>& precision, uint32_t triangle, Mask<N>& active,
                                Real<N>& best, Query& query) {
        if constexpr (std::is_same_v<Precision<N>, Precise<N>>) {
            precision.test(triangle, active, best, query);
        } else {
            Real<N> t;
            Mask<N> hit = precision.meet(triangle, active, t);
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
    }

    static void triangles(const ModelView& model, const Rays& rays, const RayGroup& group,
                          Query& query) {
        const TreeRays<N> treeRays(model.tree, rays, group);
        const Precision<N> precision(model, rays, group);
        Real<N> best = limits(query, group.lanes);
        const auto leaf = [&](uint32_t first, uint32_t count, Mask<N> active) {
            const uint32_t* prims = model.tree.prims + first;
            for (uint32_t i = 0; i < count; ++i) {
                query.counter.triangle();
                test(precision, prims[i], active, best, query);
                if (M == HitMode::Any && !any(active)) break;
            }
            return best;
        };
        traverseKd(model.tree, treeRays, Real<N>::load(query.tNear), best, query.counter, leaf);
        if constexpr (M == HitMode::Closest)
            select(Mask<N>::fromBits(group.lanes), best, Real<N>::load(query.best))
                .store(query.best);
    }

    static void children(const ModelView& model, const Rays& rays, const RayGroup& group,
                         Query& query) {
        const TreeRays<N> treeRays(model.childTree, rays, group);
        // A child lies in many leaves: which lanes met which child of late.
        struct {
            uint32_t child = kNoHit, lanes = 0;
        } visited[16];
        const auto leaf = [&](uint32_t first, uint32_t count, Mask<N> active) {
            for (uint32_t i = 0; i < count; ++i) {
                const uint32_t number = model.childTree.prims[first + i];
                auto& seen = visited[number % 16];
                if (seen.child != number) {
                    seen.child = number;
                    seen.lanes = 0;
                }
                const uint32_t lanes = live(query, active.bits()) & ~seen.lanes;
                if (!lanes) continue;
                seen.lanes |= lanes;
                child(model, number, rays, lanes, query);
            }
            return limits(query, group.lanes);
        };
        traverseKd(model.childTree, treeRays, Real<N>::load(query.tNear),
                   limits(query, group.lanes), query.counter, leaf);
    }

    static void child(const ModelView& parent, uint32_t number, const Rays& rays,
                      uint32_t lanes, Query& query) {
        if (!lanes) return;
        query.counter.instance();
        const InstanceView& instance = parent.children[number];
        query.currentPath[query.currentLevels++] = number;
        if (instance.identity) {
            model(*instance.model, rays, lanes, query);
        } else {
            Rays local;
            transformRays(instance, rays, local);
            model(*instance.model, local, lanes, query);
        }
        --query.currentLevels;
    }
};

} // namespace smart::SMART_ISA
