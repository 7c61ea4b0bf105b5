// SPDX-License-Identifier: MIT
// A small picture through the C interface, seen along -z at the square from -1 to 1.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <sstream>
#include <string>
#include <vector>

#include "openrt/rt.h"
#include "openrt/rts.h"

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

inline const RTshaderclass& loaded(const char* className, const std::string& file) {
    const RTuint id = load(className, file);
    EXPECT_NE(id, RTuint(RT_INVALID)) << rtGetErrorText();
    return *rtGetShaderClassDescriptor(id);
}

/// The classes that are in the library itself.
inline std::vector<const RTshaderclass*> builtinClasses() {
    std::vector<const RTshaderclass*> classes;
    std::istringstream names(rtGetShaderClassNames(nullptr));
    for (std::string name; std::getline(names, name);) {
        const RTuint id = rtGenNewShaderClass(name.c_str(), nullptr);
        EXPECT_NE(id, RTuint(RT_INVALID)) << name;
        classes.push_back(rtGetShaderClassDescriptor(id));
    }
    return classes;
}

using Rgb = std::array<float, 3>;

} // namespace plugin_test
