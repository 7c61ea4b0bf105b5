// SPDX-License-Identifier: MIT
// The metallic-roughness surface against glTF's formulas and the conservation of energy.
#include <gtest/gtest.h>

#include <cmath>

#include "openrt/shader.hpp"
#include "tests/libsmart/shading/builtin/ggx_integrals.h"
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

void expectNear(const Rgba& got, const std::array<double, 3>& wanted, double tolerance) {
    for (std::size_t k = 0; k < 3; ++k)
        EXPECT_NEAR(got[k], wanted[k], tolerance * (1 + std::fabs(wanted[k]))) << "channel " << k;
}

/// The specular BRDF of appendix B of the glTF 2.0 specification as written there, times pi and
/// the cosine, for one f0; with what light reflected more often adds.
double specular(double f0, double roughness, double nl, double nv, double nh, double vh) {
    const double a = roughness * roughness, a2 = a * a;
    const double f = f0 + (1 - f0) * std::pow(1 - vh, 5);
    const double d = a2 / (kPi * std::pow(nh * nh * (a2 - 1) + 1, 2));
    const double g = 2 * nl / (nl + std::sqrt(a2 + (1 - a2) * nl * nl)) * 2 * nv /
                     (nv + std::sqrt(a2 + (1 - a2) * nv * nv));
    const double lost = 1 / test::ggxAlbedo(nv, roughness).white - 1;
    return kPi * nl * f * g * d / (4 * nl * nv) * (1 + f0 * lost);
}

/// Share of light that the specular lobe of f0 takes.
double specularAlbedo(double f0, double roughness, double nv) {
    const test::GgxAlbedo once = test::ggxAlbedo(nv, roughness);
    return (f0 * once.white + (1 - f0) * once.grazing) * (1 + f0 * (1 / once.white - 1));
}

/// A mixture of a metal and of a diffuse surface under a dielectric layer.
double gltf(double base, double metallic, double roughness, double nl, double nv, double nh,
            double vh) {
    const double diffuse = base * (1 - specularAlbedo(0.04, roughness, nv)) * nl;
    const double dielectric = diffuse + specular(0.04, roughness, nl, nv, nh, vh);
    return (1 - metallic) * dielectric +
           metallic * specular(base, roughness, nl, nv, nh, vh);
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
                    EXPECT_NEAR(got[k], wanted, 3e-3 * (wanted + 0.01))
                        << metallic << " " << roughness << " " << tilt;
                }
            }
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
                                       gltf(0.5, 0, 1, 1, 1, 1, 1) + 2},
               2e-3);
    EXPECT_EQ(tracer.shadowRays, 1);
    tracer.shadowAttenuation = {0, 0, 0};
    expectNear(tracer.shade(*shader), {0.5, 1, 2}, 1e-6);
}

TEST(MetallicRoughnessTest, TheEnvironmentIsAmbientLight) {
    FakeTracer tracer; // the normal has y = 0, so both directions look at the upper half
    tracer.environmentAt[0] = {1, 2, 4};
    const auto dielectric = MadeShader("MetallicRoughness")
                                .set("baseColor", Vec4(0.5f, 0.5f, 0.5f, 1))
                                .set("metallic", 0.0f)
                                .make();
    const double layer = specularAlbedo(0.04, 1, 1), share = 0.5 * (1 - layer) + layer;
    expectNear(tracer.shade(*dielectric), {share, 2 * share, 4 * share}, 1e-3);
    EXPECT_EQ(tracer.tracedRays, 0);
    tracer.traced = {8, 8, 8};
    const auto mirror = MadeShader("MetallicRoughness").set("roughness", 0.0f).make();
    expectNear(tracer.shade(*mirror), {8, 8, 8}, 1e-3);
    EXPECT_EQ(tracer.tracedRays, 1);
    const auto half = MadeShader("MetallicRoughness").set("roughness", 0.15f).make();
    expectNear(tracer.shade(*half), {4.5, 5, 6}, 1e-3);
}

