// SPDX-License-Identifier: MIT
#include "libsmart/shading/builtin/glass.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/libsmart/shading/fake_tracer.h"

namespace smart {
namespace {

using openrt::Color;
using smart::builtin::Fresnel;
using test::FakeTracer;
using test::MadeShader;

constexpr double kPi = 3.14159265358979323846;

/// Fresnel's equations by angles: sin^2 and tan^2 of difference over sum; 1 in total reflection.
double reflectance(double eta, double angle) {
    const double sine = eta * std::sin(angle);
    if (sine >= 1) return 1;
    const double behind = std::asin(sine);
    if (angle < 1e-7) return std::pow((eta - 1) / (eta + 1), 2);
    const double s = std::sin(angle - behind) / std::sin(angle + behind);
    const double p = std::tan(angle - behind) / std::tan(angle + behind);
    return (s * s + p * p) / 2;
}

TEST(FresnelTest, FollowsTheClosedFormAtAllAnglesOnBothSides) {
    for (const double index : {1.0003, 1.33, 1.5, 2.42})
        for (const double eta : {1 / index, index})
            for (int degree = 0; degree < 90; ++degree) {
                const double angle = degree * kPi / 180;
                const Fresnel<float> got{float(eta), float(std::cos(angle))};
                if (std::fabs(eta * std::sin(angle) - 1) < 1e-3) continue; // infinite slope
                EXPECT_NEAR(got.reflectance, reflectance(eta, angle), 2e-5)
                    << eta << " " << degree;
                const double sine = eta * std::sin(angle);
                const double cosine = sine < 1 ? std::sqrt(1 - sine * sine) : 0;
                EXPECT_NEAR(got.transmittedCosine, cosine, 2e-5) << eta << " " << degree;
            }
}

TEST(FresnelTest, LimitsAndBrewstersAngle) {
    EXPECT_NEAR(Fresnel<float>(1 / 1.5f, 1).reflectance, 0.04, 1e-7);
    EXPECT_NEAR(Fresnel<float>(1.5f, 1).reflectance, 0.04, 1e-7);
    EXPECT_EQ(Fresnel<float>(1 / 1.5f, 0).reflectance, 1);
    EXPECT_EQ(Fresnel<float>(1.5f, 0.5f).reflectance, 1); // total reflection
    EXPECT_EQ(Fresnel<float>(1.5f, 0.5f).transmittedCosine, 0);
    for (const float cosine : {0.25f, 1.0f})
        EXPECT_NEAR(Fresnel<float>(1, cosine).reflectance, 0, 1e-7); // no border
    EXPECT_TRUE(std::isfinite(Fresnel<float>(1, 0).reflectance));
    // At Brewster's angle light polarised in the plane of incidence is not reflected: what is,
    // is half of s, whose reflectance is ((1 - n^2) / (1 + n^2))^2 there.
    const double n = 1.5, brewster = std::atan(n);
    EXPECT_NEAR(Fresnel<float>(float(1 / n), float(std::cos(brewster))).reflectance,
                std::pow((1 - n * n) / (1 + n * n), 2) / 2, 1e-6);
}

void setRay(FakeTracer& tracer, double angle, bool inside) {
    tracer.setRay(float(std::sin(angle)), 0, float(inside ? std::cos(angle) : -std::cos(angle)));
}

TEST(GlassTest, ReflectsAndRefractsBySnellsLaw) {
    for (const bool inside : {false, true})
        for (int degree = 0; degree < 90; degree += 3) {
            FakeTracer tracer;
            tracer.traced = {1, 1, 1};
            const double angle = degree * kPi / 180, eta = inside ? 1.5 : 1 / 1.5;
            setRay(tracer, angle, inside);
            const auto rgba = tracer.shade(*MadeShader("Glass").make());
            EXPECT_NEAR(rgba[0], 1, 1e-6) << degree; // R + T = 1
            const auto& mirrored = tracer.directions.at(0);
            EXPECT_NEAR(mirrored[0], std::sin(angle), 1e-6);
            EXPECT_NEAR(mirrored[2], inside ? -std::cos(angle) : std::cos(angle), 1e-6);
            const double sine = eta * std::sin(angle);
            if (sine >= 1) {
                EXPECT_EQ(tracer.tracedRays, 1) << degree;
                continue;
            }
            ASSERT_EQ(tracer.tracedRays, 2) << degree;
            const auto& refracted = tracer.directions.at(1);
            EXPECT_NEAR(refracted[0], sine, 2e-6) << degree;
            EXPECT_NEAR(refracted[2], (inside ? 1 : -1) * std::sqrt(1 - sine * sine), 4e-6)
                << degree;
            EXPECT_NEAR(tracer.tracedWeight, 1 - reflectance(eta, angle), 2e-5) << degree;
        }
}

TEST(GlassTest, AbsorbsOnTheWayInsideOnly) {
    FakeTracer tracer;
    tracer.traced = {1, 1, 1};
    tracer.state.rayDistance = 1.75f;
    const auto shader =
        MadeShader("Glass").set("absorption", Color(0.1f, 0.5f, 2)).make();
    EXPECT_NEAR(tracer.shade(*shader)[2], 1, 1e-6);
    tracer.setRay(0, 0, 1);
    for (const RTuint flags : {0u, RTS_INDIRECT}) {
        tracer.state.flags = flags;
        const auto rgba = tracer.shade(*shader);
        EXPECT_NEAR(rgba[0], std::exp(-0.1 * 1.75), 1e-6);
        EXPECT_NEAR(rgba[1], std::exp(-0.5 * 1.75), 1e-6);
        EXPECT_NEAR(rgba[2], std::exp(-2.0 * 1.75), 1e-6);
    }
}

TEST(GlassTest, ColourTintsWhatPasses) {
    FakeTracer tracer;
    tracer.traced = {1, 1, 1};
    const auto rgba =
        tracer.shade(*MadeShader("Glass").set("color", Color(0.5f, 1, 0)).make());
    EXPECT_NEAR(rgba[0], 0.04 + 0.96 * 0.5, 1e-6);
    EXPECT_NEAR(rgba[1], 1, 1e-6);
    EXPECT_NEAR(rgba[2], 0.04, 1e-6);
}

TEST(GlassTest, ShadowRaysGoStraightOn) {
    const auto shader = MadeShader("Glass").set("color", Color(1, 0.5f, 1)).make();
    for (const bool inside : {false, true})
        for (const double angle : {0.0, 0.7, 1.4}) {
            FakeTracer tracer;
            setRay(tracer, angle, inside);
            float rgb[3] = {};
            ASSERT_EQ(shader->functions().transparency(shader->block(), &tracer.state, rgb), 0);
            EXPECT_NEAR(rgb[0], 1 - reflectance(1 / 1.5, angle), 1e-5);
            EXPECT_NEAR(rgb[1], 0.5 * rgb[0], 1e-6);
        }
    EXPECT_FALSE(shader->functions().opaque && shader->functions().opaque(shader->block()));
}

TEST(GlassTest, PathsChooseReflectionAsOftenAsItIsStrong) {
    FakeTracer tracer;
    std::mt19937 generator(3);
    tracer.nextRandom = [&] { return float(generator() >> 8) * 0x1p-24f; };
    tracer.state.flags = RTS_INDIRECT;
    tracer.traced = {1, 1, 1};
    const double angle = 1.3;
    setRay(tracer, angle, false);
    const auto shader = MadeShader("Glass").make();
    const int count = 20000;
    for (int i = 0; i < count; ++i) EXPECT_EQ(tracer.shade(*shader)[0], 1);
    int reflected = 0;
    for (const auto& d : tracer.directions) reflected += d[2] > 0;
    const double wanted = reflectance(1 / 1.5, angle);
    EXPECT_NEAR(double(reflected) / count, wanted, 4 * std::sqrt(wanted / count));
    EXPECT_EQ(tracer.tracedRays, count);
}

} // namespace
} // namespace smart
