// SPDX-License-Identifier: MIT
// openrt/rt.hpp: overloads by type, and a shader class that is a C++ type.
#include <glm/glm.hpp> // before it: the types convert

#include "openrt/rt.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <stdexcept>

namespace {

struct Glow {
    openrt::Color color{1, 1, 1};
    bool inverted = false;

    void registerParams(const openrt::ShaderRegistrator& r) const {
        r.registerParam<openrt::Color>("color", openrt::PER_SHADER, offsetof(Glow, color));
        r.registerParam<bool>("inverted", openrt::PER_SHADER, offsetof(Glow, inverted));
    }
    void shade(openrt::TraceContext& c) const {
        c.setRadiance(inverted ? openrt::Color(1.0f) - color : color);
    }
};

struct Broken {
    Broken() { throw std::runtime_error("no Broken today"); }
    void shade(openrt::TraceContext&) const {}
};

struct Throwing {
    void shade(openrt::TraceContext&) const { throw 1; }
};

class CppInterface : public testing::Test {
protected:
    CppInterface() {
        rtInit(nullptr, nullptr);
        rtThreads(1);
        rtSetFrameBuffer(reinterpret_cast<RTubyte*>(pixel_), 1, 1, RT_RGB_32F);
    }
    ~CppInterface() override { rtExit(); }

    openrt::Color render() {
        rtBegin(RT_TRIANGLES);
        rtVertex(openrt::Vec2(-9, -9));
        rtVertex(openrt::Vec3(9, -9, 0));
        rtVertex(openrt::Vec4(0, 18, 0, 2));
        rtEnd();
        rtRender();
        return openrt::Color(pixel_);
    }

    float pixel_[3] = {};
};

TEST_F(CppInterface, ShaderClassesAreTypes) {
    ASSERT_NE(rtGenNewShaderClass<Glow>("Glow"), RT_INVALID);
    rtGenNewShader();
    EXPECT_EQ(render(), openrt::Color(1.0f));
    rtParameter(rtParameterHandle("color"), openrt::Color(1, 0.5f, 0));
    EXPECT_EQ(render(), openrt::Color(1, 0.5f, 0));
    rtParameter(rtParameterHandle("inverted"), true);
    EXPECT_EQ(render(), openrt::Color(0, 0.5f, 1));
    ASSERT_NE(rtGenNewShaderClass("Glow", nullptr), RT_INVALID) << "known by its name now";
    ASSERT_NE(rtGenNewShaderClass<Glow>(), RT_INVALID);
    EXPECT_EQ(rtGetError(), RTenum(RT_NO_ERROR));
}

/// A parameter of every type that registerParam takes; shows the one that is asked for.
struct AllTypes {
    struct Pair {
        float a = 0;
        int b = 0;
    };
    bool truth = false;
    int number = 0;
    openrt::TextureId texture;
    openrt::Int2 two;
    openrt::Int3 three;
    float real = 0;
    openrt::Vec2 pair;
    openrt::Vec3 vector;
    openrt::Vec4 four;
    openrt::Color color;
    openrt::Mat4 matrix;
    const char* text = "";
    Pair plain;

