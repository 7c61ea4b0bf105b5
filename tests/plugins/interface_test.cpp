// SPDX-License-Identifier: MIT
// The sizes of the structures that libraries and plug-ins share, by revision of the interface.
#include <gtest/gtest.h>

#include <cstddef>
#include <map>
#include <vector>

#include "openrt/rts_packet.h"
#include "openrt/rts_plugin_format.h"

namespace {

const std::vector<std::size_t> kGrowing = {
    sizeof(RTSstate),       sizeof(RTSfunctions),       sizeof(RTScameraray),
    sizeof(RTSpixel),       sizeof(RTSpacket),          sizeof(RTSpacketfunctions),
    sizeof(RTshaderclass),  sizeof(RTSplugin),          sizeof(RTSpluginclass)};

/// Where this fails, a structure has grown: give RTS_INTERFACE_REVISION the next number and this
/// table a line. Lines of released revisions stay.
TEST(Interface, AStructureThatGrowsMakesANewRevision) {
    if (sizeof(void*) != 8) GTEST_SKIP() << "the table is for 64-bit machines";
    const std::map<unsigned, std::vector<std::size_t>> sizes = {
        {1, {224, 72, 40, 64, 3056, 72, 144, 40, 32}},
        {2, {224, 72, 40, 64, 3056, 72, 152, 40, 32}}};
    ASSERT_TRUE(sizes.contains(RTS_INTERFACE_REVISION));
    EXPECT_EQ(sizes.at(RTS_INTERFACE_REVISION), kGrowing);
    EXPECT_EQ(sizes.rbegin()->first, RTS_INTERFACE_REVISION);
    const std::vector<std::size_t>* older = nullptr;
    for (const auto& [revision, now] : sizes) {
        for (std::size_t i = 0; older && i < now.size(); ++i) EXPECT_GE(now[i], (*older)[i]);
        older = &now;
    }
}

/// These lie in arrays or in the memory of whoever asks, and can not grow.
TEST(Interface, OtherStructuresStayAsTheyAre) {
    if (sizeof(void*) != 8) GTEST_SKIP() << "the sizes are those of 64-bit machines";
    EXPECT_EQ(sizeof(RTSparameter), 24u);
    EXPECT_EQ(sizeof(RTSlightsample), 28u);
    EXPECT_EQ(sizeof(RTShitinfo), 40u);
    EXPECT_EQ(offsetof(RTSplugin, neededRevision), 16u); // is read from files of any version
}

} // namespace
