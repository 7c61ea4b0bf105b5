// SPDX-License-Identifier: MIT
// The comparison of openrt-info --check-packets: which classes pass it, and which must not.
#include "samples/tools/packet_check.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/plugins/picture.h"

using namespace plugin_test;
using samples::checkPackets;
using samples::PacketVerdict;

namespace {

PacketVerdict verdictOf(const char* className) {
    return checkPackets(loaded(className, "packets.so"));
}

TEST(PacketCheck, AClassWrittenOnceAgreesWithItself) {
    const Picture context;
    const PacketVerdict verdict = verdictOf("Honest");
    EXPECT_GT(verdict.points, 1000u);
    EXPECT_EQ(verdict.different, 0u) << verdict.example;
}

TEST(PacketCheck, EveryOtherWayIsFound) {
    const Picture context;
    const PacketVerdict ulp = verdictOf("Ulp");
    EXPECT_GT(ulp.different, 0u);
    EXPECT_LT(ulp.different, ulp.points / 8); // one lane of sixteen
    EXPECT_NE(ulp.example.find("green is "), std::string::npos) << ulp.example;
    const PacketVerdict silent = verdictOf("Silent");
    EXPECT_EQ(silent.different, silent.points);
    EXPECT_NE(silent.example.find("sets no radiance"), std::string::npos);
    const PacketVerdict unstable = verdictOf("Unstable");
    EXPECT_EQ(unstable.different, unstable.points);
    EXPECT_NE(unstable.example.find("fails"), std::string::npos);
    EXPECT_GT(verdictOf("Gambler").different, 100u);
}

TEST(PacketCheck, AllBuiltInClassesAgree) {
    const Picture context;
    int checked = 0;
    for (const RTshaderclass* const c : builtinClasses()) {
        if (!c->shadePacket) continue;
        const PacketVerdict verdict = checkPackets(*c);
        EXPECT_EQ(verdict.different, 0u) << c->name << ": " << verdict.example;
        EXPECT_GT(verdict.points, 1000u) << c->name;
        ++checked;
    }
    EXPECT_GT(checked, 5);
}

} // namespace
