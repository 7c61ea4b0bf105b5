// SPDX-License-Identifier: MIT
// Classes that are refused, constructors that fail late, and shaders that are removed while a
// frame uses them.
#include <atomic>
#include <chrono>
#include <functional>
#include <stdexcept>
#include <string>
#include <thread>

#include "tests/shaders/shader_picture.h"

namespace smart::test {
namespace {

using namespace openrt;

class MisbehavingClasses : public ShaderPicture {
protected:
    /// Refused with a text, and nothing else happens.
    static void expectRefused(RTuint answer) {
        EXPECT_EQ(answer, RT_INVALID);
        const RTenum error = rtGetError();
        EXPECT_EQ(error, RTenum(RT_INVALID_VALUE));
        EXPECT_GT(std::string(rtGetErrorText()).size(), 10u);
    }
};

int constructNothing(void*, void*, void*) {
    return 0;
}
int shadeNothing(const void*, RTSstate*) {
    return 0;
}
RTshaderclass soundClass() {
    RTshaderclass c{};
    c.structSize = sizeof c;
    c.interfaceVersion = RTS_INTERFACE_VERSION;
    c.kind = RT_SURFACE_SHADER;
    c.name = "Sound";
    c.alignment = 1;
    c.construct = constructNothing;
    c.shade = shadeNothing;
    return c;
}

TEST_F(MisbehavingClasses, DescriptorsThatDoNotAddUpAreRefused) {
    const RTshaderclass sound = soundClass();
    EXPECT_NE(rtRegisterShaderClass(&sound), RT_INVALID) << "the control";
    static const RTSparameter beyond[] = {{"p", RTS_PER_SHADER, RTS_FLOAT1, 8, 4}};
    static const RTSparameter small[] = {{"p", RTS_PER_SHADER, RTS_FLOAT3, 0, 4}};
    static const RTSparameter wrap[] = {{"p", RTS_PER_SHADER, RTS_RAW, 0xFFFFFFFCu, 8}};
    static const RTSparameter nameless[] = {{nullptr, RTS_PER_SHADER, RTS_FLOAT1, 0, 4}};
    static const RTSparameter twice[] = {{"p", RTS_PER_SHADER, RTS_FLOAT1, 0, 4},
                                         {"p", RTS_PER_SHADER, RTS_FLOAT1, 4, 4}};
    static const RTSparameter typeless[] = {{"p", RTS_PER_SHADER, RTStype(99), 0, 4}};
    static const RTSparameter scopeless[] = {{"p", RTSscope(7), RTS_FLOAT1, 0, 4}};
    static const RTSparameter vertexInt[] = {{"p", RTS_PER_VERTEX, RTS_INT1, 0, 4}};
    const auto with = [](const RTSparameter* list, RTuint count) {
        return [=](RTshaderclass& c) {
            c.shaderSize = c.vertexSize = 8;
            c.parameters = list;
            c.parameterCount = count;
        };
    };
    const std::function<void(RTshaderclass&)> spoils[] = {
        [](RTshaderclass& c) { c.structSize = 0; },
        [](RTshaderclass& c) { c.structSize = 20; },
        [](RTshaderclass& c) { c.interfaceVersion = RTS_INTERFACE_VERSION + 1; },
        [](RTshaderclass& c) { c.interfaceVersion = 0; },
        [](RTshaderclass& c) { c.kind = 0x1234; },
        [](RTshaderclass& c) { c.name = nullptr; },
        [](RTshaderclass& c) { c.name = ""; },
        [](RTshaderclass& c) { c.construct = nullptr; },
        [](RTshaderclass& c) { c.shade = nullptr; },
        [](RTshaderclass& c) { c.kind = RT_LIGHT_SHADER; },
        [](RTshaderclass& c) { c.kind = RT_CAMERA_SHADER; },
        [](RTshaderclass& c) { c.kind = RT_RENDERING_OBJECT_SHADER; },
        [](RTshaderclass& c) { c.alignment = 3; },
        [](RTshaderclass& c) { c.alignment = 128; },
        [](RTshaderclass& c) { c.vertexSize = 2; },
        [](RTshaderclass& c) { c.vertexSize = 4 * 257; },
        [](RTshaderclass& c) { c.parameterCount = 1; },
        with(beyond, 1),
        with(small, 1),
        with(wrap, 1),
        with(nameless, 1),
        with(twice, 2),
        with(typeless, 1),
        with(scopeless, 1),
        with(vertexInt, 1),
    };
    int number = 0;
    for (const auto& spoil : spoils) {
        SCOPED_TRACE(number++);
        RTshaderclass spoilt = soundClass();
        spoil(spoilt);
        expectRefused(rtRegisterShaderClass(&spoilt));
    }
    expectRefused(rtRegisterShaderClass(nullptr));
}

struct ThrowsWhenMade {
    ThrowsWhenMade() { throw std::runtime_error("not today"); }
    void shade(TraceContext&) const {}
};
struct ThrowsWhenAsked {
    float value = 0;
    void registerParams(const ShaderRegistrator&) const { throw std::runtime_error("no list"); }
    void shade(TraceContext&) const {}
};

TEST_F(MisbehavingClasses, AConstructorThatThrowsIsAnErrorText) {
    expectRefused(rtGenNewShaderClass<ThrowsWhenMade>("ThrowsWhenMade"));
    EXPECT_THROW(rtGenNewShaderClass<ThrowsWhenAsked>("ThrowsWhenAsked"), std::runtime_error);
    EXPECT_EQ(rtGenNewShader(), RT_INVALID);
    EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_OPERATION));
}

