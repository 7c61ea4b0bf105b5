// SPDX-License-Identifier: MIT
#include "libsmart/shading/builtin/microfacet.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/libsmart/shading/builtin/ggx_integrals.h"

namespace smart {
namespace {

using namespace smart::builtin;

TEST(MicrofacetTest, TheTableHoldsTheAlbedos) {
    for (const double roughness : {0.04, 0.09, 0.2, 0.33, 0.5, 0.71, 0.99})
        for (const double mu : {0.08, 0.2, 0.41, 0.77, 1.0}) {
            const test::GgxAlbedo wanted = test::ggxAlbedo(mu, roughness);
            const auto got = microfacetAlbedo(float(mu), float(roughness));
            EXPECT_NEAR(got.white / wanted.white, 1, 0.003) << mu << " " << roughness;
            EXPECT_NEAR(got.grazing, wanted.grazing, 0.003) << mu << " " << roughness;
        }
}

TEST(MicrofacetTest, NoArgumentLeavesTheTable) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const float mu : {-1.0f, 0.0f, 1e-30f, 1.0f, 9.0f, nan})
        for (const float roughness : {-1.0f, 0.0f, 0.04f, 1.0f, 9.0f, nan}) {
            const auto got = microfacetAlbedo(mu, roughness);
            EXPECT_GT(got.white, 0.2f);
            EXPECT_LE(got.white, 1.0f);
            EXPECT_GE(got.grazing, 0.0f);
            EXPECT_LE(got.grazing, got.white * 1.001f);
        }
}

TEST(MicrofacetTest, VisibleNormalsHaveTheirDensity) {
    // The share of normals within 30 degrees of the surface's, against the integral of the density.
    const float alpha = 0.5f;
    for (const float mu : {1.0f, 0.6f, 0.1f}) {
        const Vec3 view(std::sqrt(1 - mu * mu), 0, mu);
        const int side = 400;
        int inside = 0;
        for (int i = 0; i < side; ++i)
            for (int j = 0; j < side; ++j) {
                const Vec3 h = visibleNormal(view, alpha, (float(i) + 0.5f) / float(side),
                                             (float(j) + 0.5f) / float(side));
                EXPECT_NEAR(length(h), 1, 1e-6f);
                inside += h.z > 0.8660254f;
            }
        EXPECT_NEAR(double(inside) / (side * side), test::visibleWithin(mu, alpha, 0.8660254),
                    5e-3) // the step of either grid at the limit
            << mu;
    }
}

TEST(MicrofacetTest, TheHighlightsMiddleIsExactForSmoothSurfaces) {
    const float a2 = 0.0016f * 0.0016f;
    const Vec3 up(0, 0, 1);
    // D G / (4 (n.l) (n.v)) = 1 / (4 pi a2) there.
    EXPECT_NEAR(microfacetPeak(up, up, 1.0f, 1.0f, a2) * 4 * a2, 1, 1e-5);
}

} // namespace
} // namespace smart
