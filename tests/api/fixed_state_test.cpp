// SPDX-License-Identifier: MIT
// The fixed-function state against Mesa's: starting values, what right and wrong calls change and
// which errors they record, attribute stacks.
#include <GL/osmesa.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "openrt/rt.h"
#include "tests/api/fixed_state_transcript.h"

namespace {

using Lines = std::vector<std::string>;

void append(void* lines, const char* text) {
    static_cast<Lines*>(lines)->push_back(text);
}

Lines answersOfMesa(int section) {
    Lines lines;
    std::vector<unsigned char> pixels(8 * 8 * 4);
    const OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, nullptr);
    EXPECT_TRUE(OSMesaMakeCurrent(context, pixels.data(), GL_UNSIGNED_BYTE, 8, 8));
    transcribeMesa(section, append, &lines);
    OSMesaDestroyContext(context);
    return lines;
}

Lines answersOfLibrary(int section) {
    Lines lines;
    static unsigned char pixels[8 * 8 * 4];
    rtInit(nullptr, nullptr);
    rtThreads(1);
    rtSetFrameBuffer(pixels, 8, 8, RT_RGBA_8);
    transcribeLibrary(section, append, &lines);
    rtExit();
    return lines;
}

class FixedStateAndMesa : public testing::TestWithParam<int> {};

TEST_P(FixedStateAndMesa, AnswerTheSame) {
    const Lines expected = answersOfMesa(GetParam()), found = answersOfLibrary(GetParam());
    ASSERT_GT(expected.size(), 15u);
    EXPECT_EQ(found.size(), expected.size());
    std::string call;
    int shown = 0;
    for (std::size_t i = 0; i < std::min(expected.size(), found.size()) && shown < 20; ++i) {
        if (expected[i].find(": ") != std::string::npos) call = expected[i];
        EXPECT_EQ(found[i], expected[i]) << "line " << i << " after " << call;
        shown += found[i] != expected[i];
    }
}

INSTANTIATE_TEST_SUITE_P(Sections, FixedStateAndMesa, testing::Range(0, int(STATE_SECTIONS)),
                         [](const testing::TestParamInfo<int>& section) {
                             return std::string(stateSectionNames[section.param]);
                         });

// What only the library has, and what OpenGL leaves open.

class FixedState : public testing::Test {
protected:
    void SetUp() override {
        rtInit(nullptr, nullptr);
        rtThreads(1);
        rtSetFrameBuffer(pixels_, 8, 8, RT_RGBA_8);
    }
    void TearDown() override { rtExit(); }

    unsigned char pixels_[8 * 8 * 4] = {};
};

TEST_F(FixedState, TranscriptsDifferIfTheStateDoes) {
    Lines first, second;
    transcribeLibrary(0, append, &first);
    rtLineWidth(3);
    transcribeLibrary(0, append, &second);
    ASSERT_EQ(first.size(), second.size());
    EXPECT_NE(first, second);
}

TEST_F(FixedState, DepthTestIsOnUntilAProgramClearsOrChooses) {
    EXPECT_TRUE(rtIsEnabled(RT_DEPTH_TEST));
    rtClear(RT_COLOR_BUFFER_BIT);
    EXPECT_FALSE(rtIsEnabled(RT_DEPTH_TEST));
    rtEnable(RT_DEPTH_TEST);
    rtClear(RT_COLOR_BUFFER_BIT);
    EXPECT_TRUE(rtIsEnabled(RT_DEPTH_TEST));
    EXPECT_EQ(rtGetError(), RTenum(RT_NO_ERROR));
}

TEST_F(FixedState, RefusesOnceForEachFunctionAndSwitch) {
    const auto twice = [](auto call, RTenum first) {
        call();
        EXPECT_EQ(rtGetError(), first);
        call();
        EXPECT_EQ(rtGetError(), RTenum(RT_NO_ERROR));
    };
    twice([] { rtEnable(RT_STENCIL_TEST); }, RT_INVALID_OPERATION);
    EXPECT_FALSE(rtIsEnabled(RT_STENCIL_TEST));
    twice([] { rtEnable(RT_COLOR_SUM); }, RT_NO_ERROR);
    EXPECT_TRUE(rtIsEnabled(RT_COLOR_SUM));
    twice([] { rtEnable(RT_TEXTURE_3D); }, RT_INVALID_OPERATION);
    twice([] { rtAccum(RT_ACCUM, 1); }, RT_INVALID_OPERATION);
    twice([] { rtEvalCoord1f(1); }, RT_INVALID_OPERATION);
    twice([] { rtEvalCoord1d(1); }, RT_INVALID_OPERATION);
    twice([] { rtIndexi(1); }, RT_INVALID_OPERATION);
    twice([] { rtDisable(RT_STENCIL_TEST); }, RT_NO_ERROR);
}

