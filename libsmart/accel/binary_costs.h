// SPDX-License-Identifier: MIT
#pragma once

#include "libsmart/accel/binary_tree.h"
#include "libsmart/accel/wide_tree.h"

namespace smart {

/// What nodes of a binary tree cost as parts of a wide one: expected, for a ray that meets the box
/// of everything.
class BinaryCosts {
public:
    BinaryCosts(const WideCosts& costs, const Box4& whole) : costs_(costs), measure_(whole) {}

    const BoxMeasure& measure() const { return measure_; }
    /// References that are never divided.
    uint32_t smallestLeaf() const { return costs_.primitive > costs_.leaf ? 1 : 4; }

    SlotCosts ofLeaf(BinaryNode& node) const {
        node.leaf = true;
        return SlotCosts(leafCost(node));
    }
    /// Distributes slots among the children, unless one leaf is cheaper.
    SlotCosts ofDivided(BinaryNode& node, const SlotCosts& left, const SlotCosts& right,
                        bool canBeLeaf) const {
        const float own = measure_.share(node.box()) * (costs_.child + costs_.node);
        SlotCosts result;
        node.leaf = result.distribute(left, right, own, canBeLeaf ? leafCost(node) : Aabb::kInf,
                                      node.shares);
        return result;
    }

private:
    float leafCost(const BinaryNode& node) const {
        return measure_.share(node.box()) *
               (costs_.child + costs_.leaf + costs_.primitive * float(node.count));
    }

    const WideCosts costs_;
    const BoxMeasure measure_;
};

/// A part of a tree that was built before, to be put in place of a leaf.
struct BinarySubtree {
    BinaryNode root;
    SlotCosts costs;
};

} // namespace smart
