// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "libsmart/accel/morton_order.h"
#include "tests/libsmart/accel/wide_tree_check.h"

namespace smart::test {
namespace {

MortonOrder orderOf(const std::vector<Aabb>& boxes, unsigned threads = 1) {
    BuildCrew crew(threads);
    return mortonOrder(boxes, crew);
}

TEST(MortonOrder, EachBoxOnceByCode) {
    for (const std::size_t count : {1u, 2u, 100u, 1500u, 40000u}) {
        std::vector<Aabb> boxes = scatteredBoxes(count, 1, count);
        if (count > 10) boxes[7] = Aabb();
        const MortonOrder order = orderOf(boxes);
        std::vector<uint32_t> numbers;
        for (const MortonKey key : order.keys) numbers.push_back(mortonNumber(key));
        std::sort(numbers.begin(), numbers.end());
        std::vector<uint32_t> expected(count);
        std::iota(expected.begin(), expected.end(), 0u);
        if (count > 10) expected.erase(expected.begin() + 7);
        EXPECT_EQ(numbers, expected);
        EXPECT_TRUE(std::is_sorted(order.keys.begin(), order.keys.end(),
                                   [](MortonKey a, MortonKey b) {
                                       return mortonCode(a) < mortonCode(b);
                                   }));
        Aabb bounds;
        for (const Aabb& box : boxes) bounds.add(box);
        for (int k = 0; k < 3; ++k) {
            EXPECT_EQ(order.bounds.lo[k], bounds.lo[k]);
            EXPECT_EQ(order.bounds.hi[k], bounds.hi[k]);
        }
        EXPECT_EQ(orderOf(boxes, 3).keys, order.keys);
    }
}

TEST(MortonOrder, TheCornersOfACubeInTheOrderOfTheCurve) {
    std::vector<Aabb> boxes;
    for (const int corner : {5, 2, 7, 0, 1, 6, 3, 4}) // bit 2: x, bit 1: y, bit 0: z
        boxes.push_back(boxAt(corner >> 2 & 1, corner >> 1 & 1, corner & 1, 0));
    const MortonOrder order = orderOf(boxes);
    const std::vector<uint32_t> expected = {3, 4, 1, 6, 7, 0, 5, 2};
    for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(mortonNumber(order.keys[i]), expected[i]);
    EXPECT_EQ(mortonSplit(order.keys), 4u); // by x first
}

TEST(MortonOrder, ManyOfOneCodeFollowAFinerCurve) {
    // A cluster far smaller than a cell, in no order, and one box that makes the cell so large.
    std::vector<Aabb> boxes;
    for (uint32_t i = 0; i < 512; ++i)
        boxes.push_back(boxAt((i * 103 % 512) * 0x1p-23, 0, 0, 0));
    boxes.push_back(boxAt(100, 100, 100, 0));
    const MortonOrder order = orderOf(boxes);
    std::size_t steps = 0;
    for (std::size_t i = 1; i < 512; ++i) {
        const Aabb& a = boxes[mortonNumber(order.keys[i - 1])];
        const Aabb& b = boxes[mortonNumber(order.keys[i])];
        steps += a.lo[0] < b.lo[0];
    }
    EXPECT_EQ(steps, 511u); // along x, the curve is the line
    EXPECT_EQ(mortonNumber(order.keys.back()), 512u);
}

TEST(MortonOrder, RangesAreDividedAtTheHighestBit) {
    const auto key = [](uint32_t code) { return MortonKey(code) << 32; };
    const std::vector<MortonKey> keys = {key(8), key(9), key(11), key(12), key(15)};
    EXPECT_EQ(mortonSplit(keys), 3u);
    EXPECT_EQ(mortonSplit(std::span(keys).first(3)), 2u);
    const std::vector<MortonKey> same(7, key(5));
    EXPECT_EQ(mortonSplit(same), 3u);
}

} // namespace
} // namespace smart::test
