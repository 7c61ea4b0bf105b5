// SPDX-License-Identifier: MIT
// The light that points receive from lights with an extent, against closed forms. What a white
// diffuse surface shows is the irradiance divided by pi.
#include "libsmart/shading/builtin/area_lights.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "tests/libsmart/shading/fake_tracer.h"

namespace smart {
namespace {

using namespace smart::builtin;
using test::FakeTracer;

constexpr double kPi = 3.14159265358979323846;

struct Estimate {
    double mean = 0, sigma = 0; ///< sigma: of the mean
    int lit = 0;
};

/// Mean of what a white surface at `at` with this normal shows, over rounds of n samples.
/// `visible`: whether nothing is between.
template <class Light>
Estimate shown(const Light& light, const Vec3& at, const Vec3& normal, RTuint n, int rounds,
               const std::function<bool(const LightSample&)>& visible = {}) {
    FakeTracer tracer;
    std::mt19937 generator(11);
    tracer.nextRandom = [&] { return float(generator() >> 8) * 0x1p-24f; };
    tracer.state.position[0] = at.x;
    tracer.state.position[1] = at.y;
    tracer.state.position[2] = at.z;
    openrt::TraceContext context(&tracer.state);
    double sum = 0, squares = 0;
    Estimate result;
    for (int round = 0; round < rounds; ++round) {
        double one = 0;
        for (RTuint i = 0; i < n; ++i) {
            LightSample sample{};
            if (!light.illuminate(context, i, n, sample)) continue;
            EXPECT_NEAR(length(sample.direction), 1, 1e-6f);
            ++result.lit;
            const double cosine = dot(normal, sample.direction);
            if (cosine > 0 && (!visible || visible(sample)))
                one += double(sample.radiance.r) * cosine / n;
        }
        sum += one;
        squares += one * one;
    }
    result.mean = sum / rounds;
    result.sigma = std::sqrt(std::max(squares / rounds - result.mean * result.mean, 0.0) / rounds);
    return result;
}

void expectWithin(const Estimate& got, double wanted, const char* what) {
    EXPECT_NEAR(got.mean, wanted, 4 * got.sigma + 2e-6 * wanted) << what;
    EXPECT_LT(got.sigma, 0.01 * wanted) << what; // or the test says nothing
}

/// Lambert's formula for a polygon above the horizon: 1 / (2 pi) * sum of the angle between
/// neighbouring corners times the cosine of their plane's normal.
double polygonFormFactor(const Vec3 (&corners)[4], const Vec3& at, const Vec3& normal) {
    double sum = 0;
    for (int i = 0; i < 4; ++i) {
        const Vec3 a = normalize(corners[i] - at), b = normalize(corners[(i + 1) % 4] - at);
        const double cosine = std::fmin(std::fmax(double(dot(a, b)), -1), 1);
        sum += std::acos(cosine) * double(dot(normalize(cross(a, b)), normal));
    }
    return std::fabs(sum) / (2 * kPi);
}

TEST(QuadLightTest, IrradianceIsLambertsFormula) {
    QuadLight light;
    light.corner = {-1, -2, 3};
    light.edge1 = {2, 0.5f, 0};
    light.edge2 = {0.25f, 3, -0.5f};
    light.radiance = Color(7.0f);
    light.twoSided = true;
    const Vec3 c = light.corner;
    const Vec3 corners[4] = {c, c + light.edge1, c + light.edge1 + light.edge2, c + light.edge2};
    for (const Vec3& at : {Vec3(0, 0, 0), Vec3(1.5f, -0.5f, 1), Vec3(-3, 1, -1)})
        for (const RTuint n : {1u, 6u, 16u}) {
            const Vec3 normal = normalize(Vec3(0.1f, -0.1f, 1));
            const Estimate got = shown(light, at, normal, n, int(32000 / n));
            expectWithin(got, 7 * polygonFormFactor(corners, at, normal), "quad");
        }
    // Sixteen strata have less noise than sixteen independent samples.
    EXPECT_LT(shown(light, {}, {0, 0, 1}, 16, 500).sigma,
              0.5 * shown(light, {}, {0, 0, 1}, 1, 8000).sigma);
}

TEST(QuadLightTest, ShinesToOneSideUnlessAskedForTwo) {
    QuadLight light; // towards +z
    EXPECT_EQ(shown(light, {0, 0, -2}, {0, 0, 1}, 4, 10).lit, 0);
    EXPECT_EQ(shown(light, {0, 0, 2}, {0, 0, -1}, 4, 10).lit, 40);
    light.twoSided = true;
    const double behind = shown(light, {0, 0, -2}, {0, 0, 1}, 4, 100).mean;
    EXPECT_NEAR(behind / shown(light, {0, 0, 2}, {0, 0, -1}, 4, 100).mean, 1, 0.05);
    EXPECT_EQ(shown(light, {0.1f, 0.1f, 0}, {0, 0, 1}, 4, 10).lit, 0); // in its plane
}

TEST(QuadLightTest, SmallAndFarItIsAPointLight) {
    QuadLight light;
    light.edge1 = {0, 1e-3f, 0};
    light.edge2 = {2e-3f, 0, 0}; // towards -z
    light.corner = {-1e-3f, 2.9995f, 4};
    light.radiance = Color(5e6f);
    const double wanted = 5e6 * 2e-6 * 0.8 / kPi / 25; // Le A cos / (pi d^2)
    expectWithin(shown(light, {}, {0, 0.6f, 0.8f}, 4, 100), wanted, "small quad");
}

TEST(QuadLightTest, PenumbraOfAnEdge) {
    // A half-plane z = 1, x < 0 below a quad at z = 2: from the floor at x the part of the light
    // with x_light > -x is seen. Integrated along x_light, by Lambert's formula for strips.
    QuadLight light;
    light.corner = {-1, -1, 2};
    light.edge1 = {0, 2, 0};
    light.edge2 = {2, 0, 0};
    for (const float x : {-1.5f, -0.6f, -0.2f, 0.0f, 0.3f, 0.9f, 1.5f}) {
        const Vec3 at(x, 0, 0);
        const Estimate got = shown(light, at, {0, 0, 1}, 16, 2000, [&](const LightSample& s) {
            return x + s.direction.x / s.direction.z > 0; // where it passes z = 1
        });
        double wanted = 0;
        const int steps = 4000;
        for (int i = 0; i < steps; ++i)
            for (int j = 0; j < 40; ++j) {
                const double lx = -1 + 2 * (i + 0.5) / steps, ly = -1 + 2 * (j + 0.5) / 40;
                if ((double(x) + lx) / 2 <= 0) continue;
                const double d2 = (lx - x) * (lx - x) + ly * ly + 4;
                wanted += 4 / (kPi * d2 * d2) * 4 / (steps * 40.0);
            }
        if (wanted > 0)
            EXPECT_NEAR(got.mean, wanted, 4 * got.sigma + 1e-4 * wanted) << x;
        else
            EXPECT_EQ(got.mean, 0) << x;
    }
}

/// What a white surface shows below a sphere of radiance 1: Howell, "A catalog of radiation heat
/// transfer configuration factors", B-43; h = distance / radius.
double sphereFormFactor(double h, double cosine) {
    if (cosine * h > 1) return cosine / (h * h); // all above the horizon
    if (cosine * h < -1) return 0;
    const double sine = std::sqrt(1 - cosine * cosine), x = std::sqrt(h * h - 1);
    const double y = -x * cosine / sine;
    return (cosine * std::acos(y) - x * sine * std::sqrt(1 - y * y)) / (kPi * h * h) +
           std::atan(sine * std::sqrt(1 - y * y) / x) / kPi;
}

TEST(SphereLightTest, IrradianceIsTheClosedForm) {
    SphereLight light;
    light.center = {1, 2, 3};
    light.radius = 1.5f;
    light.radiance = Color(4.0f);
    for (const double distance : {1.6, 2.5, 20.0})
        for (const double tilt : {0.0, 0.8, 1.4, 1.57, 1.8}) { // partly below the horizon too
            const Vec3 at(1, 2, float(3 - distance));
            const Vec3 normal(float(std::sin(tilt)), 0, float(std::cos(tilt)));
            const double h = distance / 1.5;
            const double wanted = 4 * sphereFormFactor(h, std::cos(tilt));
            const Estimate got = shown(light, at, normal, 16, 1500);
            EXPECT_NEAR(got.mean, wanted, 4 * got.sigma + 1e-5 * wanted) << distance << " " << tilt;
            if (wanted > 0) {
                EXPECT_LT(got.sigma, 0.02 * wanted) << distance << " " << tilt;
            }
        }
}

TEST(SphereLightTest, DirectionsFillTheConeAndDistancesEndOnTheSphere) {
    SphereLight light;
    light.center = {0, 0, 5};
    light.radius = 3;
    FakeTracer tracer;
    openrt::TraceContext context(&tracer.state);
    float u = 0, v = 0;
    bool first = true;
    tracer.nextRandom = [&] { return (first = !first) ? v : u; };
    for (u = 0; u < 1; u += 0.09f)
        for (v = 0; v < 1; v += 0.13f) {
            LightSample s{};
            ASSERT_TRUE(light.illuminate(context, 0, 1, s));
            EXPECT_NEAR(s.direction.z, 1 - u * 0.2, 1e-6); // cosine of the cone is 4/5
            EXPECT_NEAR(length(s.direction * s.distance - light.center), 3, 4e-6);
            EXPECT_LT(s.distance, 4.0001f);
        }
}

TEST(SphereLightTest, FarAndTinyIsExact) {
    SphereLight light;
    light.center = {0, 6e5f, 8e5f};
    light.radius = 1e-3f;
    light.radiance = Color(1e18f);
    const Estimate got = shown(light, {}, {0, 0, 1}, 4, 10);
    EXPECT_NEAR(got.mean / (1e18 * 1e-18 * 0.8), 1, 1e-6); // Le r^2 / d^2 * cosine
    light.center = {0, 0, 1e-20f};
    light.radius = 1e-26f;
    EXPECT_NEAR(shown(light, {}, {0, 0, 1}, 4, 10).mean / 1e6, 1, 1e-5);
}

TEST(SphereLightTest, PointsInsideGetNothing) {
    SphereLight light;
    for (const float z : {0.0f, 0.2f, 0.5f})
        EXPECT_EQ(shown(light, {0, 0, z}, {0, 0, 1}, 4, 10).lit, 0) << z;
    EXPECT_GT(shown(light, {0, 0, 0.51f}, {0, 0, -1}, 4, 10).lit, 0);
    light.radius = 0;
    EXPECT_EQ(shown(light, {0, 0, 2}, {0, 0, -1}, 4, 10).lit, 0);
}

TEST(AreaLightsTest, AskForTheirSamples) {
    for (const char* name : {"QuadLight", "SphereLight"})
        for (const int samples : {-3, 0, 1, 4, 100}) {
            const auto light = test::MadeShader(name).set("samples", samples).make();
            EXPECT_EQ(light->functions().lightSamples(light->block()),
                      RTuint(std::max(samples, 1)));
        }
}

TEST(StrataTest, EachSampleHasItsCell) {
    for (RTuint n = 1; n <= 40; ++n) {
        const Strata strata(n);
        ASSERT_EQ(strata.columns * strata.rows, n);
        ASSERT_LE(strata.columns, strata.rows);
        std::vector<int> hits(n);
        for (RTuint i = 0; i < n; ++i)
            ++hits[RTuint(strata.u(i, 0.5f) * float(strata.columns)) +
                   strata.columns * RTuint(strata.v(i, 0.5f) * float(strata.rows))];
        for (const int count : hits) EXPECT_EQ(count, 1) << n;
    }
    EXPECT_EQ(Strata(16).columns, 4u);
    EXPECT_EQ(Strata(12).columns, 3u);
}

} // namespace
} // namespace smart
