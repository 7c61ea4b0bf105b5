// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "libsmart/accel/slot_costs.h"

namespace smart {

/// A node of the binary tree that wide nodes are made of. Nothing is set before describe().
struct BinaryNode {
    float lo[3], hi[3];
    uint32_t first; ///< references of a leaf
    uint32_t count; ///< references below it
    uint32_t left;  ///< the right child follows it; 0: this node is not divided
    bool leaf;      ///< cheapest as one leaf
    SlotShares shares;

    void describe(const Box4& box, uint32_t firstReference, uint32_t references) {
        for (int k = 0; k < 3; ++k) {
            lo[k] = box.lo[k];
            hi[k] = box.hi[k];
        }
        first = firstReference;
        count = references;
        left = 0;
        leaf = false;
        shares = {};
    }
    Box4 box() const { return Box4(Float4{lo[0], lo[1], lo[2], 0.0f}, Float4{hi[0], hi[1], hi[2], 0.0f}); }
};

/// Nodes in blocks that several threads fill at once, each its own. The root is node 0.
class BinaryTree {
public:
    static constexpr uint32_t kBlockSize = 1024;

    /// Where one part of a build takes its nodes from.
    class Source {
    public:
        /// The first one goes on in the root's block.
        explicit Source(BinaryTree& tree, bool isFirst = false)
            : tree_(tree), next_(isFirst ? 2 : 0), end_(isFirst ? kBlockSize : 0) {}
        /// The first of two neighbours.
        uint32_t takePair() {
            if (next_ == end_) {
                next_ = tree_.newBlock();
                end_ = next_ + kBlockSize;
            }
            next_ += 2;
            return next_ - 2;
        }

    private:
        BinaryTree& tree_;
        uint32_t next_, end_;
    };

    /// For so many nodes at most, taken by so many sources. Node 0 exists, and nobody is given it.
    BinaryTree(std::size_t nodes, std::size_t sources)
        : blocks_(nodes / kBlockSize + sources + 1) {
        newBlock();
    }
    BinaryNode& operator[](uint32_t node) { return blocks_[node / kBlockSize][node % kBlockSize]; }
    const BinaryNode& operator[](uint32_t node) const {
        return blocks_[node / kBlockSize][node % kBlockSize];
    }

private:
    uint32_t newBlock() {
        const uint32_t block = used_.fetch_add(1, std::memory_order_relaxed);
        blocks_[block] = std::make_unique_for_overwrite<BinaryNode[]>(kBlockSize);
        return block * kBlockSize;
    }

    std::vector<std::unique_ptr<BinaryNode[]>> blocks_;
    std::atomic<uint32_t> used_{0};
};

} // namespace smart
