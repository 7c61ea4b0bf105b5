// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <atomic>
#include <csignal>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

#include "libsmart/accel/build_crew.h"

namespace smart {
namespace {

TEST(BuildCrew, EveryPartIsDoneOnce) {
    for (const unsigned threads : {0u, 1u, 2u, 5u}) {
        BuildCrew crew(threads);
        for (const std::size_t count : {0u, 1u, 2u, 3u, 1000u}) {
            std::vector<std::atomic<int>> done(count);
            crew.forEach(count, [&](std::size_t i) { ++done[i]; });
            for (const auto& times : done) EXPECT_EQ(times, 1) << threads << ' ' << count;
        }
    }
}

TEST(BuildCrew, HelpersThatStartLaterWorkToo) {
    BuildCrew crew(8);
    for (std::size_t count = 1; count < 20; ++count) {
        std::atomic<std::size_t> sum{0};
        crew.forEach(count, [&](std::size_t i) { sum += i + 1; });
        EXPECT_EQ(sum, count * (count + 1) / 2);
    }
}

TEST(BuildCrew, WorksAtTheSameTime) {
    BuildCrew crew(2);
    std::atomic<int> arrived{0};
    crew.forEach(2, [&](std::size_t) { // each part waits for the other
        ++arrived;
        while (arrived < 2) std::this_thread::yield();
    });
    EXPECT_EQ(arrived, 2);
}

TEST(BuildCrew, SignalsAreLeftToTheApplicationsThreads) {
    BuildCrew crew(2);
    std::atomic<int> arrived{0}, blocked{0};
    crew.forEach(2, [&](std::size_t) { // one part on each thread
        ++arrived;
        while (arrived < 2) std::this_thread::yield();
        sigset_t mask;
        pthread_sigmask(SIG_BLOCK, nullptr, &mask);
        blocked += sigismember(&mask, SIGUSR1);
        EXPECT_FALSE(sigismember(&mask, SIGSEGV));
    });
    EXPECT_EQ(blocked, 1);
}

TEST(BuildCrew, WhatAPartThrowsReachesTheCallerAndTheCrewGoesOn) {
    for (const unsigned threads : {1u, 4u}) {
        BuildCrew crew(threads);
        for (int round = 0; round < 20; ++round) {
            EXPECT_THROW(crew.forEach(100,
                                      [](std::size_t i) {
                                          if (i % 10 == 3) throw std::runtime_error("part");
                                      }),
                         std::runtime_error);
            std::atomic<int> done{0};
            crew.forEach(100, [&](std::size_t) { ++done; });
            EXPECT_EQ(done, 100);
        }
    }
}

} // namespace
} // namespace smart
