// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <limits>

#include "libsmart/accel/wide_tree.h"

namespace smart {
namespace {

constexpr int kBins = 32;
constexpr uint32_t kSmallest = 4; ///< primitives that are never split
constexpr int kSplitDepth = kWideMaxDepth - 33; ///< below, halves: 2^32 primitives in 32 levels

float halfArea(const Aabb& box) {
    const float x = box.hi[0] - box.lo[0], y = box.hi[1] - box.lo[1], z = box.hi[2] - box.lo[2];
    return x * y + y * z + z * x;
}

/// A node of the binary tree that wide nodes are made of.
struct Binary {
    Aabb box;
    uint32_t first = 0, count = 0;
    uint32_t left = 0; ///< the right child follows it
    bool leaf = false; ///< cheapest as one leaf
    /// To fill i slots of a wide node at the least cost: how many of them the left child takes; 0:
    /// it is better to fill fewer. And how many where this node is made a wide node.
    std::array<uint8_t, kWideChildren + 1> share{};
    uint8_t ownShare = 0;
};

/// Least cost of filling up to so many slots with a subtree.
using SlotCosts = std::array<float, kWideChildren + 1>;

struct Split {
    float cost = std::numeric_limits<float>::infinity();
    int axis = 0;
    int bin = 0; ///< first bin of the right side
};

class Builder {
public:
    Builder(std::span<const Aabb> boxes, const WideCosts& costs) : boxes_(boxes), costs_(costs) {}

    WideTree build() {
        WideTree tree;
        for (uint32_t i = 0; i < boxes_.size(); ++i)
            if (!boxes_[i].empty()) tree.prims.push_back(i);
        if (tree.prims.empty()) return tree;
        tree.prims.shrink_to_fit();
        prims_ = tree.prims.data();
        for (const uint32_t prim : tree.prims) tree.bounds.add(boxes_[prim]);
        wholeArea_ = std::max(tree.bounds.halfArea(), std::numeric_limits<double>::min());
        binary_.reserve(tree.prims.size());
        binary_.emplace_back();
        divide(0, 0, uint32_t(tree.prims.size()), 0);
        fill(tree, 0);
        tree.nodes.shrink_to_fit();
        return tree;
    }

private:
    SlotCosts divide(uint32_t node, uint32_t first, uint32_t count, int depth) {
        Aabb box, centres;
        for (uint32_t i = first; i < first + count; ++i) {
            const Aabb& b = boxes_[prims_[i]];
            box.add(b);
            const float c[3] = {centre(b, 0), centre(b, 1), centre(b, 2)};
            centres.add(c);
        }
        binary_[node].box = box;
        binary_[node].first = first;
        binary_[node].count = count;
        SlotCosts costs;
        if (count <= kSmallest) {
            binary_[node].leaf = true;
            costs.fill(leafCost(box, count));
            return costs;
        }
        uint32_t middle = first + count / 2;
        Split best;
        if (depth < kSplitDepth) best = findSplit(first, count, centres);
        if (best.cost < std::numeric_limits<float>::infinity()) {
            const float low = centres.lo[best.axis];
            const float scale = binScale(centres, best.axis);
            uint32_t* const end = std::partition(
                prims_ + first, prims_ + first + count, [&](uint32_t prim) {
                    return binOf(centre(boxes_[prim], best.axis), low, scale) < best.bin;
                });
            middle = uint32_t(end - prims_);
        }
        const uint32_t left = uint32_t(binary_.size());
        binary_.emplace_back();
        binary_.emplace_back();
        binary_[node].left = left;
        const SlotCosts l = divide(left, first, middle - first, depth + 1);
        const SlotCosts r = divide(left + 1, middle, first + count - middle, depth + 1);
        return distribute(binary_[node], l, r);
    }

    /// Distributes slots between two subtrees, for each number of them.
    SlotCosts distribute(Binary& node, const SlotCosts& left, const SlotCosts& right) const {
        SlotCosts costs;
        for (int slots = 2; slots <= kWideChildren; ++slots) {
            float least = std::numeric_limits<float>::infinity();
            for (int i = 1; i < slots; ++i) {
                const float cost = left[std::size_t(i)] + right[std::size_t(slots - i)];
                if (cost < least) {
                    least = cost;
                    node.share[std::size_t(slots)] = uint8_t(i);
                }
            }
            costs[std::size_t(slots)] = least;
        }
        node.ownShare = node.share[kWideChildren];
        const float area = share(node.box);
        costs[1] = area * (costs_.child + costs_.node) + costs[kWideChildren];
        if (node.count <= kWideLeafSize && !(costs[1] < leafCost(node.box, node.count))) {
            costs[1] = leafCost(node.box, node.count);
            node.leaf = true;
        }
        for (std::size_t slots = 2; slots <= std::size_t(kWideChildren); ++slots) {
            if (costs[slots] < costs[slots - 1]) continue;
            costs[slots] = costs[slots - 1];
            node.share[slots] = 0;
        }
        return costs;
    }