TEST_F(FixedState, OwnSwitchesAndMaterial) {
    for (const RTenum cap : {RT_SHADOWS, RT_REFLECTIONS}) {
        EXPECT_FALSE(rtIsEnabled(cap));
        rtEnable(cap);
        EXPECT_TRUE(rtIsEnabled(cap));
        rtPushAttrib(RT_ENABLE_BIT);
        rtDisable(cap);
        rtPopAttrib();
        EXPECT_TRUE(rtIsEnabled(cap));
    }
    rtShadeModel(RT_PHONG);
    RTint model = 0;
    rtGetIntegerv(RT_SHADE_MODEL, &model);
    EXPECT_EQ(model, RT_PHONG);
    rtMaterialf(RT_FRONT, RT_REFLECTION, 0.5f);
    RTfloat front = 0, back = 1;
    rtGetMaterialfv(RT_FRONT, RT_REFLECTION, &front);
    rtGetMaterialfv(RT_BACK, RT_REFLECTION, &back);
    EXPECT_EQ(front, 0.5f);
    EXPECT_EQ(back, 0.0f);
    EXPECT_EQ(rtGetError(), RTenum(RT_NO_ERROR));
    for (const RTfloat wrong : {-0.1f, 1.1f, NAN}) {
        rtMaterialf(RT_FRONT, RT_REFLECTION, wrong);
        EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_VALUE));
    }
    rtGetMaterialfv(RT_FRONT, RT_REFLECTION, &front);
    EXPECT_EQ(front, 0.5f);
}

TEST_F(FixedState, SwitchesOfLightsAreOfTwoGroups) {
    for (const RTbitfield group : {RT_ENABLE_BIT, RT_LIGHTING_BIT, RT_FOG_BIT}) {
        rtEnable(RT_LIGHT3);
        rtDisable(RT_LIGHT5);
        rtPushAttrib(group);
        rtDisable(RT_LIGHT3);
        rtEnable(RT_LIGHT5);
        rtPopAttrib();
        EXPECT_EQ(rtIsEnabled(RT_LIGHT3), group != RT_FOG_BIT);
        EXPECT_EQ(rtIsEnabled(RT_LIGHT5), group == RT_FOG_BIT);
    }
}

const RTfloat kNotNumbers[4] = {1, 1, NAN, 1};

