// SPDX-License-Identifier: MIT
#include "libsmart/shading/shader_class.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "libsmart/base/error.h"
#include "libsmart/shading/shader_object.h"

namespace smart {
namespace {

int constructNothing(void*, void*, void*) { return 0; }
int constructFails(void*, void*, void*) { return 1; }
int shadeNothing(const void*, RTSstate*) { return 0; }
int illuminateNothing(const void*, const float*, RTSlightsample*) { return 0; }
int noRay(const void*, float, float, RTScameraray*) { return 0; }
int noPixel(const void*, RTSpixel*, float*) { return 0; }

/// A descriptor that is right; tests break one thing each.
struct Sound {
    std::vector<RTSparameter> parameters = {
        {"color", RTS_PER_SHADER, RTS_FLOAT3, 0, 12},
        {"count", RTS_PER_SHADER, RTS_INT1, 12, 4},
        {"flag", RTS_PER_SHADER, RTS_INT1, 16, 1},
        {"name", RTS_PER_SHADER, RTS_STRING, 24, sizeof(const char*)},
        {"matrix", RTS_PER_TRIANGLE, RTS_FLOAT16, 0, 64},
        {"blob", RTS_PER_TRIANGLE, RTS_RAW, 64, 5},
        {"weight", RTS_PER_VERTEX, RTS_FLOAT2, 4, 8}};
    RTshaderclass descriptor = {};

