// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "libsmart/accel/binary_tree.h"
#include "libsmart/accel/wide_tree.h"

namespace smart {

/// What becomes of the leaves of a binary tree.
class LeafMaker {
public:
    /// Writes the primitives of a leaf, and nodes below it if need be. The child to enter in the
    /// wide node above.
    virtual uint32_t make(const BinaryNode& leaf, WideTree& tree) const = 0;

protected:
    ~LeafMaker() = default;
};

/// Appends primitives as one leaf: the child to enter. Throws Error where their numbers are too
/// many for a child.
uint32_t appendLeaf(const uint32_t* prims, uint32_t count, WideTree& tree);

/// A node whose places are all without a child.
WideNode emptyWideNode();

/// Writes the wide nodes that the distributed slots of a binary tree describe. Nodes stand before
/// those below them, and those below one are neighbours.
void collapse(const BinaryTree& binary, const LeafMaker& leaves, WideTree& tree);

} // namespace smart
