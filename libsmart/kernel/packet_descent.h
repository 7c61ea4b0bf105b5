// SPDX-License-Identifier: MIT
// A packet of rays that start far from each other goes down a wide tree together as long as a few
// of them meet a box: each still meets sixteen boxes at a time, but what a node and its place in
// the order cost is shared. Triangles that several meet are tested against all of them at once.
#pragma once

#include <type_traits>

#include "libsmart/kernel/intersect.h"
#include "libsmart/kernel/mixed_packet.h"

namespace smart::SMART_ISA {

/// So many nodes a packet opens, at most.
inline constexpr int kDescentNodes = 40;

template <template <int> class Precision, HitMode M>
class PacketDescent {
public:
    static constexpr int N = kPacketSize;
    using Query = Search<N, M, NoCounts>;

    PacketDescent(const ModelView& model, const PacketRays& packet, float padding)
        : rays(model.wide, packet.rays, padding),
          shear(packet.rays),
          best(Real<N>::load(packet.far)),
          model_(model),
          packet_(packet),
          test_(model, packet.rays, RayGroup{packet.lanes, {}, 0}, shear) {
        select(Mask<N>::fromBits(packet.lanes), best + Real<N>::load(rays.slack),
               Real<N>(-__builtin_inff()))
            .store(far);
    }

    /// Finds what the rays meet together.
    void run(Query& query) {
        const int some = lowestBit(packet_.lanes);
        for (int k = 0; k < 3; ++k) start_[k] = packet_.rays.org[k][some];
        open(0, packet_.lanes);
        while (top_ > 0) {
            const Entry entry = stack_[--top_];
            const uint32_t lanes = awaits(entry, query);
            if (__builtin_popcount(lanes) < least(entry.child) ||
                (opened_ == kDescentNodes && !(entry.child & kWideLeaf))) {
                few_[left_] = entry;
                few_[left_].lanes = lanes;
                left_ += lanes != 0;
            } else if (entry.child & kWideLeaf) {
                leaf(entry.child, lanes, query);
            } else {
                open(entry.child, lanes);
            }
        }
    }

    /// What too few rays meet, for each: leave(lane, child, from), nodes and leaves with the
    /// distance from which on they matter, those that were met first last.
    template <class Leave>
    void eachLeft(const Leave& leave) const {
        for (int i = left_; i-- > 0;) {
            const Entry& entry = few_[i];
            for (uint32_t lanes = entry.lanes; lanes; lanes &= lanes - 1) {
                const int lane = lowestBit(lanes);
                leave(lane, entry.child, from_[entry.place >> 4][lane][entry.place & 15u]);
            }
        }
    }

    const MixedRays rays;
    const MixedShear shear;
    Real<N> best; ///< as far as rays look
    /// As far as boxes matter to them; -infinity without a ray, or once it is blocked.
    alignas(64) float far[N];

private:
    using Test = std::conditional_t<std::is_same_v<Precision<N>, Fast<N>>, Fast<N>,
                                    WatertightTest<N, MixedShear>>;
    /// From so many rays on they go on together.
    static constexpr int kTogether = 3, kTogetherInLeaf = 2;
    static constexpr int kEntries = kDescentNodes * kWideChildren + 1;

    struct Entry {
        uint32_t child, lanes;
        uint32_t node;  ///< whose child it is
        uint32_t place; ///< slot, which one of the opened nodes that is << 4
        int hits;       ///< how often something had been hit
    };

    int least(uint32_t child) const { return child & kWideLeaf ? kTogetherInLeaf : kTogether; }

    /// For which rays an entry still matters.
    uint32_t awaits(const Entry& entry, const Query& query) const {
        if (M == HitMode::Any) return entry.lanes & ~query.blocked;
        if (entry.hits == hits_) return entry.lanes;
        return entry.lanes & rays.meet(model_.wide.nodes[entry.node], entry.place & 15u,
                                       Real<N>::load(packet_.near), Real<N>::load(far))
                                 .bits();
    }

