// SPDX-License-Identifier: MIT
// The conservation of energy in whole pictures: what reflects all light is invisible in an
// environment of radiance 1, and light between surfaces adds up to its geometric series.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "openrt/rt.hpp"

namespace {

using openrt::Color;
using openrt::Vec3;
using openrt::Vec4;

constexpr double kPi = 3.14159265358979323846;
constexpr RTuint kSide = 6;

/// A context of its own, and the parts of a frame.
class FurnaceTest : public testing::Test {
protected:
    void SetUp() override {
        rtInit(nullptr, nullptr);
        pixels_.resize(std::size_t(kSide) * kSide * 3);
        rtSetFrameBuffer(reinterpret_cast<RTubyte*>(pixels_.data()), kSide, kSide, RT_RGB_32F);
        rtRecursionLimit(64);
    }
    void TearDown() override {
        EXPECT_EQ(rtGetError(), RTenum(RT_NO_ERROR)) << rtGetErrorText();
        rtExit();
    }

    static RTuint make(const char* shaderClass) {
        rtGenNewShaderClass(shaderClass, nullptr);
        return rtGenNewShader();
    }
    template <class T>
    static void set(const char* name, const T& value) {
        rtParameter(rtParameterHandle(name), value);
    }

    /// A sphere of radius 1 of the bound shader, its normals interpolated.
    static void drawSphere() {
        const int rings = 16, sectors = 32;
        const auto point = [&](int ring, int sector) {
            const double polar = kPi * ring / rings, around = 2 * kPi * sector / sectors;
            const double x = std::sin(polar) * std::cos(around), y = std::cos(polar),
                         z = -std::sin(polar) * std::sin(around);
            rtNormal3d(x, y, z);
            rtVertex3d(x, y, z);
        };
        for (int ring = 0; ring < rings; ++ring) {
            rtBegin(RT_QUAD_STRIP);
            for (int sector = 0; sector <= sectors; ++sector) {
                point(ring, sector);
                point(ring + 1, sector);
            }
            rtEnd();
        }
    }

    /// A window on the sphere from outside, all of whose pixels show it.
    static void lookAtSphere() {
        rtUseCamera(make("Orthographic"));
        set("lowerLeft", Vec3(-0.68f, -0.68f, 3));
        set("horizontal", Vec3(1.36f, 0, 0));
        set("vertical", Vec3(0, 1.36f, 0));
    }
    static void lookOutOfSphere() {
        rtUseCamera(make("Pinhole"));
        set("origin", Vec3(0.1f, 0.2f, 0.3f));
    }
    static void useEnvironment(float radiance) {
        rtUseEnvironmentShader(make("ConstantEnvironment"));
        set("radiance", Color(radiance));
    }
    static void usePaths(int samples) {
        rtUseRenderingObject(make("PathTracer"));
        set("samples", samples);
    }

    /// Renders, and gives the mean of all pixels, red.
    double render() {
        rtRender();
        RTint bad = 0;
        rtGetIntegerv(RT_STAT_BAD_PIXELS, &bad);
        EXPECT_EQ(bad, 0);
        double sum = 0;
        for (std::size_t i = 0; i < pixels_.size(); i += 3) sum += double(pixels_[i]);
        return sum / (double(kSide) * kSide);
    }
    /// Picture of the bound shader's sphere in the furnace.
    double furnace(RTuint surface, int samples = 1024) {
        lookAtSphere();
        useEnvironment(1);
        usePaths(samples);
        rtBindShader(surface);
        drawSphere();
        return render();
    }

