// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "libsmart/accel/wide_node.h"
#include "libsmart/base/aabb.h"

namespace smart {

/// A bounding volume hierarchy of wide nodes over numbered primitives. Root = nodes[0]; nodes is
/// empty when there is no primitive. Each primitive is in one leaf.
struct WideTree {
    Aabb bounds;
    std::vector<WideNode> nodes;
    std::vector<uint32_t> prims; ///< primitive numbers, leaf by leaf

    std::size_t bytes() const {
        return nodes.capacity() * sizeof(WideNode) + prims.capacity() * sizeof(uint32_t);
    }
};

/// Builds a binary tree by the surface area heuristic over 32 bins an axis (Wald, "On fast
/// construction of SAH-based bounding volume hierarchies", 2007). Which of its subtrees become wide
/// nodes, and which leaves, is found by dynamic programming over the slots of wide nodes, so that
/// the expected cost is least (as Ylitie, Karras, Laine, "Efficient incoherent ray traversal on
/// GPUs through compressed wide BVHs", 2017). An empty box leaves a primitive out. Throws
/// std::bad_alloc.
WideTree buildWideTree(const std::vector<Aabb>& boxes);

} // namespace smart
