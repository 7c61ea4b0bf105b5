// SPDX-License-Identifier: MIT
// Depth-first traversal of wide nodes by a beam: sixteen child boxes at once against all of it, and
// each child that is left against its rays. All tests of a node are made when it is opened, so that
// they run side by side: a branch on each result would be one that no predictor learns.
#pragma once

#include "libsmart/kernel/beam.h"

namespace smart::SMART_ISA {

/// Depths between which the rays of a packet look for hits, widened by what they may be off by.
struct DepthRange {
    Real<kPacketSize> from, to;
    Real<kPacketSize> limit; ///< the far one as given

    DepthRange(const RayTile& tile, const Beam& beam, int v, const Real<kPacketSize>& tNear,
               const Real<kPacketSize>& tFar) {
        using R = Real<kPacketSize>;
        const R first = tNear * beam.depthScale(v), last = tFar * beam.depthScale(v);
        if (tile.startsThere) {
            from = first * R(1 - 0x1p-20f);
            limit = last;
            to = last * R(1 + 0x1p-8f);
        } else {
            from = max(beam.originDepth(v) - last - R(beam.pad()), R(0.0f));
            limit = beam.originDepth(v) - first;
            to = limit + R(beam.pad());
        }
    }
};

/// The rays that meet a box: see raysOf().
template <class State>
HWY_INLINE uint64_t raysThatMeet(const Beam& beam, const SeenBoxes& seen, int box,
                                 const State& state) {
    uint64_t rays = 0;
    for (int v = 0; v < kTileVectors; ++v) {
        const auto met = beam.meet(seen, box, v, state.nearDepth(v), state.farDepth(v));
        rays |= uint64_t(met.bits()) << 16 * v;
    }
    return rays;
}

/// Nearest boxes first.
/// State: packets() whose rays still look for something, looking(near), these rays from depth
/// `near` on as bits (raysOf()), nearDepth(v) and farDepth(v) of their rays (-infinity where a ray
/// looks for nothing), farthestDepth() of all, prefetch(child), and leaf(child, rays that meet its
/// box). What comes of leaves may wait: while any waits(), leaf() may be called for a child that
/// joins(child) them; goThrough() brings all up to date.
template <class State>
void traverseWide(const WideNode* nodes, const Beam& beam, State& state) {
    constexpr int N = kPacketSize;
    struct Entry {
        uint64_t rays; ///< that meet the box
        float near;
        uint32_t child;
    };
    Entry stack[kWideMaxDepth * kWideChildren];
    int top = 0;

    const auto open = [&](uint32_t index, uint64_t rays) HWY_ATTR {
        const WideNode& node = nodes[index];
        SeenBoxes seen;
        beam.see(node, seen);
        Real<N> from;
        const uint32_t within = beam.meet(seen, 0.0f, state.farthestDepth(), from).bits();
        alignas(64) float near[N], order[N];
        from.store(near);
        const Real<N> distinct = numbered(from);
        distinct.store(order);
        Entry met[N];
        int slots[N];
        uint32_t hits = 0;
        int count = 0;
        for (uint32_t rest = within; rest; rest &= rest - 1) {
            const int slot = lowestBit(rest);
            const uint64_t meeting = rays & raysThatMeet(beam, seen, slot, state);
            met[count] = {meeting, near[slot], node.child[slot]};
            slots[count] = slot;
            hits |= uint32_t(meeting != 0) << slot;
            count += meeting != 0;
        }
        for (int i = 0; i < count; ++i) {
            state.prefetch(met[i].child);
            // Its place by counting, as a sort has branches that nobody can predict.
            const uint32_t farther = hits & (distinct > Real<N>(order[slots[i]])).bits();
            stack[top + __builtin_popcount(farther)] = met[i];
        }
        top += count;
    };

    open(0, state.looking(0.0f));
    while (true) {
        if (state.waits() && !(top > 0 && state.joins(stack[top - 1].child))) {
            state.goThrough();
            if (!state.packets()) return;
        }
        if (top == 0) return;
        const Entry& entry = stack[--top];
        const uint32_t child = entry.child;
        const uint64_t rays = entry.rays & state.looking(entry.near);
        if (!rays) continue;
        if (child & kWideLeaf)
            state.leaf(child, rays);
        else
            open(child, rays);
    }
}

/// In no order, for rays that ask for no nearest hit. Leaves come before nodes, so that many go
/// together.
template <class State>
void traverseWideUnordered(const WideNode* nodes, const Beam& beam, State& state) {
    constexpr int N = kPacketSize;
    struct Entry {
        uint64_t rays; ///< that meet the box
        uint32_t child;
    };
    Entry stack[kWideMaxDepth * kWideChildren];
    Entry leaves[kWideChildren];
    int top = 0;
    stack[top++] = {state.looking(0.0f), 0};
    while (top > 0) {
        const Entry entry = stack[--top];
        const uint64_t rays = entry.rays & state.looking(0.0f);
        if (!rays) continue;
        const WideNode& node = nodes[entry.child];
        SeenBoxes seen;
        beam.see(node, seen);
        Real<N> from;
        int count = 0;
        for (uint32_t rest = beam.meet(seen, 0.0f, state.farthestDepth(), from).bits(); rest;
             rest &= rest - 1) {
            const int slot = lowestBit(rest);
            const uint32_t child = node.child[slot];
            const uint64_t met = rays & raysThatMeet(beam, seen, slot, state);
            // Without a branch: stored in any case, and counted where it is to stay. Word by word:
            // what was stored so would be waited for to be copied whole.
            stack[top].rays = leaves[count].rays = met;
            stack[top].child = leaves[count].child = child;
            const int leaf = int(child >> 31), stays = met != 0;
            state.prefetch(stays ? child : entry.child); // or what is near anyway
            top += stays & ~leaf;
            count += stays & leaf;
        }
        for (int i = 0; i < count; ++i) {
            if (state.waits() && !state.joins(leaves[i].child)) {
                state.goThrough();
                if (!state.packets()) return;
            }
            state.leaf(leaves[i].child, leaves[i].rays);
        }
    }
    if (state.waits()) state.goThrough();
}

} // namespace smart::SMART_ISA
