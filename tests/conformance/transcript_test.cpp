// SPDX-License-Identifier: MIT
#include "tests/conformance/transcript.h"

#include <gtest/gtest.h>

namespace conformance {
namespace {

TEST(Transcript, IsSplitIntoSections) {
    const Transcript transcript = parseTranscript("noise\ncase a/b\n1 2\nx\ncase c\n");
    ASSERT_EQ(transcript.size(), 2u);
    EXPECT_EQ(transcript.at("a/b"), (std::vector<std::string>{"1 2", "x"}));
    EXPECT_TRUE(transcript.at("c").empty());
}

TEST(Transcript, NumbersMayDifferByRounding) {
    EXPECT_EQ(firstDifference({"1.0 -3e8 0"}, {"1.000001 -300000100 -0"}), "");
    EXPECT_NE(firstDifference({"1.0"}, {"1.0001"}), "");
    EXPECT_NE(firstDifference({"1.0"}, {"nan"}), "");
}

TEST(Transcript, DifferencesAreFound) {
    EXPECT_EQ(firstDifference({"error a"}, {"error a"}), "");
    EXPECT_NE(firstDifference({"error a"}, {"error b"}), "");
    EXPECT_NE(firstDifference({"a b"}, {"a"}), "");
    EXPECT_NE(firstDifference({"a"}, {"a b"}), "");
    EXPECT_NE(firstDifference({"a"}, {}), "");
    EXPECT_NE(firstDifference({}, {"a"}), "");
}

TEST(Transcript, AChoiceAllowsEach) {
    EXPECT_EQ(firstDifference({"error a|b"}, {"error a"}), "");
    EXPECT_EQ(firstDifference({"error a|b"}, {"error b"}), "");
    EXPECT_NE(firstDifference({"error a|b"}, {"error c"}), "");
}

} // namespace
} // namespace conformance
