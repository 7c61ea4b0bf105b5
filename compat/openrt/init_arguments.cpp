// SPDX-License-Identifier: MIT
#include "compat/openrt/init_arguments.h"

#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string_view>

#include "libsmart/base/variable_warning.h"

namespace smart::compat {

namespace {

std::optional<unsigned> numberUpTo(const char* text, unsigned limit) {
    unsigned value = 0;
    const char* const end = text + std::strlen(text);
    const auto [rest, error] = std::from_chars(text, end, value);
    if (error != std::errc() || rest != end || value > limit) return std::nullopt;
    return value;
}

void warnOfArgument(const char* name, const char* value, const char* reason) {
    std::fprintf(stderr, "openrt: %s %s: %s\n", name, value, reason);
}

bool isSize(const char* text) {
    unsigned width = 0, height = 0;
    char rest = 0;
    return std::sscanf(text, "%5ux%5u%c", &width, &height, &rest) == 2 && width && height;
}

/// Applies one argument; returns what is wrong with its value, or nullptr.
const char* apply(InitOptions& options, std::string_view name, const char* value) {
    if (name == "--rt-threads") {
        const auto threads = numberUpTo(value, kMaxThreads);
        if (!threads) return "not a number from 0 to 1024";
        options.threads = *threads;
    } else if (name == "--rt-samples") {
        const auto samples = numberUpTo(value, kMaxSamples);
        if (!samples || *samples == 0) return "not a number from 1 to 4096";
        options.samples = samples;
    } else if (name == "--rt-isa") {
        if (!selectKernels(value)) return "no such instruction set in this library or machine";
    } else if (name == "--rt-precision") {
        if (std::strcmp(value, "fast") == 0)
            options.precision = Precision::Fast;
        else if (std::strcmp(value, "watertight") == 0)
            options.precision = Precision::Watertight;
        else if (std::strcmp(value, "precise") == 0)
            options.precision = Precision::Precise;
        else
            return "neither fast nor watertight nor precise";
    } else if (name == "--rt-offscreen") {
        if (!numberUpTo(value, 1u << 30)) return "not a number";
        return "needs a program with an rtut window";
    } else if (name == "--rt-size") {
        if (!isSize(value)) return "not a size, as in 640x480";
        return "needs a program with an rtut window";
    } else { // --rt-output, --rt-depth
        return "needs a program with an rtut window";
    }
    return nullptr;
}

bool takesValue(std::string_view name) {
    for (const char* known : {"--rt-threads", "--rt-isa", "--rt-precision", "--rt-samples",
                              "--rt-offscreen", "--rt-output", "--rt-depth", "--rt-size"})
        if (name == known) return true;
    return false;
}

} // namespace

unsigned threadsFromEnvironment() {
    const char* const text = secure_getenv("OPENRT_THREADS");
    if (!text || !*text) return 0;
    const auto threads = numberUpTo(text, kMaxThreads);
    if (!threads) warnOfVariable("OPENRT_THREADS", text, "not a number from 0 to 1024");
    return threads.value_or(0);
}

InitOptions takeInitArguments(int* argcp, char** argv) {
    InitOptions options;
    options.threads = threadsFromEnvironment();
    if (!argcp || !argv) return options;
    const int count = *argcp;
    int kept = 0;
    for (int i = 0; i < count; ++i) {
        if (i == 0 || !argv[i] || !takesValue(argv[i])) {
            argv[kept++] = argv[i];
            continue;
        }
        const char* const name = argv[i];
        if (i + 1 == count || !argv[i + 1]) {
            warnOfArgument(name, "", "the value is missing");
            continue;
        }
        const char* const value = argv[++i];
        if (const char* reason = apply(options, name, value)) warnOfArgument(name, value, reason);
    }
    if (kept < count) {
        argv[kept] = nullptr;
        *argcp = kept;
    }
    return options;
}

} // namespace smart::compat
