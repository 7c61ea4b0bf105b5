// SPDX-License-Identifier: MIT
// The surfaces against the formulas that their headers state, in double.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "openrt/shader.hpp"
#include "tests/libsmart/shading/fake_tracer.h"

namespace smart {
namespace {

using openrt::Color;
using test::FakeTracer;
using test::MadeShader;
using Rgba = std::array<float, 4>;

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

TEST(SurfacesTest, IndirectLightStandsInThePlaceOfAmbientLight) {
    FakeTracer tracer;
    tracer.state.flags = RTS_INDIRECT;
    tracer.traced = {2, 4, 8};
    tracer.textures[1] = {0.5f, 1, 0.25f, 1};
    expectNear(tracer.shade(*MadeShader("DiffuseShader").set("color", Color(0.5f, 1, 1)).make()),
               {1, 4, 8});
    expectNear(tracer.shade(*MadeShader("TexturedDiffuseShader")
                                 .set("texture", 1)
                                 .set("radiance", Color(9.0f))
                                 .make()),
               {1, 4, 2});
    expectNear(tracer.shade(*phong().set("texture", 1).make()), {0.5, 2, 1 + 1});
    EXPECT_EQ(tracer.tracedRays, 3);
}

TEST(SurfacesTest, DiffuseDirectionsFollowTheCosine) {
    FakeTracer tracer;
    std::mt19937 generator(5);
    tracer.nextRandom = [&] { return float(generator() >> 8) * 0x1p-24f; };
    tracer.state.flags = RTS_INDIRECT;
    tracer.setNormal(0.6f, 0, -0.8f);
    tracer.setRay(0, 0, 1);
    const auto shader = MadeShader("DiffuseShader").make();
    const int count = 20000;
    for (int i = 0; i < count; ++i) tracer.shade(*shader);
    // Means of the cosine, its square and the two other coordinates: 2/3, 1/2, 0, 0.
    double cosine = 0, squared = 0, across = 0, y = 0;
    for (const auto& d : tracer.directions) {
        const double z = 0.6 * d[0] - 0.8 * d[2];
        ASSERT_GT(z, 0);
        cosine += z / count;
        squared += z * z / count;
        across += (0.8 * d[0] + 0.6 * d[2]) / count;
        y += d[1] / count;
    }
    const double sigma = 1 / std::sqrt(double(count));
    EXPECT_NEAR(cosine, 2.0 / 3, 4 * 0.24 * sigma);
    EXPECT_NEAR(squared, 0.5, 4 * 0.29 * sigma);
    EXPECT_NEAR(across, 0, 4 * 0.5 * sigma);
    EXPECT_NEAR(y, 0, 4 * 0.5 * sigma);
}

TEST(SurfacesTest, PathsOfSmallWeightEndByChanceAndCountAsMuchMore) {
    FakeTracer tracer;
    tracer.state.flags = RTS_INDIRECT;
    tracer.state.weight = 0.5f;
    tracer.traced = {1, 1, 1};
    const auto shader = MadeShader("DiffuseShader").set("color", Color(0.125f)).make();
    // The share 1/16 goes on with probability 1/4: the numbers are those of the direction, then
    // of the roulette.
    std::vector<float> numbers;
    std::size_t next = 0;
    tracer.nextRandom = [&] { return numbers[next++ % numbers.size()]; };
    numbers = {0.5f, 0.5f, 0.24f};
    EXPECT_EQ(tracer.shade(*shader)[0], 0.5f);
    EXPECT_EQ(tracer.tracedWeight, 0.25f);
    numbers = {0.5f, 0.5f, 0.26f};
    next = 0;
    EXPECT_EQ(tracer.shade(*shader)[0], 0);
    EXPECT_EQ(tracer.tracedRays, 1);
}

TEST(SurfacesTest, APathThatIsWeakAlreadyIsNotHeldToTheSameLimitAgain) {
    FakeTracer tracer;
    tracer.state.flags = RTS_INDIRECT;
    tracer.state.weight = 0.01f; // as a weak mirror left it
    tracer.traced = {1, 1, 1};
    std::vector<float> numbers{0.5f, 0.5f, 0.74f};
    std::size_t next = 0;
    tracer.nextRandom = [&] { return numbers[next++ % numbers.size()]; };
    const auto shader = MadeShader("DiffuseShader").set("color", Color(0.75f)).make();
    EXPECT_FLOAT_EQ(tracer.shade(*shader)[0], 1); // goes on with probability 3/4
    EXPECT_FLOAT_EQ(tracer.tracedWeight, 0.01f);
    numbers = {0.5f, 0.5f, 0.76f};
    next = 0;
    EXPECT_EQ(tracer.shade(*shader)[0], 0);
}

TEST(SurfacesTest, NoMirroredDirectionLeadsBehindTheTriangle) {
    FakeTracer tracer;
    tracer.state.shadingNormal[0] = 0.6f;
    tracer.state.shadingNormal[2] = 0.8f;
    tracer.setRay(0.8f, 0, -0.6f); // at right angles to that normal: it mirrors nothing
    for (const char* name : {"MirrorShader", "Phong", "MetallicRoughness"}) {
        MadeShader made(name);
        if (name[0] == 'P') std::move(made).set("reflection", Color(1.0f));
        if (name[1] == 'e') std::move(made).set("roughness", 0.0f);
        tracer.shade(*std::move(made).make());
        EXPECT_FLOAT_EQ(tracer.tracedDirection[0], 0.8f) << name;
        EXPECT_FLOAT_EQ(tracer.tracedDirection[2], 0.6f) << name;
    }
    EXPECT_EQ(tracer.tracedRays, 3);
}

TEST(SurfacesTest, NoRandomDirectionLeadsBehindTheTriangle) {
    FakeTracer tracer;
    std::mt19937 generator(6);
    tracer.nextRandom = [&] { return float(generator() >> 8) * 0x1p-24f; };
    tracer.state.flags = RTS_INDIRECT;
    tracer.traced = {1, 1, 1};
    tracer.state.shadingNormal[1] = 0.8f;
    tracer.state.shadingNormal[2] = 0.6f;
    for (const char* name : {"DiffuseShader", "MetallicRoughness", "AmbientOcclusion"}) {
        const auto shader = MadeShader(name).make();
        for (int i = 0; i < 500; ++i) tracer.shade(*shader);
    }
    ASSERT_GT(tracer.directions.size(), 2000u);
    for (const auto& d : tracer.directions) EXPECT_GE(d[2], -1e-6f);
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
