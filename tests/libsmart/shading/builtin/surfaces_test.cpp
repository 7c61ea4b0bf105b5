// SPDX-License-Identifier: MIT
// The surfaces against the formulas that their headers state, in double.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "openrt/shader.hpp"
#include "tests/libsmart/shading/fake_tracer.h"

namespace smart {
namespace {

using openrt::Color;
using openrt::Vec4;
using test::FakeTracer;
using test::MadeShader;
using Rgba = std::array<float, 4>;

constexpr double kPi = 3.14159265358979323846;

RTSlightsample light(double x, double y, double z, float r, float g, float b) {
    const double length = std::sqrt(x * x + y * y + z * z);
    return {{float(x / length), float(y / length), float(z / length)}, float(length), {r, g, b}};
}

void expectNear(const Rgba& got, const std::array<double, 3>& wanted) {
    for (std::size_t k = 0; k < 3; ++k)
        EXPECT_NEAR(got[k], wanted[k], 2e-6 * (1 + std::fabs(wanted[k]))) << "channel " << k;
}

TEST(SurfacesTest, FixedFunctionShowsTheCurrentColour) {
    FakeTracer tracer;
    tracer.lights.push_back(light(0, 0, 1, 1, 1, 1));
    const float color[4] = {0.1f, 0.2f, 0.3f, 0.4f};
    std::copy_n(color, 4, tracer.state.color);
    EXPECT_EQ(tracer.shade(*MadeShader("FixedFunction").make()), (Rgba{0.1f, 0.2f, 0.3f, 0.4f}));
}

TEST(SurfacesTest, ConstantShowsItsValue) {
    FakeTracer tracer;
    EXPECT_EQ(tracer.shade(*MadeShader("ConstantShader").set("value", Color(3, 2, 0.5f)).make()),
              (Rgba{3, 2, 0.5f, 1}));
}

TEST(SurfacesTest, DiffuseSumsLightsByTheirCosines) {
    FakeTracer tracer;
    tracer.lights = {light(0, 3, 4, 2, 4, 6), light(1, 0, 0.001, 0, 0, 0), light(0, 0, -1, 9, 9, 9),
                     light(0, 0, 2, 1, 1, 1)};
    const auto shader = MadeShader("DiffuseShader").set("color", Color(0.5f, 1, 0.25f)).make();
    const std::array<double, 3> front = {0.5 * (2 * 0.8 + 1), 4 * 0.8 + 1, 0.25 * (6 * 0.8 + 1)};
    expectNear(tracer.shade(*shader), front);
    EXPECT_EQ(tracer.shadowRays, 0);
    // From behind only the light behind counts; the same if the normals were given turned.
    tracer.setRay(0, 0, 1);
    expectNear(tracer.shade(*shader), {4.5, 9, 2.25});
    for (float& n : tracer.state.shadingNormal) n = -n;
    expectNear(tracer.shade(*shader), {4.5, 9, 2.25});
}

TEST(SurfacesTest, TexturedDiffuseAddsItsAmbientRadiance) {
    FakeTracer tracer;
    tracer.lights = {light(0, 3, 4, 1, 1, 1)};
    tracer.textures[4] = {0.5f, 0.25f, 1, 1};
    const auto shader = MadeShader("TexturedDiffuseShader")
                            .set("texture", 4)
                            .set("radiance", Color(0.2f))
                            .make();
    expectNear(tracer.shade(*shader), {0.5, 0.25, 1});
}

TEST(SurfacesTest, TextureShowsItselfWithAlpha) {
    FakeTracer tracer;
    tracer.textures[2] = {0.5f, 0.25f, 1, 0.125f};
    EXPECT_EQ(tracer.shade(*MadeShader("TextureShader").set("texture", 2).make()),
              (Rgba{0.5f, 0.25f, 1, 0.125f}));
    EXPECT_EQ(tracer.shade(*MadeShader("TextureShader").make()), (Rgba{1, 1, 1, 1}));
}

TEST(SurfacesTest, MirrorAttenuatesWhatItSees) {
    FakeTracer tracer;
    tracer.traced = {1, 2, 4};
    tracer.setRay(0.6f, 0, -0.8f);
    tracer.state.weight = 0.5f;
    const auto shader = MadeShader("MirrorShader").set("attenuation", Color(0.5f, 0.25f, 0)).make();
    EXPECT_EQ(tracer.shade(*shader), (Rgba{0.5f, 0.5f, 0, 1}));
    EXPECT_FLOAT_EQ(tracer.tracedDirection[0], 0.6f);
    EXPECT_FLOAT_EQ(tracer.tracedDirection[2], 0.8f);
    EXPECT_EQ(tracer.tracedWeight, 0.25f); // share of the pixel
    tracer.setRay(0.6f, 0, 0.8f); // from behind
    tracer.shade(*shader);
    EXPECT_FLOAT_EQ(tracer.tracedDirection[2], -0.8f);
    tracer.mayTrace = 0; // the recursion limit
    EXPECT_EQ(tracer.shade(*shader), (Rgba{0, 0, 0, 1}));
}

MadeShader phong() {
    return MadeShader("Phong")
        .set("ambient", Color(0.1f, 0.2f, 0.3f))
        .set("diffuse", Color(0.5f))
        .set("specular", Color(0.25f))
        .set("emissive", Color(0, 0, 1))
        .set("shininess", 10.0f);
}

TEST(SurfacesTest, PhongFollowsItsFormula) {
    FakeTracer tracer;
    tracer.setRay(0.6f, 0, -0.8f);
    tracer.lights = {light(0.3, 0.4, 1.2, 1, 2, 3)};
    tracer.textures[1] = {0.5f, 1, 1, 1};
    tracer.shadowAttenuation = {1, 0.5f, 0};
    const double cosine = 1.2 / 1.3, highlight = (0.6 * 0.3 + 0.8 * 1.2) / 1.3;
    const double peak = 0.25 * std::pow(highlight, 10);
    expectNear(tracer.shade(*phong().set("texture", 1).make()),
               {0.05 + 0.25 * cosine + peak, 0.2 + (0.5 * cosine + peak) * 2 * 0.5, 0.3 + 1});
    EXPECT_EQ(tracer.shadowRays, 1);
    EXPECT_EQ(tracer.tracedRays, 0);
}

TEST(SurfacesTest, PhongSpawnsRaysOnlyForWhatItReflectsAndTransmits) {
    FakeTracer tracer;
    tracer.traced = {1, 1, 1};
    const auto shader =
        phong().set("reflection", Color(0.5f, 0, 0)).set("transmission", Color(0, 0.25f, 0)).make();
    expectNear(tracer.shade(*shader), {0.1 + 0.5, 0.2 + 0.25, 0.3 + 1});
    EXPECT_EQ(tracer.tracedRays, 2);
    EXPECT_EQ(tracer.tracedDirection[2], -1); // the last one goes straight on
    float rgb[3] = {};
    EXPECT_EQ(shader->functions().transparency(shader->block(), &tracer.state, rgb), 0);
    EXPECT_EQ(rgb[1], 0.25f);
    EXPECT_EQ(rgb[0], 0);
}

TEST(SurfacesTest, NoLightReachesThroughTheTrianglesPlane) {
    FakeTracer tracer;
    tracer.state.shadingNormal[1] = 0.8f; // leans over, so that the light is in front of it
    tracer.state.shadingNormal[2] = 0.6f;
    tracer.lights = {light(0, 1, -0.1, 1, 1, 1)};
    expectNear(tracer.shade(*phong().make()), {0.1, 0.2, 1.3});
    EXPECT_EQ(tracer.shadowRays, 0);
}

// Metallic-roughness --------------------------------------------------------------------------

/// Appendix B of the glTF 2.0 specification as written there, times pi and the cosine.
double gltf(double base, double metallic, double roughness, double nl, double nv, double nh,
            double vh) {
    const double a = roughness * roughness, a2 = a * a;
    const double diffuseColor = base * (1 - metallic), f0 = 0.04 * (1 - metallic) + base * metallic;
    const double f = f0 + (1 - f0) * std::pow(1 - vh, 5);
    const double d = a2 / (kPi * std::pow(nh * nh * (a2 - 1) + 1, 2));
    const double g = 2 * nl / (nl + std::sqrt(a2 + (1 - a2) * nl * nl)) * 2 * nv /
                     (nv + std::sqrt(a2 + (1 - a2) * nv * nv));
    const double brdf = (1 - f) / kPi * diffuseColor + f * g * d / (4 * nl * nv);
    return kPi * brdf * nl;
}

TEST(MetallicRoughnessTest, FollowsGltf) {
    for (const float metallic : {0.0f, 0.3f, 1.0f})
        for (const float roughness : {0.1f, 0.5f, 1.0f})
            for (const double tilt : {0.1, 0.7, 1.3}) {
                FakeTracer tracer;
                tracer.setRay(0.6f, 0, -0.8f);
                const double l[3] = {std::sin(tilt) * 0.6, std::sin(tilt) * 0.8, std::cos(tilt)};
                tracer.lights = {light(l[0], l[1], l[2], 1, 1, 2)};
                const double v[3] = {-0.6, 0, 0.8};
                double h[3], length = 0;
                for (int k = 0; k < 3; ++k) h[k] = l[k] + v[k], length += h[k] * h[k];
                length = std::sqrt(length);
                const double vh = (h[0] * v[0] + h[2] * v[2]) / length, nh = h[2] / length;
                const auto shader = MadeShader("MetallicRoughness")
                                        .set("baseColor", Vec4(0.8f, 0.5f, 0.1f, 1))
                                        .set("metallic", metallic)
                                        .set("roughness", roughness)
                                        .make();
                const Rgba got = tracer.shade(*shader);
                const double base[3] = {0.8, 0.5, 0.1}, radiance[3] = {1, 1, 2};
                for (std::size_t k = 0; k < 3; ++k) {
                    const double wanted = radiance[k] * gltf(base[k], metallic, roughness, l[2],
                                                             0.8, nh, vh);
                    EXPECT_NEAR(got[k], wanted, 2e-5 * (wanted + 0.01))
                        << metallic << " " << roughness << " " << tilt;
                }
            }
}

TEST(MetallicRoughnessTest, TheHighlightsMiddleIsExactForSmoothSurfaces) {
    FakeTracer tracer;
    tracer.lights = {light(0, 0, 1, 1, 1, 1)};
    const auto shader =
        MadeShader("MetallicRoughness").set("roughness", 0.0f).make(); // taken as 0.04
    const double wanted = gltf(1, 1, 0.04, 1, 1, 1, 1);
    EXPECT_NEAR(tracer.shade(*shader)[0] / wanted, 1, 1e-4);
}

TEST(MetallicRoughnessTest, TexturesAndTheCurrentColourMultiply) {
    FakeTracer tracer;
    tracer.textures[1] = {0.5f, 0.5f, 0.5f, 1};
    tracer.textures[2] = {9, 1, 0, 9}; // roughness times 1, metallic times 0
    tracer.textures[3] = {0.25f, 0.5f, 1, 1};
    tracer.state.color[0] = 0.5f;
    tracer.lights = {light(0, 0, 1, 1, 1, 1)};
    const auto shader = MadeShader("MetallicRoughness")
                            .set("baseColorTexture", 1)
                            .set("metallicRoughnessTexture", 2)
                            .set("emissiveTexture", 3)
                            .set("emissive", Color(2.0f))
                            .make();
    expectNear(tracer.shade(*shader), {gltf(0.25, 0, 1, 1, 1, 1, 1) + 0.5,
                                       gltf(0.5, 0, 1, 1, 1, 1, 1) + 1,
                                       gltf(0.5, 0, 1, 1, 1, 1, 1) + 2});
    EXPECT_EQ(tracer.shadowRays, 1);
    tracer.shadowAttenuation = {0, 0, 0};
    expectNear(tracer.shade(*shader), {0.5, 1, 2});
}

TEST(MetallicRoughnessTest, TheEnvironmentIsAmbientLight) {
    FakeTracer tracer; // the normal has y = 0, so both directions look at the upper half
    tracer.environmentAt[0] = {1, 2, 4};
    const auto dielectric = MadeShader("MetallicRoughness")
                                .set("baseColor", Vec4(0.5f, 0.5f, 0.5f, 1))
                                .set("metallic", 0.0f)
                                .make();
    expectNear(tracer.shade(*dielectric), {0.54, 2 * 0.54, 4 * 0.54});
    EXPECT_EQ(tracer.tracedRays, 0);
    tracer.traced = {8, 8, 8};
    const auto mirror = MadeShader("MetallicRoughness").set("roughness", 0.0f).make();
    expectNear(tracer.shade(*mirror), {8, 8, 8});
    EXPECT_EQ(tracer.tracedRays, 1);
    const auto half = MadeShader("MetallicRoughness").set("roughness", 0.15f).make();
    expectNear(tracer.shade(*half), {4.5, 5, 6});
}

TEST(MetallicRoughnessTest, AlphaModes) {
    FakeTracer tracer;
    tracer.traced = {8, 8, 8};
    const auto made = [](int mode, float alpha) {
        return MadeShader("MetallicRoughness")
            .set("baseColor", Vec4(0, 0, 0, alpha))
            .set("emissive", Color(1.0f))
            .set("alphaMode", mode)
            .make();
    };
    const auto transparency = [&](const ShaderObject& shader) {
        float rgb[3] = {-1, -1, -1};
        EXPECT_EQ(shader.functions().transparency(shader.block(), &tracer.state, rgb), 0);
        return rgb[0];
    };
    EXPECT_EQ(tracer.shade(*made(0, 0.25f))[0], 1); // opaque
    EXPECT_EQ(transparency(*made(0, 0.25f)), 0);
    EXPECT_EQ(tracer.shade(*made(1, 0.49f))[0], 8); // mask: through
    EXPECT_EQ(tracer.tracedDirection[2], -1);
    EXPECT_EQ(transparency(*made(1, 0.49f)), 1);
    EXPECT_EQ(tracer.shade(*made(1, 0.5f))[0], 1);
    EXPECT_EQ(transparency(*made(1, 0.5f)), 0);
    EXPECT_EQ(tracer.shade(*made(2, 0.25f))[0], 0.25f + 0.75f * 8); // blend
    EXPECT_EQ(transparency(*made(2, 0.25f)), 0.75f);
}

TEST(MetallicRoughnessTest, SingleSidedSurfacesAreSeenFromTheirNormalsSideOnly) {
    FakeTracer tracer;
    tracer.traced = {8, 8, 8};
    const auto shader = MadeShader("MetallicRoughness")
                            .set("baseColor", Vec4(0, 0, 0, 1))
                            .set("emissive", Color(1.0f))
                            .set("metallic", 0.0f)
                            .set("doubleSided", 0)
                            .make();
    EXPECT_EQ(tracer.shade(*shader)[0], 1);
    tracer.setRay(0, 0, 1);
    EXPECT_EQ(tracer.shade(*shader)[0], 8);
    for (float& n : tracer.state.shadingNormal) n = -n; // a mirrored instance: winding turned
    EXPECT_EQ(tracer.shade(*shader)[0], 1);
}

TEST(SurfacesTest, NothingIsNanWhereverTheLightIs) {
    for (const std::string& name : builtinClassNames()) {
        if (findBuiltinClass(name)->kind() != RT_SURFACE_SHADER) continue;
        for (const double z : {0.0, 1e-30, 1.0, -1.0})
            for (const float ray : {-1.0f, 0.0f, 1.0f}) {
                FakeTracer tracer;
                tracer.setRay(std::sqrt(1 - ray * ray), 0, ray);
                tracer.lights = {light(1, 0, z, 1e30f, 0, 1), light(0, 0, z ? z : 1, 1, 1, 1)};
                const auto shader = MadeShader(name.c_str()).make();
                for (const float value : tracer.shade(*shader))
                    EXPECT_TRUE(std::isfinite(value)) << name;
            }
    }
}

} // namespace
} // namespace smart
