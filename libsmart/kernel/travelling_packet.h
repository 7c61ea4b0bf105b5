// SPDX-License-Identifier: MIT
// A packet of rays that have little in common, on its way through a wide tree: a node is opened
// once for all of its rays that meet it, however few these are, which shares what a node, its place
// on the stack and mispredicted branches cost.
//
// Wald, Gribble, Boulos, Kensler, "SIMD ray stream tracing", 2007; Barringer, Akenine-Moeller,
// "Dynamic ray stream traversal", ACM Transactions on Graphics 33(4), 2014.
#pragma once

#include <type_traits>

#include "libsmart/kernel/mixed_packet.h"
#include "libsmart/kernel/scene_traversal.h"

namespace smart::SMART_ISA {

template <template <int> class Precision, HitMode M>
class TravellingPacket {
public:
    static constexpr int N = kPacketSize;
    using Query = Search<N, M, NoCounts>;

    TravellingPacket(const ModelView& walked, const PacketRays& given)
        : model(walked),
          packet(given),
          rays(walked.wide, given.rays, Traversal::kPadding),
          shear_(given.rays),
          test_(walked, given.rays, RayGroup{given.lanes, {}, 0}, shear_) {
        for (int k = 0; k < 3; ++k) shear_.slope(k).store(slopes_[k]);
        if constexpr (!kFast) test_.doubtful().store(doubtful_);
    }

    /// How far boxes matter to rays that look as far as `best`.
    Real<N> horizon(const Real<N>& best) const { return best + Real<N>::load(rays.slack); }

    /// Which children each of `lanes` meets, by lane; `some`: those that any of them meets. Places
    /// without a child may be among them.
    HWY_INLINE Word<N> meetChildren(const WideNode& node, uint32_t lanes, const float (&far)[N],
                                    uint32_t& some) const {
        Word<N> rows(0u);
        some = 0;
        for (; lanes; lanes &= lanes - 1) {
            const int lane = lowestBit(lanes);
            Real<N> entered;
            const uint32_t met =
                rays.meetBoxes(node, lane, packet.near[lane], far[lane], entered).bits();
            rows = select(Mask<N>::fromBits(lanes & (0u - lanes)), Word<N>(met), rows);
            some |= met;
        }
        return rows;
    }

    HWY_INLINE void prefetch(uint32_t child) const {
        const char* const leaf = reinterpret_cast<const char*>(
            model.wide.blocks + kWordsOfTriangle * std::size_t((child & ~kWideLeaf) >> 4));
        const char* const node = reinterpret_cast<const char*>(model.wide.nodes + child);
        const char* const next = child & kWideLeaf ? leaf : node;
        for (int line = 0; line < 7; ++line) __builtin_prefetch(next + 64 * line);
    }

    /// Goes through the triangles of a leaf that `active` rays meet, each against all of them.
    /// found(lanes, t, number) -> the lanes that are still active.
    template <class Found>
    HWY_INLINE void meetTogether(const TriangleBlock& block, Mask<N> active, Real<N>& best,
                                 Query& query, const Found& found) const {
        const Real<N> near = Real<N>::load(packet.near);
        for (uint32_t i = 0; i < block.count(); ++i) {
            Real<N> t;
            Mask<N> hit;
            if constexpr (kFast) {
                hit = test_.meet(block.number(i), active, t);
                if (!any(hit)) continue;
            } else {
                Triangle triangle;
                block.load(i, triangle);
                hit = test_.meet(triangle, active, t);
                if (!any(hit)) continue;
                hit = test_.comparable(block.number(i), hit, t, best, query);
            }
            active = found(hit & (t >= near) & (t <= best), t, block.number(i));
            if (!any(active)) return;
        }
    }

    /// One of the rays, which looks as far as `best`, against all triangles of a leaf.
    HWY_INLINE void meetAlone(const TriangleBlock& block, int lane, float best,
                              BlockHits& hits) const {
        hits.sure = hits.atStart = 0;
        hits.unsure = block.all();
        if constexpr (!kFast) {
            if (test_.someLarge()) return;
            const LaneRay ray(*this, lane);
            meetBlock(ray.shear(block), slopes_[2][lane], doubtful_[lane], block.all(),
                      packet.near[lane], best, hits);
        }
    }
    /// Brings the query of one ray up to date with what meetAlone found; returns how far it looks
    /// from then on.
    [[gnu::noinline]] float decide(const TriangleBlock& block, int lane, float best,
                                   const BlockHits& hits, Query& query) const {
        const LaneRay ray(*this, lane);
        const Precision<1> precision(model, ray.ray, ray.group, ray.shear);
        Search<1, M, NoCounts> alone;
        alone.tNear[0] = packet.near[lane];
        alone.triangle[0] = query.triangle[lane];
        alone.lastOfEqual = query.lastOfEqual;
        alone.levels[0] = 0;
        alone.currentLevels = query.currentLevels;
        for (uint32_t l = 0; l < query.currentLevels; ++l)
            alone.currentPath[l] = query.currentPath[l];
        if (query.triangle[lane] != kNoHit) {
            alone.levels[0] = query.levels[lane];
            for (uint32_t l = 0; l < query.levels[lane]; ++l)
                alone.path[l][0] = query.path[l][lane];
        }
        Real<1> far(best);
        Traversal::decide(precision, block, hits, far, alone);
        query.blocked |= alone.blocked << lane;
        if (alone.deepest) { // something was kept, if only what had been there
            query.triangle[lane] = alone.triangle[0];
            query.levels[lane] = alone.levels[0];
            for (uint32_t l = 0; l < alone.levels[0]; ++l) query.path[l][lane] = alone.path[l][0];
            query.deepest = query.deepest > alone.deepest ? query.deepest : alone.deepest;
        }
        return far.v;
    }

    const ModelView& model;
    const PacketRays& packet;
    const MixedRays rays;

private:
    using Traversal = SceneTraversal<Precision, 1, M, NoCounts>;
    static constexpr bool kFast = std::is_same_v<Precision<N>, Fast<N>>;
    using Test = std::conditional_t<kFast, Fast<N>, WatertightTest<N, MixedShear>>;

    struct LaneRay {
        LocalRays<1> ray;
        RayGroup group;
        Shear<1> shear;

        LaneRay(const TravellingPacket& all, int lane)
            : ray(of(all.packet.rays, lane)),
              group{1, {}, all.shear_.dominantAxis(lane)},
              shear(ray, group,
                    {all.slopes_[0][lane], all.slopes_[1][lane], all.slopes_[2][lane]}) {}
        static LocalRays<1> of(const LocalRays<N>& rays, int lane) {
            LocalRays<1> ray;
            takeLane(rays, lane, ray);
            return ray;
        }
    };

    const MixedShear shear_;
    const Test test_;
    alignas(64) float slopes_[3][N], doubtful_[N];
};

} // namespace smart::SMART_ISA
