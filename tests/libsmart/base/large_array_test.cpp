// SPDX-License-Identifier: MIT
#include "libsmart/base/large_array.h"

#include <cstdint>
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

namespace smart {
namespace {

/// Whether the system was asked for huge pages where that address is: VmFlags of proc_pid_smaps(5).
bool inHugePages(const void* address) {
    std::ifstream maps("/proc/self/smaps");
    bool here = false;
    for (std::string line; std::getline(maps, line);) {
        unsigned long begin = 0, end = 0;
        char dash = 0;
        std::istringstream range(line);
        if (range >> std::hex >> begin >> dash >> end && dash == '-')
            here = begin <= uintptr_t(address) && uintptr_t(address) < end;
        else if (here && line.starts_with("VmFlags:"))
            return line.find(" hg") != std::string::npos;
    }
    return false;
}

TEST(LargeArray, IsInHugePages) {
    if (!std::ifstream("/sys/kernel/mm/transparent_hugepage/enabled"))
        GTEST_SKIP() << "the system has no huge pages";
    constexpr std::size_t kCount = std::size_t(4) << 20;
    const LargeArray<float> large(kCount);
    const std::vector<float> other(kCount);
    EXPECT_TRUE(inHugePages(&large[kCount / 2]));
    EXPECT_FALSE(inHugePages(&other[kCount / 2]));
}

TEST(LargeArray, KeepsItsElementsWhileItGrowsAndShrinks) {
    LargeArray<uint32_t> array;
    constexpr uint32_t kCount = 3u << 20;
    for (uint32_t i = 0; i < kCount; ++i) array.push_back(i);
    array.resize(kCount - kCount / 4);
    array.shrink_to_fit();
    const LargeArray<uint32_t> copy = array;
    for (uint32_t i = 0; i < copy.size(); ++i) ASSERT_EQ(copy[i], i);
}

TEST(LargeArray, SmallOnesAreLeftAlone) {
    for (const std::size_t count : {0, 1, 1000}) {
        const LargeArray<uint32_t> array(count, 7u);
        for (const uint32_t element : array) EXPECT_EQ(element, 7u);
        EXPECT_EQ(array.size(), count);
    }
}

} // namespace
} // namespace smart
