// SPDX-License-Identifier: MIT
// Which rays of a packet that have little in common are blocked. Boxes are met in no particular
// order, as the first hit of any kind ends a ray, and what they hold is looked into at once: the
// leaves of a node come before the nodes below it.
#pragma once

#include "libsmart/kernel/travelling_packet.h"

namespace smart::SMART_ISA {

/// What rays can reach within their limits, as a box.
class RayReach {
public:
    static constexpr int N = kPacketSize;

    RayReach(const PacketRays& packet, const MixedRays& rays, const Real<N>& far) {
        const Mask<N> on = Mask<N>::fromBits(packet.lanes);
        const Real<N> inf(__builtin_inff()), none(-__builtin_inff()), zero(0.0f);
        for (int k = 0; k < 3; ++k) {
            const Real<N> org = Real<N>::load(packet.rays.org[k]);
            const Real<N> dir = Real<N>::load(packet.rays.dir[k]);
            const Real<N> end = org + select(dir == zero, zero, dir * far);
            lo_[k] = smallestLane(select(on, min(org, end) - rays.reachPad, inf));
            hi_[k] = largestLane(select(on, max(org, end) + rays.reachPad, none));
        }
    }
    /// Which children of a node lie there, in part at least.
    HWY_INLINE uint32_t meet(const WideNode& node) const {
        const Real<N> first = Real<N>::load(node.lo[0]), last = Real<N>::load(node.hi[0]);
        Mask<N> met = (first <= last) & (first <= Real<N>(hi_[0])) & (last >= Real<N>(lo_[0]));
        for (int k = 1; k < 3; ++k)
            met = met & (Real<N>::load(node.lo[k]) <= Real<N>(hi_[k])) &
                  (Real<N>::load(node.hi[k]) >= Real<N>(lo_[k]));
        return met.bits();
    }

private:
    float lo_[3], hi_[3];
};

template <template <int> class Precision>
class PacketOcclusion {
public:
    static constexpr int N = kPacketSize;
    using Packet = TravellingPacket<Precision, HitMode::Any>;
    using Query = typename Packet::Query;

    /// query: as the caller opens it.
    PacketOcclusion(const ModelView& model, const PacketRays& rays, Query& query)
        : packet_(model, rays),
          query_(query),
          reach_(rays, packet_.rays, packet_.horizon(Real<N>::load(rays.far))) {
        packet_.horizon(Real<N>::load(rays.far)).store(far_);
    }

    /// Finds query.blocked.
    void run() {
        open(0, packet_.packet.lanes);
        while (true) {
            for (int i = 0; i < leaves_; ++i)
                visit(waiting_[i].child, waiting_[i].lanes & ~query_.blocked);
            uint32_t lanes = 0;
            while (lanes == 0) {
                if (top_ == 0) return;
                lanes = nodes_[--top_].lanes & ~query_.blocked;
            }
            open(nodes_[top_].child, lanes);
        }
    }

private:
    /// From so many rays on, each triangle of a leaf is tested against all of them; fewer are
    /// tested one by one, each against all triangles.
    static constexpr int kTogetherInLeaf = 3;
    /// A box against all rays costs as much more than a ray against all boxes.
    static constexpr int kBoxSurcharge = 3;

    struct Entry {
        uint32_t child, lanes;
    };

    /// Finds which rays meet which children. Few branches: nobody could predict them.
    HWY_INLINE void open(uint32_t index, uint32_t lanes) {
        const WideNode& node = packet_.model.wide.nodes[index];
        const uint32_t near = reach_.meet(node);
        int top = top_, leaves = 0;
        const auto put = [&](uint32_t slot, uint32_t meeting) HWY_ATTR {
            const uint32_t child = node.child[slot];
            const int some = meeting != 0, isLeaf = int(child >> 31);
            nodes_[top].child = waiting_[leaves].child = child; // word by word: see traverseWide
            nodes_[top].lanes = waiting_[leaves].lanes = meeting;
            top += some & (isLeaf ^ 1);
            leaves += some & isLeaf;
            packet_.prefetch(child);
        };
        if (__builtin_popcount(near) + kBoxSurcharge <= __builtin_popcount(lanes)) {
            const Real<N> from = Real<N>::load(packet_.packet.near), to = Real<N>::load(far_);
            for (uint32_t rest = near; rest; rest &= rest - 1) {
                const uint32_t slot = uint32_t(lowestBit(rest));
                put(slot, lanes & packet_.rays.meet(node, slot, from, to).bits());
            }
        } else {
            uint32_t some;
            const Word<N> rows = packet_.meetChildren(node, lanes, far_, some);
            for (uint32_t rest = some & near; rest; rest &= rest - 1) {
                const uint32_t slot = uint32_t(lowestBit(rest));
                put(slot, withBit(rows, 1u << slot).bits());
            }
        }
        top_ = top;
        leaves_ = leaves;
    }

    HWY_INLINE void visit(uint32_t leaf, uint32_t lanes) {
        const TriangleBlock block(packet_.model.wide.blocks, leaf);
        if (__builtin_popcount(lanes) >= kTogetherInLeaf) {
            Mask<N> active = Mask<N>::fromBits(lanes);
            Real<N> far = Real<N>::load(packet_.packet.far);
            packet_.meetTogether(block, active, far, query_,
                                 [&](const Mask<N>& hit, const Real<N>&, uint32_t) HWY_ATTR {
                                     query_.blocked |= hit.bits();
                                     active = andNot(active, hit);
                                     return active;
                                 });
            return;
        }
        for (; lanes; lanes &= lanes - 1) {
            const int lane = lowestBit(lanes);
            BlockHits hits;
            packet_.meetAlone(block, lane, packet_.packet.far[lane], hits);
            if (hits.sure)
                query_.blocked |= 1u << lane;
            else if (hits.any())
                packet_.decide(block, lane, packet_.packet.far[lane], hits, query_);
        }
    }

    const Packet packet_;
    Query& query_;
    const RayReach reach_;
    alignas(64) float far_[N]; ///< as far as boxes matter
    int top_ = 0, leaves_ = 0;
    Entry nodes_[kWideMaxDepth * kWideChildren + 1], waiting_[kWideChildren + 1];
};

} // namespace smart::SMART_ISA
