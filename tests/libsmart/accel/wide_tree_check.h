// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "libsmart/accel/wide_tree.h"
#include "tests/support/ray_sets.h"

namespace smart::test {

/// Walks a whole tree and counts what is wrong with it.
class WideTreeCheck {
public:
    /// Each box that is not empty is in one leaf, inside all boxes above.
    WideTreeCheck(const WideTree& tree, std::span<const Aabb> boxes)
        : tree_(tree), boxes_(boxes), leavesOf_(boxes.size()) {
        walk();
        uint32_t primitives = 0;
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            const std::vector<Aabb>& leaves = leavesOf_[i];
            mistakes_ += leaves.size() != (boxes[i].empty() ? 0u : 1u);
            for (const Aabb& leaf : leaves) mistakes_ += !holds(leaf, boxes[i]);
            primitives += !boxes[i].empty();
        }
        mistakes_ += primitives != tree.primitives;
    }
    /// Triangles may be cut: points anywhere on one are inside one of its leaves.
    WideTreeCheck(const WideTree& tree, std::span<const Aabb> boxes,
                  std::span<const Triangle> triangles, int pointsOfEach)
        : tree_(tree), boxes_(boxes), leavesOf_(boxes.size()) {
        walk();
        Random random(99);
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            if (boxes[i].empty()) {
                mistakes_ += !leavesOf_[i].empty();
                continue;
            }
            const Triangle& t = triangles[i];
            for (int n = 0; n < pointsOfEach; ++n) {
                double u = random.unit(), v = random.unit();
                if (u + v > 1) {
                    u = 1 - u;
                    v = 1 - v;
                }
                if (n < 3) { // the corners
                    u = n == 1;
                    v = n == 2;
                }
                double point[3];
                for (int k = 0; k < 3; ++k)
                    point[k] = t.v0[k] + u * (double(t.v1[k]) - t.v0[k]) +
                               v * (double(t.v2[k]) - t.v0[k]);
                const auto inside = [&](const Aabb& box) {
                    for (int k = 0; k < 3; ++k)
                        if (!(box.lo[k] <= point[k] && point[k] <= box.hi[k])) return false;
                    return true;
                };
                mistakes_ += std::none_of(leavesOf_[i].begin(), leavesOf_[i].end(), inside);
            }
        }
    }
    std::size_t mistakes() const { return mistakes_; }
    int depth() const { return depth_; }

private:
    static bool holds(const Aabb& outer, const Aabb& inner) {
        for (int k = 0; k < 3; ++k)
            if (!(outer.lo[k] <= inner.lo[k] && inner.hi[k] <= outer.hi[k])) return false;
        return true;
    }
    void walk() {
        if (!tree_.nodes.empty()) visit(0, tree_.bounds, 1);
        mistakes_ += visited_ != tree_.nodes.size();
    }
    void visit(uint32_t number, const Aabb& outer, int depth) {
        // Nodes stand before those below them, and subtrees are neighbours.
        if (number != visited_ || number >= tree_.nodes.size() || depth > kWideMaxDepth) {
            ++mistakes_;
            return;
        }
        ++visited_;
        depth_ = std::max(depth_, depth);
        const WideNode& node = tree_.nodes[number];
        for (int slot = 0; slot < kWideChildren; ++slot) {
            Aabb box;
            for (int k = 0; k < 3; ++k) {
                box.lo[k] = node.lo[k][slot];
                box.hi[k] = node.hi[k][slot];
            }
            if (box.empty()) continue;
            mistakes_ += !holds(outer, box);
            const uint32_t child = node.child[slot];
            if (!(child & kWideLeaf)) {
                visit(child, box, depth + 1);
                continue;
            }
            const uint32_t first = (child & ~kWideLeaf) >> 4, count = (child & 15u) + 1;
            for (uint32_t i = first; i < first + count; ++i) {
                if (i >= tree_.prims.size() || tree_.prims[i] >= boxes_.size())
                    ++mistakes_;
                else
                    leavesOf_[tree_.prims[i]].push_back(box);
            }
        }
    }

    const WideTree& tree_;
    const std::span<const Aabb> boxes_;
    std::vector<std::vector<Aabb>> leavesOf_;
    std::size_t mistakes_ = 0;
    uint32_t visited_ = 0;
    int depth_ = 0;
};

inline Aabb boxAt(double x, double y, double z, double half) {
    Aabb box;
    const float lo[3] = {float(x - half), float(y - half), float(z - half)};
    const float hi[3] = {float(x + half), float(y + half), float(z + half)};
    box.add(lo);
    box.add(hi);
    return box;
}

inline std::vector<Aabb> scatteredBoxes(std::size_t count, double scale, uint64_t seed) {
    Random random(seed);
    std::vector<Aabb> boxes;
    for (std::size_t i = 0; i < count; ++i)
        boxes.push_back(boxAt(scale * random.unit(), scale * random.unit(), scale * random.unit(),
                              scale * 0.01 * random.unit()));
    return boxes;
}

/// Long, thin and small triangles among each other.
inline std::vector<Triangle> mixedTriangles(std::size_t count, uint64_t seed) {
    Random random(seed);
    std::vector<Triangle> triangles(count);
    for (Triangle& triangle : triangles) {
        float* const corners[] = {triangle.v0, triangle.v1, triangle.v2};
        const double size = random.below(8) == 0 ? 1.0 : 0.05;
        for (int k = 0; k < 3; ++k) {
            const double at = random.unit();
            corners[0][k] = float(at);
            corners[1][k] = float(at + size * (random.unit() - 0.5));
            corners[2][k] = float(at + 0.05 * (random.unit() - 0.5));
        }
    }
    return triangles;
}

inline std::vector<Aabb> boxesOf(std::span<const Triangle> triangles) {
    std::vector<Aabb> boxes(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        boxes[i].add(triangles[i].v0);
        boxes[i].add(triangles[i].v1);
        boxes[i].add(triangles[i].v2);
    }
    return boxes;
}

} // namespace smart::test
