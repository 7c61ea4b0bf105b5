// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "compat/rtut/options.h"

namespace rtut {

/// Pixels of a frame: RGBA, 8 bits each, row 0 at the bottom, and their window depth if asked for.
struct Picture {
    Size size{0, 0};
    std::vector<uint8_t> rgba;
    std::vector<float> depth;
};

/// Writes the colours as PNG; returns what went wrong, "" if nothing did.
std::string writePng(const std::string& path, const Picture& picture);

/// Writes the depth as PFM; returns the same.
std::string writePfm(const std::string& path, const Picture& picture);

} // namespace rtut
