// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace conformance {

// 8-bit pixels, row 0 at the top as in the file.
struct Picture {
    int width = 0, height = 0;
    std::vector<std::array<std::uint8_t, 3>> pixels;

    bool sameSize(const Picture& other) const {
        return width == other.width && height == other.height;
    }
};

// Window depth, row 0 at the top.
struct DepthPicture {
    int width = 0, height = 0;
    std::vector<float> depth;
};

// Each throws std::runtime_error with the file's name.
Picture readPng(const std::string& path);
void writePng(const std::string& path, const Picture& picture);
DepthPicture readPfm(const std::string& path);

} // namespace conformance
