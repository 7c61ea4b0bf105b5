// SPDX-License-Identifier: MIT
// Scaled images and mipmaps against GLU's, by number: it filters in single precision and cuts off,
// so a step of its 16 bits may differ.
#include <GL/glu.h>
#include <gtest/gtest.h>
#include <openrt/rt.h>
#include <openrt/rtu.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>

#include "tests/compat/rtu/calls.h"

using namespace testing_rtu;

namespace {

struct FormatCase {
    RTenum rt;
    GLenum gl;
    int components;
};
const FormatCase kFormats[] = {{RT_LUMINANCE, GL_LUMINANCE, 1},
                               {RT_ALPHA, GL_ALPHA, 1},
                               {RT_LUMINANCE_ALPHA, GL_LUMINANCE_ALPHA, 2},
                               {RT_RGB, GL_RGB, 3},
                               {RT_BGR, GL_BGR, 3},
                               {RT_RGBA, GL_RGBA, 4},
                               {RT_BGRA, GL_BGRA, 4}};

struct Images : testing::Test {
    void SetUp() override {
        rtInit(nullptr, nullptr);
        rtLevels.clear();
        glLevels.clear();
    }
    void TearDown() override { rtExit(); }
    std::mt19937 random{7};

    template <class T>
    std::vector<T> noise(std::size_t count) {
        std::vector<T> values(count);
        for (T& value : values) {
            if constexpr (std::is_floating_point_v<T>)
                value = std::uniform_real_distribution<T>(0, 1)(random);
            else
                value = T(std::uniform_int_distribution<int64_t>(
                    0, std::numeric_limits<T>::max())(random));
        }
        return values;
    }

