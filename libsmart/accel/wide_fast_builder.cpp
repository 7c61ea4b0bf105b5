// SPDX-License-Identifier: MIT
#include <algorithm>

#include "libsmart/accel/binary_builder.h"
#include "libsmart/accel/morton_order.h"
#include "libsmart/accel/wide_collapse.h"

namespace smart {
namespace {

/// So many neighbours on the curve, or fewer, make a subtree by the bits of their codes.
constexpr uint32_t kSubtreeSize = 64;
/// Keys that one thread makes subtrees of at a time. It shapes the work, not the tree.
constexpr uint32_t kKeysOfPart = 8192;

/// A stretch of the curve.
struct Stretch {
    uint32_t first = 0, count = 0;
};

/// Cuts the curve into stretches of no more than `most` keys, where their codes differ.
void cutCurve(std::span<const MortonKey> keys, Stretch all, uint32_t most,
              std::vector<Stretch>& stretches) {
    if (all.count <= most) {
        stretches.push_back(all);
        return;
    }
    const uint32_t left = uint32_t(mortonSplit(keys.subspan(all.first, all.count)));
    cutCurve(keys, {all.first, left}, most, stretches);
    cutCurve(keys, {all.first + left, all.count - left}, most, stretches);
}

/// Makes subtrees of stretches of the curve.
class CurveBuilder {
public:
    CurveBuilder(std::span<const Aabb> boxes, std::span<const MortonKey> keys,
                 const BinaryCosts& costs, BinaryTree& tree)
        : boxes_(boxes), keys_(keys), costs_(costs), tree_(tree), nodes_(tree) {}

    BinarySubtree build(Stretch stretch) {
        BinaryNode root;
        Box4 box;
        const SlotCosts costs = divide(stretch, root, box);
        return {root, costs};
    }

private:
    SlotCosts divide(Stretch stretch, BinaryNode& node, Box4& box) {
        if (stretch.count <= costs_.smallestLeaf()) {
            for (uint32_t i = stretch.first; i < stretch.first + stretch.count; ++i)
                box.add(Box4(boxes_[mortonNumber(keys_[i])]));
            node.describe(box, stretch.first, stretch.count);
            return costs_.ofLeaf(node);
        }
        const uint32_t left =
            uint32_t(mortonSplit(keys_.subspan(stretch.first, stretch.count)));
        const uint32_t pair = nodes_.takePair();
        const SlotCosts leftCosts = divide({stretch.first, left}, tree_[pair], box);
        Box4 rightBox;
        const SlotCosts rightCosts = divide({stretch.first + left, stretch.count - left},
                                            tree_[pair + 1], rightBox);
        box.add(rightBox);
        node.describe(box, stretch.first, stretch.count);
        node.left = pair;
        return costs_.ofDivided(node, leftCosts, rightCosts, stretch.count <= kWideLeafSize);
    }

    const std::span<const Aabb> boxes_;
    const std::span<const MortonKey> keys_;
    const BinaryCosts& costs_;
    BinaryTree& tree_;
    BinaryTree::Source nodes_;
};

/// Leaves of stretches.
class StretchLeaves final : public LeafMaker {
public:
    explicit StretchLeaves(std::span<const MortonKey> keys) : keys_(keys) {}
    uint32_t gather(const BinaryNode& leaf, uint32_t* prims) const override {
        for (uint32_t i = 0; i < leaf.count; ++i) prims[i] = mortonNumber(keys_[leaf.first + i]);
        return leaf.count;
    }

private:
    const std::span<const MortonKey> keys_;
};

} // namespace

// Neighbours along a space-filling curve become subtrees (Lauterbach and others, "Fast BVH
// construction on GPUs", 2009), and the surface area heuristic sorts these (Pantaleoni, Luebke,
// "HLBVH: hierarchical LBVH construction for real-time ray tracing", 2010).
WideTree buildWideTreeFast(std::span<const Aabb> boxes, unsigned threads, const WideCosts& costs) {
    if (boxes.size() <= kSubtreeSize) return buildWideTree(boxes, threads, costs);
    WideTree tree;
    BuildCrew crew(threads);
    const MortonOrder order = mortonOrder(boxes, crew);
    if (order.keys.empty()) return tree;
    const BinaryCosts binaryCosts(costs, order.bounds);

    const Stretch all{0, uint32_t(order.keys.size())};
    std::vector<Stretch> parts;
    cutCurve(order.keys, all, kKeysOfPart, parts);
    // Threads that build above the subtrees, and one source for each part.
    BinaryTree binary(2 * order.keys.size(), crew.threads() + parts.size());
    std::vector<std::vector<BinarySubtree>> built(parts.size());
    crew.forEach(parts.size(), [&](std::size_t i) {
        std::vector<Stretch> stretches;
        cutCurve(order.keys, parts[i], kSubtreeSize, stretches);
        built[i].reserve(stretches.size());
        CurveBuilder builder(boxes, order.keys, binaryCosts, binary);
        for (const Stretch stretch : stretches) built[i].push_back(builder.build(stretch));
    });
    std::vector<BinarySubtree> subtrees;
    ReferenceList list;
    for (const std::vector<BinarySubtree>& part : built) {
        for (const BinarySubtree& subtree : part) {
            const BoxReference reference(subtree.root.box(), uint32_t(subtrees.size()));
            list.references.push_back(reference);
            list.bounds.add(reference);
            subtrees.push_back(subtree);
        }
    }
    list.count = subtrees.size();
    BinaryBuilder(std::move(list), nullptr, subtrees, binaryCosts, binary, crew);
    tree.bounds = order.bounds.aabb();
    tree.primitives = all.count;
    finishWideTree(binary, StretchLeaves(order.keys), costs, tree);
    return tree;
}

} // namespace smart
