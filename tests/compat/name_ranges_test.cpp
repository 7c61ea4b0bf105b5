// SPDX-License-Identifier: MIT
#include "compat/recorder/name_ranges.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace smart::compat {
namespace {

constexpr uint32_t kNames = 40;

/// The lowest n consecutive free names, found by looking at each.
uint32_t lowestFree(const std::set<uint32_t>& names, uint32_t n) {
    for (uint32_t first = 1;; ++first) {
        uint32_t k = 0;
        while (k < n && !names.contains(first + k)) ++k;
        if (k == n) return first;
    }
}

TEST(NameRanges, LikeASetOfNames) {
    std::mt19937 random(1);
    for (int round = 0; round < 200; ++round) {
        NameRanges ranges;
        std::set<uint32_t> names;
        for (int step = 0; step < 60; ++step) {
            const uint32_t first = 1 + random() % kNames, n = 1 + random() % 6;
            switch (random() % 3) {
            case 0: {
                const uint32_t expected = lowestFree(names, n);
                ASSERT_EQ(ranges.addFree(n), expected);
                for (uint32_t k = 0; k < n; ++k) names.insert(expected + k);
                break;
            }
            case 1:
                ranges.add(first);
                names.insert(first);
                break;
            default:
                ranges.remove(first, first + n - 1);
                for (uint32_t k = 0; k < n; ++k) names.erase(first + k);
            }
            for (uint32_t name = 0; name <= 2 * kNames; ++name)
                ASSERT_EQ(ranges.contains(name), names.contains(name));
        }
    }
}

TEST(NameRanges, UpToTheLastName) {
    NameRanges ranges;
    EXPECT_EQ(ranges.addFree(0), 0u);
    EXPECT_EQ(ranges.addFree(0x7FFFFFFF), 1u);
    EXPECT_EQ(ranges.addFree(0x7FFFFFFF), 0x80000000u);
    EXPECT_EQ(ranges.addFree(2), 0u);
    EXPECT_EQ(ranges.addFree(1), 0xFFFFFFFFu);
    EXPECT_EQ(ranges.addFree(1), 0u);
    EXPECT_TRUE(ranges.contains(0xFFFFFFFFu));
    ranges.remove(0x80000000u, 0xFFFFFFFFu);
    EXPECT_FALSE(ranges.contains(0xFFFFFFFFu));
    EXPECT_TRUE(ranges.contains(0x7FFFFFFFu));
    ranges.remove(0, 0xFFFFFFFFu);
    EXPECT_EQ(ranges.addFree(5), 1u);
}

} // namespace
} // namespace smart::compat
