// SPDX-License-Identifier: MIT
// Pairs of boxes that overlap against all pairs, and how many are looked at to find them.
#include "compat/rtu/box_pairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <tuple>
#include <utility>

namespace {

using smart::compat::BoxPairs;
using smart::compat::GridBox;
using Pairs = std::set<std::pair<uint32_t, uint32_t>>;

bool overlap(const GridBox& a, const GridBox& b) {
    for (int axis = 0; axis < 2; ++axis)
        if (a.high[axis] < b.low[axis] || b.high[axis] < a.low[axis]) return false;
    return true;
}

std::vector<GridBox> sorted(std::vector<GridBox> boxes) {
    std::sort(boxes.begin(), boxes.end(),
              [](const GridBox& a, const GridBox& b) { return a.low[0] < b.low[0]; });
    return boxes;
}

/// Boxes of sizes up to these, within 2^28 about the origin.
std::vector<GridBox> randomBoxes(unsigned count, int width, int height) {
    std::mt19937 random(count + unsigned(width));
    const int size[2] = {width, height};
    std::vector<GridBox> boxes(count);
    for (GridBox& box : boxes)
        for (int axis = 0; axis < 2; ++axis) {
            const int most = 1 << 28;
            box.low[axis] = std::uniform_int_distribution(-most, most)(random);
            const int extent = std::uniform_int_distribution(0, size[axis])(random);
            box.high[axis] = std::min(box.low[axis] + extent, most);
        }
    return sorted(boxes);
}

/// Teeth of a comb: each spans the first axis and has a place of its own on the other.
std::vector<GridBox> comb(int teeth, int along, int offset) {
    std::vector<GridBox> boxes;
    for (int i = 0; i < teeth; ++i) {
        GridBox box;
        box.low[along] = offset;
        box.high[along] = offset + 4 * teeth;
        box.low[1 - along] = offset + 4 * i;
        box.high[1 - along] = offset + 4 * i + 1;
        boxes.push_back(box);
    }
    return boxes;
}

std::size_t visits(const std::vector<GridBox>& boxes) {
    std::size_t count = 0;
    BoxPairs(boxes, [&](uint32_t, uint32_t) { ++count; });
    return count;
}

TEST(BoxPairs, areThoseThatOverlap) {
    constexpr int kSmall = 1 << 22, kLarge = 1 << 28;
    for (const auto& [count, width, height] :
         {std::tuple(2u, kLarge, kLarge), {33u, kSmall, kSmall}, {400u, kSmall, kSmall},
          {400u, kLarge, kSmall}, {400u, kSmall, kLarge}, {400u, kLarge, kLarge}, {300u, 0, 0}}) {
        const std::vector<GridBox> boxes = randomBoxes(count, width, height);
        Pairs expected, found;
        for (uint32_t i = 0; i < count; ++i)
            for (uint32_t k = 0; k < i; ++k)
                if (overlap(boxes[i], boxes[k])) expected.emplace(i, k);
        BoxPairs(boxes, [&](uint32_t i, uint32_t k) {
            ASSERT_GT(i, k);
            if (overlap(boxes[i], boxes[k])) found.emplace(i, k);
        });
        EXPECT_EQ(found, expected) << count << " of up to " << width << " by " << height;
    }
}

TEST(BoxPairs, manyAtOnePlace) {
    const std::vector<GridBox> boxes(100, GridBox{{5, 5}, {5, 5}});
    EXPECT_EQ(visits(boxes), 100u * 99 / 2);
}

TEST(BoxPairs, combsAreNotLookedAtPairByPair) {
    constexpr int kTeeth = 4000;
    const std::size_t most = 100 * kTeeth; // all pairs: 2000 a tooth
    for (const int along : {0, 1}) EXPECT_LT(visits(sorted(comb(kTeeth, along, 0))), most);
    std::vector<GridBox> both = comb(kTeeth, 0, 0);
    const std::vector<GridBox> other = comb(kTeeth / 2, 1, 4 * kTeeth + 9);
    both.insert(both.end(), other.begin(), other.end());
    EXPECT_LT(visits(sorted(both)), most) << "one of each kind, beside each other";
    // Its teeth without a width: they lie on one line.
    std::vector<GridBox> line = comb(kTeeth, 0, 0);
    for (GridBox& box : line) box.high[0] = box.low[0];
    EXPECT_LT(visits(line), most);
}

} // namespace
