// SPDX-License-Identifier: MIT
// Many frames of changing scenes in one context: memory and threads of the process stay what they
// were after the first tenth. many_frames COUNT [--json FILE]
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "openrt/rt.h"
#include "tests/memory/scenes.h"

namespace openrt::test {
namespace {

/// A number of /proc/self/status.
long ofProcess(const char* name) {
    FILE* const file = std::fopen("/proc/self/status", "r");
    char line[256];
    long value = -1;
    while (file && std::fgets(line, sizeof line, file))
        if (std::strncmp(line, name, std::strlen(name)) == 0)
            value = std::atol(line + std::strlen(name) + 1);
    if (file) std::fclose(file);
    return value;
}

struct Usage {
    long kilobytes, threads;
};
Usage usage() { return {ofProcess("VmRSS"), ofProcess("Threads")}; }

} // namespace
} // namespace openrt::test

int main(int argc, char* argv[]) {
    using namespace openrt::test;
    const long count = argc > 1 ? std::atol(argv[1]) : 0;
    const char* const json = argc > 3 && std::strcmp(argv[2], "--json") == 0 ? argv[3] : nullptr;
    if (count < 10) return 2;
    constexpr RTuint kSize = 16;
    std::vector<RTubyte> pixels(kSize * kSize * 4);
    rtInit(nullptr, nullptr);
    rtThreads(2);
    Usage early = {};
    for (long frame = 0; frame < count; ++frame) {
        if (frame == count / 10) early = usage();
        rtSetFrameBuffer(pixels.data(), kSize, kSize, RT_RGBA_8);
        scenes()[std::size_t(frame) % scenes().size()].describeAndRender();
        backToStart();
    }
    const Usage late = usage();
    std::fprintf(stderr, "%ld frames: %ld kB after a tenth, %ld kB at the end; %ld threads, %ld\n",
                 count, early.kilobytes, late.kilobytes, early.threads, late.threads);
    rtExit();
    if (json) {
        FILE* const file = std::fopen(json, "w");
        if (!file) return 2;
        std::fprintf(file,
                     "{\"frames\": %ld, \"early_kb\": %ld, \"late_kb\": %ld, \"threads\": %ld}\n",
                     count, early.kilobytes, late.kilobytes, late.threads);
        std::fclose(file);
    }
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    constexpr long kSlack = 1 << 20; // what sanitizers keep of freed memory, and of threads' accesses
#else
    // What allocators keep between frames comes and goes by less than this.
    constexpr long kSlack = 2048;
#endif
    return late.threads == early.threads && late.kilobytes <= early.kilobytes + kSlack ? 0 : 1;
}
