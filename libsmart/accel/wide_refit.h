// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "libsmart/accel/box_reference.h"
#include "libsmart/accel/build_crew.h"
#include "libsmart/accel/wide_tree.h"

namespace smart {

inline bool hasChild(const WideNode& node, int slot) {
    return node.lo[0][slot] <= node.hi[0][slot];
}

/// The number of a leaf's first entry in WideTree::prims, and how many it has.
inline std::pair<uint32_t, uint32_t> leafEntries(uint32_t child) {
    return {(child & ~kWideLeaf) >> 4, (child & 15u) + 1};
}

/// Expected cost of a ray that meets the bounds of a tree.
float wideTreeCost(std::span<const WideNode> nodes, const Aabb& bounds, const WideCosts& costs);

/// Parts of a tree that threads can go through apart: ranges of nodes, each of whole subtrees, and
/// the nodes above them, those further up first.
struct WideParts {
    std::vector<std::pair<uint32_t, uint32_t>> ranges;
    std::vector<uint32_t> above;
};
WideParts partsOf(std::span<const WideNode> nodes);

/// Boxes of all nodes anew, from the leaves up, by leafBox(child): the box of what is in a leaf. The
/// bounds of all.
template <class LeafBox>
Aabb refitNodes(std::span<WideNode> nodes, const LeafBox& leafBox, BuildCrew& crew) {
    std::vector<Aabb> boxes(nodes.size());
    const auto refit = [&](uint32_t number) {
        WideNode& node = nodes[number];
        Box4 all;
        for (int slot = 0; slot < kWideChildren; ++slot) {
            if (!hasChild(node, slot)) continue;
            const uint32_t child = node.child[slot];
            const Box4 box = child & kWideLeaf ? leafBox(child) : Box4(boxes[child]);
            all.add(box);
            for (int k = 0; k < 3; ++k) {
                node.lo[k][slot] = box.lo[k];
                node.hi[k][slot] = box.hi[k];
            }
        }
        boxes[number] = all.aabb();
    };
    const WideParts parts = partsOf(nodes);
    crew.forEach(parts.ranges.size(), [&](std::size_t i) {
        for (uint32_t node = parts.ranges[i].second; node-- > parts.ranges[i].first;) refit(node);
    });
    for (std::size_t i = parts.above.size(); i-- > 0;) refit(parts.above[i]);
    return boxes.empty() ? Aabb() : boxes[0];
}

/// The same tree over boxes that have changed, in a time that grows linearly with their number. Of
/// a primitive that was cut, all of it is in each of its leaves afterwards. False, and nothing is
/// changed, where other boxes are empty than were when the tree was built. Throws std::bad_alloc.
bool refitWideTree(WideTree& tree, std::span<const Aabb> boxes, unsigned threads = 1,
                   const WideCosts& costs = kTriangleCosts);

} // namespace smart
