// SPDX-License-Identifier: MIT
#include "libsmart/accel/wide_collapse.h"

#include "libsmart/accel/wide_refit.h"
#include "libsmart/base/error.h"

namespace smart {
namespace {

/// Writes wide nodes, each before those below it.
class Collapse {
public:
    Collapse(const BinaryTree& binary, const LeafMaker& leaves, WideTree& tree)
        : binary_(binary), leaves_(leaves), tree_(tree) {}

    uint32_t makeNode(const BinaryNode& node) {
        const uint32_t wide = uint32_t(tree_.nodes.size());
        tree_.nodes.emplace_back();
        const BinaryNode* children[kWideChildren];
        int count = 0;
        if (node.leaf)
            children[count++] = &node; // of the root alone
        else
            share(node, kWideChildren, node.shares.own, children, count);
        for (int slot = 0; slot < kWideChildren; ++slot) {
            const bool used = slot < count;
            WideNode& to = tree_.nodes[wide];
            for (int k = 0; k < 3; ++k) {
                to.lo[k][slot] = used ? children[slot]->lo[k] : Aabb::kInf;
                to.hi[k][slot] = used ? children[slot]->hi[k] : -Aabb::kInf;
            }
            to.child[slot] = 0;
        }
        for (int slot = 0; slot < count; ++slot) {
            const BinaryNode& child = *children[slot];
            const uint32_t number = child.leaf ? makeLeaf(child) : makeNode(child);
            tree_.nodes[wide].child[slot] = number;
        }
        return wide;
    }

private:
    uint32_t makeLeaf(const BinaryNode& leaf) {
        uint32_t prims[kWideLeafSize];
        const uint32_t count = leaves_.gather(leaf, prims);
        const std::size_t first = tree_.prims.size();
        if (first + count > BoxReference::kMaxNumber)
            throw Error(ErrorCode::OutOfMemory, "box tree: more than 2^27 references");
        tree_.prims.insert(tree_.prims.end(), prims, prims + count);
        return kWideLeaf | uint32_t(first) << 4 | (count - 1);
    }
    /// The subtrees that share so many slots of a wide node.
    void collect(const BinaryNode& node, int slots, const BinaryNode** children, int& count) const {
        while (slots > 1 && node.shares.left[std::size_t(slots)] == 0) --slots;
        if (slots == 1)
            children[count++] = &node;
        else
            share(node, slots, node.shares.left[std::size_t(slots)], children, count);
    }
    void share(const BinaryNode& node, int slots, int ofLeft, const BinaryNode** children,
               int& count) const {
        collect(binary_[node.left], ofLeft, children, count);
        collect(binary_[node.left + 1], slots - ofLeft, children, count);
    }

    const BinaryTree& binary_;
    const LeafMaker& leaves_;
    WideTree& tree_;
};

/// Primitives below a node that has none but leaves below it, as trees of triangles turn out.
constexpr uint32_t kTypicalNode = 50;

/// Memory that is not needed goes back where it is more than a little.
template <class T>
void shrink(std::vector<T>& vector) {
    if (vector.capacity() - vector.size() > vector.size() / 32) vector.shrink_to_fit();
}

} // namespace

void finishWideTree(const BinaryTree& binary, const LeafMaker& leaves, const WideCosts& costs,
                    WideTree& tree) {
    tree.nodes.reserve(tree.primitives / kTypicalNode + 1);
    tree.prims.reserve(tree.primitives);
    Collapse(binary, leaves, tree).makeNode(binary[0]);
    shrink(tree.nodes);
    shrink(tree.prims);
    tree.cost = wideTreeCost(tree.nodes, tree.bounds, costs);
}

} // namespace smart