struct ThrowsLater {
    static inline std::atomic<int> left = 0; ///< how many more can be made
    ThrowsLater() {
        if (left-- <= 0) throw std::runtime_error("worn out");
    }
    float value = 0.5f;
    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<float>("value", PER_SHADER, offsetof(ThrowsLater, value));
    }
    void shade(TraceContext& c) const { c.setRadiance(Color(value)); }
};

TEST_F(MisbehavingClasses, AConstructorThatThrowsLaterStopsOnlyFramesThatNeedIt) {
    ThrowsLater::left = 3; // for the descriptor, the class's defaults and one frame
    const RTuint good = constant(Color(0.25f));
    ASSERT_NE(rtGenNewShaderClass<ThrowsLater>("ThrowsLater"), RT_INVALID);
    const RTuint shader = rtGenNewShader();
    ThrowsLater::left = 1;
    rectangle(shader, 0, 0, 16, 16, 0);
    EXPECT_EQ(render().at(3, 3)[0], 0.5f);
    expectReported(0);

    rtBindShader(shader);
    set("value", 0.75f); // has to be made anew
    rectangle(good, 0, 0, 16, 16, 0);
    EXPECT_EQ(render().at(3, 3)[0], 0.25f) << "a frame that does not use it";
    expectReported(0);
    rectangle(good, 0, 0, 8, 16, 0);
    rectangle(shader, 8, 0, 16, 16, 0);
    EXPECT_EQ(render().at(3, 3)[0], 0.25f);
    EXPECT_EQ(blackPixels(shown()), pixelsWhere([](int x, int) { return x >= 8; }));
    expectReported(128);

    ThrowsLater::left = 1;
    rtBindShader(shader);
    set("value", 0.625f); // and now it can be made
    rectangle(shader, 0, 0, 16, 16, 0);
    EXPECT_EQ(render().at(3, 3)[0], 0.625f);
    expectReported(0);
}

struct CameraThatThrowsLater : ThrowsLater {
    static constexpr ShaderKind kind = ShaderKind::Camera;
    void initPrimaryRay(float, float, TraceContext& c) const { c.setRay({0, 0, 5}, {0, 0, -1}); }
};

