// SPDX-License-Identifier: MIT
#include "libsmart/accel/wide_refit.h"

#include <algorithm>

#include "libsmart/accel/reference_list.h"

namespace smart {
namespace {

constexpr uint32_t kNodesOfPart = 128;

void cut(std::span<const WideNode> nodes, uint32_t node, uint32_t end, WideParts& parts) {
    if (end - node <= kNodesOfPart) {
        parts.ranges.emplace_back(node, end);
        return;
    }
    parts.above.push_back(node);
    // Subtrees are neighbours, in the order of their places.
    uint32_t last = 0;
    for (int slot = 0; slot < kWideChildren; ++slot) {
        const uint32_t child = nodes[node].child[slot];
        if (!hasChild(nodes[node], slot) || child & kWideLeaf) continue;
        if (last) cut(nodes, last, child, parts);
        last = child;
    }
    if (last) cut(nodes, last, end, parts);
}

} // namespace

float wideTreeCost(std::span<const WideNode> nodes, const Aabb& bounds, const WideCosts& costs) {
    if (nodes.empty()) return 0;
    const BoxMeasure measure{Box4(bounds)};
    double sum = costs.node;
    for (const WideNode& node : nodes) {
        float ofNode = 0;
        for (int slot = 0; slot < kWideChildren; ++slot) {
            if (!hasChild(node, slot)) continue;
            const Box4 box(Float4{node.lo[0][slot], node.lo[1][slot], node.lo[2][slot], 0.0f},
                           Float4{node.hi[0][slot], node.hi[1][slot], node.hi[2][slot], 0.0f});
            const uint32_t child = node.child[slot];
            const float inside =
                child & kWideLeaf
                    ? costs.leaf + costs.primitive * float(leafEntries(child).second)
                    : costs.node;
            ofNode += measure.share(box) * (costs.child + inside);
        }
        sum += ofNode;
    }
    return float(sum);
}

WideParts partsOf(std::span<const WideNode> nodes) {
    WideParts parts;
    if (!nodes.empty()) cut(nodes, 0, uint32_t(nodes.size()), parts);
    return parts;
}

bool refitWideTree(WideTree& tree, std::span<const Aabb> boxes, unsigned threads,
                   const WideCosts& costs) {
    BuildCrew crew(threads);
    if (countBoxes(boxes, crew).back() != tree.primitives) return false;
    const auto isLeftOut = [&](uint32_t prim) {
        return prim >= boxes.size() || boxes[prim].empty();
    };
    if (std::any_of(tree.prims.begin(), tree.prims.end(), isLeftOut)) return false;
    tree.bounds = refitNodes(std::span(tree.nodes), [&](uint32_t child) {
        const auto [first, count] = leafEntries(child);
        Box4 box;
        for (uint32_t i = first; i < first + count; ++i) box.add(Box4(boxes[tree.prims[i]]));
        return box;
    }, crew);
    tree.cost = wideTreeCost(tree.nodes, tree.bounds, costs);
    return true;
}

} // namespace smart
