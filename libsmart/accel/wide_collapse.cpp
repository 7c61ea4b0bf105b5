// SPDX-License-Identifier: MIT
#include "libsmart/accel/wide_collapse.h"

#include "libsmart/base/error.h"

namespace smart {
namespace {

class Collapse {
public:
    Collapse(const BinaryTree& binary, const LeafMaker& leaves, WideTree& tree)
        : binary_(binary), leaves_(leaves), tree_(tree) {}

    uint32_t makeNode(const BinaryNode& node) {
        const uint32_t wide = uint32_t(tree_.nodes.size());
        tree_.nodes.push_back(emptyWideNode());
        const BinaryNode* children[kWideChildren];
        int count = 0;
        if (node.leaf)
            children[count++] = &node; // of the root alone
        else
            share(node, kWideChildren, node.shares.own, children, count);
        for (int slot = 0; slot < count; ++slot) {
            const BinaryNode& child = *children[slot];
            for (int k = 0; k < 3; ++k) {
                tree_.nodes[wide].lo[k][slot] = child.lo[k];
                tree_.nodes[wide].hi[k][slot] = child.hi[k];
            }
            const uint32_t number = child.leaf ? leaves_.make(child, tree_) : makeNode(child);
            tree_.nodes[wide].child[slot] = number;
        }
        return wide;
    }

private:
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

} // namespace

uint32_t appendLeaf(const uint32_t* prims, uint32_t count, WideTree& tree) {
    const std::size_t first = tree.prims.size();
    if (first + count > BoxReference::kMaxNumber)
        throw Error(ErrorCode::OutOfMemory, "box tree: more than 2^27 references");
    tree.prims.insert(tree.prims.end(), prims, prims + count);
    return kWideLeaf | uint32_t(first) << 4 | (count - 1);
}

WideNode emptyWideNode() {
    WideNode node{};
    for (int k = 0; k < 3; ++k) {
        for (int slot = 0; slot < kWideChildren; ++slot) {
            node.lo[k][slot] = Aabb::kInf;
            node.hi[k][slot] = -Aabb::kInf;
        }
    }
    return node;
}

void collapse(const BinaryTree& binary, const LeafMaker& leaves, WideTree& tree) {
    Collapse(binary, leaves, tree).makeNode(binary[0]);
}

} // namespace smart