    /// Of the rays that meet all, those that meet a box.
    float share(const Aabb& box) const { return float(box.halfArea() / wholeArea_); }
    float leafCost(const Aabb& box, uint32_t count) const {
        return share(box) * (costs_.child + costs_.leaf + costs_.primitive * float(count));
    }

    static float centre(const Aabb& box, int axis) {
        return 0.5f * box.lo[axis] + 0.5f * box.hi[axis];
    }
    /// Bins a unit of length; 0 where float can not say.
    static float binScale(const Aabb& centres, int axis) {
        const float scale = float(kBins) * 0.9999f / (centres.hi[axis] - centres.lo[axis]);
        return scale < std::numeric_limits<float>::infinity() ? scale : 0.0f;
    }
    static int binOf(float centre, float low, float scale) {
        return std::min(int((centre - low) * scale), kBins - 1);
    }

    Split findSplit(uint32_t first, uint32_t count, const Aabb& centres) const {
        struct Bin {
            Aabb box;
            uint32_t count = 0;
        };
        Split best;
        std::array<std::array<Bin, kBins>, 3> bins{};
        float scale[3];
        for (int axis = 0; axis < 3; ++axis) scale[axis] = binScale(centres, axis);
        for (uint32_t i = first; i < first + count; ++i) {
            const Aabb& b = boxes_[prims_[i]];
            for (int axis = 0; axis < 3; ++axis) {
                if (!(scale[axis] > 0)) continue;
                Bin& bin = bins[std::size_t(axis)][std::size_t(
                    binOf(centre(b, axis), centres.lo[axis], scale[axis]))];
                bin.box.add(b);
                ++bin.count;
            }
        }
        for (int axis = 0; axis < 3; ++axis) {
            if (!(scale[axis] > 0)) continue;
            const auto& row = bins[std::size_t(axis)];
            float rightCost[kBins];
            Aabb box;
            uint32_t n = 0;
            for (int i = kBins - 1; i > 0; --i) {
                box.add(row[std::size_t(i)].box);
                n += row[std::size_t(i)].count;
                rightCost[i] = n ? halfArea(box) * float(n) : -1.0f;
            }
            box = Aabb();
            n = 0;
            for (int i = 1; i < kBins; ++i) {
                box.add(row[std::size_t(i - 1)].box);
                n += row[std::size_t(i - 1)].count;
                if (n == 0 || rightCost[i] < 0) continue;
                const float total = halfArea(box) * float(n) + rightCost[i];
                if (total < best.cost) best = {total, axis, i};
            }
        }
        return best;
    }

    static void placeNothing(WideNode& node, int slot) {
        for (int k = 0; k < 3; ++k) {
            node.lo[k][slot] = std::numeric_limits<float>::infinity();
            node.hi[k][slot] = -std::numeric_limits<float>::infinity();
        }
        node.child[slot] = 0;
    }

    /// Makes a wide node of a binary one, and those below it.
    uint32_t fill(WideTree& tree, uint32_t binary) const {
        const uint32_t wide = uint32_t(tree.nodes.size());
        tree.nodes.emplace_back();
        uint32_t children[kWideChildren];
        int count = 0;
        if (binary_[binary].leaf)
            children[count++] = binary; // of the root alone
        else
            part(binary, kWideChildren, binary_[binary].ownShare, children, count);
        for (int slot = 0; slot < kWideChildren; ++slot) {
            if (slot >= count) {
                placeNothing(tree.nodes[wide], slot);
                continue;
            }
            const Binary& child = binary_[children[slot]];
            for (int k = 0; k < 3; ++k) {
                tree.nodes[wide].lo[k][slot] = child.box.lo[k];
                tree.nodes[wide].hi[k][slot] = child.box.hi[k];
            }
            const uint32_t reference =
                child.leaf ? kWideLeaf | child.first << 4 | (child.count - 1)
                           : fill(tree, children[slot]);
            tree.nodes[wide].child[slot] = reference;
        }
        return wide;
    }

    /// The subtrees that share so many slots of a wide node.
    void collect(uint32_t binary, int slots, uint32_t* children, int& count) const {
        const Binary& node = binary_[binary];
        while (slots > 1 && node.share[std::size_t(slots)] == 0) --slots;
        if (slots == 1)
            children[count++] = binary;
        else
            part(binary, slots, node.share[std::size_t(slots)], children, count);
    }
    void part(uint32_t binary, int slots, int left, uint32_t* children, int& count) const {
        collect(binary_[binary].left, left, children, count);
        collect(binary_[binary].left + 1, slots - left, children, count);
    }

    const std::span<const Aabb> boxes_;
    const WideCosts costs_;
    uint32_t* prims_ = nullptr;
    std::vector<Binary> binary_;
    double wholeArea_ = 1;
};

} // namespace

WideTree buildWideTree(std::span<const Aabb> boxes, unsigned, const WideCosts& costs) {
    return Builder(boxes, costs).build();
}

WideTree buildWideTreeFast(std::span<const Aabb> boxes, unsigned threads, const WideCosts& costs) {
    return buildWideTree(boxes, threads, costs);
}

} // namespace smart
