// SPDX-License-Identifier: MIT
#include "compat/recorder/build_choice.h"

#include <gtest/gtest.h>

#include <random>

#include "compat/recorder/recorder.h"

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

/// An object that is defined again and again.
class RedefinedObject : public testing::Test {
protected:
    void define() {
        std::mt19937 random(3);
        const auto coordinate = [&random] { return double(random() % 1000); };
        recorder_.begin(Primitive::Triangles);
        for (int i = 0; i < 3 * kTriangles; ++i)
            recorder_.vertex({coordinate(), coordinate(), coordinate(), 1});
        recorder_.end();
        recorder_.endObject();
    }
    /// Of the tree that the object has after another definition; each builder makes its own.
    uint64_t leaves() {
        recorder_.replaceObject(object_);
        define();
        recorder_.instantiate(object_);
        const uint64_t leaves = statistics(*recorder_.compileScene()).leaves;
        recorder_.clearScene();
        return leaves;
    }
    void SetUp() override {
        object_ = recorder_.newObject(ObjectMode::Define);
        define();
        recorder_.buildHints().quality = BuildQuality::Fastest;
        fast_ = leaves();
        recorder_.buildHints().quality = BuildQuality::DontCare;
    }

    static constexpr int kTriangles = 1000;
    Recorder recorder_;
    uint32_t object_ = 0;
    uint64_t fast_ = 0;
};

TEST_F(RedefinedObject, RaysOfQueriesAndShadersCountBesideCameraRays) {
    EXPECT_EQ(leaves(), fast_);
    recorder_.countQueryRays(7 * kTriangles);
    EXPECT_EQ(leaves(), fast_);
    recorder_.countQueryRays(9 * kTriangles);
    EXPECT_NE(leaves(), fast_);
    EXPECT_EQ(leaves(), fast_) << "since the last time there were none";
    recorder_.setFrameRays(5 * kTriangles);
    recorder_.countQueryRays(4 * kTriangles);
    EXPECT_NE(leaves(), fast_);
    recorder_.setFrameRays(5 * kTriangles); // no more have come
    EXPECT_EQ(leaves(), fast_);
    recorder_.setFrameRays(14 * kTriangles);
    EXPECT_NE(leaves(), fast_);
}

} // namespace
} // namespace smart::compat
