// SPDX-License-Identifier: MIT
// The C++ shader interface: from plain classes to descriptors, and through them back to the class.
#include <gtest/gtest.h>

#include <glm/glm.hpp>
#include <limits>
#include <string>

#include "openrt/shader.hpp"
#include "samples/shaders/sample_shaders.h"
#include "tests/libsmart/shading/fake_tracer.h"

namespace smart {
namespace {

using namespace openrt;
using test::bytesOf;
using test::FakeTracer;

struct Everything {
    int one = 1;
    bool flag = true;
    TextureId texture{3};
    Int2 two{1, 2};
    Int3 three{1, 2, 3};
    float f1 = 0.5f;
    Vec2 f2{1, 2};
    Vec3 f3{1, 2, 3};
    Color color{0.25f};
    Vec4 f4{1, 2, 3, 4};
    Mat4 matrix;
    const char* text = "default";
    struct Pair {
        short a, b;
    } pair{7, 8};

    struct TriangleParam {
        int id = 5;
        Vec3 axis{0, 1, 0};
    };
    struct VertexParam {
        float heat = 0.75f;
        Color tint{0.5f, 0.25f, 0.125f};
    };

    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<int>("one", PER_SHADER, offsetof(Everything, one));
        r.registerParam<bool>("flag", PER_SHADER, offsetof(Everything, flag));
        r.registerParam<TextureId>("texture", PER_SHADER, offsetof(Everything, texture));
        r.registerParam<Int2>("two", PER_SHADER, offsetof(Everything, two));
        r.registerParam<Int3>("three", PER_SHADER, offsetof(Everything, three));
        r.registerParam<float>("f1", PER_SHADER, offsetof(Everything, f1));
        r.registerParam<Vec2>("f2", PER_SHADER, offsetof(Everything, f2));
        r.registerParam<Vec3>("f3", PER_SHADER, offsetof(Everything, f3));
        r.registerParam<Color>("color", PER_SHADER, offsetof(Everything, color));
        r.registerParam<Vec4>("f4", PER_SHADER, offsetof(Everything, f4));
        r.registerParam<Mat4>("matrix", PER_SHADER, offsetof(Everything, matrix));
        r.registerParam<const char*>("text", PER_SHADER, offsetof(Everything, text));
        r.registerParam<Pair>("pair", PER_SHADER, offsetof(Everything, pair));
        r.registerParam<int>("id", PER_TRIANGLE, offsetof(TriangleParam, id));
        r.registerParam<Vec3>("axis", PER_TRIANGLE, offsetof(TriangleParam, axis));
        r.registerParam<float>("heat", PER_VERTEX, offsetof(VertexParam, heat));
        r.registerParam<Color>("tint", PER_VERTEX, offsetof(VertexParam, tint));
    }
    void shade(TraceContext& c) const {
        c.setRadiance(color * c.vertexParam<VertexParam>().heat *
                      float(c.triangleParam<TriangleParam>().id));
    }
    bool transparency(TraceContext& c) const { return c.frontFace(); }
};

TEST(CppShaderTest, ParametersHaveTheirTypesSizesAndDefaults) {
    const auto c = std::make_shared<ShaderClass>(*shaderClass<Everything>("Everything"), nullptr);
    const struct {
        const char* name;
        RTSscope scope;
        RTStype type;
        std::size_t value;
    } expected[] = {{"one", RTS_PER_SHADER, RTS_INT1, 4},
                    {"flag", RTS_PER_SHADER, RTS_INT1, 4},
                    {"texture", RTS_PER_SHADER, RTS_INT1, 4},
                    {"two", RTS_PER_SHADER, RTS_INT2, 8},
                    {"three", RTS_PER_SHADER, RTS_INT3, 12},
                    {"f1", RTS_PER_SHADER, RTS_FLOAT1, 4},
                    {"f2", RTS_PER_SHADER, RTS_FLOAT2, 8},
                    {"f3", RTS_PER_SHADER, RTS_FLOAT3, 12},
                    {"color", RTS_PER_SHADER, RTS_FLOAT3, 12},
                    {"f4", RTS_PER_SHADER, RTS_FLOAT4, 16},
                    {"matrix", RTS_PER_SHADER, RTS_FLOAT16, 64},
                    {"text", RTS_PER_SHADER, RTS_STRING, 0},
                    {"pair", RTS_PER_SHADER, RTS_RAW, 4},
                    {"id", RTS_PER_TRIANGLE, RTS_INT1, 4},
                    {"axis", RTS_PER_TRIANGLE, RTS_FLOAT3, 12},
                    {"heat", RTS_PER_VERTEX, RTS_FLOAT1, 4},
                    {"tint", RTS_PER_VERTEX, RTS_FLOAT3, 12}};
    ASSERT_EQ(c->parameterCount(), std::size(expected));
    for (const auto& e : expected) {
        const int index = c->findParameter(e.name);
        ASSERT_GE(index, 0) << e.name;
        EXPECT_EQ(c->parameter(uint32_t(index)).scope, e.scope) << e.name;
        EXPECT_EQ(c->parameter(uint32_t(index)).type, e.type) << e.name;
        EXPECT_EQ(valueSize(c->parameter(uint32_t(index))), e.value) << e.name;
    }
    const Everything::TriangleParam triangle;
    const Everything::VertexParam vertex;
    EXPECT_EQ(c->triangleDefaults(), bytesOf(triangle));
    EXPECT_EQ(c->vertexDefaults(), bytesOf(vertex));

    const ShaderObject object(c, {});
    const auto& block = *static_cast<const Everything*>(object.block());
    EXPECT_EQ(block.one, 1);
    EXPECT_TRUE(block.flag);
    EXPECT_EQ(block.matrix, Mat4());
    EXPECT_STREQ(block.text, "default");
}

TEST(CppShaderTest, WrittenParametersReachTheBlockAndStringsAreCopied) {
    const auto c = std::make_shared<ShaderClass>(*shaderClass<Everything>("Everything"), nullptr);
    const auto index = [&](const char* name) { return uint32_t(c->findParameter(name)); };
    std::string text = "a text that is too long for any small string optimisation to hold it";
    std::vector<std::byte> characters(text.size());
    std::memcpy(characters.data(), text.data(), text.size());
    ParameterValues values;
    values[index("text")] = characters;
    values[index("flag")] = bytesOf(int(0));
    values[index("f3")] = bytesOf(Vec3(4, 5, 6));
    values[index("pair")] = bytesOf(Everything::Pair{9, 10});
    const ShaderObject object(c, values);
    characters.clear();
    const auto& block = *static_cast<const Everything*>(object.block());
    EXPECT_EQ(block.text, text);
    EXPECT_FALSE(block.flag);
    EXPECT_EQ(block.texture.id, 3); // next to the flag, which is one byte
    EXPECT_EQ(block.f3, Vec3(4, 5, 6));
    EXPECT_EQ(block.pair.b, 10);
    EXPECT_EQ(reinterpret_cast<uintptr_t>(object.block()) % alignof(Everything), 0u);

    values[index("flag")] = bytesOf(int(256)); // no bit of it in the lowest byte
    EXPECT_TRUE(static_cast<const Everything*>(ShaderObject(c, values).block())->flag);
}

TEST(CppShaderTest, TheDescriptorIsMadeOnceForEachName) {
    EXPECT_EQ(shaderClass<Everything>("A"), shaderClass<Everything>("A"));
    EXPECT_NE(shaderClass<Everything>("A"), shaderClass<Everything>("B"));
    EXPECT_STREQ(shaderClass<Everything>("B")->name, "B");
    EXPECT_THROW(shaderClass<Everything>(nullptr), std::invalid_argument);
}

struct Sky {
    static constexpr ShaderKind kind = ShaderKind::Environment;
    void shade(TraceContext& c) const { c.setRadiance(Color(1, 2, 3)); }
};
struct Lamp {
    bool illuminate(const Vec3& at, Vec3& direction, float& distance, Color& radiance) const {
        if (at.x < 0) return false;
        direction = Vec3(0, 1, 0);
        distance = 2;
        radiance = Color(4, 5, 6);
        return true;
    }
};
struct Eye {
    void initPrimaryRay(float x, float y, TraceContext& c) const {
        c.setRay(Vec3(x, y, 0), Vec3(0, 0, 1), 0.5f);
    }
};
struct Sampler {
    Color renderPixel(PixelContext& c) const {
        const Vec4 v = c.trace({0.25f, 0.75f});
        c.setAlpha(v.w);
        return Color(v.x, v.y, v.z) * float(c.samples());
    }
};
struct Glassy {
    template <class Context>
    void shade(Context& c) const {
        c.setRadiance(Color(c.rayDistance()));
        c.setAlpha(0.5f);
    }
    template <class Context>
    Color transparency(Context&) const {
        return {0.25f, 0.5f, 0.75f};
    }
};

TEST(CppShaderTest, KindsFollowFromTheMembers) {
    EXPECT_EQ(shaderClass<Everything>("x")->kind, RTenum(RT_SURFACE_SHADER));
    EXPECT_EQ(shaderClass<Sky>("x")->kind, RTenum(RT_ENV_SHADER));
    EXPECT_EQ(shaderClass<Lamp>("x")->kind, RTenum(RT_LIGHT_SHADER));
    EXPECT_EQ(shaderClass<Eye>("x")->kind, RTenum(RT_CAMERA_SHADER));
    EXPECT_EQ(shaderClass<Sampler>("x")->kind, RTenum(RT_RENDERING_OBJECT_SHADER));
    EXPECT_EQ((shaderClass<Glassy, ShaderKind::Environment>("x")->kind), RTenum(RT_ENV_SHADER));
    EXPECT_EQ(shaderClass<Sky>("x")->transparency, nullptr);
    EXPECT_EQ((shaderClass<Glassy, ShaderKind::Environment>("x")->transparency), nullptr);
}

TEST(CppShaderTest, FunctionsReachTheMembers) {
    FakeTracer tracer;
    const auto object = [](const RTshaderclass* d) {
        return std::make_shared<const ShaderObject>(std::make_shared<ShaderClass>(*d, nullptr),
                                                    ParameterValues{});
    };
    const auto everything = object(shaderClass<Everything>("x"));
    tracer.state.triangleParam = everything->shaderClass().triangleDefaults().data();
    tracer.state.vertexParam = everything->shaderClass().vertexDefaults().data();
    EXPECT_EQ(tracer.shade(*everything)[0], 0.25f * 0.75f * 5);
    float rgb[3] = {9, 9, 9};
    EXPECT_EQ(everything->functions().transparency(everything->block(), &tracer.state, rgb), 0);
    EXPECT_EQ(rgb[1], 1);
    tracer.state.frontFace = 0;
    everything->functions().transparency(everything->block(), &tracer.state, rgb);
    EXPECT_EQ(rgb[1], 0);

    const auto glass = object(shaderClass<Glassy>("x"));
    tracer.state.rayDistance = 3;
    EXPECT_EQ(tracer.shade(*glass), (std::array<float, 4>{3, 3, 3, 0.5f}));
    glass->functions().transparency(glass->block(), &tracer.state, rgb);
    EXPECT_EQ(rgb[2], 0.75f);

    const auto lamp = object(shaderClass<Lamp>("x"));
    RTSlightsample sample = {};
    const float front[3] = {1, 0, 0}, back[3] = {-1, 0, 0};
    EXPECT_EQ(lamp->functions().illuminate(lamp->block(), back, &sample), 0);
    EXPECT_EQ(lamp->functions().illuminate(lamp->block(), front, &sample), 1);
    EXPECT_EQ(sample.radiance[2], 6);
    EXPECT_EQ(sample.distance, 2);

    const auto eye = object(shaderClass<Eye>("x"));
    RTScameraray ray = {};
    EXPECT_EQ(eye->functions().cameraRay(eye->block(), 0.25f, 0.5f, &ray), 0);
    EXPECT_EQ(ray.origin[1], 0.5f);
    EXPECT_EQ(ray.tnear, 0.5f);
    EXPECT_EQ(ray.tfar, std::numeric_limits<float>::infinity());

    RTSpixel pixel = {};
    pixel.structSize = sizeof(pixel);
    pixel.state = &tracer.state;
    pixel.samples = 4;
    pixel.trace = [](RTSpixel*, float x, float y, float rgba[4]) {
        rgba[0] = x;
        rgba[1] = y;
        rgba[2] = 0;
        rgba[3] = 0.125f;
    };
    const auto sampler = object(shaderClass<Sampler>("x"));
    float rgba[4] = {};
    EXPECT_EQ(sampler->functions().renderPixel(sampler->block(), &pixel, rgba), 0);
    EXPECT_EQ(rgba[0], 1);
    EXPECT_EQ(rgba[1], 3);
    EXPECT_EQ(rgba[3], 0.125f);
}

struct Thrower {
    void shade(TraceContext&) const { throw std::runtime_error("shade"); }
    Color transparency(TraceContext&) const { throw 1; }
};
struct ThrowingLamp {
    bool illuminate(const Vec3&, Vec3&, float&, Color&) const { throw 1; }
};
struct ThrowingEye {
    void initPrimaryRay(float, float, TraceContext&) const { throw 1; }
};
struct ThrowingSampler {
    Color renderPixel(PixelContext&) const { throw 1; }
};
struct Unborn {
    Unborn() { throw std::runtime_error("constructor"); }
    void shade(TraceContext&) const {}
};

TEST(CppShaderTest, ExceptionsBecomeFaultCodes) {
    FakeTracer tracer;
    const ShaderObject thrower(
        std::make_shared<ShaderClass>(*shaderClass<Thrower>("x"), nullptr), {});
    float rgb[4] = {};
    EXPECT_NE(thrower.functions().shade(thrower.block(), &tracer.state), 0);
    EXPECT_NE(thrower.functions().transparency(thrower.block(), &tracer.state, rgb), 0);
    const float at[3] = {};
    RTSlightsample sample = {};
    const ThrowingLamp lamp;
    EXPECT_LT(shaderClass<ThrowingLamp>("x")->illuminate(&lamp, at, &sample), 0);
    RTScameraray ray = {};
    const ThrowingEye eye;
    EXPECT_NE(shaderClass<ThrowingEye>("x")->cameraRay(&eye, 0, 0, &ray), 0);
    RTSpixel pixel = {};
    const ThrowingSampler sampler;
    EXPECT_NE(shaderClass<ThrowingSampler>("x")->renderPixel(&sampler, &pixel, rgb), 0);
    // Without registerParams nothing is constructed for the descriptor; the class does it.
    EXPECT_THROW(ShaderClass(*shaderClass<Unborn>("x"), nullptr), Error);
}

TEST(CppShaderTest, VectorsConvertFromAndToGlm) {
    const glm::vec3 g(1, 2, 3);
    const Vec3 v = g;
    EXPECT_EQ(v, Vec3(1, 2, 3));
    const glm::vec3 back = v;
    EXPECT_EQ(back, g);
    const glm::vec4 color4 = Vec4(1, 2, 3, 4);
    EXPECT_EQ(color4.w, 4);
    glm::mat4 m(1.0f);
    m[3][1] = 7; // column 3, row 1
    const Mat4 ours = m;
    EXPECT_EQ(ours(1, 3), 7);
    EXPECT_EQ(ours * Vec4(0, 0, 0, 1), Vec4(0, 7, 0, 1));
    const glm::mat4 again = ours;
    EXPECT_EQ(again, m);
    glm::mat4 other(2.0f);
    other[1][0] = 3;
    const glm::mat4 product = m * other, oursProduct = Mat4(m) * Mat4(other);
    EXPECT_EQ(oursProduct, product);
}

TEST(CppShaderTest, NormalizeWorksAtAnyScale) {
    for (const float scale : {1e-38f, 1e-20f, 1.0f, 1e20f, 1e38f}) {
        const Vec3 n = normalize(Vec3(3 * scale / 4, 0, scale));
        EXPECT_FLOAT_EQ(n.x, 0.6f);
        EXPECT_FLOAT_EQ(n.z, 0.8f);
    }
    EXPECT_EQ(normalize(Vec3()), Vec3());
}

// The samples ---------------------------------------------------------------------------------

TEST(SampleShaderTest, TheCheckerInCShowsBothColoursAndItsTint) {
    const auto c = std::make_shared<ShaderClass>(*checkerClass(), nullptr);
    const ShaderObject checker(c, {});
    FakeTracer tracer;
    tracer.lights.push_back({{0, 0, 1}, 1, {1, 1, 1}});
    const float tint[3] = {1, 0.5f, 0.25f};
    tracer.state.vertexParam = tint;
    tracer.state.texCoord[0] = 0.01f;
    tracer.state.texCoord[1] = 0.01f;
    EXPECT_EQ(tracer.shade(checker), (std::array<float, 4>{0.9f, 0.45f, 0.225f, 1}));
    tracer.state.texCoord[0] = 0.13f;
    EXPECT_EQ(tracer.shade(checker), (std::array<float, 4>{0.1f, 0.05f, 0.025f, 1}));
}

TEST(SampleShaderTest, TheWoodInCppHasRingsAndShadows) {
    const auto c = std::make_shared<ShaderClass>(*woodClass(), nullptr);
    const ShaderObject wood(c, {});
    FakeTracer tracer;
    tracer.lights.push_back({{0, 0, 1}, 1, {1, 1, 1}});
    EXPECT_FLOAT_EQ(tracer.shade(wood)[0], 0.8f * 1.1f);
    tracer.shadowAttenuation = {0, 0, 0};
    EXPECT_FLOAT_EQ(tracer.shade(wood)[0], 0.8f * 0.1f);
}

} // namespace
} // namespace smart