    Sound() {
        descriptor.structSize = sizeof(RTshaderclass);
        descriptor.interfaceVersion = RTS_INTERFACE_VERSION;
        descriptor.kind = RT_SURFACE_SHADER;
        descriptor.name = "Sound";
        descriptor.shaderSize = 32;
        descriptor.triangleSize = 69;
        descriptor.vertexSize = 12;
        descriptor.alignment = 8;
        descriptor.construct = constructNothing;
        descriptor.shade = shadeNothing;
    }
    ShaderClassPtr make() {
        descriptor.parameters = parameters.data();
        descriptor.parameterCount = RTuint(parameters.size());
        return std::make_shared<ShaderClass>(descriptor, nullptr);
    }
};

TEST(ShaderClassTest, TakesASoundDescriptorAndCopiesIt) {
    Sound sound;
    std::string name = "Copied";
    sound.descriptor.name = name.c_str();
    const ShaderClassPtr c = sound.make();
    name = "Changed";
    sound.parameters[0].name = "changed";
    EXPECT_EQ(c->name(), "Copied");
    EXPECT_STREQ(c->descriptor().name, "Copied");
    EXPECT_EQ(c->findParameter("color"), 0);
    EXPECT_EQ(c->findParameter("weight"), 6);
    EXPECT_EQ(c->findParameter("changed"), -1);
    EXPECT_EQ(c->findParameter("colo"), -1);
    EXPECT_STREQ(c->descriptor().parameters[0].name, "color");
    EXPECT_EQ(c->triangleDefaults().size(), 69u);
}

TEST(ShaderClassTest, RefusesEachBrokenDescriptorWithAText) {
    struct Case {
        const char* what; ///< found in the text
        std::function<void(Sound&)> breakIt;
    };
    const std::vector<Case> cases = {
        {"version", [](Sound& s) { s.descriptor.interfaceVersion = 99; }},
        {"bytes", [](Sound& s) { s.descriptor.structSize = 16; }},
        {"without a name", [](Sound& s) { s.descriptor.name = nullptr; }},
        {"without a name", [](Sound& s) { s.descriptor.name = ""; }},
        {"unknown kind", [](Sound& s) { s.descriptor.kind = 7; }},
        {"construct", [](Sound& s) { s.descriptor.construct = nullptr; }},
        {"shade", [](Sound& s) { s.descriptor.shade = nullptr; }},
        {"illuminate", [](Sound& s) { s.descriptor.kind = RT_LIGHT_SHADER; }},
        {"cameraRay", [](Sound& s) { s.descriptor.kind = RT_CAMERA_SHADER; }},
        {"renderPixel", [](Sound& s) { s.descriptor.kind = RT_RENDERING_OBJECT_SHADER; }},
        {"only surfaces", [](Sound& s) { s.descriptor.kind = RT_ENV_SHADER; }},
        {"alignment", [](Sound& s) { s.descriptor.alignment = 0; }},
        {"alignment", [](Sound& s) { s.descriptor.alignment = 24; }},
        {"alignment", [](Sound& s) { s.descriptor.alignment = 128; }},
        {"1 MiB", [](Sound& s) { s.descriptor.shaderSize = 0xFFFFFFF0u; }},
        {"1 MiB", [](Sound& s) { s.descriptor.triangleSize = 1u << 24; }},
        {"256 floats", [](Sound& s) { s.descriptor.vertexSize = 1028; }},
        {"multiple", [](Sound& s) { s.descriptor.vertexSize = 13; }},
        {"constructor failed", [](Sound& s) { s.descriptor.construct = constructFails; }},
        {"has no name", [](Sound& s) { s.parameters[0].name = nullptr; }},
        {"has no name", [](Sound& s) { s.parameters[0].name = ""; }},
        {"two parameters", [](Sound& s) { s.parameters[1].name = "color"; }},
        {"unknown scope", [](Sound& s) { s.parameters[0].scope = RTSscope(3); }},
        {"unknown type", [](Sound& s) { s.parameters[0].type = RTStype(0); }},
        {"unknown type", [](Sound& s) { s.parameters[0].type = RTStype(15); }},
        {"bytes", [](Sound& s) { s.parameters[0].size = 16; }},
        {"bytes", [](Sound& s) { s.parameters[5].size = 0; }},
        {"outside", [](Sound& s) { s.parameters[0].offset = 24; }},
        {"outside", [](Sound& s) { s.parameters[0].offset = 0xFFFFFFFCu; }},
        {"outside", [](Sound& s) { s.parameters[5].size = 6; }},
        {"outside", [](Sound& s) { s.descriptor.vertexSize = 8; }},
        {"not aligned", [](Sound& s) { s.parameters[0].offset = 2; }},
        {"not aligned", [](Sound& s) { s.parameters[3].offset = 20; }},
        {"not aligned", [](Sound& s) { s.descriptor.alignment = 2; }},
        {"string", [](Sound& s) { s.parameters[3].scope = RTS_PER_TRIANGLE; }},
        {"interpolated", [](Sound& s) { s.parameters[6] = {"w", RTS_PER_VERTEX, RTS_INT2, 4, 8}; }},
        {"interpolated", [](Sound& s) { s.parameters[6] = {"w", RTS_PER_VERTEX, RTS_RAW, 4, 4}; }},
    };
    for (std::size_t i = 0; i < cases.size(); ++i) {
        Sound sound;
        cases[i].breakIt(sound);
        try {
            sound.make();
            ADD_FAILURE() << "case " << i << " was taken: " << cases[i].what;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::InvalidValue);
            EXPECT_NE(std::string(error.what()).find(cases[i].what), std::string::npos)
                << "case " << i << ": " << error.what();
        }
    }
    Sound missing;
    missing.make();
    missing.descriptor.parameters = nullptr;
    EXPECT_THROW(ShaderClass(missing.descriptor, nullptr), Error);
}

TEST(ShaderClassTest, EachKindNeedsItsOwnFunctionOnly) {
    RTshaderclass d = {};
    d.structSize = sizeof(RTshaderclass);
    d.interfaceVersion = RTS_INTERFACE_VERSION;
    d.name = "Plain";
    d.alignment = 1;
    d.construct = constructNothing;
    d.kind = RT_LIGHT_SHADER;
    d.illuminate = illuminateNothing;
    EXPECT_NO_THROW(ShaderClass(d, nullptr));
    d.illuminate = nullptr;
    d.kind = RT_CAMERA_SHADER;
    d.cameraRay = noRay;
    EXPECT_NO_THROW(ShaderClass(d, nullptr));
    d.cameraRay = nullptr;
    d.kind = RT_RENDERING_OBJECT_SHADER;
    d.renderPixel = noPixel;
    EXPECT_NO_THROW(ShaderClass(d, nullptr));
}

TEST(ShaderClassTest, ReleasesItsModuleLast) {
    static std::weak_ptr<int> watched;
    static bool aliveAtDestroy;
    auto module = std::make_shared<int>(1);
    watched = module;
    Sound sound;
    sound.descriptor.destroy = [](void*) { aliveAtDestroy = !watched.expired(); };
    sound.descriptor.parameters = sound.parameters.data();
    auto c = std::make_shared<ShaderClass>(sound.descriptor, std::move(module));
    auto object = std::make_shared<const ShaderObject>(std::move(c), ParameterValues{});
    aliveAtDestroy = false;
    object.reset();
    EXPECT_TRUE(aliveAtDestroy);
    EXPECT_TRUE(watched.expired());
}

} // namespace
} // namespace smart
