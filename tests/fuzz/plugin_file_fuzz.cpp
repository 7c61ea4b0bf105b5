// SPDX-License-Identifier: MIT
// Shader libraries: what the reader of ELF files makes of any file, before anything is loaded. An
// input is a list of changes (position, byte) to a good library, or, where it starts so, a file.
#include <sys/mman.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "libsmart/base/error.h"
#include "libsmart/shading/plugin_file.h"
#include "tests/fuzz/input.h"

namespace {

const std::vector<char>& goodLibrary() {
    static const std::vector<char> bytes = [] {
        std::ifstream file(FUZZ_GOOD_PLUGIN, std::ios::binary);
        return std::vector<char>(std::istreambuf_iterator<char>(file), {});
    }();
    if (bytes.empty()) std::abort();
    return bytes;
}

std::vector<char> fileOf(openrt::test::Input& input, const uint8_t* data, std::size_t size) {
    if (size >= 4 && std::memcmp(data, "\x7f" "ELF", 4) == 0) return {data, data + size};
    std::vector<char> bytes = goodLibrary();
    if (input.byte() & 1) bytes.resize(bytes.size() * input.word() / 65536);
    while (!input.atEnd() && !bytes.empty()) {
        // Headers and tables are what matters; they lie at the front.
        std::size_t at = input.word();
        if (at >= 0x8000) at = (at - 0x8000) * bytes.size() / 0x8000;
        bytes[at % bytes.size()] = char(input.byte());
    }
    return bytes;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, std::size_t size) {
    static const int descriptor = memfd_create("plugin", MFD_CLOEXEC);
    openrt::test::Input input(data, size);
    const std::vector<char> bytes = fileOf(input, data, size);
    if (ftruncate(descriptor, 0) != 0 ||
        pwrite(descriptor, bytes.data(), bytes.size(), 0) != ssize_t(bytes.size()))
        std::abort();
    try {
        smart::examinePluginFile("/proc/self/fd/" + std::to_string(descriptor));
    } catch (const smart::Error&) {
    }
    return 0;
}
