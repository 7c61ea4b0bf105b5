// SPDX-License-Identifier: MIT
#include "libsmart/accel/kd_events.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

namespace smart {
namespace {

TEST(KdEvents, OrderIsThatOfPositionThenKindThenPrimitive) {
    const float inOrder[] = {-std::numeric_limits<float>::max(), -2.0f, -1e-45f, 0.0f, 1e-45f,
                             0.5f, 1.0f, std::numeric_limits<float>::max()};
    KdEvent previous = 0;
    for (const float position : inOrder) {
        for (const KdEventKind kind :
             {KdEventKind::End, KdEventKind::Planar, KdEventKind::Start}) {
            for (const uint32_t prim : {0u, 7u, kKdMaxPrims - 1}) {
                const KdEvent event = makeKdEvent(position, kind, prim);
                EXPECT_GT(event, previous);
                EXPECT_EQ(kdEventPosition(event), position);
                EXPECT_EQ(kdEventKind(event), kind);
                EXPECT_EQ(kdEventPrim(event), prim);
                previous = event;
            }
        }
    }
}

TEST(KdEvents, NegativeZeroIsZero) {
    EXPECT_EQ(makeKdEvent(-0.0f, KdEventKind::End, 1), makeKdEvent(0.0f, KdEventKind::End, 1));
}

TEST(KdEvents, SortAndMergeAgreeWithTheStandardLibrary) {
    std::mt19937 generator(1);
    const auto randomEvents = [&generator](std::size_t count) {
        std::vector<KdEvent> events;
        for (uint32_t i = 0; i < count; ++i) {
            const float position = float(int(generator() % 4001) - 2000) / 16; // many equal ones
            events.push_back(makeKdEvent(position, KdEventKind(generator() % 3), i));
        }
        return events;
    };
    std::vector<KdEvent> scratch;
    for (const std::size_t count : {0, 1, 2, 17, 300, 2048, 50000}) {
        std::vector<KdEvent> events = randomEvents(count), expected = events;
        sortKdEvents(events.data(), count, scratch);
        std::sort(expected.begin(), expected.end());
        EXPECT_EQ(events, expected) << count;

        for (const std::size_t addedCount : {0, 1, 5, 400}) {
            std::vector<KdEvent> added = randomEvents(addedCount), merged = events;
            std::sort(added.begin(), added.end());
            merged.resize(count + addedCount);
            mergeKdEvents(merged.data(), count, added.data(), addedCount);
            std::vector<KdEvent> both = events;
            both.insert(both.end(), added.begin(), added.end());
            std::sort(both.begin(), both.end());
            EXPECT_EQ(merged, both) << count << " and " << addedCount;
        }
    }
}

TEST(KdEvents, ArenaListsAreDisjointAndReused) {
    KdEventArena arena;
    const KdEventLists first = arena.allocate(10);
    const KdEventArena::Mark mark = arena.mark();
    const KdEventLists second = arena.allocate(1000);
    const KdEventLists third = arena.allocate(3);
    std::vector<std::pair<const KdEvent*, const KdEvent*>> ranges;
    for (int k = 0; k < 3; ++k) {
        ranges.emplace_back(first.events[k], first.events[k] + 21);
        ranges.emplace_back(second.events[k], second.events[k] + 2001);
        ranges.emplace_back(third.events[k], third.events[k] + 7);
    }
    std::sort(ranges.begin(), ranges.end());
    for (std::size_t i = 1; i < ranges.size(); ++i) {
        EXPECT_LE(ranges[i - 1].second, ranges[i].first);
    }
    arena.release(mark);
    EXPECT_EQ(arena.allocate(1000).events[0], second.events[0]);
    arena.release(mark);
    EXPECT_NE(arena.allocate(100000).events[0], nullptr);
}

} // namespace
} // namespace smart
