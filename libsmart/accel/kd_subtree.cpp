// SPDX-License-Identifier: MIT
#include "libsmart/accel/kd_subtree.h"

#include <algorithm>
#include <utility>

namespace smart {
namespace {

class SubtreeBuilder {
public:
    SubtreeBuilder(const std::vector<uint32_t>& ids, KdSplitter& splitter, KdEventArena& arena)
        : ids_(ids), splitter_(splitter), arena_(arena) {}

    /// Builds `cell` into nodes[slot].
    void build(const KdCell& cell, std::size_t slot) {
        KdPlane plane;
        KdCell left, right;
        const KdEventArena::Mark start = arena_.mark();
        if (!splitter_.split(cell, ids_, plane, arena_, left, arena_, right)) {
            makeLeaf(cell, slot);
            return;
        }
        const std::size_t child = tree.nodes.size();
        tree.nodes.resize(child + 2);
        tree.nodes[slot] = makeKdInner(plane, child);
        build(left, child);
        build(right, child + 1);
        arena_.release(start);
    }

    KdSubtree tree;

private:
    void makeLeaf(const KdCell& cell, std::size_t slot) {
        tree.nodes[slot] = makeKdLeaf(tree.prims.size(), cell.count);
        tree.depth = std::max(tree.depth, cell.depth);
        for (uint32_t i = 0; i < cell.lists.size[0]; ++i) {
            const KdEvent event = cell.lists.events[0][i];
            if (kdEventKind(event) == KdEventKind::End) continue;
            tree.prims.push_back(ids_[kdEventPrim(event)]);
        }
    }

    const std::vector<uint32_t>& ids_;
    KdSplitter& splitter_;
    KdEventArena& arena_;
};

} // namespace

KdSubtree buildKdSubtree(const KdCell& cell, const std::vector<uint32_t>& ids,
                         KdSplitter& splitter, KdEventArena& arena) {
    SubtreeBuilder builder(ids, splitter, arena);
    builder.tree.nodes.resize(1);
    builder.build(cell, 0);
    return std::move(builder.tree);
}

} // namespace smart