TEST_F(MisbehavingClasses, AFrameIsNotStartedWithoutItsCamera) {
    const RTuint good = constant(Color(0.25f));
    ThrowsLater::left = 3;
    ASSERT_NE(rtGenNewShaderClass<CameraThatThrowsLater>("CameraThatThrowsLater"), RT_INVALID);
    const RTuint camera = rtGenNewShader();
    ThrowsLater::left = 0;
    rectangle(good, 0, 0, 16, 16, 0);
    rtUseCamera(camera);
    rtRender();
    EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_OPERATION));
    EXPECT_NE(std::string(rtGetErrorText()).find("CameraThatThrowsLater"), std::string::npos);
    ThrowsLater::left = 1;
    rtBindShader(camera);
    set("value", 1.0f);
    EXPECT_EQ(render().at(3, 3)[0], 0.25f) << "the scene had stayed";
    expectReported(0);
}

std::atomic<bool> frameMayGoOn;
std::atomic<int> waiting;

/// Waits in the frame until the test lets it go on; then shows what it was frozen with.
template <int kind>
struct Slow {
    float value = 0.25f;
    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<float>("value", PER_SHADER, offsetof(Slow, value));
    }
    void shade(TraceContext& c) const {
        ++waiting;
        while (!frameMayGoOn) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        c.setRadiance(Color(value));
    }
};
struct SlowEnvironment : Slow<1> {
    static constexpr openrt::ShaderKind kind = ShaderKind::Environment;
};

TEST_F(MisbehavingClasses, WhatAFrameInFlightUsesMayBeRemoved) {
    for (int round = 0; round < 3; ++round) {
        frameMayGoOn = false;
        waiting = 0;
        const RTuint surfaceClass = rtGenNewShaderClass<Slow<0>>("Slow");
        const RTuint surface = rtGenNewShader();
        set("value", 0.5f);
        const RTuint environmentClass = rtGenNewShaderClass<SlowEnvironment>("SlowEnvironment");
        const RTuint environment = rtGenNewShader();
        rtUseEnvironmentShader(environment);
        const RTuint light = builtin("DirectionalLight");
        rtUseLight(light);
        const RTuint object = rtNewObject(RT_DEFINE);
        rectangle(surface, 0, 0, 8, 16, 0);
        rtEndObject();
        rtInstantiateObjectShader(object, surface);
        rtStartRendering();
        while (waiting == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));

        rtBindShader(surface);
        set("value", 0.0f);
        for (const RTuint shader : {surface, environment, light}) rtRemoveShader(shader);
        rtRemoveShaderClass(surfaceClass);
        rtRemoveShaderClass(environmentClass);
        rtRemoveObject(object);
        rectangle(constant(Color(1.0f)), 0, 0, 16, 16, 0); // of the next frame
        frameMayGoOn = true;
        rtEndRendering();
        expectReported(0);
        for (int x = 0; x < kPictureSize; ++x)
            EXPECT_EQ(shown().at(x, 5)[0], x < kPictureSize / 2 ? 0.5f : 0.25f);
        const SmallPicture next = render();
        for (int x = 0; x < kPictureSize; ++x) EXPECT_EQ(next.at(x, 5)[0], 1);
        expectReported(0);
    }
}

TEST_F(MisbehavingClasses, APluginStaysLoadedAsLongAsAFrameUsesIt) {
    rtRecursionLimit(9); // some hundred rays a pixel: the frame outlasts the calls below
    SmallPicture first;
    for (int round = 0; round < 4; ++round) {
        const RTuint shaderClass = rtGenNewShaderClass("TracesForever", OPENRT_TEST_CPP_PLUGIN);
        ASSERT_NE(shaderClass, RT_INVALID) << rtGetErrorText();
        const RTuint shader = rtGenNewShader();
        rectangle(shader, 0, 0, 16, 16, 0);
        rtStartRendering();
        rtRemoveShader(shader);
        rtRemoveShaderClass(shaderClass);
        if (round == 3) break; // rtExit waits for it
        rtEndRendering();
        expectReported(0);
        if (round == 0) first = shown();
        EXPECT_EQ(shown(), first);
        EXPECT_GT(shown().at(3, 3)[0], 0.25f);
    }
}

} // namespace
} // namespace smart::test
