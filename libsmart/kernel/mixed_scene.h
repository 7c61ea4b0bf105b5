// SPDX-License-Identifier: MIT
// Packets of rays that start close to each other and point anywhere, in scenes of any instances: a
// packet comes to an instance once for all of its rays that meet the instance's box.
#pragma once

#include "libsmart/kernel/packet_occlusion.h"
#include "libsmart/kernel/packet_search.h"

namespace smart::SMART_ISA {

/// Precision: one of the float modes.
template <template <int> class Precision, HitMode M>
class MixedScene {
public:
    static constexpr int N = kPacketSize;
    using Query = Search<N, M, NoCounts>;
    using Rays = LocalRays<N>;

    /// Brings the query up to date with a model and what is nested in it, as SceneTraversal does.
    static void model(const ModelView& model, const Rays& rays, uint32_t lanes, Query& query) {
        lanes = live(query, lanes);
        if (__builtin_popcount(lanes) <= kFewRays || model.tree.nodes) {
            SceneTraversal<Precision, N, M, NoCounts>::oneByOne(model, rays, lanes, query);
            return;
        }
        if (model.wide.nodes) triangles(model, rays, lanes, query);
        if (model.childTree.nodes)
            children(model, rays, live(query, lanes), query);
        else
            for (uint32_t i = 0; i < model.childCount; ++i)
                child(model, i, rays, live(query, lanes), query);
    }

private:
    static constexpr int kFewRays = 2;
    static constexpr float kPadding = SceneTraversal<Precision, 1, M, NoCounts>::kPadding;

    static uint32_t live(const Query& query, uint32_t lanes) {
        return M == HitMode::Any ? lanes & ~query.blocked : lanes;
    }

    [[gnu::noinline]] static void triangles(const ModelView& model, const Rays& rays,
                                            uint32_t lanes, Query& query) {
        PacketRays packet;
        packet.rays = rays;
        Real<N>::load(query.tNear).store(packet.near);
        Real<N>::load(query.best).store(packet.far);
        packet.lanes = lanes;
        if constexpr (M == HitMode::Any) {
            PacketOcclusion<Precision>(model, packet, query).run();
        } else {
            PacketSearch<Precision> search(model, packet, query);
            search.run();
            select(Mask<N>::fromBits(lanes), search.best(), Real<N>::load(query.best))
                .store(query.best);
        }
    }

    /// Goes through the tree over a model's instances, those nearest to where the packet starts
    /// first.
    static void children(const ModelView& model, const Rays& rays, uint32_t lanes, Query& query) {
        if (!lanes) return;
        struct Entry {
            uint32_t child, lanes;
            const WideNode* node; ///< whose child it is
            uint32_t slot;
        };
        const WideView& tree = model.childTree;
        const MixedRays mixed(tree, rays, kPadding);
        const int some = lowestBit(lanes);
        const Real<N> near = Real<N>::load(query.tNear);
        const auto met = [&](const WideNode& node, uint32_t slot, uint32_t asked) HWY_ATTR {
            const Real<N> far = Real<N>::load(query.best) + Real<N>::load(mixed.slack);
            return live(query, asked) & mixed.meet(node, slot, near, far).bits();
        };
        Entry stack[kWideMaxDepth * kWideChildren];
        int top = 0;
        const auto open = [&](const WideNode& node, uint32_t asked) HWY_ATTR {
            const Real<N> low = Real<N>::load(node.lo[0]), high = Real<N>::load(node.hi[0]);
            alignas(64) float order[N];
            const float start[3] = {rays.org[0][some], rays.org[1][some], rays.org[2][some]};
            const Real<N> distinct = numbered(boxDistance(node, start));
            distinct.store(order);
            const uint32_t used = (low <= high).bits();
            for (uint32_t rest = used; rest; rest &= rest - 1) {
                const uint32_t slot = uint32_t(lowestBit(rest));
                const uint32_t farther = used & (distinct > Real<N>(order[slot])).bits();
                stack[top + __builtin_popcount(farther)] = {node.child[slot], asked, &node, slot};
            }
            top += __builtin_popcount(used);
        };
        open(tree.nodes[0], lanes);
        while (top > 0) {
            const Entry entry = stack[--top];
            const uint32_t meeting = met(*entry.node, entry.slot, entry.lanes);
            if (!meeting) continue;
            if (!(entry.child & kWideLeaf)) {
                open(tree.nodes[entry.child], meeting);
                continue;
            }
            const uint32_t first = (entry.child & ~kWideLeaf) >> 4;
            for (uint32_t i = first; i <= first + (entry.child & 15u); ++i)
                child(model, tree.prims[i], rays, live(query, meeting), query);
        }
    }

    static void child(const ModelView& parent, uint32_t number, const Rays& rays, uint32_t lanes,
                      Query& query) {
        if (!lanes) return;
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
