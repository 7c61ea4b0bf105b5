// SPDX-License-Identifier: MIT
#include "libsmart/remote/tile_patience.h"

#include <gtest/gtest.h>

namespace smart::test {
namespace {

using namespace std::chrono_literals;

void answer(TilePatience& patience, int times, TilePatience::Duration time) {
    for (int i = 0; i < times; ++i) patience.answered(time);
}

TEST(TilePatience, QuickTilesMayTakeTheLeast) {
    TilePatience patience(1s);
    EXPECT_EQ(patience.limit(), 1s);
    answer(patience, 1000, 20ms);
    EXPECT_EQ(patience.limit(), 1s);
}

TEST(TilePatience, SlowTilesAreNotLate) {
    TilePatience patience(1s);
    answer(patience, 24, 3s);
    EXPECT_GT(patience.limit(), 3s);
    answer(patience, 1000, 3s);
    EXPECT_GT(patience.limit(), 11s);
    EXPECT_LE(patience.limit(), 12s);
    answer(patience, 100, 20ms);
    EXPECT_EQ(patience.limit(), 1s);
}

TEST(TilePatience, AProcessThatWasStoppedChangesLittle) {
    TilePatience patience(1s);
    answer(patience, 100, 20ms);
    answer(patience, 6, 1h); // what one of two threads had
    EXPECT_LT(patience.limit(), 10s);
    answer(patience, 64, 20ms);
    EXPECT_EQ(patience.limit(), 1s);
}

} // namespace
} // namespace smart::test