    /// The largest difference to GLU's image, in steps of 16 bits.
    template <class T>
    double scaleDifference(const FormatCase& format, GLenum type, int wIn, int hIn, int wOut,
                           int hOut) {
        // Rows of multiples of four bytes.
        const auto rowOf = [&](int width) {
            return (std::size_t(width) * std::size_t(format.components) * sizeof(T) + 3) / 4 * 4 /
                   sizeof(T);
        };
        const std::vector<T> in = noise<T>(rowOf(wIn) * std::size_t(hIn));
        std::vector<T> rt(rowOf(wOut) * std::size_t(hOut)), gl(rt);
        EXPECT_EQ(rtuScaleImage(format.rt, wIn, hIn, type, in.data(), wOut, hOut, type, rt.data()),
                  0);
        EXPECT_EQ(gluScaleImage(format.gl, wIn, hIn, type, in.data(), wOut, hOut, type, gl.data()),
                  0);
        const double range =
            std::is_floating_point_v<T> ? 1.0 : double(std::numeric_limits<T>::max());
        double worst = 0;
        for (std::size_t i = 0; i < rt.size(); ++i)
            worst = std::max(worst, std::fabs(double(rt[i]) - double(gl[i])) / range * 65535);
        return worst;
    }
};

TEST_F(Images, scaleAsGluDoes) {
    for (const FormatCase& format : kFormats)
        for (const auto& [wIn, hIn, wOut, hOut] :
             {std::array{8, 8, 4, 4}, {13, 7, 5, 3}, {4, 4, 9, 6}, {16, 2, 3, 5}, {1, 1, 4, 4}}) {
            EXPECT_LE(scaleDifference<uint8_t>(format, GL_UNSIGNED_BYTE, wIn, hIn, wOut, hOut),
                      257.01);
            EXPECT_LE(scaleDifference<int8_t>(format, GL_BYTE, wIn, hIn, wOut, hOut), 516.1);
            EXPECT_LE(scaleDifference<uint16_t>(format, GL_UNSIGNED_SHORT, wIn, hIn, wOut, hOut),
                      1.01);
            EXPECT_LE(scaleDifference<int16_t>(format, GL_SHORT, wIn, hIn, wOut, hOut), 2.01);
            EXPECT_LE(scaleDifference<uint32_t>(format, GL_UNSIGNED_INT, wIn, hIn, wOut, hOut),
                      1.01);
            EXPECT_LE(scaleDifference<int32_t>(format, GL_INT, wIn, hIn, wOut, hOut), 2.01);
            EXPECT_LE(scaleDifference<float>(format, GL_FLOAT, wIn, hIn, wOut, hOut), 1.01);
        }
}

TEST_F(Images, anEvenPictureStaysEven) {
    const std::vector<uint8_t> in(20 * 12 * 3, 201);
    std::vector<uint8_t> out(8 * 8 * 3);
    ASSERT_EQ(rtuScaleImage(RT_RGB, 20, 12, RT_UNSIGNED_BYTE, in.data(), 8, 8, RT_UNSIGNED_BYTE,
                            out.data()),
              0);
    for (const uint8_t value : out) EXPECT_EQ(value, 201);
}

TEST_F(Images, theUnpackStateSaysHowRowsLie) {
    // A 2 by 2 image within rows of 5 pixels, after a row and a pixel to skip.
    std::vector<uint8_t> in(5 * 4, 99);
    in[5 + 1] = 10, in[5 + 2] = 20, in[10 + 1] = 30, in[10 + 2] = 40;
    rtPixelStorei(RT_UNPACK_ROW_LENGTH, 5);
    rtPixelStorei(RT_UNPACK_SKIP_ROWS, 1);
    rtPixelStorei(RT_UNPACK_SKIP_PIXELS, 1);
    rtPixelStorei(RT_UNPACK_ALIGNMENT, 1);
    uint8_t out[4] = {};
    ASSERT_EQ(rtuScaleImage(RT_LUMINANCE, 2, 2, RT_UNSIGNED_BYTE, in.data(), 1, 1,
                            RT_UNSIGNED_BYTE, out),
              0);
    EXPECT_EQ(out[0], 25);
}

/// The 3 by 2 pixels of `values` as rtuScaleImage writes them in the pack state of now; bytes that
/// it leaves alone are 0xee.
template <class T>
std::vector<T> written(const std::vector<T>& values, RTenum format, RTenum type) {
    std::vector<T> out(40);
    std::memset(out.data(), 0xee, out.size() * sizeof(T));
    EXPECT_EQ(rtuScaleImage(format, 3, 2, type, values.data(), 3, 2, type, out.data()), 0);
    return out;
}
/// What glReadPixels' rules make of it: OpenGL 1.5, section 4.3.2.
template <class T>
std::vector<T> packed(const std::vector<T>& values, std::size_t offset, std::size_t stride) {
    std::vector<T> out(40);
    std::memset(out.data(), 0xee, out.size() * sizeof(T));
    const auto row = std::ptrdiff_t(values.size() / 2);
    std::copy(values.begin(), values.begin() + row, out.begin() + std::ptrdiff_t(offset));
    std::copy(values.begin() + row, values.end(), out.begin() + std::ptrdiff_t(offset + stride));
    return out;
}

TEST_F(Images, thePackStateSaysHowRowsAreWritten) {
    std::vector<uint8_t> in(18);
    for (std::size_t i = 0; i < in.size(); ++i) in[i] = uint8_t(10 + i);
    rtPixelStorei(RT_UNPACK_ALIGNMENT, 1);
    const auto rgb = [&] { return written(in, RT_RGB, RT_UNSIGNED_BYTE); };
    EXPECT_EQ(rgb(), packed(in, 0, 12)) << "the start";
    for (const auto& [alignment, stride] : {std::pair(1, 9), {2, 10}, {4, 12}, {8, 16}}) {
        rtPixelStorei(RT_PACK_ALIGNMENT, alignment);
        EXPECT_EQ(rgb(), packed(in, 0, std::size_t(stride))) << alignment;
    }
    rtPixelStorei(RT_PACK_ALIGNMENT, 1);
    rtPixelStorei(RT_PACK_ROW_LENGTH, 5);
    EXPECT_EQ(rgb(), packed(in, 0, 15));
    rtPixelStorei(RT_PACK_SKIP_PIXELS, 1);
    EXPECT_EQ(rgb(), packed(in, 3, 15));
    rtPixelStorei(RT_PACK_ROW_LENGTH, 0);
    rtPixelStorei(RT_PACK_SKIP_PIXELS, 0);
    rtPixelStorei(RT_PACK_SKIP_ROWS, 2);
    EXPECT_EQ(rgb(), packed(in, 18, 9));
    rtDestroyContext(rtGetCurrentContext());
    const std::vector<uint8_t> padded = packed(in, 0, 12);
    EXPECT_EQ(written(padded, RT_RGB, RT_UNSIGNED_BYTE), padded) << "without a context: the start";
}

TEST_F(Images, bytesAreSwappedOnTheWayInAndOut) {
    std::vector<uint16_t> in = noise<uint16_t>(6), swapped(in);
    for (uint16_t& value : swapped) value = uint16_t(value << 8 | value >> 8);
    rtPixelStorei(RT_UNPACK_ALIGNMENT, 2);
    rtPixelStorei(RT_PACK_ALIGNMENT, 2);
    const auto gray = [](const std::vector<uint16_t>& from) {
        return written(from, RT_LUMINANCE, RT_UNSIGNED_SHORT);
    };
    EXPECT_EQ(gray(in), packed(in, 0, 3));
    rtPixelStorei(RT_PACK_SWAP_BYTES, RT_TRUE);
    EXPECT_EQ(gray(in), packed(swapped, 0, 3));
    rtPixelStorei(RT_UNPACK_SWAP_BYTES, RT_TRUE);
    EXPECT_EQ(gray(swapped), packed(swapped, 0, 3));
}

TEST_F(Images, mipmapsAreThoseOfGlu) {
    for (const FormatCase& format : kFormats)
        for (const auto& [width, height] : {std::pair(8, 8), {16, 4}, {5, 9}, {1, 7}, {32, 1}}) {
            bytesPerPixel = format.components;
            const auto row = std::size_t(width * format.components + 3) / 4 * 4;
            const std::vector<uint8_t> in = noise<uint8_t>(row * std::size_t(height));
            rtLevels.clear();
            glLevels.clear();
            ASSERT_EQ(rtuBuild2DMipmaps(RT_TEXTURE_2D, format.components, width, height, format.rt,
                                        RT_UNSIGNED_BYTE, in.data()),
                      0);
            ASSERT_EQ(gluBuild2DMipmaps(GL_TEXTURE_2D, format.components, width, height, format.gl,
                                        GL_UNSIGNED_BYTE, in.data()),
                      0);
            ASSERT_FALSE(glLevels.empty());
            ASSERT_EQ(rtLevels.size(), glLevels.size());
            for (std::size_t i = 0; i < glLevels.size(); ++i) {
                EXPECT_EQ(rtLevels[i].level, glLevels[i].level);
                ASSERT_EQ(rtLevels[i].width, glLevels[i].width);
                ASSERT_EQ(rtLevels[i].height, glLevels[i].height);
                // GLU pads rows unless they are whole words, where this rows' lengths allow it.
                const auto tight = std::size_t(glLevels[i].width * format.components);
                if (tight % 4 != 0 && glLevels[i].height > 1) continue;
                for (std::size_t k = 0; k < glLevels[i].bytes.size(); ++k)
                    ASSERT_NEAR(rtLevels[i].bytes[k], glLevels[i].bytes[k], 1)
                        << width << 'x' << height << ", level " << i << ", byte " << k;
            }
        }
}

TEST_F(Images, oneDimensionAndSelectedLevels) {
    bytesPerPixel = 1;
    const std::vector<uint8_t> in = noise<uint8_t>(16);
    ASSERT_EQ(rtuBuild1DMipmaps(RT_TEXTURE_1D, 1, 16, RT_LUMINANCE, RT_UNSIGNED_BYTE, in.data()),
              0);
    ASSERT_EQ(gluBuild1DMipmaps(GL_TEXTURE_1D, 1, 16, GL_LUMINANCE, GL_UNSIGNED_BYTE, in.data()),
              0);
    ASSERT_EQ(rtLevels.size(), glLevels.size());
    for (std::size_t i = 0; i < glLevels.size(); ++i)
        for (std::size_t k = 0; k < glLevels[i].bytes.size(); ++k)
            EXPECT_NEAR(rtLevels[i].bytes[k], glLevels[i].bytes[k], 1);
    rtLevels.clear();
    ASSERT_EQ(rtuBuild1DMipmapLevels(RT_TEXTURE_1D, 1, 16, RT_LUMINANCE, RT_UNSIGNED_BYTE, 2, 3, 4,
                                     in.data()),
              0);
    ASSERT_EQ(rtLevels.size(), 2u);
    EXPECT_EQ(rtLevels[0].level, 3);
    EXPECT_EQ(rtLevels[0].width, 8);
}

TEST_F(Images, theUnpackStateIsAsItWas) {
    rtPixelStorei(RT_UNPACK_ALIGNMENT, 8);
    rtPixelStorei(RT_UNPACK_ROW_LENGTH, 64);
    const std::vector<uint8_t> in(64 * 64);
    bytesPerPixel = 1;
    rtuBuild2DMipmaps(RT_TEXTURE_2D, 1, 4, 4, RT_LUMINANCE, RT_UNSIGNED_BYTE, in.data());
    RTint value = 0;
    rtGetIntegerv(RT_UNPACK_ALIGNMENT, &value);
    EXPECT_EQ(value, 8);
    rtGetIntegerv(RT_UNPACK_ROW_LENGTH, &value);
    EXPECT_EQ(value, 64);
}

TEST_F(Images, sizesBeyondAllMemoryAreRefused) {
    const uint8_t pixel[64] = {};
    constexpr int kMost = std::numeric_limits<int>::max();
    // The product of the first three is 3056 modulo 2^64.
    for (const auto& [width, height, depth] :
         {std::array{288549115, 1971995458, 301668200}, {kMost, kMost, kMost}}) {
        EXPECT_EQ(rtuBuild3DMipmaps(RT_TEXTURE_3D, 1, width, height, depth, RT_LUMINANCE,
                                    RT_UNSIGNED_BYTE, pixel),
                  RTint(RTU_OUT_OF_MEMORY));
        EXPECT_EQ(rtGetError(), RTenum(RT_OUT_OF_MEMORY));
    }
    uint8_t out[64] = {};
    EXPECT_EQ(rtuScaleImage(RT_LUMINANCE, 2, 2, RT_UNSIGNED_BYTE, pixel, kMost, kMost,
                            RT_UNSIGNED_BYTE, out),
              RTint(RTU_OUT_OF_MEMORY));
    EXPECT_EQ(rtGetError(), RTenum(RT_OUT_OF_MEMORY));
}

TEST_F(Images, theLastLevelOfAllIsOne) {
    bytesPerPixel = 1;
    const uint8_t in[4] = {};
    constexpr int kMost = std::numeric_limits<int>::max();
    EXPECT_EQ(rtuBuild1DMipmapLevels(RT_TEXTURE_1D, 1, 4, RT_LUMINANCE, RT_UNSIGNED_BYTE,
                                     kMost - 1, kMost, kMost, in),
              0);
    ASSERT_EQ(rtLevels.size(), 1u);
    EXPECT_EQ(rtLevels[0].level, kMost);
    EXPECT_EQ(rtLevels[0].width, 2);
}

TEST_F(Images, theContextMayEndWhileLevelsAreGiven) {
    bytesPerPixel = 1;
    whenLevelComes = [] { rtDestroyContext(rtGetCurrentContext()); };
    const uint8_t in[16] = {};
    EXPECT_EQ(rtuBuild2DMipmaps(RT_TEXTURE_2D, 1, 4, 4, RT_LUMINANCE, RT_UNSIGNED_BYTE, in), 0);
    whenLevelComes = nullptr;
    EXPECT_EQ(rtLevels.size(), 3u);
}

TEST_F(Images, wrongArgumentsAreGlusNumbersAndRecorded) {
    uint8_t pixel[64] = {};
    const auto scale = [&](RTenum format, int w, RTenum type, const void* in, void* out) {
        return rtuScaleImage(format, w, 2, type, in, 1, 1, type, out);
    };
    EXPECT_EQ(scale(RT_RGB, -1, RT_UNSIGNED_BYTE, pixel, pixel), RTint(RTU_INVALID_VALUE));
    EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_VALUE));
    EXPECT_EQ(scale(0x1234, 2, RT_UNSIGNED_BYTE, pixel, pixel), RTint(RTU_INVALID_ENUM));
    EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_ENUM));
    EXPECT_EQ(scale(RT_RGB, 2, RT_BITMAP, pixel, pixel), RTint(RTU_INVALID_ENUM));
    EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_ENUM));
    EXPECT_EQ(scale(RT_RGB, 2, RT_UNSIGNED_BYTE, nullptr, pixel), RTint(RTU_INVALID_VALUE));
    EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_VALUE));
    EXPECT_EQ(scale(RT_RGB, 2, RT_UNSIGNED_BYTE, pixel, nullptr), RTint(RTU_INVALID_VALUE));
    EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_VALUE));
    EXPECT_EQ(scale(RT_RGB, 0, RT_UNSIGNED_BYTE, pixel, pixel), 0) << "nothing to do";
    EXPECT_EQ(rtuBuild2DMipmaps(RT_TEXTURE_2D, 3, 0, 4, RT_RGB, RT_UNSIGNED_BYTE, pixel),
              RTint(RTU_INVALID_VALUE));
    EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_VALUE));
    EXPECT_EQ(rtuBuild2DMipmapLevels(RT_TEXTURE_2D, 3, 4, 4, RT_RGB, RT_UNSIGNED_BYTE, 0, 2, 1,
                                     pixel),
              RTint(RTU_INVALID_VALUE));
    EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_VALUE));
    EXPECT_TRUE(rtLevels.empty());
    EXPECT_EQ(scale(RT_RGB, 2, RT_UNSIGNED_BYTE, pixel, pixel), 0) << "control";
}

} // namespace