    std::vector<float> pixels_;
};

TEST_F(FurnaceTest, DiffuseSurfaces) {
    EXPECT_NEAR(furnace(make("DiffuseShader"), 64), 1, 1e-5);
    EXPECT_NEAR(furnace(make("TexturedDiffuseShader"), 64), 1, 1e-5);
    const RTuint phong = make("Phong");
    set("diffuse", Color(1.0f));
    set("ambient", Color(9.0f)); // not in path tracing
    EXPECT_NEAR(furnace(phong, 64), 1, 1e-5);
    set("diffuse", Color(0.4f));
    EXPECT_NEAR(furnace(phong, 64), 0.4, 1e-5);
}

TEST_F(FurnaceTest, MetallicRoughness) {
    for (const float metallic : {0.0f, 1.0f})
        for (const float roughness : {0.05f, 0.5f, 1.0f}) {
            const RTuint surface = make("MetallicRoughness");
            set("metallic", metallic);
            set("roughness", roughness);
            EXPECT_NEAR(furnace(surface), 1, 0.005) << metallic << " " << roughness;
        }
}

TEST_F(FurnaceTest, WithoutPathsTheEnvironmentAddsUpToo) {
    for (const float metallic : {0.0f, 1.0f}) {
        const RTuint surface = make("MetallicRoughness");
        set("metallic", metallic);
        set("roughness", 0.6f);
        lookAtSphere();
        useEnvironment(1);
        rtBindShader(surface);
        drawSphere();
        EXPECT_NEAR(render(), 1, 1e-4) << metallic;
    }
}

TEST_F(FurnaceTest, Glass) {
    EXPECT_NEAR(furnace(make("Glass")), 1, 0.005);
    const RTuint dense = make("Glass");
    set("index", 2.4f);
    EXPECT_NEAR(furnace(dense), 1, 0.005);
}

TEST_F(FurnaceTest, MirrorsLoseNothingAtTheRim) {
    const auto mirrored = [&](RTuint surface) {
        rtUseCamera(make("Orthographic"));
        set("lowerLeft", Vec3(0.975f, -0.03f, 3));
        set("horizontal", Vec3(0.02f, 0, 0));
        set("vertical", Vec3(0, 0.06f, 0));
        useEnvironment(1);
        rtBindShader(surface);
        drawSphere();
        return render();
    };
    const RTuint mirror = make("MirrorShader");
    set("attenuation", Color(0.5f));
    EXPECT_NEAR(mirrored(mirror), 0.5, 1e-6);
    const RTuint phong = make("Phong");
    set("diffuse", Color(0.0f));
    set("reflection", Color(0.5f));
    EXPECT_NEAR(mirrored(phong), 0.5, 1e-6);
    const float black[4] = {0, 0, 0, 1};
    rtEnable(RT_LIGHTING);
    rtEnable(RT_REFLECTIONS);
    rtMaterialfv(RT_FRONT_AND_BACK, RT_AMBIENT_AND_DIFFUSE, black);
    rtMaterialf(RT_FRONT_AND_BACK, RT_REFLECTION, 0.5f);
    EXPECT_NEAR(mirrored(0), 0.5, 1e-6);
}

TEST_F(FurnaceTest, APathThroughAWeakMirrorIsNoNoisierThanItsRoulette) {
    constexpr int kPaths = 64;
    // A tiny mirror that fills the picture shows the glowing sphere around it and the camera.
    make("MirrorShader");
    set("attenuation", Color(0.01f));
    rtBegin(RT_TRIANGLES);
    rtVertex3f(0.09f, 0.19f, 0.299f);
    rtVertex3f(0.13f, 0.19f, 0.299f);
    rtVertex3f(0.09f, 0.23f, 0.299f);
    rtEnd();
    make("Phong");
    set("emissive", Color(0.5f));
    set("diffuse", Color(0.5f));
    drawSphere();
    lookOutOfSphere();
    usePaths(kPaths);
    const double mean = render() / 0.01;
    EXPECT_NEAR(mean, 1, 0.05);
    double squares = 0;
    for (std::size_t i = 0; i < pixels_.size(); i += 3)
        squares += std::pow(double(pixels_[i]) / 0.01 - mean, 2);
    // Every other path ends at each wall, having gained 0.5 there: geometrically distributed.
    EXPECT_NEAR(std::sqrt(squares / (double(kSide) * kSide)), 0.5 * std::sqrt(2.0 / kPaths), 0.03);
}

TEST_F(FurnaceTest, ASurfaceThatAbsorbsIsSeen) {
    const RTuint glass = make("Glass");
    set("absorption", Color(0.1f));
    EXPECT_LT(furnace(glass, 64), 0.95);
}

TEST_F(FurnaceTest, LightInsideAGlowingSphereIsItsGeometricSeries) {
    for (const float albedo : {0.3f, 0.5f, 0.8f}) {
        const RTuint surface = make("Phong");
        set("emissive", Color(1 - albedo)); // L = e / (1 - albedo) = 1
        set("diffuse", Color(albedo));
        lookOutOfSphere();
        usePaths(1024);
        rtBindShader(surface);
        drawSphere();
        EXPECT_NEAR(render(), 1, 0.005) << albedo;
    }
}

TEST_F(FurnaceTest, TheRecursionLimitCutsTheSeriesShort) {
    rtRecursionLimit(2);
    const RTuint glowing = make("Phong");
    set("emissive", Color(0.5f));
    set("diffuse", Color(0.5f));
    lookOutOfSphere();
    usePaths(64);
    rtBindShader(glowing);
    drawSphere();
    EXPECT_NEAR(render(), 0.5 + 0.25 + 0.125, 1e-5);
}

/// A floor with occlusion under two area lights and a rough metal: random numbers everywhere.
void drawNoisyScene() {
    const auto make = [](const char* name) {
        rtGenNewShaderClass(name, nullptr);
        return rtGenNewShader();
    };
    rtUseCamera(make("Pinhole"));
    rtParameter(rtParameterHandle("origin"), Vec3(0, 0, 4));
    rtUseEnvironmentShader(make("ConstantEnvironment"));
    rtParameter(rtParameterHandle("radiance"), Color(0.2f, 0.3f, 0.4f));
    rtUseLight(make("QuadLight"));
    rtParameter(rtParameterHandle("corner"), Vec3(-0.5f, -0.5f, 3));
    rtParameter(rtParameterHandle("twoSided"), true);
    rtUseLight(make("SphereLight"));
    rtParameter(rtParameterHandle("center"), Vec3(2, 2, 2));
    const RTuint surfaces[3] = {make("AmbientOcclusion"), make("MetallicRoughness"), make("Phong")};
    for (int i = 0; i < 3; ++i) {
        rtBindShader(surfaces[i]);
        rtBegin(RT_TRIANGLES);
        rtVertex3f(float(i) * 0.9f - 2.2f, -2, -float(i) * 0.3f);
        rtVertex3f(float(i) * 0.9f + 1.8f, -2, 0.5f);
        rtVertex3f(float(i) * 0.9f - 0.7f, 2, 0.2f);
        rtEnd();
    }
}

TEST_F(FurnaceTest, DefaultIsAFrameWithoutARenderingObjectToTheBit) {
    for (const RTuint samples : {1u, 5u}) {
        rtSamples(samples);
        drawNoisyScene();
        render();
        const std::vector<float> without = pixels_;
        drawNoisyScene();
        rtUseRenderingObject(make("Default"));
        render();
        EXPECT_EQ(pixels_, without) << samples;
        rtSeed(samples + 10); // another seed is another picture
        drawNoisyScene();
        render();
        EXPECT_NE(pixels_, without) << samples;
        rtSeed(0);
    }
}

} // namespace
