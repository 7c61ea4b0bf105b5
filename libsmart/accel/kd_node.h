// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace smart {

/// One node of a kd-tree in 8 plain bytes, read by kernels of every instruction set.
/// Inner node: `split`, and bits = (index of the left child << 2) | axis 0..2; the right child
/// follows the left. Leaf: `firstPrim` into KdTree::prims, and bits = (count << 2) | 3.
struct KdNode {
    union {
        float split;
        uint32_t firstPrim;
    };
    uint32_t bits;
};
static_assert(sizeof(KdNode) == 8);

inline constexpr uint32_t kKdLeaf = 3;      ///< value of the axis field in a leaf
inline constexpr int kKdMaxDepth = 56;      ///< no tree is deeper; kernels' stacks rely on it

} // namespace smart
