// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

namespace rtut {

struct Size {
    int width, height;
    bool operator==(const Size&) const = default;
};
struct Place {
    int x, y;
};

inline constexpr int kMaxWindowSize = 16384; ///< pixels, each way

/// What the command line asks for.
struct Options {
    int offscreenFrames = 0; ///< 0: on screen
    std::string output;      ///< a pattern for frameFile; empty: no files
    std::string depth;       ///< the same, of files with the window depth
    std::optional<Size> size;
    std::optional<Size> initialSize; ///< -geometry: only until the program asks for another
    std::optional<Place> initialPlace;
};

/// Takes the arguments of rtutInit out of argv. `problem` says what is wrong with one; then
/// nothing else is meaningful.
Options takeArguments(int* argcp, char** argv, std::string& problem);

/// The file of a frame: the pattern's %d, with width and zeros as printf has them, is its number;
/// %% is a percent sign.
std::string frameFile(const std::string& pattern, int frame);

} // namespace rtut
