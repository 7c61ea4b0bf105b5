// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <functional>
#include <vector>

#include "openrt/shader.hpp"
#include "tests/libsmart/shading/fake_tracer.h"

namespace smart {
namespace {

using test::MadeShader;

/// A pixel whose samples the test colours.
struct FakePixel : RTSpixel {
    std::function<std::array<float, 4>(float x, float y, RTuint flags)> color;
    std::vector<std::array<float, 2>> asked;
    int paths = 0;
    test::FakeTracer tracer;

    explicit FakePixel(RTuint wanted) : RTSpixel{} {
        structSize = sizeof(RTSpixel);
        state = &tracer.state;
        samples = wanted;
        trace = [](RTSpixel* p, float u, float v, float rgba[4]) { answer(p, u, v, 0, rgba); };
        traceWith = answer;
        samplePosition = [](RTSpixel*, RTuint i, RTuint n, float xy[2]) {
            xy[0] = n > 1 ? (float(i) + 0.5f) / float(n) : 0.5f;
            xy[1] = 0.5f;
        };
    }
    std::array<float, 4> render(const ShaderObject& object) {
        std::array<float, 4> rgba = {-1, -1, -1, -1};
        EXPECT_EQ(object.functions().renderPixel(object.block(), this, rgba.data()), 0);
        return rgba;
    }

private:
    static void answer(RTSpixel* pixel, float x, float y, RTuint flags, float rgba[4]) {
        FakePixel& self = *static_cast<FakePixel*>(pixel);
        self.asked.push_back({x, y});
        self.paths += (flags & RTS_INDIRECT) != 0;
        const auto answered = self.color(x, y, flags);
        std::copy_n(answered.begin(), 4, rgba);
    }
};

std::array<float, 4> steps(float x, float, RTuint) {
    return {x < 0.5f ? 0.0f : 1.0f, 0.5f, x, 1 - x};
}

TEST(RenderingObjectsTest, DefaultIsTheMeanOfTheFramesSamples) {
    const auto object = MadeShader("Default").make();
    for (const RTuint n : {0u, 1u, 4u}) {
        FakePixel pixel(n);
        pixel.color = steps;
        const auto rgba = pixel.render(*object);
        EXPECT_EQ(pixel.asked.size(), std::max(n, 1u));
        EXPECT_EQ(pixel.paths, 0);
        EXPECT_EQ(rgba[2], 0.5f);
        EXPECT_EQ(rgba[3], 0.5f);
        EXPECT_EQ(rgba[0], n == 4 ? 0.5f : 1.0f);
    }
}

TEST(RenderingObjectsTest, AntialiasTakesMoreSamplesWhereTheyDiffer) {
    const auto object = MadeShader("Antialias").make();
    FakePixel flat(1), edge(1), faint(1);
    flat.color = [](float, float, RTuint) { return std::array<float, 4>{0.25f, 0.5f, 1, 1}; };
    EXPECT_EQ(flat.render(*object), (std::array<float, 4>{0.25f, 0.5f, 1, 1}));
    EXPECT_EQ(flat.asked.size(), 4u);
    edge.color = [](float x, float, RTuint) {
        return std::array<float, 4>{0, x < 0.1f ? 1.0f : 0.0f, 0, 1};
    };
    EXPECT_EQ(edge.render(*object)[1], 2.0f / 16);
    EXPECT_EQ(edge.asked.size(), 16u);
    for (std::size_t i = 0; i < 16; ++i)
        EXPECT_EQ(edge.asked[i][0], (float(i) + 0.5f) / 16); // each position once
    // A contrast below the threshold, in all channels.
    faint.color = [](float x, float, RTuint) {
        return std::array<float, 4>{x < 0.1f ? 1.2f : 1.0f, 1, 1, 1};
    };
    faint.render(*object);
    EXPECT_EQ(faint.asked.size(), 4u);
    faint.render(*MadeShader("Antialias").set("contrast", 0.05f).make());
    EXPECT_EQ(faint.asked.size(), 4u + 16u);
}

TEST(RenderingObjectsTest, AntialiasTakesStrangeCountsAsTheyAreMeant) {
    for (const int least : {-5, 0, 3, 9})
        for (const int most : {-5, 0, 4, 20}) {
            FakePixel pixel(1);
            pixel.color = steps;
            pixel.render(
                *MadeShader("Antialias").set("minSamples", least).set("maxSamples", most).make());
            const int low = std::max(least, 2);
            const auto taken = int(pixel.asked.size());
            EXPECT_GE(taken, low);
            EXPECT_LE(taken, std::max(low, most));
        }
}

TEST(RenderingObjectsTest, PathTracerTracesPaths) {
    for (const int samples : {-1, 0, 1, 5}) {
        FakePixel pixel(3);
        pixel.color = steps;
        const auto rgba = pixel.render(*MadeShader("PathTracer").set("samples", samples).make());
        const auto wanted = std::size_t(samples > 0 ? samples : 3);
        EXPECT_EQ(pixel.asked.size(), wanted);
        EXPECT_EQ(pixel.paths, int(wanted));
        EXPECT_NEAR(rgba[2], 0.5, 1e-6);
        EXPECT_NEAR(rgba[3], 0.5, 1e-6);
    }
}

} // namespace
} // namespace smart
