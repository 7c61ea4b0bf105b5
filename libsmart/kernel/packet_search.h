// SPDX-License-Identifier: MIT
// The nearest hits of a packet whose rays have little in common. Boxes near where the packet starts
// come first, for all of its rays; what is on the stack is tested again once something was hit.
#pragma once

#include "libsmart/kernel/travelling_packet.h"

namespace smart::SMART_ISA {

/// How far the boxes of a node are from a point, along the axis on which they are farthest.
HWY_INLINE Real<kPacketSize> boxDistance(const WideNode& node, const float (&point)[3]) {
    using R = Real<kPacketSize>;
    R distance(0.0f);
    for (int k = 0; k < 3; ++k) {
        const R at(point[k]);
        distance = max(distance, max(R::load(node.lo[k]) - at, at - R::load(node.hi[k])));
    }
    return distance;
}

template <template <int> class Precision>
class PacketSearch {
public:
    static constexpr int N = kPacketSize;
    using Packet = TravellingPacket<Precision, HitMode::Closest>;
    using Query = typename Packet::Query;

    /// query: as the caller opens it.
    PacketSearch(const ModelView& model, const PacketRays& rays, Query& query)
        : packet_(model, rays), query_(query) {
        const int some = lowestBit(rays.lanes);
        for (int k = 0; k < 3; ++k) start_[k] = rays.rays.org[k][some];
        Real<N>::load(rays.far).store(best_);
        look(Real<N>::load(rays.far));
    }

    /// Finds query.triangle.
    void run() {
        open(0, packet_.packet.lanes);
        while (top_ > 0) {
            const Entry& entry = stack_[--top_];
            const uint32_t lanes = awaits(entry);
            if (!lanes) continue;
            if (entry.child & kWideLeaf)
                visit(entry.child, lanes);
            else
                open(entry.child, lanes);
        }
    }

    /// How far the rays look now.
    Real<N> best() const { return Real<N>::load(best_); }

private:
    /// See PacketOcclusion.
    static constexpr int kTogetherInLeaf = 3;

    struct Entry {
        uint32_t child, lanes;
        uint32_t node; ///< whose child it is
        uint16_t slot;
        uint16_t hits; ///< how often something had been hit
    };

    /// For which rays an entry still matters.
    uint32_t awaits(const Entry& entry) const {
        if (entry.hits == hits_) return entry.lanes;
        return entry.lanes & packet_.rays.meet(packet_.model.wide.nodes[entry.node], entry.slot,
                                               Real<N>::load(packet_.packet.near),
                                               Real<N>::load(far_))
                                 .bits();
    }

    /// Finds which rays meet which children. Those come onto the stack, the nearest to the start
    /// on top. Few branches: nobody could predict them.
    HWY_INLINE void open(uint32_t index, uint32_t lanes) {
        const WideNode& node = packet_.model.wide.nodes[index];
        uint32_t all;
        const Word<N> rows = packet_.meetChildren(node, lanes, far_, all);
        const Real<N> lo = Real<N>::load(node.lo[0]), hi = Real<N>::load(node.hi[0]);
        all &= (lo <= hi).bits();
        const Real<N> distinct = numbered(boxDistance(node, start_));
        alignas(64) float order[N];
        distinct.store(order);
        for (uint32_t rest = all; rest; rest &= rest - 1) {
            const uint32_t slot = uint32_t(lowestBit(rest)), child = node.child[slot];
            const uint32_t farther = all & (distinct > Real<N>(order[slot])).bits();
            stack_[top_ + __builtin_popcount(farther)] = {
                child, withBit(rows, 1u << slot).bits(), index, uint16_t(slot), hits_};
            packet_.prefetch(child);
        }
        top_ += __builtin_popcount(all);
    }

    HWY_INLINE void visit(uint32_t leaf, uint32_t lanes) {
        const TriangleBlock block(packet_.model.wide.blocks, leaf);
        if (__builtin_popcount(lanes) >= kTogetherInLeaf)
            visitTogether(block, Mask<N>::fromBits(lanes));
        else
            for (; lanes; lanes &= lanes - 1) visitAlone(block, lowestBit(lanes));
    }
    HWY_INLINE void visitTogether(const TriangleBlock& block, const Mask<N>& lanes) {
        const Real<N> before = Real<N>::load(best_);
        Real<N> best = before;
        packet_.meetTogether(
            block, lanes, best, query_,
            [&](const Mask<N>& hit, const Real<N>& t, uint32_t number) HWY_ATTR {
                best = query_.accept(hit, t, best, number);
                return lanes;
            });
        if (!any(best != before)) return;
        best.store(best_);
        look(best);
        ++hits_;
    }
    HWY_INLINE void visitAlone(const TriangleBlock& block, int lane) {
        BlockHits hits;
        packet_.meetAlone(block, lane, best_[lane], hits);
        if (!hits.any()) return;
        const bool isPlain = !(hits.atStart | hits.unsure) && !(hits.sure & (hits.sure - 1));
        if (isPlain) {
            const int i = lowestBit(hits.sure);
            best_[lane] = hits.t[i];
            query_.keepTriangleOf(lane, block.number(uint32_t(i)));
        } else {
            const float before = best_[lane];
            best_[lane] = packet_.decide(block, lane, before, hits, query_);
            if (best_[lane] == before) return;
        }
        far_[lane] = best_[lane] + packet_.rays.slack[lane];
        ++hits_;
    }

    /// From now on rays look as far as `best`.
    void look(const Real<N>& best) {
        select(Mask<N>::fromBits(packet_.packet.lanes), packet_.horizon(best),
               Real<N>(-__builtin_inff()))
            .store(far_);
    }

    const Packet packet_;
    Query& query_;
    alignas(64) float best_[N]; ///< as far as rays look
    alignas(64) float far_[N];  ///< as far as boxes matter to them
    float start_[3];
    uint16_t hits_ = 0;
    int top_ = 0;
    Entry stack_[kWideMaxDepth * kWideChildren + 1];
};

} // namespace smart::SMART_ISA
