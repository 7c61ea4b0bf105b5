// SPDX-License-Identifier: MIT
// Files that are no shader libraries of this machine, among them every way of cutting one short.
#include "libsmart/shading/plugin_file.h"

#include <gtest/gtest.h>

#include <elf.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "libsmart/base/error.h"

namespace smart {
namespace {

using Bytes = std::vector<char>;

const std::string kGood = TEST_PLUGINS "/kinds.so";

Bytes bytesOf(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return Bytes(std::istreambuf_iterator<char>(file), {});
}

/// A file without a disk, for many versions of it.
class MemoryFile {
public:
    MemoryFile() : descriptor_(memfd_create("plugin", 0)) {}
    ~MemoryFile() { close(descriptor_); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }
    std::string write(const Bytes& bytes) const {
        EXPECT_EQ(pwrite(descriptor_, bytes.data(), bytes.size(), 0), ssize_t(bytes.size()));
        return path();
    }
    std::string cutTo(uint64_t length) const {
        EXPECT_EQ(ftruncate(descriptor_, off_t(length)), 0);
        return path();
    }

private:
    int descriptor_;
};

class PluginFile : public testing::Test {
protected:
    PluginFile() {
        char name[] = "/tmp/openrt_plugin_XXXXXX";
        folder_ = mkdtemp(name);
    }
    ~PluginFile() override { std::filesystem::remove_all(folder_); }

    std::string path(const std::string& name) const { return folder_ + "/" + name; }
    std::string write(const Bytes& bytes) const {
        std::ofstream(path("file.so"), std::ios::binary)
            .write(bytes.data(), std::streamsize(bytes.size()));
        return path("file.so");
    }
    /// The reason for which a file is refused; empty: it is not.
    static std::string reason(const std::string& file) {
        try {
            examinePluginFile(file);
            return "";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::InvalidValue);
            const std::string text = error.what();
            EXPECT_EQ(text.find(file + ": "), 0u) << text;
            return text.substr(file.size() + 2);
        }
    }
    /// The good library after a change to its header.
    template <class Change>
    std::string reasonAfter(Change&& change) const {
        Bytes bytes = bytesOf(kGood);
        Elf64_Ehdr header;
        std::memcpy(&header, bytes.data(), sizeof header);
        change(header);
        std::memcpy(bytes.data(), &header, sizeof header);
        return reason(write(bytes));
    }

    std::string folder_;
};

TEST_F(PluginFile, AGoodLibraryIsAccepted) {
    EXPECT_EQ(reason(kGood), "");
    EXPECT_EQ(reason(write(bytesOf(kGood))), "");
}

TEST_F(PluginFile, WhatIsNoLibraryIsRefusedByItsKind) {
    EXPECT_NE(reason(path("missing.so")).find("can not be read: "), std::string::npos);
    EXPECT_EQ(reason(folder_), "is a folder");
    EXPECT_EQ(reason("/dev/null"), "is no regular file");
    ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
    EXPECT_EQ(reason(path("pipe")), "is no regular file"); // and does not wait for a writer
    EXPECT_EQ(reason(write({})), "is no shared library");
    const std::string text = "This is a text, and longer than the header of a shared library is: "
                             "it has more than sixty-four bytes.";
    EXPECT_EQ(reason(write(Bytes(text.begin(), text.end()))), "is no shared library");
    EXPECT_EQ(reason(write(Bytes(100000, '\0'))), "is no shared library");
    EXPECT_EQ(reason("/proc/self/exe"), "is no shader library: it has no data symbol rtsPlugin");
}

TEST_F(PluginFile, AFileThatMayNotBeRead) {
    const std::string file = write(bytesOf(kGood));
    chmod(file.c_str(), 0);
    chmod(folder_.c_str(), 0755);
    const bool root = geteuid() == 0;
    if (root && seteuid(65534) != 0) GTEST_SKIP() << "can not give up being root";
    const std::string text = reason(file);
    if (root) {
        ASSERT_EQ(seteuid(0), 0);
    }
    EXPECT_EQ(text, "can not be read: Permission denied");
}

TEST_F(PluginFile, AnotherProcessor) {
    const uint16_t other = Elf64_Half(EM_RISCV);
    EXPECT_NE(reasonAfter([&](Elf64_Ehdr& h) { h.e_machine = other; })
                  .find("is for another processor: RISC-V, not for "),
              std::string::npos);
    EXPECT_NE(reasonAfter([](Elf64_Ehdr& h) { h.e_ident[EI_CLASS] = ELFCLASS32; })
                  .find("is for another processor"),
              std::string::npos);
    EXPECT_NE(reasonAfter([](Elf64_Ehdr& h) { h.e_ident[EI_DATA] = ELFDATA2MSB; })
                  .find("of the other byte order"),
              std::string::npos);
    EXPECT_EQ(reasonAfter([](Elf64_Ehdr& h) { h.e_type = ET_REL; }),
              "is no shared library, but another ELF file");
    EXPECT_EQ(reasonAfter([](Elf64_Ehdr& h) { h.e_phentsize = 1; }), "is damaged");
    EXPECT_EQ(reasonAfter([](Elf64_Ehdr& h) { h.e_phoff = ~0ull; }), "is cut off");
}

/// However much is missing, the file is refused unless all that is loaded of it is there.
TEST_F(PluginFile, CutOffAnywhere) {
    const Bytes whole = bytesOf(kGood);
    Elf64_Ehdr header;
    std::memcpy(&header, whole.data(), sizeof header);
    uint64_t needed = 0;
    for (int i = 0; i < header.e_phnum; ++i) {
        Elf64_Phdr segment;
        std::memcpy(&segment, whole.data() + header.e_phoff + std::size_t(i) * sizeof segment,
                    sizeof segment);
        needed = std::max<uint64_t>(needed, segment.p_offset + segment.p_filesz);
    }
    ASSERT_LT(needed, whole.size());
    const MemoryFile file;
    std::mt19937 random(1);
    for (int i = 0; i < 400; ++i) {
        const uint64_t length = i < 300 ? random() % needed : needed - 1 - uint64_t(i - 300);
        file.write(whole);
        EXPECT_NE(reason(file.cutTo(length)), "") << length;
    }
    file.write(whole);
    EXPECT_EQ(reason(file.cutTo(needed)), "");
}

/// Damage of any kind is refused or overlooked; it neither crashes nor hangs.
TEST_F(PluginFile, DamagedAnywhere) {
    const Bytes whole = bytesOf(kGood);
    const MemoryFile file;
    std::mt19937 random(2);
    int refused = 0;
    for (int i = 0; i < 1500; ++i) {
        Bytes bytes = whole;
        // The tables lie at the start of the file; small and huge numbers in their place.
        for (int k = 0; k < 3; ++k) {
            const std::size_t at = random() % (i % 2 ? 1024 : 8192) / 4 * 4;
            const uint32_t number = random() % 2 ? uint32_t(random()) : uint32_t(random() % 64);
            std::memcpy(bytes.data() + at, &number, sizeof number);
        }
        refused += !reason(file.write(bytes)).empty();
    }
    EXPECT_GT(refused, 100);
}

} // namespace
} // namespace smart