// Each wrong call, all answers before and after.
TEST_F(FixedState, NullAndNotANumberChangeNothing) {
    const RTfloat ones[4] = {1, 1, 1, 1};
    const std::vector<std::pair<RTenum, void (*)()>> calls = {
        {RT_INVALID_VALUE, [] { rtLightfv(RT_LIGHT0, RT_AMBIENT, nullptr); }},
        {RT_INVALID_ENUM, [] { rtLightfv(RT_LIGHT0, RT_SHININESS, nullptr); }},
        {RT_INVALID_ENUM, [] { rtLightf(RT_LIGHT0, RT_AMBIENT, 1); }},
        {RT_INVALID_VALUE, [] { rtLightf(RT_LIGHT0, RT_SPOT_EXPONENT, NAN); }},
        {RT_INVALID_VALUE, [] { rtLightf(RT_LIGHT0, RT_SPOT_CUTOFF, NAN); }},
        {RT_INVALID_VALUE, [] { rtLightf(RT_LIGHT0, RT_LINEAR_ATTENUATION, NAN); }},
        {RT_INVALID_VALUE, [] { rtLightModeliv(RT_LIGHT_MODEL_AMBIENT, nullptr); }},
        {RT_INVALID_ENUM, [] { rtLightModelf(RT_LIGHT_MODEL_COLOR_CONTROL, NAN); }},
        {RT_INVALID_ENUM, [] { rtLightModelf(RT_LIGHT_MODEL_AMBIENT, 1); }},
        {RT_INVALID_ENUM, [] { rtFogi(RT_FOG_COLOR, 1); }},
        {RT_INVALID_ENUM, [] { rtTexGenf(RT_S, RT_OBJECT_PLANE, 1); }},
        {RT_INVALID_VALUE, [] { rtMaterialfv(RT_FRONT, RT_DIFFUSE, nullptr); }},
        {RT_INVALID_ENUM, [] { rtMaterialf(RT_FRONT, RT_DIFFUSE, 1); }},
        {RT_INVALID_VALUE, [] { rtMaterialf(RT_FRONT, RT_SHININESS, NAN); }},
        {RT_INVALID_OPERATION,
         [] {
             const RTint indices[3] = {1, 2, 3};
             rtMaterialiv(RT_FRONT, RT_COLOR_INDEXES, indices);
         }},
        {RT_INVALID_VALUE, [] { rtFogfv(RT_FOG_COLOR, nullptr); }},
        {RT_INVALID_VALUE, [] { rtFogf(RT_FOG_DENSITY, NAN); }},
        {RT_INVALID_ENUM, [] { rtFogf(RT_FOG_MODE, 1e30f); }},
        {RT_INVALID_VALUE, [] { rtPointParameterf(RT_POINT_SIZE_MIN, NAN); }},
        {RT_INVALID_VALUE, [] { rtPointParameterfv(RT_POINT_SIZE_MAX, nullptr); }},
        {RT_INVALID_ENUM, [] { rtPointParameterf(RT_POINT_DISTANCE_ATTENUATION, 1); }},
        {RT_INVALID_VALUE, [] { rtTexEnvfv(RT_TEXTURE_ENV, RT_TEXTURE_ENV_COLOR, nullptr); }},
        {RT_INVALID_ENUM, [] { rtTexEnvf(RT_TEXTURE_ENV, RT_TEXTURE_ENV_COLOR, 1); }},
        {RT_INVALID_VALUE, [] { rtTexEnvf(RT_TEXTURE_ENV, RT_RGB_SCALE, NAN); }},
        {RT_INVALID_VALUE, [] { rtTexGendv(RT_S, RT_EYE_PLANE, nullptr); }},
        {RT_INVALID_VALUE, [] { rtClipPlane(RT_CLIP_PLANE0, nullptr); }},
        {RT_INVALID_VALUE, [] { rtPolygonStipple(nullptr); }},
        {RT_INVALID_VALUE, [] { rtPointSize(NAN); }},
        {RT_INVALID_VALUE, [] { rtLineWidth(NAN); }},
        {RT_INVALID_VALUE, [] { rtLightfv(RT_LIGHT0, RT_POSITION, kNotNumbers); }},
        {RT_INVALID_VALUE, [] { rtLightfv(RT_LIGHT0, RT_AMBIENT, kNotNumbers); }},
        {RT_INVALID_VALUE, [] { rtLightfv(RT_LIGHT0, RT_SPOT_DIRECTION, kNotNumbers); }},
        {RT_INVALID_VALUE, [] { rtLightModelfv(RT_LIGHT_MODEL_AMBIENT, kNotNumbers); }},
        {RT_INVALID_VALUE, [] { rtLightModelf(RT_LIGHT_MODEL_TWO_SIDE, NAN); }},
        {RT_INVALID_VALUE, [] { rtMaterialfv(RT_FRONT, RT_DIFFUSE, kNotNumbers); }},
        {RT_INVALID_VALUE, [] { rtFogf(RT_FOG_START, NAN); }},
        {RT_INVALID_VALUE, [] { rtFogfv(RT_FOG_COLOR, kNotNumbers); }},
        {RT_INVALID_VALUE, [] { rtPolygonOffset(NAN, 1); }},
        {RT_INVALID_VALUE, [] { rtPolygonOffset(1, NAN); }},
        {RT_INVALID_VALUE,
         [] { rtTexEnvf(RT_TEXTURE_FILTER_CONTROL, RT_TEXTURE_LOD_BIAS, NAN); }},
        {RT_INVALID_VALUE,
         [] { rtTexEnvfv(RT_TEXTURE_ENV, RT_TEXTURE_ENV_COLOR, kNotNumbers); }},
        {RT_INVALID_VALUE, [] { rtTexGenfv(RT_S, RT_OBJECT_PLANE, kNotNumbers); }},
        {RT_INVALID_VALUE, [] { rtTexGenfv(RT_S, RT_EYE_PLANE, kNotNumbers); }},
        {RT_INVALID_VALUE,
         [] {
             const RTdouble plane[4] = {1, 1, 1, NAN};
             rtClipPlane(RT_CLIP_PLANE0, plane);
         }},
        {RT_INVALID_VALUE,
         [] { rtPointParameterfv(RT_POINT_DISTANCE_ATTENUATION, kNotNumbers); }},
        {RT_INVALID_VALUE, [] { rtBlendColor(1, 1, 1, NAN); }},
        {RT_INVALID_VALUE, [] { rtAlphaFunc(RT_LESS, NAN); }},
        {RT_INVALID_VALUE, [] { rtClearAccum(1, 1, NAN, 1); }},
        {RT_INVALID_VALUE, [] { rtSampleCoverage(NAN, RT_TRUE); }},
        {RT_INVALID_ENUM, [] { rtActiveTexture(RT_TEXTURE4); }},
        {RT_INVALID_ENUM, [] { rtClientActiveTexture(RT_TEXTURE4); }},
        {RT_INVALID_ENUM, [] { rtMultiTexCoord2f(RT_TEXTURE4, 1, 1); }},
        {RT_INVALID_VALUE, [] { rtMultiTexCoord2fv(RT_TEXTURE0, nullptr); }},
        {RT_INVALID_VALUE, [] { rtSecondaryColor3ubv(nullptr); }},
        {RT_INVALID_VALUE, [] { rtFogCoorddv(nullptr); }},
        {RT_INVALID_VALUE, [] { rtEdgeFlagv(nullptr); }},
        {RT_INVALID_VALUE, [] { rtGetLightfv(RT_LIGHT0, RT_AMBIENT, nullptr); }},
        {RT_INVALID_VALUE, [] { rtGetMaterialiv(RT_FRONT, RT_AMBIENT, nullptr); }},
        {RT_INVALID_VALUE, [] { rtGetTexEnviv(RT_TEXTURE_ENV, RT_RGB_SCALE, nullptr); }},
        {RT_INVALID_VALUE, [] { rtGetTexGendv(RT_S, RT_EYE_PLANE, nullptr); }},
        {RT_INVALID_VALUE, [] { rtGetClipPlane(RT_CLIP_PLANE0, nullptr); }},
        {RT_INVALID_VALUE, [] { rtGetPolygonStipple(nullptr); }},
        {RT_INVALID_OPERATION, [] { rtRenderMode(RT_SELECT); }},
        {RT_INVALID_OPERATION, [] { rtRenderMode(RT_FEEDBACK); }},
    };
    rtLightfv(RT_LIGHT0, RT_AMBIENT, ones);
    Lines before, after;
    transcribeLibrary(0, append, &before);
    for (std::size_t i = 0; i < calls.size(); ++i) {
        calls[i].second();
        EXPECT_EQ(rtGetError(), calls[i].first) << "call " << i;
        after.clear();
        transcribeLibrary(0, append, &after);
        EXPECT_EQ(after, before) << "call " << i;
    }
}

