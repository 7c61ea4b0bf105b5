// SPDX-License-Identifier: MIT
#include "compat/recorder/build_choice.h"

#include <gtest/gtest.h>

namespace smart::compat {
namespace {

TEST(BuildChoiceTest, WhatTheApplicationAsksForIsDone) {
    for (const uint64_t rays : {uint64_t(0), uint64_t(1) << 40}) {
        EXPECT_EQ(chooseQuality(BuildQuality::Nicest, rays, 1000), BuildQuality::Nicest);
        EXPECT_EQ(chooseQuality(BuildQuality::Fastest, rays, 1000), BuildQuality::Fastest);
    }
}

TEST(BuildChoiceTest, ObjectsThatChangeOftenAreBuiltFast) {
    const auto choose = [](std::optional<uint64_t> rays, std::size_t triangles) {
        return chooseQuality(BuildQuality::DontCare, rays, triangles);
    };
    EXPECT_EQ(choose(std::nullopt, 1000000), BuildQuality::DontCare) << "the first time";
    EXPECT_EQ(choose(0, 1000), BuildQuality::Fastest);
    EXPECT_EQ(choose(512 * 512, 1000000), BuildQuality::Fastest) << "anew for every frame";
    EXPECT_EQ(choose(512 * 512, 1000), BuildQuality::DontCare) << "small beside the picture";
    EXPECT_EQ(choose(uint64_t(1) << 40, 1000000), BuildQuality::DontCare) << "after a long time";
}

} // namespace
} // namespace smart::compat
