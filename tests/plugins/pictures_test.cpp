// SPDX-License-Identifier: MIT
// A shader package of all five kinds, compiled from the headers of today and from the frozen
// ones: the pixels are what a pocket calculator says.
#include <gtest/gtest.h>

#include <string>

#include "tests/plugins/picture.h"

using namespace plugin_test;

namespace {

class Package : public testing::TestWithParam<const char*> {
protected:
    RTuint shaderOf(const char* className) const {
        EXPECT_NE(load(className, GetParam()), RTuint(RT_INVALID)) << rtGetErrorText();
        return rtGenNewShader();
    }
    static void setColor(const char* parameter, float r, float g, float b) {
        rtParameter3f(rtParameterHandle(parameter), r, g, b);
    }
};

TEST_P(Package, RendersWhatItsFormulasSay) {
    Picture picture;
    const RTuint beam = shaderOf("Beam");
    setColor("radiance", 0.5f, 1, 2);
    const RTuint backdrop = shaderOf("Backdrop");
    setColor("color", 0.125f, 0.25f, 0.5f);
    const RTuint camera = shaderOf("Slide");
    const RTuint dimmer = shaderOf("Dimmer");
    shaderOf("Matt");
    setColor("color", 1, 0.5f, 0.25f);
    const RTuint gain = rtParameterHandle("gain"), heat = rtParameterHandle("heat");

    rtUseLight(beam);
    rtUseEnvironmentShader(backdrop);
    rtUseCamera(camera);
    rtUseRenderingObject(dimmer);
    // The right half: heat rises from 0 in the middle to 1 at the edge.
    rtBegin(RT_QUADS);
    rtParameter1f(heat, 0);
    rtVertex3f(0, -1, 0);
    rtParameter1f(heat, 1);
    rtVertex3f(1, -1, 0);
    rtVertex3f(1, 1, 0);
    rtParameter1f(heat, 0);
    rtParameter1f(gain, 4);
    rtVertex3f(0, 1, 0);
    rtEnd();
    // Before the light of its upper half: lets blue through only.
    rtParameter1f(heat, 1);
    rtBegin(RT_QUADS);
    rtVertex3f(0, 0, 50);
    rtVertex3f(1, 0, 50);
    rtVertex3f(1, 1, 50);
    rtVertex3f(0, 1, 50);
    rtEnd();
    rtRender();
    ASSERT_EQ(rtGetError(), RTenum(RT_NO_ERROR)) << rtGetErrorText();

    for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
            Rgb expected = {0.125f, 0.25f, 0.5f};
            if (x >= kSize / 2) {
                const float across = (float(x) + 0.5f) * 2 / kSize - 1;
                const bool open = y < kSize / 2;
                expected = {open ? 0.5f * 4 * across : 0, open ? 0.5f * 4 * across : 0,
                            0.5f * 4 * across};
            }
            for (int k = 0; k < 3; ++k)
                EXPECT_NEAR(picture.at(x, y)[k], 0.5f * expected[k], 1e-6f)
                    << x << ' ' << y << ' ' << k;
        }
    }
    RTint bad = -1;
    rtGetIntegerv(RT_STAT_BAD_PIXELS, &bad);
    EXPECT_EQ(bad, 0);
}

INSTANTIATE_TEST_SUITE_P(All, Package, testing::Values("kinds.so", "kinds_frozen.so"),
                         [](const auto& test) {
                             const std::string file = test.param;
                             return file.substr(0, file.find('.'));
                         });

} // namespace
