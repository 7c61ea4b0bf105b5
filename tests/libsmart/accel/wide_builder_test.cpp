// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "libsmart/accel/wide_tree.h"
#include "tests/support/ray_sets.h"

namespace smart {
namespace {

/// Walks a whole tree and counts what is wrong with it.
class TreeCheck {
public:
    TreeCheck(const WideTree& tree, const std::vector<Aabb>& boxes)
        : tree_(tree), boxes_(boxes), seen_(boxes.size()) {
        if (!tree.nodes.empty()) visit(0, tree.bounds, 1);
        for (std::size_t i = 0; i < boxes.size(); ++i)
            mistakes_ += seen_[i] != (boxes[i].empty() ? 0 : 1);
    }
    std::size_t mistakes() const { return mistakes_; }
    int depth() const { return depth_; }

private:
    static bool holds(const Aabb& outer, const Aabb& inner) {
        for (int k = 0; k < 3; ++k)
            if (!(outer.lo[k] <= inner.lo[k] && inner.hi[k] <= outer.hi[k])) return false;
        return true;
    }
    void visit(uint32_t number, const Aabb& outer, int depth) {
        if (number >= tree_.nodes.size() || depth > kWideMaxDepth) {
            ++mistakes_;
            return;
        }
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
                if (i >= tree_.prims.size() || tree_.prims[i] >= boxes_.size()) {
                    ++mistakes_;
                    continue;
                }
                ++seen_[tree_.prims[i]];
                mistakes_ += !holds(box, boxes_[tree_.prims[i]]);
            }
        }
    }

    const WideTree& tree_;
    const std::vector<Aabb>& boxes_;
    std::vector<int> seen_;
    std::size_t mistakes_ = 0;
    int depth_ = 0;
};

Aabb boxAt(double x, double y, double z, double half) {
    Aabb box;
    const float lo[3] = {float(x - half), float(y - half), float(z - half)};
    const float hi[3] = {float(x + half), float(y + half), float(z + half)};
    box.add(lo);
    box.add(hi);
    return box;
}

std::vector<Aabb> scattered(std::size_t count, double scale, uint64_t seed) {
    test::Random random(seed);
    std::vector<Aabb> boxes;
    for (std::size_t i = 0; i < count; ++i)
        boxes.push_back(boxAt(scale * random.unit(), scale * random.unit(), scale * random.unit(),
                              scale * 0.01 * random.unit()));
    return boxes;
}

void expectSound(const std::vector<Aabb>& boxes, const std::string& name) {
    const WideTree tree = buildWideTree(boxes);
    const TreeCheck check(tree, boxes);
    EXPECT_EQ(check.mistakes(), 0u) << name;
    EXPECT_LE(check.depth(), kWideMaxDepth) << name;
}

TEST(WideBuilder, EveryPrimitiveIsInOneLeafInsideAllItsBoxes) {
    for (const std::size_t count : {1u, 2u, 4u, 5u, 15u, 16u, 17u, 64u, 257u, 5000u})
        expectSound(scattered(count, 1, count), std::to_string(count));
}

TEST(WideBuilder, NothingMakesAnEmptyTree) {
    EXPECT_TRUE(buildWideTree({}).nodes.empty());
    EXPECT_TRUE(buildWideTree(std::vector<Aabb>(2)).nodes.empty());
}

TEST(WideBuilder, EmptyBoxesAreLeftOut) {
    std::vector<Aabb> boxes = scattered(500, 1, 3);
    for (std::size_t i = 0; i < boxes.size(); i += 3) boxes[i] = Aabb();
    expectSound(boxes, "every third empty");
}

TEST(WideBuilder, HardShapes) {
    expectSound(std::vector<Aabb>(1000, boxAt(1, 2, 3, 0.5)), "all the same");
    expectSound(std::vector<Aabb>(100, boxAt(1, 2, 3, 0)), "all one point");
    std::vector<Aabb> boxes;
    for (int i = 0; i < 2000; ++i) boxes.push_back(boxAt(i, 0, 0, 0));
    expectSound(boxes, "points on a line");
    boxes.clear();
    for (int i = 0; i < 120; ++i) boxes.push_back(boxAt(std::ldexp(1.0, i), 0, 0, 1e-6));
    expectSound(boxes, "each twice as far as the one before");
    boxes.clear();
    for (int i = 0; i < 120; ++i) boxes.push_back(boxAt(0, 0, 0, std::ldexp(1.0, i)));
    expectSound(boxes, "each around the one before");
    for (const double scale : {1e-40, 1e-30, 1e-12, 1e12, 1e30, 1e38})
        expectSound(scattered(300, scale, 5), "scale " + std::to_string(std::log10(scale)));
}

TEST(WideBuilder, WideNodesAreWellFilled) {
    const std::size_t count = 20000;
    const WideTree tree = buildWideTree(scattered(count, 1, 6));
    EXPECT_LE(tree.nodes.size() * 30, count); // 30 primitives a node, at least
    EXPECT_EQ(tree.bytes(), tree.nodes.capacity() * 448 + tree.prims.capacity() * 4);
}

TEST(WideBuilder, TheSameEveryTime) {
    const std::vector<Aabb> boxes = scattered(3000, 1, 7);
    const WideTree a = buildWideTree(boxes), b = buildWideTree(boxes);
    EXPECT_EQ(a.prims, b.prims);
    EXPECT_EQ(a.nodes.size(), b.nodes.size());
}

TEST(WideBuilder, ControlsTheCheckFindsFaults) {
    const std::vector<Aabb> boxes = scattered(500, 1, 8);
    const WideTree sound = buildWideTree(boxes);
    {
        WideTree tree = sound;
        tree.prims[7] = tree.prims[8];
        EXPECT_GT(TreeCheck(tree, boxes).mistakes(), 0u);
    }
    {
        WideTree tree = sound;
        tree.nodes[0].hi[1][0] = std::nextafter(tree.nodes[0].hi[1][0], -1.0f);
        EXPECT_GT(TreeCheck(tree, boxes).mistakes(), 0u);
    }
    {
        WideTree tree = sound;
        tree.nodes[0].lo[0][0] = Aabb::kInf;
        EXPECT_GT(TreeCheck(tree, boxes).mistakes(), 0u);
    }
}

} // namespace
} // namespace smart