    /// Tests the children against the rays, one by one. Those that enough of them meet come onto
    /// the stack, the nearest to the start on top. Few branches: nobody could predict them.
    HWY_INLINE void open(uint32_t index, uint32_t lanes) {
        const WideNode& node = model_.wide.nodes[index];
        const uint32_t opened = uint32_t(opened_++);
        float(*const from)[N] = from_[opened];
        Word<N> rows(0u); // of each ray: the children it meets
        uint32_t all = 0;
        for (uint32_t rest = lanes; rest; rest &= rest - 1) {
            const int lane = lowestBit(rest);
            Real<N> entered;
            const uint32_t met =
                rays.meetBoxes(node, lane, packet_.near[lane], far[lane], entered).bits();
            entered.store(from[lane]);
            rows = select(Mask<N>::fromBits(1u << lane), Word<N>(met), rows);
            all |= met;
        }
        const Real<N> lo = Real<N>::load(node.lo[0]), hi = Real<N>::load(node.hi[0]);
        all &= (lo <= hi).bits();
        Real<N> distance(0.0f);
        for (int k = 0; k < 3; ++k) {
            const Real<N> start(start_[k]);
            distance = max(distance, max(Real<N>::load(node.lo[k]) - start,
                                         start - Real<N>::load(node.hi[k])));
        }
        const Real<N> distinct = numbered(distance);
        alignas(64) float order[N];
        distinct.store(order);
        uint32_t slots[N];
        for (uint32_t rest = all; rest; rest &= rest - 1) {
            const uint32_t slot = uint32_t(lowestBit(rest));
            const uint32_t farther = all & (distinct > Real<N>(order[slot])).bits();
            slots[__builtin_popcount(farther)] = slot;
        }
        const int count = __builtin_popcount(all);
        int top = top_, left = left_;
        for (int i = 0; i < count; ++i) {
            const uint32_t slot = slots[i], child = node.child[slot];
            const uint32_t meeting = withBit(rows, 1u << slot).bits();
            const bool enough = __builtin_popcount(meeting) >= least(child);
            const Entry entry{child, meeting, index, slot | opened << 4, hits_};
            stack_[top] = entry;
            few_[left] = entry;
            top += enough;
            left += !enough;
            __builtin_prefetch(child & kWideLeaf ? block(child) : nodeAt(child));
        }
        top_ = top;
        left_ = left;
    }
    const char* block(uint32_t child) const {
        return reinterpret_cast<const char*>(
            model_.wide.blocks + kWordsOfTriangle * std::size_t((child & ~kWideLeaf) >> 4));
    }
    const char* nodeAt(uint32_t child) const {
        return reinterpret_cast<const char*>(model_.wide.nodes + child);
    }

    void leaf(uint32_t child, uint32_t lanes, Query& query) {
        const TriangleBlock block(model_.wide.blocks, child);
        Mask<N> active = Mask<N>::fromBits(lanes);
        bool some = false;
        for (uint32_t i = 0; i < block.count(); ++i) {
            Real<N> t;
            Mask<N> hit;
            if constexpr (std::is_same_v<Test, Fast<N>>) {
                hit = test_.meet(block.number(i), active, t);
                if (!any(hit)) continue;
            } else {
                Triangle triangle;
                block.load(i, triangle);
                hit = test_.meet(triangle, active, t);
                if (!any(hit)) continue;
                hit = test_.comparable(block.number(i), hit, t, best, query);
            }
            hit = hit & (t >= Real<N>::load(packet_.near)) & (t <= best);
            best = query.accept(hit, t, best, block.number(i));
            some = true;
            if constexpr (M == HitMode::Any) {
                active = andNot(active, hit);
                if (!any(active)) break;
            }
        }
        if (!some) return;
        ++hits_;
        const uint32_t looking =
            M == HitMode::Any ? packet_.lanes & ~query.blocked : packet_.lanes;
        select(Mask<N>::fromBits(looking), best + Real<N>::load(rays.slack),
               Real<N>(-__builtin_inff()))
            .store(far);
    }

    const ModelView& model_;
    const PacketRays& packet_;
    const Test test_;
    float start_[3];
    int top_ = 0, left_ = 0, opened_ = 0, hits_ = 0;
    Entry stack_[kEntries], few_[kEntries];
    alignas(64) float from_[kDescentNodes][N][kWideChildren];
};

} // namespace smart::SMART_ISA
