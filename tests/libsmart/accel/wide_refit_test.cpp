// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "libsmart/accel/wide_refit.h"
#include "tests/libsmart/accel/wide_tree_check.h"

namespace smart::test {
namespace {

std::vector<Aabb> shaken(std::vector<Aabb> boxes, double by, uint64_t seed) {
    Random random(seed);
    for (Aabb& box : boxes) {
        for (int k = 0; k < 3; ++k) {
            const float shift = float(by * (random.unit() - 0.5));
            box.lo[k] += shift;
            box.hi[k] += shift + float(by * random.unit());
        }
    }
    return boxes;
}

TEST(WideRefit, BoxesEncloseWhatMoved) {
    for (const std::size_t count : {1u, 5u, 16u, 17u, 300u, 20000u}) {
        const std::vector<Aabb> boxes = scatteredBoxes(count, 1, count);
        for (const unsigned threads : {1u, 3u}) {
            WideTree tree = buildWideTreeFast(boxes);
            for (int step = 0; step < 3; ++step) {
                const std::vector<Aabb> moved = shaken(boxes, 0.1 * step, step + 1);
                ASSERT_TRUE(refitWideTree(tree, moved, threads));
                EXPECT_EQ(WideTreeCheck(tree, moved).mistakes(), 0u) << count << ' ' << step;
            }
        }
    }
}

TEST(WideRefit, ControlWithoutRefitTheCheckFindsFaults) {
    const std::vector<Aabb> boxes = scatteredBoxes(300, 1, 3);
    const WideTree tree = buildWideTree(boxes);
    EXPECT_GT(WideTreeCheck(tree, shaken(boxes, 0.1, 4)).mistakes(), 0u);
}

TEST(WideRefit, WhereNothingMovesNothingChanges) {
    const std::vector<Aabb> boxes = scatteredBoxes(5000, 1, 5);
    const WideTree built = buildWideTree(boxes);
    WideTree tree = built;
    ASSERT_TRUE(refitWideTree(tree, boxes, 2));
    EXPECT_EQ(tree.cost, built.cost);
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        for (int slot = 0; slot < kWideChildren; ++slot) {
            for (int k = 0; k < 3; ++k) {
                ASSERT_EQ(tree.nodes[i].lo[k][slot], built.nodes[i].lo[k][slot]);
                ASSERT_EQ(tree.nodes[i].hi[k][slot], built.nodes[i].hi[k][slot]);
            }
        }
    }
}

TEST(WideRefit, TheCostTellsHowGoodTheTreeStillIs) {
    const std::vector<Aabb> boxes = scatteredBoxes(5000, 1, 6);
    WideTree tree = buildWideTree(boxes);
    const float built = tree.cost;
    std::vector<Aabb> shifted = boxes, scaled = boxes;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        for (int k = 0; k < 3; ++k) {
            shifted[i].lo[k] += 5;
            shifted[i].hi[k] += 5;
            scaled[i].lo[k] *= 16;
            scaled[i].hi[k] *= 16;
        }
    }
    ASSERT_TRUE(refitWideTree(tree, shifted));
    EXPECT_NEAR(tree.cost, built, 0.01 * built);
    ASSERT_TRUE(refitWideTree(tree, scaled));
    EXPECT_NEAR(tree.cost, built, 0.001 * built);
    // Boxes change places: the tree fits no more, a new one does.
    std::vector<Aabb> mixed = boxes;
    Random random(7);
    for (std::size_t i = 1; i < mixed.size(); ++i)
        std::swap(mixed[i], mixed[random.below(uint32_t(i))]);
    ASSERT_TRUE(refitWideTree(tree, mixed));
    EXPECT_GT(tree.cost, 5 * built);
    EXPECT_NEAR(buildWideTree(mixed).cost, built, 0.1 * built);
}

TEST(WideRefit, OtherEmptyBoxesNeedANewTree) {
    std::vector<Aabb> boxes = scatteredBoxes(100, 1, 8);
    boxes[3] = Aabb();
    const WideTree built = buildWideTree(boxes);
    WideTree tree = built;
    std::vector<Aabb> moved = shaken(boxes, 0.1, 9);
    moved[3] = Aabb();
    ASSERT_TRUE(refitWideTree(tree, moved));
    tree = built;
    std::vector<Aabb> fewer = moved;
    fewer[50] = Aabb();
    EXPECT_FALSE(refitWideTree(tree, fewer)); // one has gone
    std::vector<Aabb> others = fewer;
    others[3] = boxAt(0.5, 0.5, 0.5, 0.1);
    EXPECT_FALSE(refitWideTree(tree, others)); // and another has come
    moved[3] = others[3];
    EXPECT_FALSE(refitWideTree(tree, moved)); // one more
    EXPECT_FALSE(refitWideTree(tree, {}));
    EXPECT_EQ(tree.cost, built.cost);
    EXPECT_EQ(WideTreeCheck(tree, boxes).mistakes(), 0u);
    WideTree nothing;
    EXPECT_TRUE(refitWideTree(nothing, {}));
}

} // namespace
} // namespace smart::test
