// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "libsmart/accel/kd_split.h"

namespace smart {

/// A finished part of a tree: nodes[0] is its root, the rest in depth-first order; child and
/// primitive indices count from its own arrays.
struct KdSubtree {
    std::vector<KdNode> nodes;
    std::vector<uint32_t> prims;
    uint32_t depth = 0; ///< of the deepest leaf, from the root of the whole tree
};

/// Builds everything below `cell` on the calling thread. `ids` as for KdSplitter::split.
KdSubtree buildKdSubtree(const KdCell& cell, const std::vector<uint32_t>& ids,
                         KdSplitter& splitter, KdEventArena& arena);

inline KdNode makeKdInner(const KdPlane& plane, std::size_t leftChild) {
    KdNode node;
    node.split = plane.position;
    node.bits = uint32_t(leftChild) << 2 | uint32_t(plane.axis);
    return node;
}
inline KdNode makeKdLeaf(std::size_t firstPrim, std::size_t count) {
    KdNode node;
    node.firstPrim = uint32_t(firstPrim);
    node.bits = uint32_t(count) << 2 | kKdLeaf;
    return node;
}

} // namespace smart
