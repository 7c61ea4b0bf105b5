// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <limits>

#include "libsmart/accel/wide_tree.h"

namespace smart {
namespace {

constexpr int kBins = 32;
constexpr int kSplitDepth = kWideMaxDepth - 33; ///< below, halves: a tree of 2^32 in 32 levels
constexpr float kLeafCost = 2.0f, kPrimitiveCost = 0.25f; // a step costs 1

float halfArea(const Aabb& box) {
    const float x = box.hi[0] - box.lo[0], y = box.hi[1] - box.lo[1], z = box.hi[2] - box.lo[2];
    return x * y + y * z + z * x;
}

struct Binary {
    Aabb box;
    uint32_t first = 0, count = 0; ///< of a leaf
    uint32_t left = 0;             ///< of an inner node; the right child follows it
};

struct Split {
    float cost = std::numeric_limits<float>::infinity();
    int axis = 0;
    int bin = 0; ///< first bin of the right side
};

class Builder {
public:
    explicit Builder(const std::vector<Aabb>& boxes) : boxes_(boxes) {}

    WideTree build() {
        WideTree tree;
        for (uint32_t i = 0; i < boxes_.size(); ++i)
            if (!boxes_[i].empty()) tree.prims.push_back(i);
        if (tree.prims.empty()) return tree;
        prims_ = tree.prims.data();
        binary_.emplace_back();
        divide(0, 0, uint32_t(tree.prims.size()), 0);
        tree.bounds = binary_[0].box;
        tree.nodes.emplace_back();
        if (binary_[0].count)
            place(tree.nodes[0], 0, 0);
        for (int i = int(binary_[0].count ? 1 : 0); i < kWideChildren; ++i)
            placeNothing(tree.nodes[0], i);
        if (!binary_[0].count) collapse(tree, 0, 0);
        return tree;
    }

private:
    void divide(uint32_t node, uint32_t first, uint32_t count, int depth) {
        Aabb box, centres;
        for (uint32_t i = first; i < first + count; ++i) {
            const Aabb& b = boxes_[prims_[i]];
            box.add(b);
            const float c[3] = {centre(b, 0), centre(b, 1), centre(b, 2)};
            centres.add(c);
        }
        binary_[node].box = box;
        const float leafCost = kLeafCost + kPrimitiveCost * float(count);
        Split best;
        if (count > 1 && depth < kSplitDepth) best = findSplit(first, count, centres);
        const float splitCost = 1.0f + best.cost / std::max(halfArea(box), 1e-37f);
        if (count <= kWideLeafSize && !(splitCost < leafCost)) {
            binary_[node].first = first;
            binary_[node].count = count;
            return;
        }
        uint32_t middle = first + count / 2;
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
        divide(left, first, middle - first, depth + 1);
        divide(left + 1, middle, first + count - middle, depth + 1);
    }

    static float centre(const Aabb& box, int axis) {
        return 0.5f * box.lo[axis] + 0.5f * box.hi[axis];
    }
    static float binScale(const Aabb& centres, int axis) {
        const float extent = centres.hi[axis] - centres.lo[axis];
        return extent > 0 ? float(kBins) * 0.9999f / extent : 0.0f;
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
            if (!(scale[axis] > 0) || !(scale[axis] < std::numeric_limits<float>::infinity()))
                continue;
            const auto& row = bins[std::size_t(axis)];
            float rightCost[kBins];
            Aabb box;
            uint32_t n = 0;
            for (int i = kBins - 1; i > 0; --i) {
                box.add(row[std::size_t(i)].box);
                n += row[std::size_t(i)].count;
                rightCost[i] = n ? halfArea(box) * cost(n) : -1.0f;
            }
            box = Aabb();
            n = 0;
            for (int i = 1; i < kBins; ++i) {
                box.add(row[std::size_t(i - 1)].box);
                n += row[std::size_t(i - 1)].count;
                if (n == 0 || rightCost[i] < 0) continue;
                const float total = halfArea(box) * cost(n) + rightCost[i];
                if (total < best.cost) best = {total, axis, i};
            }
        }
        return best;
    }
    static float cost(uint32_t n) { return kLeafCost + kPrimitiveCost * float(n); }

    static void placeNothing(WideNode& node, int place) {
        for (int k = 0; k < 3; ++k) {
            node.lo[k][place] = std::numeric_limits<float>::infinity();
            node.hi[k][place] = -std::numeric_limits<float>::infinity();
        }
        node.child[place] = 0;
    }
    void place(WideNode& node, int at, uint32_t binary) const {
        const Binary& b = binary_[binary];
        for (int k = 0; k < 3; ++k) {
            node.lo[k][at] = b.box.lo[k];
            node.hi[k][at] = b.box.hi[k];
        }
        node.child[at] = b.count ? kWideLeaf | b.first << 4 | (b.count - 1) : 0u;
    }
    void collapse(WideTree& tree, uint32_t wide, uint32_t binary) {
        uint32_t open[kWideChildren] = {binary_[binary].left, binary_[binary].left + 1};
        int count = 2;
        while (count < kWideChildren) {
            int largest = -1;
            float area = -1.0f;
            for (int i = 0; i < count; ++i) {
                if (binary_[open[i]].count) continue;
                const float a = halfArea(binary_[open[i]].box);
                if (a > area) {
                    area = a;
                    largest = i;
                }
            }
            if (largest < 0) break;
            const uint32_t left = binary_[open[largest]].left;
            open[largest] = left;
            open[count++] = left + 1;
        }
        for (int i = 0; i < kWideChildren; ++i) {
            if (i >= count) {
                placeNothing(tree.nodes[wide], i);
                continue;
            }
            place(tree.nodes[wide], i, open[i]);
            if (binary_[open[i]].count) continue;
            const uint32_t child = uint32_t(tree.nodes.size());
            tree.nodes.emplace_back();
            tree.nodes[wide].child[i] = child;
            collapse(tree, child, open[i]);
        }
    }

    const std::vector<Aabb>& boxes_;
    uint32_t* prims_ = nullptr;
    std::vector<Binary> binary_;
};

} // namespace

WideTree buildWideTree(const std::vector<Aabb>& boxes) { return Builder(boxes).build(); }

} // namespace smart
