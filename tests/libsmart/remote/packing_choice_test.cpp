// SPDX-License-Identifier: MIT
#include "libsmart/remote/packing_choice.h"

#include <gtest/gtest.h>

namespace smart {
namespace {

using namespace std::chrono_literals;
using Clock = PackingChoice::Clock;

constexpr double kTile = 1e-3, kPack = 1e-5;

/// Tiles that come one by one through a line, in a time that is only told.
class Line {
public:
    explicit Line(unsigned threads) : choice(threads) {
        choice.worked(kTile);
        choice.packed(kPack, 4000, 1000);
    }
    void come(unsigned tiles, uint64_t bytes, Clock::duration apart) {
        for (unsigned i = 0; i < tiles; ++i) choice.arrived(all_ += bytes, now += apart);
    }
    PackingChoice choice;
    Clock::time_point now;

private:
    uint64_t all_ = 0;
};

TEST(PackingChoice, NothingIsKnownWithoutFigures) {
    EXPECT_EQ(PackingChoice(1).gain(), 0);
    Line line(1);
    EXPECT_EQ(line.choice.gain(), 0);
    line.come(16, 4000, 1ms);
    EXPECT_EQ(line.choice.gain(), 0); // too few
}

TEST(PackingChoice, ItPaysWhereTheLineIsTheLimit) {
    Line line(8); // 8000 tiles a second, of which a fourth comes through
    line.come(40, 4000, 500us);
    EXPECT_NEAR(line.choice.bytesPerSecond(), 8e6, 1);
    // The threads are busier with packing, 8000 / 1.01; the line carries as many.
    EXPECT_NEAR(line.choice.gain(), 8000 / 1.01 / 2000, 1e-6);
}

TEST(PackingChoice, ItCostsWhereTracingIsTheLimit) {
    Line line(2); // 2000 tiles a second, and all come through
    line.come(40, 4000, 500us);
    EXPECT_NEAR(line.choice.gain(), 1 / 1.01, 1e-9);
}

TEST(PackingChoice, ItIsNothingWhereTilesDoNotShrink) {
    PackingChoice choice(8);
    choice.worked(kTile);
    choice.packed(kPack, 4000, 4000);
    uint64_t bytes = 0;
    for (Clock::time_point now; bytes < 160000; now += 500us) choice.arrived(bytes += 4000, now);
    EXPECT_NEAR(choice.gain(), 1, 1e-9);
}

TEST(PackingChoice, WhatArrivesTogetherIsNotTakenForALine) {
    Line line(8);
    for (int burst = 0; burst < 30; ++burst) {
        line.come(10, 4000, 1us);
        line.now += 10ms;
    }
    EXPECT_LT(line.choice.bytesPerSecond(), 2 * 4000 * 1000.0);
}

TEST(PackingChoice, PausesAreNotTheLines) {
    Line line(8);
    for (int frame = 0; frame < 4; ++frame) {
        line.come(17, 4000, 500us);
        line.choice.paused();
        line.now += 1s;
    }
    EXPECT_NEAR(line.choice.bytesPerSecond(), 8e6, 1);
}

TEST(PackingChoice, LinesChange) {
    Line line(8);
    line.come(40, 4000, 125us);
    EXPECT_LT(line.choice.gain(), 1);
    line.come(400, 4000, 1ms); // slower
    EXPECT_NEAR(line.choice.bytesPerSecond(), 4e6, 1);
    EXPECT_GT(line.choice.gain(), 3.9);
    line.come(40, 4000, 125us); // and fast again
    EXPECT_LT(line.choice.gain(), 1);
}

} // namespace
} // namespace smart
