// SPDX-License-Identifier: MIT
#include "compat/rtut/messages.h"

#include <cstdio>
#include <cstdlib>
#include <set>
#include <string>

namespace rtut {

namespace {

char newest[256] = "";

} // namespace

void tell(const char* function, const char* text) noexcept {
    std::snprintf(newest, sizeof newest, "%s: %s", function, text);
    std::fprintf(stderr, "rtut: %s\n", newest);
}

void tellOnce(const char* function, const char* text) noexcept {
    try {
        static std::set<std::string> told;
        if (told.insert(function).second) tell(function, text);
    } catch (...) {
        tell(function, text);
    }
}

const char* newestMessage() noexcept { return newest; }

void endProgram(int status, const char* text, const char* detail) noexcept {
    std::fprintf(stderr, "rtut: %s%s\n", text, detail);
    std::exit(status);
}

} // namespace rtut
