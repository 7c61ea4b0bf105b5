// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <set>
#include <utility>

#include "openrt/rt.hpp"

namespace smart::test {

inline constexpr int kPictureSize = 16;

/// Pixels by column and row, those of a rectangle or of a condition.
using PixelSet = std::set<std::pair<int, int>>;

template <class Condition>
PixelSet pixelsWhere(Condition&& condition) {
    PixelSet set;
    for (int y = 0; y < kPictureSize; ++y)
        for (int x = 0; x < kPictureSize; ++x)
            if (condition(x, y)) set.insert({x, y});
    return set;
}

/// RGBA in floats.
struct SmallPicture {
    std::array<float, 4 * kPictureSize * kPictureSize> values{};

    const float* at(int x, int y) const { return &values[4 * (kPictureSize * y + x)]; }
    bool operator==(const SmallPicture& other) const {
        return std::memcmp(values.data(), other.values.data(), sizeof values) == 0;
    }
};

/// Pixels in which two pictures differ in any bit.
inline PixelSet differences(const SmallPicture& a, const SmallPicture& b) {
    return pixelsWhere(
        [&](int x, int y) { return std::memcmp(a.at(x, y), b.at(x, y), 4 * sizeof(float)) != 0; });
}

/// Pixels that are opaque black.
inline PixelSet blackPixels(const SmallPicture& picture) {
    return pixelsWhere([&](int x, int y) {
        const float* p = picture.at(x, y);
        return p[0] == 0 && p[1] == 0 && p[2] == 0 && p[3] == 1;
    });
}

/// A context of its own that draws 16 x 16 pixels, seen along -z through the square from -1 to 1
/// with rays from z = 10 on.
class ShaderPicture : public testing::Test {
protected:
    ShaderPicture() {
        rtInit(nullptr, nullptr);
        rtThreads(2);
        rtSetFrameBuffer(reinterpret_cast<RTubyte*>(frame_.values.data()), kPictureSize,
                         kPictureSize, RT_RGBA_32F);
        rtMatrixMode(RT_PROJECTION);
        rtOrtho(-1, 1, -1, 1, -10, 10);
        rtMatrixMode(RT_MODELVIEW);
    }
    ~ShaderPicture() override { rtExit(); }

    /// A new shader of a class of the library, bound.
    static RTuint builtin(const char* name) {
        rtGenNewShaderClass(name, nullptr);
        return rtGenNewShader();
    }
    /// A new shader of a class of this program, bound.
    template <class T>
    static RTuint own(const char* name) {
        rtGenNewShaderClass<T>(name);
        return rtGenNewShader();
    }
    template <class Value>
    static void set(const char* name, const Value& value) {
        rtParameter(rtParameterHandle(name), value);
    }
    static RTuint constant(const openrt::Color& value) {
        const RTuint shader = builtin("ConstantShader");
        set("value", value);
        return shader;
    }
    /// A rectangle in columns [x0, x1), rows [y0, y1) of the picture, at z, facing the viewer.
    static void rectangle(RTuint shader, int x0, int y0, int x1, int y1, float z) {
        const auto place = [](int pixel) { return float(pixel) * 2 / kPictureSize - 1; };
        rtBindShader(shader);
        rtNormal3f(0, 0, 1);
        rtBegin(RT_QUADS);
        rtVertex3f(place(x0), place(y0), z);
        rtVertex3f(place(x1), place(y0), z);
        rtVertex3f(place(x1), place(y1), z);
        rtVertex3f(place(x0), place(y1), z);
        rtEnd();
    }
    SmallPicture render() {
        frame_.values.fill(-1);
        rtRender();
        return frame_;
    }
    /// What the frame fetched last shows.
    const SmallPicture& shown() const { return frame_; }

    static int statistic(RTenum name) {
        RTint value = -1;
        rtGetIntegerv(name, &value);
        return value;
    }
    static int badPixels() { return statistic(RT_STAT_BAD_PIXELS); }

    /// Of the frame fetched last: told as an error, once, if and only if there are bad pixels.
    static void expectReported(std::size_t count) {
        EXPECT_EQ(std::size_t(badPixels()), count);
        EXPECT_EQ(rtGetError(), RTenum(count ? RT_INVALID_OPERATION : RT_NO_ERROR))
            << rtGetErrorText();
        EXPECT_EQ(rtGetError(), RTenum(RT_NO_ERROR));
    }
    static void expectNoError() {
        EXPECT_EQ(rtGetError(), RTenum(RT_NO_ERROR)) << rtGetErrorText();
    }

private:
    SmallPicture frame_;
};

} // namespace smart::test
