// SPDX-License-Identifier: MIT
#include "libsmart/base/large_array.h"

#include <sys/mman.h>

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

namespace smart {
namespace {

/// What proc_pid_smaps(5) says of the mapping that has that address, under that name.
std::string factOf(const void* address, const std::string& name) {
    std::ifstream maps("/proc/self/smaps");
    bool here = false;
    for (std::string line; std::getline(maps, line);) {
        unsigned long begin = 0, end = 0;
        char dash = 0;
        std::istringstream range(line);
        if (range >> std::hex >> begin >> dash >> end && dash == '-')
            here = begin <= uintptr_t(address) && uintptr_t(address) < end;
        else if (here && line.starts_with(name))
            return line.substr(name.size());
    }
    return "";
}

/// Whether the system was asked for huge pages where that address is.
bool inHugePages(const void* address) {
    return factOf(address, "VmFlags:").find(" hg") != std::string::npos;
}

/// Bytes of huge pages in the mapping that has that address.
std::size_t hugeBytes(const void* address) {
    return std::stoul(factOf(address, "AnonHugePages:")) * 1024;
}

constexpr std::size_t kHugePage = std::size_t(2) << 20;

/// So many bytes that nobody has asked for huge pages in.
class FreshMemory {
public:
    explicit FreshMemory(std::size_t bytes)
        : bytes_(bytes),
          memory_(static_cast<std::byte*>(mmap(nullptr, bytes, PROT_READ | PROT_WRITE,
                                               MAP_PRIVATE | MAP_ANONYMOUS, -1, 0))) {}
    ~FreshMemory() { munmap(memory_, bytes_); }
    std::byte* hugePage() const {
        return memory_ + (kHugePage - uintptr_t(memory_) % kHugePage) % kHugePage;
    }

private:
    const std::size_t bytes_;
    std::byte* const memory_;
};

class HugePages : public testing::Test {
protected:
    void SetUp() override {
        if (!std::ifstream("/sys/kernel/mm/transparent_hugepage/enabled"))
            GTEST_SKIP() << "the system has no huge pages";
    }
};

TEST_F(HugePages, AreAskedForInAllOfALargeArray) {
    const LargeArray<float> large(std::size_t(4) << 20);
    EXPECT_TRUE(inHugePages(&large[large.size() / 2]));
}

TEST_F(HugePages, AreAskedForInsideOfTheMemoryOnly) {
    const FreshMemory memory(5 * kHugePage);
    std::byte* const first = memory.hugePage();
    EXPECT_FALSE(inHugePages(first));
    useHugePages(first + 4096, 3 * kHugePage);
    EXPECT_FALSE(inHugePages(first + 8192));
    EXPECT_TRUE(inHugePages(first + kHugePage));
    EXPECT_TRUE(inHugePages(first + 3 * kHugePage - 1));
    EXPECT_FALSE(inHugePages(first + 3 * kHugePage)) << "not all of that page is ours";
}

TEST_F(HugePages, ComeWhereThereWereSmallOnes) {
    const FreshMemory memory(9 * kHugePage);
    std::byte* const first = memory.hugePage();
    for (std::size_t page = 0; page < 8 * kHugePage; page += 4096) first[page] = std::byte(1);
    useHugePages(first, 8 * kHugePage);
    for (std::size_t page = 0; page < 8 * kHugePage; page += 4096) first[page] = std::byte(1);
    const FreshMemory other(2 * kHugePage);
    useHugePages(other.hugePage(), kHugePage);
    *other.hugePage() = std::byte(1);
    if (hugeBytes(other.hugePage()) == 0) GTEST_SKIP() << "the system gives none";
    EXPECT_GE(hugeBytes(first), 4 * kHugePage);
}

TEST_F(HugePages, AreNotAskedForInWhatIsSmall) {
    const FreshMemory memory(4 * kHugePage);
    useHugePages(memory.hugePage() + 4096, kHugePage);
    for (std::size_t page = 0; page < 2; ++page)
        EXPECT_FALSE(inHugePages(memory.hugePage() + page * kHugePage));
    useHugePages(nullptr, 0);
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

TEST(LargeArray, IsAVectorOfAnySize) {
    for (const std::size_t count : {0, 1, 1000}) {
        const LargeArray<uint32_t> array(count, 7u);
        for (const uint32_t element : array) EXPECT_EQ(element, 7u);
        EXPECT_EQ(array.size(), count);
    }
}

} // namespace
} // namespace smart
