// SPDX-License-Identifier: MIT
// Every built-in surface and environment gives each point of a packet the bits that it gives the
// point alone, and draws as many random numbers for it.
#include <gtest/gtest.h>

#include <limits>

#include "openrt/shader.hpp"
#include "tests/libsmart/shading/builtin/twin_points.h"
#include "tests/libsmart/shading/fake_tracer.h"

namespace smart {
namespace {

using openrt::Color;
using openrt::Vec4;
using test::MadeShader;
using test::TwinPoints;
using ShaderPtr = std::shared_ptr<const ShaderObject>;

/// Lanes whose two forms differ, over some packets with few and many points.
int differences(const ShaderObject& shader, RTuint flags) {
    int found = 0;
    for (uint32_t seed = 1; seed <= 40; ++seed) {
        const RTuint active = seed % 4 == 0 ? 0xFFFFu : seed % 4 == 1 ? 1u << seed % 16
                                                                     : seed * 2654435761u >> 16;
        TwinPoints points(seed, active, flags);
        if (shader.functions().shadePacket(shader.block(), &points.packet) != 0) ++found;
        for (std::size_t lane = 0; lane < RTS_PACKET_SIZE; ++lane) {
            if (!(active >> lane & 1u)) continue;
            RTSstate& state = points.states[lane];
            if (shader.functions().shade(shader.block(), &state) != 0) ++found;
            bool same = points.ofPacket[lane].drawn == points.ofStates[lane].drawn &&
                        (points.packet.resultSet >> lane & 1u) == state.resultSet;
            for (int k = 0; k < 4; ++k)
                same &= std::bit_cast<uint32_t>(points.packet.result[k].lane[lane]) ==
                            std::bit_cast<uint32_t>(state.result[k]) &&
                        std::isfinite(state.result[k]);
            found += !same;
        }
    }
    return found;
}

void expectTwins(const ShaderPtr& shader, const std::string& what) {
    ASSERT_NE(shader->functions().shadePacket, nullptr) << what;
    EXPECT_EQ(differences(*shader, 0), 0) << what;
    EXPECT_EQ(differences(*shader, RTS_INDIRECT), 0) << what << ", path tracing";
}

TEST(BuiltinPacketsTest, EveryClassWithItsDefaults) {
    int count = 0;
    for (const std::string& name : builtinClassNames()) {
        const RTenum kind = findBuiltinClass(name)->kind();
        if (kind != RT_SURFACE_SHADER && kind != RT_ENV_SHADER) continue;
        expectTwins(MadeShader(name.c_str()).make(), name);
        ++count;
    }
    EXPECT_GE(count, 11);
}

TEST(BuiltinPacketsTest, Phong) {
    for (const int texture : {0, 3})
        expectTwins(MadeShader("Phong")
                        .set("texture", texture)
                        .set("ambient", Color(0.1f, 0.2f, 0))
                        .set("specular", Color(0.25f))
                        .set("emissive", Color(0, 0, 1))
                        .set("reflection", Color(0.1f, 0.5f, 0.3f))
                        .set("transmission", Color(0.02f, 0, 0.5f))
                        .make(),
                    "Phong");
}

TEST(BuiltinPacketsTest, Textured) {
    expectTwins(MadeShader("TexturedDiffuseShader")
                    .set("texture", 2)
                    .set("radiance", Color(0.5f, 0, 1))
                    .make(),
                "TexturedDiffuseShader");
    expectTwins(
        MadeShader("ImageEnvironment").set("texture", 1).set("rotation", 77.0f).make(),
        "ImageEnvironment");
}

TEST(BuiltinPacketsTest, MetallicRoughness) {
    for (const int alphaMode : {0, 1, 2})
        for (const int textured : {0, 1}) {
            expectTwins(MadeShader("MetallicRoughness")
                            .set("unlit", 1)
                            .set("baseColor", Vec4(0.9f, 0.5f, 0, 0.7f))
                            .set("alphaMode", alphaMode)
                            .set("baseColorTexture", textured)
                            .make(),
                        "unlit " + std::to_string(alphaMode) + " " + std::to_string(textured));
            for (const float roughness : {0.0f, 0.2f, 1.0f})
                expectTwins(MadeShader("MetallicRoughness")
                                .set("baseColor", Vec4(0.9f, 0.5f, 0, 0.7f))
                                .set("metallic", textured ? 0.8f : 0.3f)
                                .set("roughness", roughness)
                                .set("emissive", Color(0, 0.5f, 0))
                                .set("alphaMode", alphaMode)
                                .set("doubleSided", alphaMode == 1 ? 0 : 1)
                                .set("baseColorTexture", textured)
                                .set("metallicRoughnessTexture", 2 * textured)
                                .set("emissiveTexture", 3 * textured)
                                .make(),
                            "MetallicRoughness " + std::to_string(alphaMode) + " " +
                                std::to_string(textured) + " " + std::to_string(roughness));
        }
}

TEST(BuiltinPacketsTest, GlassAndOcclusion) {
    for (const float index : {1.0f, 1.33f, 0.7f})
        expectTwins(MadeShader("Glass")
                        .set("index", index)
                        .set("absorption", Color(0.1f, 0, 2))
                        .set("color", Color(1, 0.9f, 0.2f))
                        .make(),
                    "Glass");
    expectTwins(MadeShader("AmbientOcclusion").set("samples", 5).set("distance", 2.5f).make(),
                "AmbientOcclusion");
}

/// Wrong on purpose: the last place of one lane, one random number too many.
struct LastPlace {
    static constexpr bool shadesPackets = true;
    void shade(openrt::TraceContext& c) const { c.setRadiance(c.color() * 0.3f); }
    void shade(openrt::PacketContext& c) const {
        openrt::PacketColor color = c.color() * 0.3f;
        color.g[0] = std::nextafter(color.g[0], 2.0f);
        c.setRadiance(color);
    }
};
struct DrawsForAll {
    static constexpr bool shadesPackets = true;
    template <class Context>
    void shade(Context& c) const {
        const auto bright = c.color().r > 0.5f;
        c.random(bright);
        c.setRadiance(c.color());
    }
    void shade(openrt::PacketContext& c) const {
        c.random();
        c.setRadiance(c.color());
    }
};

TEST(BuiltinPacketsTest, TheComparisonSeesTheLastPlaceAndEveryRandomNumber) {
    for (const RTshaderclass* descriptor : {openrt::shaderClass<LastPlace>("LastPlace"),
                                            openrt::shaderClass<DrawsForAll>("DrawsForAll")}) {
        const auto shader =
            MadeShader(std::make_shared<ShaderClass>(*descriptor, nullptr)).make();
        EXPECT_GT(differences(*shader, 0), 5);
    }
}

} // namespace
} // namespace smart
