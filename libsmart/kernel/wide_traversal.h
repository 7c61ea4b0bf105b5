// SPDX-License-Identifier: MIT
// Depth-first traversal of wide nodes by a beam: sixteen child boxes at once against all of it,
// and each child that is left against its rays, before it is entered.
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

/// State: packets() whose rays still look for something, nearDepth(v) and farDepth(v) of their rays
/// (-infinity where a ray looks for nothing), farthestDepth() of all, prefetch(child), and
/// leaf(child, packets, active rays of each packet), which may bring all that up to date.
template <class State>
void traverseWide(const WideNode* nodes, const Beam& beam, State& state) {
    constexpr int N = kPacketSize;
    // Written and read word by word: what is stored in parts arrives late where it is loaded whole.
    struct Entry {
        float near;
        uint32_t child;
        uint32_t place; ///< slot, packets << 4, level of the node whose child it is << 8
    };
    SeenBoxes seen[kWideMaxDepth];
    Entry stack[kWideMaxDepth * kWideChildren];
    int top = 0;

    const auto open = [&](uint32_t index, uint32_t level, uint32_t packets) HWY_ATTR {
        const WideNode& node = nodes[index];
        beam.see(node, seen[level]);
        Real<N> from;
        const uint32_t hits = beam.meet(seen[level], 0.0f, state.farthestDepth(), from).bits();
        alignas(64) float near[N], order[N];
        from.store(near);
        const Real<N> distinct = numbered(from);
        distinct.store(order);
        const uint32_t above = packets << 4 | level << 8;
        for (uint32_t rest = hits; rest; rest &= rest - 1) {
            const int slot = lowestBit(rest);
            const uint32_t child = node.child[slot];
            state.prefetch(child);
            // Its place by counting, as a sort has branches that nobody can predict.
            const uint32_t farther = hits & (distinct > Real<N>(order[slot])).bits();
            stack[top + __builtin_popcount(farther)] = {near[slot], child, uint32_t(slot) | above};
        }
        top += __builtin_popcount(hits);
    };

    open(0, 0, state.packets());
    while (top > 0) {
        const Entry& entry = stack[--top];
        if (entry.near > state.farthestDepth()) continue;
        const uint32_t place = entry.place, level = place >> 8;
        const SeenBoxes& boxes = seen[level];
        uint32_t packets = 0;
        Mask<N> active[kTileVectors];
        for (int v = 0; v < kTileVectors; ++v) {
            active[v] =
                beam.meet(boxes, int(place & 15u), v, state.nearDepth(v), state.farDepth(v));
            packets |= uint32_t(any(active[v])) << v;
        }
        packets &= place >> 4;
        if (!packets) continue;
        const uint32_t child = entry.child;
        if (child & kWideLeaf) {
            state.leaf(child, packets, active);
            if (!state.packets()) return;
        } else {
            open(child, level + 1u, packets);
        }
    }
}

} // namespace smart::SMART_ISA
