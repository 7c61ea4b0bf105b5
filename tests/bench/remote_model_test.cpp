// SPDX-License-Identifier: MIT
#include "tests/bench/remote_model.h"

#include <gtest/gtest.h>

#include <string>

namespace smart::bench {
namespace {

RemoteCosts easy() {
    RemoteCosts costs;
    costs.tileSeconds = 1e-3;
    costs.answerBytes = 4096;
    return costs;
}

TEST(RemoteModel, OneRankIsAlone) {
    const RemotePrediction p = predict(easy(), 2000, 1, 4);
    EXPECT_DOUBLE_EQ(p.frameSeconds, 0.5);
    EXPECT_DOUBLE_EQ(p.framesPerSecond, 2.0);
    EXPECT_DOUBLE_EQ(p.efficiency, 1.0);
}

TEST(RemoteModel, WithoutANetworkAllRanksCount) {
    const RemotePrediction p = predict(easy(), 2000, 8, 4);
    EXPECT_DOUBLE_EQ(p.framesPerSecond, 16.0);
    EXPECT_DOUBLE_EQ(p.efficiency, 1.0);
    EXPECT_EQ(std::string(p.limit), "tracing");
}

TEST(RemoteModel, EachLimitIsFound) {
    RemoteCosts line = easy();
    line.lineBytesPerSecond = 4096 * 1000; // a thousand tiles a second
    EXPECT_DOUBLE_EQ(predict(line, 2000, 8, 4).framesPerSecond, 2.5); // and 4000 of its own
    EXPECT_EQ(std::string(predict(line, 2000, 8, 4).limit), "the line of rank 0");

    RemoteCosts served = easy();
    served.masterSeconds = 1e-4;
    EXPECT_DOUBLE_EQ(predict(served, 2000, 512, 4).framesPerSecond, 7.0);
    EXPECT_EQ(std::string(predict(served, 2000, 512, 4).limit), "the serving thread of rank 0");

    RemoteCosts far = easy();
    far.latencySeconds = 5e-3; // three tiles of a thread in eleven milliseconds
    EXPECT_DOUBLE_EQ(predict(far, 1000, 12, 1).framesPerSecond, 1.0 + 3.0);
    EXPECT_EQ(std::string(predict(far, 1000, 12, 1).limit), "latency");
}

TEST(RemoteModel, AFrameTakesATileAndTwoLatenciesAtLeast) {
    RemoteCosts costs = easy();
    costs.latencySeconds = 1e-3;
    EXPECT_DOUBLE_EQ(predict(costs, 10, 512, 64).frameSeconds, 3e-3);
}

} // namespace
} // namespace smart::bench
