// SPDX-License-Identifier: MIT
// A small picture through the C interface, seen along -z at the square from -1 to 1.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <string>

#include "openrt/rt.h"

namespace plugin_test {

inline constexpr int kSize = 8;

/// A fresh context with a frame buffer.
class Picture {
public:
    Picture() {
        rtInit(nullptr, nullptr);
        rtThreads(2);
        rtSetFrameBuffer(reinterpret_cast<RTubyte*>(pixels_), kSize, kSize, RT_RGB_32F);
    }
    ~Picture() { rtExit(); }
    Picture(const Picture&) = delete;
    Picture& operator=(const Picture&) = delete;

    std::array<float, 3> at(int x, int y) const {
        const float* p = pixels_[y][x];
        return {p[0], p[1], p[2]};
    }
    std::array<float, 3> centre() const { return at(kSize / 2, kSize / 2); }

    /// The whole view, with the bound shader.
    static void fill() { square(-1, 1); }
    /// All heights, from x0 to x1.
    static void square(float x0, float x1) {
        rtBegin(RT_QUADS);
        rtVertex3f(x0, -1, 0);
        rtVertex3f(x1, -1, 0);
        rtVertex3f(x1, 1, 0);
        rtVertex3f(x0, 1, 0);
        rtEnd();
    }

private:
    float pixels_[kSize][kSize][3] = {};
};

inline std::string pluginFile(const std::string& name) { return TEST_PLUGINS "/" + name; }

inline RTuint load(const char* className, const std::string& file) {
    return rtGenNewShaderClass(className, pluginFile(file).c_str());
}

using Rgb = std::array<float, 3>;

} // namespace plugin_test
