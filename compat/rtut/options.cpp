// SPDX-License-Identifier: MIT
#include "compat/rtut/options.h"

#include <charconv>
#include <cstdio>
#include <cstring>
#include <string_view>
#include <utility>

namespace rtut {

namespace {

constexpr int kMaxFrames = 1000000;
constexpr int kMaxPadding = 20;

std::optional<int> numberIn(const char* text, int low, int high) {
    int value = 0;
    const char* const end = text + std::strlen(text);
    const auto [rest, error] = std::from_chars(text, end, value);
    if (error != std::errc() || rest != end || value < low || value > high) return std::nullopt;
    return value;
}

std::optional<Size> sizeOf(const char* text) {
    Size size{};
    char rest = 0;
    if (std::sscanf(text, "%6dx%6d%c", &size.width, &size.height, &rest) != 2 || size.width < 1 ||
        size.height < 1 || size.width > kMaxWindowSize || size.height > kMaxWindowSize)
        return std::nullopt;
    return size;
}

/// What stands at a percent sign.
struct Conversion {
    std::size_t length = 0; ///< 0: nothing that a pattern may have
    bool isNumber = false;
    bool zeros = false;
    int padding = 0;
};

Conversion conversionAt(const std::string& pattern, std::size_t at) {
    std::size_t i = at + 1;
    Conversion result;
    if (i < pattern.size() && pattern[i] == '%') return {2, false, false, 0};
    if (i < pattern.size() && pattern[i] == '0') result.zeros = true;
    for (; i < pattern.size() && pattern[i] >= '0' && pattern[i] <= '9'; ++i)
        if ((result.padding = result.padding * 10 + pattern[i] - '0') > kMaxPadding) return {};
    if (i >= pattern.size() || pattern[i] != 'd') return {};
    result.isNumber = true;
    result.length = i + 1 - at;
    return result;
}

/// How many numbers the pattern has; nullopt: something else stands at a percent sign.
std::optional<int> numbersIn(const std::string& pattern) {
    int numbers = 0;
    for (std::size_t at = 0; (at = pattern.find('%', at)) != pattern.npos;) {
        const Conversion conversion = conversionAt(pattern, at);
        if (conversion.length == 0) return std::nullopt;
        numbers += conversion.isNumber;
        at += conversion.length;
    }
    return numbers;
}

bool applyGeometry(Options& options, const char* text) {
    Size size{};
    Place place{};
    int length = 0;
    if (std::sscanf(text, "%6dx%6d%n", &size.width, &size.height, &length) == 2 && length > 0) {
        if (size.width < 1 || size.height < 1 || size.width > kMaxWindowSize ||
            size.height > kMaxWindowSize)
            return false;
        options.initialSize = size;
        text += length;
    }
    if (*text == 0) return options.initialSize.has_value();
    char rest = 0;
    if (std::sscanf(text, "%6d%6d%c", &place.x, &place.y, &rest) != 2) return false;
    options.initialPlace = place;
    return true;
}

/// Applies an argument with a value; returns what is wrong with it, or nullptr.
const char* apply(Options& options, std::string_view name, const char* value) {
    if (name == "--rt-offscreen") {
        const auto frames = numberIn(value, 1, kMaxFrames);
        if (!frames) return "not a number of frames from 1 to 1000000";
        options.offscreenFrames = *frames;
    } else if (name == "--rt-output" || name == "--rt-depth") {
        std::string& pattern = name == "--rt-output" ? options.output : options.depth;
        pattern = value;
        const auto numbers = numbersIn(pattern);
        if (pattern.empty() || !numbers || *numbers > 1)
            return "not a file name with one %d for the number of a frame";
    } else if (name == "--rt-size") {
        options.size = sizeOf(value);
        if (!options.size) return "not a size, as in 640x480";
    } else if (name == "-geometry") {
        if (!applyGeometry(options, value)) return "not a geometry, as in 640x480+10+10";
    }
    return nullptr;
}

bool takesValue(std::string_view name) {
    return name == "--rt-offscreen" || name == "--rt-output" || name == "--rt-depth" ||
           name == "--rt-size" || name == "-geometry" || name == "-display";
}
bool isIgnored(std::string_view name) {
    return name == "-iconic" || name == "-direct" || name == "-indirect" || name == "-sync" ||
           name == "-gldebug";
}

/// What is wrong with the files asked for, "" if nothing is.
std::string problemOf(const std::string& name, const std::string& pattern, int frames) {
    if (pattern.empty()) return {};
    if (frames == 0) return name + ": there are no files without --rt-offscreen";
    if (frames > 1 && numbersIn(pattern) == 0)
        return name + ' ' + pattern + ": a %d is missing for several frames";
    return {};
}

} // namespace

Options takeArguments(int* argcp, char** argv, std::string& problem) {
    Options options;
    if (!argcp || !argv) return options;
    const int count = *argcp;
    int kept = 0;
    for (int i = 0; i < count; ++i) {
        if (i == 0 || !argv[i] || !(takesValue(argv[i]) || isIgnored(argv[i]))) {
            argv[kept++] = argv[i];
            continue;
        }
        if (isIgnored(argv[i])) continue;
        const std::string name = argv[i];
        if (i + 1 == count || !argv[i + 1]) {
            problem = name + ": the value is missing";
            return options;
        }
        if (const char* reason = apply(options, name, argv[++i])) {
            problem = name + ' ' + argv[i] + ": " + reason;
            return options;
        }
    }
    if (kept < count) argv[kept] = nullptr;
    *argcp = kept;
    for (const auto& [name, pattern] :
         {std::pair("--rt-output", &options.output), std::pair("--rt-depth", &options.depth)})
        if (problem.empty()) problem = problemOf(name, *pattern, options.offscreenFrames);
    return options;
}

std::string frameFile(const std::string& pattern, int frame) {
    std::string path;
    for (std::size_t at = 0; at < pattern.size();) {
        if (pattern[at] != '%') {
            path += pattern[at++];
            continue;
        }
        const Conversion conversion = conversionAt(pattern, at);
        if (conversion.isNumber) {
            const std::string number = std::to_string(frame);
            const auto padding = std::size_t(conversion.padding);
            if (number.size() < padding)
                path.append(padding - number.size(), conversion.zeros ? '0' : ' ');
            path += number;
        } else {
            path += '%';
        }
        at += conversion.length;
    }
    return path;
}

} // namespace rtut
