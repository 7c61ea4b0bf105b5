// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <functional>
#include <string>

#include "openrt/rt.h"

/// A context with one thread that draws into a small picture of floats.
class FloatPicture : public testing::Test {
protected:
    static constexpr std::size_t kSize = 32;
    using Pixels = std::array<float, kSize * kSize * 4>;

    FloatPicture() {
        rtInit(nullptr, nullptr);
        rtThreads(1);
        rtSetFrameBuffer(reinterpret_cast<RTubyte*>(pixels_.data()), kSize, kSize, RT_RGBA_32F);
        rtMatrixMode(RT_PROJECTION);
        rtFrustum(-1, 1, -1, 1, 1, 20);
        rtMatrixMode(RT_MODELVIEW);
    }
    ~FloatPicture() override { rtExit(); }

    /// The picture of what the calls draw; there is one, and no error.
    Pixels pictureOf(const std::function<void()>& calls) {
        pixels_.fill(-1.0f);
        rtPushMatrix();
        rtColor3f(0.25f, 0.5f, 0.75f);
        calls();
        rtPopMatrix();
        rtRender();
        EXPECT_EQ(rtGetError(), unsigned(RT_NO_ERROR)) << rtGetErrorText();
        EXPECT_GT(drawn(), kSize) << "the picture is (nearly) empty";
        return pixels_;
    }
    std::size_t drawn() const {
        std::size_t count = 0;
        for (std::size_t i = 0; i < pixels_.size(); i += 4)
            count += pixels_[i] > 0 || pixels_[i + 1] > 0 || pixels_[i + 2] > 0;
        return count;
    }
    static RTint value(RTenum name) {
        RTint result = -1;
        rtGetIntegerv(name, &result);
        return result;
    }
    static void expectError(RTenum error) {
        EXPECT_EQ(rtGetError(), error) << rtGetErrorText();
        EXPECT_EQ(rtGetError(), unsigned(RT_NO_ERROR));
    }

    Pixels pixels_{};
};
