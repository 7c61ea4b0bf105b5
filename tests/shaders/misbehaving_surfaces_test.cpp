// SPDX-License-Identifier: MIT
// A surface that misbehaves costs its own pixels and nothing else: the frame completes, all other
// pixels have the bits of a frame without it, the count is exact.
#include "tests/shaders/misbehaving_surfaces.h"

#include <string>

#include "tests/shaders/misbehaving.h"
#include "tests/shaders/shader_picture.h"

namespace smart::test {
namespace {

using namespace misbehaving;

template <class T>
RTuint linkedIn(const char* name) {
    return rtGenNewShaderClass<T>(name);
}
RTuint linkedInC(const char* name) {
    return rtRegisterShaderClass(misbehavingClass(name));
}

struct Case {
    const char* name;
    bool bad; ///< its pixels are black and counted
    RTuint (*registerClass)(const char*);
    const char* library;
};

constexpr const char* kCpp = OPENRT_TEST_CPP_PLUGIN;
constexpr const char* kC = OPENRT_TEST_C_PLUGIN;

const Case kCases[] = {
    {"ThrowsNumber", true, linkedIn<ThrowsNumber>, kCpp},
    {"ThrowsException", true, linkedIn<ThrowsException>, kCpp},
    {"ThrowsInPacket", true, linkedIn<ThrowsInPacket>, kCpp},
    {"NanRadiance", true, linkedIn<NanRadiance>, kCpp},
    {"InfiniteRadiance", true, linkedIn<InfiniteRadiance>, kCpp},
    {"NanAlpha", true, linkedIn<NanAlpha>, kCpp},
    {"NanInPacket", true, linkedIn<NanInPacket>, kCpp},
    {"OverflowsInTrace", true, linkedIn<OverflowsInTrace>, kCpp},
    {"ReturnsFault", true, linkedInC, kC},
    {"ReturnsFaultInPacket", true, linkedInC, kC},
    {"DividesByZero", true, linkedInC, kC},
    {"NeverWrites", false, linkedIn<NeverWrites>, kCpp},
    {"TracesForever", false, linkedIn<TracesForever>, kCpp},
    {"TracesForeverInPackets", false, linkedIn<TracesForeverInPackets>, kCpp},
    {"TracesNonsense", false, linkedIn<TracesNonsense>, kCpp},
    {"StrangeWeights", false, linkedIn<StrangeWeights>, kCpp},
    {"AsksAbsentLights", false, linkedIn<AsksAbsentLights>, kCpp},
    {"UnknownTextures", false, linkedIn<UnknownTextures>, kCpp},
    {"WritesForeignLanes", false, linkedIn<WritesForeignLanes>, kCpp},
};

class MisbehavingSurfaces : public ShaderPicture {
protected:
    MisbehavingSurfaces() {
        steady_ = constant({0.25f, 0.75f, 0.5f});
        lit_ = builtin("Phong");
        set("diffuse", openrt::Color(0.9f, 0.6f, 0.3f));
        set("emissive", openrt::Color(0.125f));
        light_ = builtin("PointLight");
        set("position", openrt::Vec3(0.3f, 0.2f, 4));
        set("radiance", openrt::Color(9.0f));
    }

    /// Two surfaces, light and shadow; and the one that misbehaves, in front.
    void describe(RTuint misbehaving) {
        rtUseLight(light_);
        rectangle(steady_, 0, 0, 8, 16, 0);
        rectangle(lit_, 8, 0, 16, 16, 0);
        rectangle(steady_, 12, 11, 14, 13, 1);
        rectangle(misbehaving, 5, 4, 11, 9, 2);
    }
    static PixelSet covered() {
        return pixelsWhere([](int x, int y) { return x >= 5 && x < 11 && y >= 4 && y < 9; });
    }