TEST_F(FixedState, NotLegalInObjectsButForMaterials) {
    rtNewObject(RT_DEFINE);
    const std::vector<void (*)()> calls = {
        [] { rtEnable(RT_FOG); },
        [] { rtShadeModel(RT_FLAT); },
        [] { rtLightf(RT_LIGHT0, RT_SPOT_CUTOFF, 4); },
        [] { rtFogf(RT_FOG_DENSITY, 2); },
        [] { rtTexEnvi(RT_TEXTURE_ENV, RT_TEXTURE_ENV_MODE, RT_DECAL); },
        [] { rtCullFace(RT_FRONT); },
        [] { rtLineWidth(2); },
        [] { rtBlendFunc(RT_ONE, RT_ONE); },
        [] { rtDepthMask(RT_FALSE); },
        [] { rtStencilMask(1); },
        [] { rtPushAttrib(RT_ALL_ATTRIB_BITS); },
        [] { rtPopAttrib(); },
        [] { rtHint(RT_FOG_HINT, RT_NICEST); },
    };
    for (std::size_t i = 0; i < calls.size(); ++i) {
        calls[i]();
        EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_OPERATION)) << "call " << i;
    }
    rtMaterialf(RT_FRONT, RT_SHININESS, 7);
    RTfloat shininess = 0;
    rtGetMaterialfv(RT_FRONT, RT_SHININESS, &shininess);
    EXPECT_EQ(shininess, 7.0f);
    rtEndObject();
    rtGetMaterialfv(RT_FRONT, RT_SHININESS, &shininess);
    EXPECT_EQ(shininess, 0.0f);
    EXPECT_EQ(rtGetError(), RTenum(RT_NO_ERROR));
}

} // namespace