    void registerParams(const openrt::ShaderRegistrator& r) const {
        using openrt::PER_SHADER;
        r.registerParam<bool>("truth", PER_SHADER, offsetof(AllTypes, truth));
        r.registerParam<int>("number", PER_SHADER, offsetof(AllTypes, number));
        r.registerParam<openrt::TextureId>("texture", PER_SHADER, offsetof(AllTypes, texture));
        r.registerParam<openrt::Int2>("two", PER_SHADER, offsetof(AllTypes, two));
        r.registerParam<openrt::Int3>("three", PER_SHADER, offsetof(AllTypes, three));
        r.registerParam<float>("real", PER_SHADER, offsetof(AllTypes, real));
        r.registerParam<openrt::Vec2>("pair", PER_SHADER, offsetof(AllTypes, pair));
        r.registerParam<openrt::Vec3>("vector", PER_SHADER, offsetof(AllTypes, vector));
        r.registerParam<openrt::Vec4>("four", PER_SHADER, offsetof(AllTypes, four));
        r.registerParam<openrt::Color>("color", PER_SHADER, offsetof(AllTypes, color));
        r.registerParam<openrt::Mat4>("matrix", PER_SHADER, offsetof(AllTypes, matrix));
        r.registerParam<const char*>("text", PER_SHADER, offsetof(AllTypes, text));
        r.registerParam<Pair>("plain", PER_SHADER, offsetof(AllTypes, plain));
    }
    void shade(openrt::TraceContext& c) const {
        const float integers = float(truth + number + texture.id + two.y + three.z);
        const float reals = real + pair.y + vector.z + four.w + color.b + matrix.m[15];
        c.setRadiance({integers, reals, float(text[0] - '0') + plain.a + float(plain.b)});
    }
};

TEST_F(CppInterface, ParametersOfAllTypes) {
    rtGenNewShaderClass<AllTypes>("AllTypes");
    rtGenNewShader();
    const auto set = [](const char* name, const auto& value) {
        rtParameter(rtParameterHandle(name), value);
    };
    set("truth", true);
    set("number", 2);
    set("texture", openrt::TextureId{4});
    set("two", openrt::Int2{0, 8});
    set("three", openrt::Int3{0, 0, 16});
    set("real", 1.0f);
    set("pair", openrt::Vec2(0, 2));
    set("vector", openrt::Vec3(0, 0, 4));
    set("four", openrt::Vec4(0, 0, 0, 8));
    set("color", openrt::Color(0, 0, 16));
    openrt::Mat4 matrix;
    matrix.m[15] = 32;
    set("matrix", matrix);
    set("text", "1");
    set("plain", AllTypes::Pair{2, 4});
    EXPECT_EQ(render(), openrt::Color(31, 63, 7));
    set("pair", glm::vec2(0, 1));
    set("vector", glm::vec3(0, 0, 2));
    set("four", glm::vec4(0, 0, 0, 3));
    set("color", glm::vec3(0, 0, 4));
    set("matrix", glm::mat4(5));
    EXPECT_EQ(render().g, 1 + 1 + 2 + 3 + 4 + 5);
    EXPECT_EQ(rtGetError(), RTenum(RT_NO_ERROR)) << rtGetErrorText();
}

TEST_F(CppInterface, FaultsOfShadersCostPixelsOnly) {
    EXPECT_EQ(rtGenNewShaderClass<Broken>("Broken"), RT_INVALID);
    EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_VALUE));
    rtGenNewShaderClass<Throwing>("Throwing");
    rtGenNewShader();
    EXPECT_EQ(render(), openrt::Color(0.0f));
    RTint bad = 0;
    rtGetIntegerv(RT_STAT_BAD_PIXELS, &bad);
    EXPECT_EQ(bad, 1);
    EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_OPERATION)) << "told once a frame";
}

TEST_F(CppInterface, OverloadsSetTheirState) {
    float v[16];
    rtColor(openrt::Color(0.5f, 0.25f, 0));
    rtGetFloatv(RT_CURRENT_COLOR, v);
    EXPECT_EQ(openrt::Vec4(v), openrt::Vec4(0.5f, 0.25f, 0, 1));
    rtColor(openrt::Vec4(0, 0, 0, 0.5f));
    rtGetFloatv(RT_CURRENT_COLOR, v);
    EXPECT_EQ(v[3], 0.5f);
    rtNormal(openrt::Vec3(1, 2, 3));
    rtGetFloatv(RT_CURRENT_NORMAL, v);
    EXPECT_EQ(openrt::Vec3(v), openrt::Vec3(1, 2, 3));
    rtTexCoord(openrt::Vec2(4, 5));
    rtGetFloatv(RT_CURRENT_TEXTURE_COORDS, v);
    EXPECT_EQ(openrt::Vec4(v), openrt::Vec4(4, 5, 0, 1));
    openrt::Mat4 m;
    m.m[12] = 7;
    rtLoadMatrix(m);
    rtTranslate({1, 0, 0});
    rtScale({2, 2, 2});
    rtRotate(90, {0, 0, 1});
    rtMultMatrix(m);
    rtGetFloatv(RT_MODELVIEW_MATRIX, v);
    EXPECT_EQ(openrt::Mat4(v)(0, 3), 8); // 7 + 1, and 7 turned to y and doubled
    EXPECT_EQ(openrt::Mat4(v)(1, 3), 14);
    EXPECT_EQ(openrt::Mat4(v)(1, 0), 2);
    EXPECT_EQ(rtGetError(), RTenum(RT_NO_ERROR));
}

} // namespace