    RTuint steady_, lit_, light_;
};

/// Renders every case in its turn, with some samples a pixel; the library forgets each.
class MisbehavingSurfacesEach : public MisbehavingSurfaces,
                                public testing::WithParamInterface<int> {
protected:
    void check(bool fromPlugin) {
        rtSamples(RTuint(GetParam()));
        // What is compared with: another surface, which throws the same shadow.
        const RTuint stand = constant(openrt::Color(1.0f));
        describe(stand);
        const SmallPicture reference = render();
        expectReported(0);
        for (const Case& each : kCases) {
            SCOPED_TRACE(each.name);
            const RTuint shaderClass =
                fromPlugin ? rtGenNewShaderClass(each.name, each.library)
                           : each.registerClass(each.name);
            ASSERT_NE(shaderClass, RT_INVALID) << rtGetErrorText();
            const RTuint shader = rtGenNewShader();
            ASSERT_NE(shader, RT_INVALID);
            describe(shader);
            const SmallPicture picture = render();
            for (const auto& [x, y] : differences(picture, reference))
                EXPECT_TRUE(covered().contains({x, y})) << x << ", " << y;
            if (each.bad) {
                EXPECT_EQ(blackPixels(picture), covered());
                expectReported(covered().size());
            } else {
                for (const float value : picture.values) EXPECT_TRUE(std::isfinite(value));
                expectReported(0);
            }
            if (std::string(each.name) == "UnknownTextures") {
                EXPECT_EQ(picture.at(6, 6)[0], 1);
            }
            if (std::string(each.name) == "AsksAbsentLights") {
                EXPECT_EQ(picture.at(6, 6)[0], 0.25f);
            }
            if (std::string(each.name) == "NeverWrites") {
                EXPECT_EQ(blackPixels(picture), covered());
            }
            if (std::string(each.name) == "WritesForeignLanes") {
                EXPECT_EQ(picture.at(6, 6)[2], 0.75f);
            }
            rtRemoveShader(shader);
            rtRemoveShaderClass(shaderClass);
            expectNoError();
        }
        describe(stand);
        EXPECT_EQ(render(), reference) << "nothing of them is left";
        expectReported(0);
    }
};

TEST_P(MisbehavingSurfacesEach, LinkedInCostsItsPixels) {
    check(false);
}
TEST_P(MisbehavingSurfacesEach, FromAPluginCostsItsPixels) {
    check(true);
}
INSTANTIATE_TEST_SUITE_P(Samples, MisbehavingSurfacesEach, testing::Values(1, 3));

TEST_F(MisbehavingSurfaces, FiniteSamplesWithAnInfiniteSumAreBad) {
    struct Blinding {
        void shade(openrt::TraceContext& c) const { c.setRadiance(openrt::Color(kMax)); }
    };
    const RTuint shader = own<Blinding>("Blinding");
    rectangle(shader, 0, 0, 4, 4, 0);
    const SmallPicture one = render();
    EXPECT_EQ(one.at(1, 1)[0], kMax);
    expectReported(0);
    rtSamples(4);
    rectangle(shader, 0, 0, 4, 4, 0);
    const SmallPicture four = render();
    EXPECT_TRUE(blackPixels(four).contains({1, 1}));
    expectReported(16);
}

TEST_F(MisbehavingSurfaces, SecondaryRaysCarryTheFault) {
    // A mirror tilted so that it shows what lies to the right of it.
    const RTuint mirror = builtin("MirrorShader");
    const RTuint bad = own<ThrowsNumber>("ThrowsNumber");
    const auto scene = [&](RTuint shown) {
        rectangle(steady_, 8, 0, 16, 16, -5);
        rtBindShader(mirror);
        rtNormal3f(1, 0, 1);
        rtBegin(RT_QUADS);
        rtVertex3f(-1, -0.5f, 0.5f);
        rtVertex3f(-0.5f, -0.5f, 0);
        rtVertex3f(-0.5f, 0.5f, 0);
        rtVertex3f(-1, 0.5f, 0.5f);
        rtEnd();
        rtBindShader(shown);
        rtBegin(RT_QUADS); // outside the view
        rtVertex3f(5, -0.25f, 9);
        rtVertex3f(5, -0.25f, -9);
        rtVertex3f(5, 0.25f, -9);
        rtVertex3f(5, 0.25f, 9);
        rtEnd();
    };
    scene(steady_);
    const SmallPicture reference = render();
    scene(bad);
    const SmallPicture picture = render();
    const PixelSet showing =
        pixelsWhere([](int x, int y) { return x < 4 && y >= 6 && y < 10; });
    EXPECT_EQ(differences(picture, reference), showing);
    EXPECT_EQ(blackPixels(picture), [&] {
        PixelSet black = blackPixels(reference);
        black.insert(showing.begin(), showing.end());
        return black;
    }());
    expectReported(showing.size());
}

/// Uses what its ray brings only as far as it is a number.
struct Swallows {
    void shade(openrt::TraceContext& c) const {
        const openrt::Color seen = c.trace(c.position(), c.rayDirection());
        const openrt::Color around = c.environment(c.rayDirection());
        c.setRadiance({std::fmin(seen.r, 0.5f), std::fmin(seen.g, 0.5f), std::fmin(around.b, 0.5f)});
    }
};
struct SwallowsInPackets {
    static constexpr bool shadesPackets = true;
    template <class Context>
    void shade(Context& c) const {
        typename Context::Color seen = c.trace(c.position(), c.rayDirection());
        seen = select(seen.g < 0.5f, seen, typename Context::Color(openrt::Color(0.5f)));
        const typename Context::Color around = c.environment(c.rayDirection());
        c.setRadiance(select(around.b < 0.5f, seen, typename Context::Color()));
    }
};
struct NanAround : NanRadiance {
    static constexpr openrt::ShaderKind kind = openrt::ShaderKind::Environment;
};

TEST_F(MisbehavingSurfaces, WhatIsNoNumberCanNotBeHiddenByWhoeverAskedForIt) {
    for (const RTuint asking :
         {own<Swallows>("Swallows"), own<SwallowsInPackets>("SwallowsInPackets")}) {
        rectangle(asking, 0, 0, 16, 8, 1);
        rectangle(steady_, 0, 0, 16, 16, 0);
        EXPECT_EQ(render().at(1, 1)[1], 0.5f);
        expectReported(0);
        rectangle(asking, 0, 0, 16, 8, 1);
        rectangle(own<NanRadiance>("NanRadiance"), 0, 0, 16, 16, 0);
        EXPECT_EQ(blackPixels(render()), pixelsWhere([](int, int) { return true; }));
        expectReported(256);
        rectangle(asking, 0, 0, 16, 8, 1);
        rectangle(steady_, 0, 0, 16, 16, 0);
        rtUseEnvironmentShader(own<NanAround>("NanAround"));
        EXPECT_EQ(blackPixels(render()), pixelsWhere([](int, int y) { return y < 8; }));
        expectReported(128);
    }
}

/// Transparencies that are no share of light.
template <int what>
struct Pane {
    void shade(openrt::TraceContext& c) const { c.setRadiance(openrt::Color(0.5f)); }
    openrt::Color transparency(openrt::TraceContext& c) const {
        switch (what) {
        case 0: throw 1;
        case 1: return {1, kNan, 1};
        case 2: return {1, kInf, 1};
        case 3: return openrt::Color(2.0f);  // as much as there is
        case 4: return openrt::Color(-1.0f); // nothing
        case 5: {
            // While transparency is asked nothing is traced.
            RTShitinfo hit;
            const bool traced = c.traceHit(c.position(), {0, 0, 1}, hit) ||
                                !c.shadow(c.position(), {0, 0, 1}, 1).black() ||
                                !c.trace(c.position(), {0, 0, 1}).black();
            return openrt::Color(traced ? 0.0f : 1.0f);
        }
        default: return openrt::Color(1.0f);
        }
    }
};

TEST_F(MisbehavingSurfaces, TransparencyThatIsNoneCostsWhatIsShaded) {
    // Light falls along (-1, 0, -1): a pane at z = 1 shadows the place one unit to its left.
    const RTuint sun = builtin("DirectionalLight");
    set("direction", openrt::Vec3(-1, 0, -1));
    const RTuint floor = builtin("Phong");
    set("diffuse", openrt::Color(0.5f));
    const auto picture = [&](RTuint pane) {
        rtUseLight(sun);
        rectangle(floor, 0, 0, 16, 16, 0);
        if (pane) rectangle(pane, 16 + 4, 2, 16 + 7, 9, 2); // twice its height away: x - 16
        return render();
    };
    const PixelSet shadow =
        pixelsWhere([](int x, int y) { return x >= 4 && x < 7 && y >= 2 && y < 9; });
    const SmallPicture open = picture(0);
    EXPECT_TRUE(blackPixels(open).empty());
    const auto check = [&](RTuint pane, const PixelSet& expectedBlack, std::size_t bad) {
        const SmallPicture result = picture(pane);
        EXPECT_EQ(differences(result, open), expectedBlack);
        EXPECT_EQ(blackPixels(result), expectedBlack);
        expectReported(bad);
    };
    {
        SCOPED_TRACE("throws");
        check(own<Pane<0>>("Pane0"), shadow, shadow.size());
    }
    {
        SCOPED_TRACE("NaN");
        check(own<Pane<1>>("Pane1"), shadow, shadow.size());
    }
    {
        SCOPED_TRACE("infinite");
        check(own<Pane<2>>("Pane2"), shadow, shadow.size());
    }
    {
        SCOPED_TRACE("above one");
        check(own<Pane<3>>("Pane3"), {}, 0);
    }
    {
        SCOPED_TRACE("below zero");
        check(own<Pane<4>>("Pane4"), shadow, 0);
    }
    {
        SCOPED_TRACE("traces");
        check(own<Pane<5>>("Pane5"), {}, 0);
    }
}

TEST_F(MisbehavingSurfaces, AHallOfMirrorsEnds) {
    // The viewer stands in a closed box of mirrors.
    rtMatrixMode(RT_PROJECTION);
    rtLoadIdentity();
    rtFrustum(-0.1, 0.1, -0.1, 0.1, 0.1, 100);
    rtMatrixMode(RT_MODELVIEW);
    rtClearColor(1, 1, 1, 1);
    const RTuint mirror = builtin("MirrorShader");
    const float corners[8][3] = {{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1},
                                 {-1, -1, 1},  {1, -1, 1},  {-1, 1, 1},  {1, 1, 1}};
    const int sides[6][4] = {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 2, 6, 4},
                             {1, 5, 7, 3}, {0, 4, 5, 1}, {2, 3, 7, 6}};
    for (const RTuint limit : {0u, 1u, 8u, 256u}) {
        rtRecursionLimit(limit);
        rtBindShader(mirror);
        rtBegin(RT_QUADS);
        for (const auto& side : sides)
            for (const int corner : side) rtVertex3fv(corners[corner]);
        rtEnd();
        const SmallPicture picture = render();
        EXPECT_EQ(blackPixels(picture), pixelsWhere([](int, int) { return true; }));
        EXPECT_EQ(statistic(RT_STAT_SECONDARY_RAYS), int(limit) * kPictureSize * kPictureSize);
        expectReported(0);
    }
}

} // namespace
} // namespace smart::test
