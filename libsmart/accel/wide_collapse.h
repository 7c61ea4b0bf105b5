// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "libsmart/accel/binary_tree.h"
#include "libsmart/accel/wide_tree.h"

namespace smart {

/// What becomes of the leaves of a binary tree.
class LeafMaker {
public:
    /// Numbers of the primitives of a leaf, kWideLeafSize at most: how many.
    virtual uint32_t gather(const BinaryNode& leaf, uint32_t* prims) const = 0;

protected:
    ~LeafMaker() = default;
};

/// Makes the nodes that the distributed slots of a binary tree describe, the leaves, and the cost.
void finishWideTree(const BinaryTree& binary, const LeafMaker& leaves, const WideCosts& costs,
                    WideTree& tree);

} // namespace smart