/// What the surface makes of radiance 1 from everywhere, at a view cosine, on average over evenly
/// spread random numbers (Roberts's additive recurrence in four dimensions).
double furnace(const ShaderObject& shader, double mu, int count, RTuint flags) {
    FakeTracer tracer;
    int sample = 0, dimension = 0;
    tracer.nextRandom = [&] {
        constexpr double kSteps[] = {0.856674883854503, 0.733891856627126, 0.628706721087848,
                                     0.538597257231439};
        const double value = 0.5 + (sample + 1) * kSteps[dimension++ % 4];
        return float(std::floor((value - std::floor(value)) * 0x1p24)) * 0x1p-24f;
    };
    tracer.state.flags = flags;
    tracer.traced = tracer.environmentAt[0] = tracer.environmentAt[1] = {1, 1, 1};
    tracer.setRay(float(std::sqrt(1 - mu * mu)), 0, float(-mu));
    double sum = 0;
    for (; sample < count; ++sample, dimension = 0) sum += double(tracer.shade(shader)[0]);
    return sum / count;
}

TEST(MetallicRoughnessTest, WhiteSurfacesReflectAllLight) {
    for (const float metallic : {0.0f, 0.5f, 1.0f})
        for (const float roughness : {0.0f, 0.3f, 0.7f, 1.0f})
            for (const double mu : {0.1, 0.5, 1.0}) {
                const auto shader = MadeShader("MetallicRoughness")
                                        .set("metallic", metallic)
                                        .set("roughness", roughness)
                                        .make();
                EXPECT_NEAR(furnace(*shader, mu, 10000, RTS_INDIRECT), 1, 0.004)
                    << metallic << " " << roughness << " " << mu;
                EXPECT_NEAR(furnace(*shader, mu, 1, 0), 1, 1e-5)
                    << metallic << " " << roughness << " " << mu;
            }
}

TEST(MetallicRoughnessTest, ColouredSurfacesReflectTheirAlbedo) {
    // The lobes' own integrals, which the random directions must have as their mean.
    for (const float metallic : {0.0f, 1.0f})
        for (const float roughness : {0.2f, 0.8f})
            for (const double mu : {0.2, 0.9}) {
                const auto shader = MadeShader("MetallicRoughness")
                                        .set("baseColor", Vec4(0.3f, 0.3f, 0.3f, 1))
                                        .set("metallic", metallic)
                                        .set("roughness", roughness)
                                        .make();
                const double layer = specularAlbedo(0.04, roughness, mu);
                const double wanted = metallic > 0 ? specularAlbedo(0.3, roughness, mu)
                                                   : layer + 0.3 * (1 - layer);
                EXPECT_NEAR(furnace(*shader, mu, 10000, RTS_INDIRECT), wanted, 0.004)
                    << metallic << " " << roughness << " " << mu;
            }
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

TEST(MetallicRoughnessTest, UnlitItShowsItsColourByItsCoverage) {
    FakeTracer tracer;
    tracer.traced = {8, 8, 8};
    tracer.environmentAt[0] = {3, 3, 3};
    for (float& c : tracer.state.color) c = 0.5f;
    const auto made = [](int alphaMode) {
        return MadeShader("MetallicRoughness")
            .set("unlit", 1)
            .set("baseColor", Vec4(2, 1, 0.5f, 0.5f))
            .set("emissive", Color(1.0f))
            .set("alphaMode", alphaMode)
            .make();
    };
    const auto opaque = tracer.shade(*made(0)), blended = tracer.shade(*made(2));
    const float expected[] = {1, 0.5f, 0.25f};
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_EQ(opaque[c], expected[c]);
        EXPECT_EQ(blended[c], 0.25f * expected[c] + 0.75f * 8);
    }
    EXPECT_EQ(tracer.shade(*made(1))[0], 8); // alpha 0.25 is below the cutoff
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

} // namespace
} // namespace smart
