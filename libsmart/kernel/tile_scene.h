// SPDX-License-Identifier: MIT
// Tiles of rays through models and the instances nested in them. What is no beam, gains nothing by
// being one, or comes to a kd-tree goes packet by packet.
#pragma once

#include "libsmart/kernel/scene_traversal.h"
#include "libsmart/kernel/tile_traversal.h"

namespace smart::SMART_ISA {

template <template <int> class Precision, HitMode M>
class TileScene {
public:
    static constexpr int N = kPacketSize;
    using Query = Search<N, M, NoCounts>;

    /// more: whether the rays go on to other models afterwards.
    static void model(const ModelView& model, const RayTile& tile, const TileLanes& lanes,
                      Query* query, bool more) {
        const bool several = model.childTree.nodes != nullptr;
        const bool own = model.tree.nodes || model.wide.nodes;
        if (!own && !several) {
            for (uint32_t i = 0; i < model.childCount; ++i)
                child(model, i, tile, live(query, lanes), query, more || i + 1 < model.childCount);
            return;
        }
        const float maxAbs = largerOf(own ? triangleBox(model).maxAbs : 0.0f,
                                      several ? model.childTree.maxAbs : 0.0f);
        TileGroups groups(tile, lanes);
        RayGroup group{};
        TileLanes same;
        while (groups.next(group, same)) {
            if (model.tree.nodes || same.count() < kLeastRays) {
                packets(model, tile, same, query);
                continue;
            }
            const Beam beam(maxAbs, tile, same, group);
            if (!beam.isNarrow()) {
                packets(model, tile, same, query);
                continue;
            }
            if (model.wide.nodes && beam.mayMeet(model.wide.nodes[0])) {
                TileTraversal<Precision, M> triangles(model, tile, beam, group, same, query);
                triangles.run();
                triangles.finish(more || model.childCount > 0);
            }
            if (several) {
                Children children(model, tile, beam, same, query);
                traverseWide(model.childTree.nodes, beam, children);
            } else {
                for (uint32_t i = 0; i < model.childCount; ++i)
                    child(model, i, tile, live(query, same), query,
                          more || i + 1 < model.childCount);
            }
        }
    }

private:
    static constexpr uint32_t kLeastRays = 6; ///< fewer gain nothing by going together

    static TileLanes live(const Query* query, TileLanes lanes) {
        if (M == HitMode::Any)
            for (int v = 0; v < kTileVectors; ++v) lanes.of[v] &= ~query[v].blocked;
        return lanes;
    }

    static void packets(const ModelView& model, const RayTile& tile, const TileLanes& lanes,
                        Query* query) {
        for (int v = 0; v < kTileVectors; ++v)
            if (lanes.of[v])
                SceneTraversal<Precision, N, M, NoCounts>::model(model, tile.rays[v], lanes.of[v],
                                                                 query[v]);
    }

    static void child(const ModelView& parent, uint32_t number, const RayTile& tile,
                      const TileLanes& lanes, Query* query, bool more) {
        if (!lanes.count()) return;
        const InstanceView& instance = parent.children[number];
        for (int v = 0; v < kTileVectors; ++v)
            query[v].currentPath[query[v].currentLevels++] = number;
        if (instance.identity) {
            model(reached(instance), tile, lanes, query, more);
        } else {
            AffineRows toObject;
            invert(instance, toObject);
            RayTile local;
            for (int v = 0; v < kTileVectors; ++v)
                if (lanes.of[v]) transformRays(toObject, tile.rays[v], local.rays[v]);
            const double x = tile.apex[0], y = tile.apex[1], z = tile.apex[2];
            for (int k = 0; k < 3; ++k) {
                const double* m = toObject[k];
                local.apex[k] = float(m[0] * x + m[1] * y + m[2] * z + m[3]);
            }
            local.startsThere = tile.startsThere;
            if (!tile.startsThere) __builtin_memcpy(local.last, tile.last, sizeof local.last);
            model(reached(instance), local, lanes, query, more);
        }
        for (int v = 0; v < kTileVectors; ++v) --query[v].currentLevels;
    }

    /// The instances nested in a model, as traverseWide visits them.
    class Children {
    public:
        Children(const ModelView& model, const RayTile& tile, const Beam& beam,
                 const TileLanes& lanes, Query* query)
            : model_(model), tile_(tile), beam_(beam), lanes_(lanes), query_(query) {
            update();
        }
        uint32_t packets() const { return packets_; }
        uint64_t looking(float near) const {
            uint64_t rays = 0;
            for (int v = 0; v < kTileVectors; ++v)
                rays |= uint64_t((far_[v] >= Real<N>(near)).bits()) << 16 * v;
            return rays;
        }
        float farthestDepth() const { return farthest_; }
        const Real<N>& nearDepth(int v) const { return near_[v]; }
        const Real<N>& farDepth(int v) const { return far_[v]; }
        void prefetch(uint32_t) const {}
        bool waits() const { return waits_; }
        bool joins(uint32_t) const { return false; }
        void goThrough() {
            update();
            waits_ = false;
        }

        void leaf(uint32_t reference, uint64_t rays) {
            const uint32_t first = (reference & ~kWideLeaf) >> 4, count = (reference & 15u) + 1;
            TileLanes lanes;
            for (int v = 0; v < kTileVectors; ++v) lanes.of[v] = raysOf(rays, v);
            for (uint32_t i = 0; i < count; ++i)
                child(model_, model_.childTree.prims[first + i], tile_, live(query_, lanes),
                      query_, true);
            waits_ = true;
        }

    private:
        void update() {
            Real<N> farthest(-__builtin_inff());
            packets_ = 0;
            const TileLanes on = live(query_, lanes_);
            for (int v = 0; v < kTileVectors; ++v) {
                near_[v] = far_[v] = Real<N>(-__builtin_inff());
                if (!on.of[v]) continue;
                const DepthRange range(tile_, beam_, v, Real<N>::load(query_[v].tNear),
                                       Real<N>::load(query_[v].best));
                near_[v] = range.from;
                far_[v] = select(Mask<N>::fromBits(on.of[v]), range.to,
                                 Real<N>(-__builtin_inff()));
                farthest = max(farthest, far_[v]);
                packets_ |= 1u << v;
            }
            farthest_ = largestLane(farthest);
        }

        const ModelView& model_;
        const RayTile& tile_;
        const Beam& beam_;
        const TileLanes& lanes_;
        Query* const query_;
        uint32_t packets_;
        bool waits_ = false;
        float farthest_;
        Real<N> near_[kTileVectors], far_[kTileVectors];
    };
};

} // namespace smart::SMART_ISA
