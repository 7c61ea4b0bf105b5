// SPDX-License-Identifier: MIT
#include <algorithm>

#include "libsmart/accel/binary_builder.h"
#include "libsmart/accel/wide_collapse.h"

namespace smart {
namespace {

/// References that cutting may add, for each that there is: of more, memory and build time grow
/// faster than rays gain.
constexpr double kExtraShare = 0.25;

/// Leaves of references. A triangle that was cut is in a leaf once, however many of its parts are.
class ReferenceLeaves final : public LeafMaker {
public:
    ReferenceLeaves(const BinaryTree& binary, const BinaryBuilder& builder)
        : binary_(binary), builder_(builder) {}
    uint32_t gather(const BinaryNode& leaf, uint32_t* prims) const override {
        uint32_t count = 0;
        collect(leaf, prims, count);
        return count;
    }

private:
    void collect(const BinaryNode& node, uint32_t* prims, uint32_t& count) const {
        if (node.left) {
            collect(binary_[node.left], prims, count);
            collect(binary_[node.left + 1], prims, count);
            return;
        }
        for (uint32_t i = node.first; i < node.first + node.count; ++i) {
            const uint32_t number = builder_.reference(i).number();
            if (std::find(prims, prims + count, number) == prims + count) prims[count++] = number;
        }
    }

    const BinaryTree& binary_;
    const BinaryBuilder& builder_;
};

WideTree build(std::span<const Aabb> boxes, TriangleVertices vertices, unsigned threads,
               const WideCosts& costs) {
    WideTree tree;
    BuildCrew crew(threads);
    ReferenceList list = listReferences(boxes, vertices ? kExtraShare : 0, crew);
    const std::size_t count = list.count;
    if (count == 0) return tree;
    tree.bounds = list.bounds.box.aabb();
    const BinaryCosts binaryCosts(costs, list.bounds.box);
    BinaryTree binary(2 * list.references.size(), crew.threads());
    const BinaryBuilder builder(std::move(list), vertices, {}, binaryCosts, binary, crew);
    tree.primitives = uint32_t(count);
    finishWideTree(binary, ReferenceLeaves(binary, builder), costs, tree);
    return tree;
}

} // namespace

WideTree buildWideTree(std::span<const Aabb> boxes, unsigned threads, const WideCosts& costs) {
    return build(boxes, nullptr, threads, costs);
}

WideTree buildWideTreeSpatial(std::span<const Aabb> boxes, const float* vertices, unsigned threads,
                              const WideCosts& costs) {
    return build(boxes, vertices, threads, costs);
}

} // namespace smart
