// SPDX-License-Identifier: MIT
#include "libsmart/render/camera_rays.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <random>

#include "tests/libsmart/render/picture_scene.h"

namespace smart::test {
namespace {

constexpr float kInf = std::numeric_limits<float>::infinity();

/// Frames can not be copied: this one is filled in place.
struct CameraFrame {
    Frame frame;
    CameraFrame(const glm::dmat4& projection, const Viewport& viewport) {
        frame.matrixCamera = cameraOf(projection);
        frame.viewport = viewport;
    }
    explicit CameraFrame(CameraRay cameraRay) {
        frame.viewport = {0, 0, 100, 50};
        frame.camera = makeCamera(std::move(cameraRay));
    }
};

/// Random points in the viewport: points of their rays have to be seen where the rays were made.
/// Returns the largest distance in pixels.
double largestError(const glm::dmat4& projection, const Viewport& viewport, double moved = 0) {
    const CameraFrame camera(projection, viewport);
    const CameraRays rays(camera.frame);
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    double worst = 0;
    for (int i = 0; i < 10000; ++i) {
        const double x = viewport.x + uniform(random) * viewport.width;
        const double y = viewport.y + uniform(random) * viewport.height;
        Ray ray;
        if (!rays.make(x + moved, y, ray)) return 1e9;
        const glm::dvec3 direction(ray.dir[0], ray.dir[1], ray.dir[2]);
        if (std::abs(glm::length(direction) - 1.0) > 1e-6) return 1e9;
        const double far = std::min(double(ray.tFar), 1e4 * (1.0 + ray.tNear));
        const double t = ray.tNear + uniform(random) * (far - ray.tNear);
        const glm::dvec3 origin(ray.org[0], ray.org[1], ray.org[2]);
        const glm::dvec4 clip = projection * glm::dvec4(origin + t * direction, 1.0);
        const double seenX = viewport.x + (clip.x / clip.w + 1.0) / 2.0 * viewport.width;
        const double seenY = viewport.y + (clip.y / clip.w + 1.0) / 2.0 * viewport.height;
        worst = std::max(worst, std::hypot(seenX - x, seenY - y));
        // In front of the viewer, between the planes, and as deep as the projection says.
        const double depth = (clip.z / clip.w + 1.0) / 2.0;
        if (!(clip.w > 0.0) || depth < -1e-5 || depth > 1.0 + 1e-5) return 1e9;
        if (std::abs(rays.depth(ray, float(t)) - depth) > 1e-5) return 1e9;
    }
    return worst;
}

TEST(CameraRays, PointsAreSeenWhereTheirRaysWereMade) {
    const Viewport viewport{0, 0, 1024, 768}, shifted{-100, 37, 1920, 1080};
    const glm::dmat4 perspective = glm::perspective(1.0, 4.0 / 3.0, 0.1, 1000.0);
    EXPECT_LT(largestError(perspective, viewport), 0.01);
    EXPECT_LT(largestError(perspective, shifted), 0.01);
    const glm::dmat4 offAxis = glm::frustum(-0.3, 1.7, 0.2, 0.9, 0.5, 200.0);
    EXPECT_LT(largestError(offAxis, viewport), 0.01);
    const glm::dmat4 orthographic = glm::ortho(-3.0, 5.0, -2.0, 2.0, -10.0, 40.0);
    EXPECT_LT(largestError(orthographic, viewport), 0.01);
    EXPECT_LT(largestError(glm::infinitePerspective(1.2, 1.5, 0.01), viewport), 0.01);
    const glm::dmat4 reversed = glm::perspective(1.0, 4.0 / 3.0, 50.0, 1.0); // near beyond far
    EXPECT_LT(largestError(reversed, viewport), 0.01);
    const glm::dmat4 view =
        glm::lookAt(glm::dvec3(3, 4, 5), glm::dvec3(0.5, -1, 0.25), glm::dvec3(0, 1, 0));
    EXPECT_LT(largestError(perspective * view, viewport), 0.01);
    EXPECT_LT(largestError(orthographic * view, viewport), 0.01);
    // The checker sees rays that are a fiftieth of a pixel off.
    EXPECT_GT(largestError(perspective, viewport, 0.02), 0.01);
}

TEST(CameraRays, FrustumAgainstItsDefinition) {
    const double l = -0.25, r = 0.5, b = -0.5, t = 0.125, n = 0.25, f = 64.0;
    const CameraFrame camera(glm::frustum(l, r, b, t, n, f), {0, 0, 300, 200});
    const CameraRays rays(camera.frame);
    for (uint32_t y = 0; y < 200; y += 7)
        for (uint32_t x = 0; x < 300; x += 7) {
            Ray ray;
            ASSERT_TRUE(rays.make(x + 0.5, y + 0.5, ray));
            for (int k = 0; k < 3; ++k) {
                EXPECT_EQ(ray.org[k], 0.0f);
                EXPECT_FALSE(std::signbit(ray.org[k]));
            }
            const glm::dvec3 onNear(l + (r - l) * (x + 0.5) / 300, b + (t - b) * (y + 0.5) / 200,
                                    -n);
            const double length = glm::length(onNear);
            for (int k = 0; k < 3; ++k) EXPECT_FLOAT_EQ(ray.dir[k], float(onNear[k] / length));
            EXPECT_FLOAT_EQ(ray.tNear, float(length * kBeforeNear));
            EXPECT_FLOAT_EQ(ray.tFar, float(length * f / n * kBeyondFar));
            EXPECT_LT(ray.tNear, float(length));
            EXPECT_GT(ray.tFar, float(length * f / n));
            EXPECT_NEAR(rays.depth(ray, float(length)), 0.0, 1e-6);
            EXPECT_NEAR(rays.depth(ray, float(length * f / n)), 1.0, 1e-6);
            // Window depth of a frustum, half way in eye space.
            const double z = (n + f) / 2;
            EXPECT_NEAR(rays.depth(ray, float(length * z / n)), f * (z - n) / (z * (f - n)), 1e-6);
        }
}

TEST(CameraRays, RaysLeadToTheEyeWhereTheNearPlaneIsTheFartherOne) {
    const CameraFrame camera(glm::perspective(1.0, 1.0, 50.0, 1.0), {0, 0, 10, 10});
    Ray ray;
    ASSERT_TRUE(CameraRays(camera.frame).make(5.0, 5.0, ray));
    EXPECT_FLOAT_EQ(ray.org[2], -50.0f);
    EXPECT_EQ(ray.dir[2], 1.0f);
    EXPECT_EQ(ray.tNear, 0.0f);
    EXPECT_FLOAT_EQ(ray.tFar, float(49.0 * kBeyondFar));
}

TEST(CameraRays, OrthographicRaysStartOnTheNearPlane) {
    const CameraFrame camera(glm::ortho(-1.0, 3.0, -2.0, 2.0, 1.0, 9.0), {0, 0, 4, 4});
    const CameraRays rays(camera.frame);
    Ray ray;
    ASSERT_TRUE(rays.make(0.5, 3.5, ray)); // upper left pixel
    EXPECT_FLOAT_EQ(ray.org[0], -0.5f);
    EXPECT_FLOAT_EQ(ray.org[1], 1.5f);
    EXPECT_FLOAT_EQ(ray.org[2], -1.0f);
    EXPECT_EQ(ray.dir[0], 0.0f);
    EXPECT_EQ(ray.dir[1], 0.0f);
    EXPECT_EQ(ray.dir[2], -1.0f);
    EXPECT_EQ(ray.tNear, 0.0f);
    EXPECT_FLOAT_EQ(ray.tFar, float(8.0 * kBeyondFar));
}

TEST(CameraRays, InfiniteFarPlaneIsNoLimit) {
    const CameraFrame camera(glm::infinitePerspective(1.0, 1.0, 0.5), {0, 0, 10, 10});
    Ray ray;
    ASSERT_TRUE(CameraRays(camera.frame).make(5.0, 5.0, ray));
    EXPECT_EQ(ray.tFar, kInf);
    EXPECT_FLOAT_EQ(ray.tNear, float(0.5 * kBeforeNear));
}

TEST(CameraRays, ViewportCoversItsPixelsOnly) {
    const CameraFrame camera(glm::dmat4(1.0), {-3, 5, 10, 2});
    const CameraRays rays(camera.frame);
    for (uint32_t y = 0; y < 12; ++y)
        for (uint32_t x = 0; x < 12; ++x)
            EXPECT_EQ(rays.covers(x, y), x < 7 && (y == 5 || y == 6)) << x << ' ' << y;
    const CameraFrame largest(glm::dmat4(1.0), {INT32_MIN, INT32_MAX, UINT32_MAX, UINT32_MAX});
    EXPECT_FALSE(CameraRays(largest.frame).covers(0, 0));
    EXPECT_TRUE(CameraRays(largest.frame).covers(0, uint32_t(INT32_MAX)));
}

TEST(CameraRays, CameraShaderSeesTheUnitSquareAndItsLimitsAreInItsUnits) {
    const CameraFrame camera([](float x, float y, RTScameraray* ray) {
        *ray = {{x, y, 7.0f}, {0.0f, 0.0f, 4.0f}, 0.5f, 2.0f, nullptr};
        return 0;
    });
    const CameraRays rays(camera.frame);
    Ray ray;
    ASSERT_TRUE(rays.make(25.0, 25.0, ray)); // of 100 x 50
    EXPECT_EQ(ray.org[0], 0.25f);
    EXPECT_EQ(ray.org[1], 0.5f);
    EXPECT_EQ(ray.org[2], 7.0f);
    EXPECT_EQ(ray.dir[2], 1.0f);
    EXPECT_EQ(ray.tNear, 2.0f);
    EXPECT_EQ(ray.tFar, 8.0f);
    EXPECT_FLOAT_EQ(rays.depth(ray, 3.0f), 0.75f);
}

TEST(CameraRays, RaysThatAreNoneAreRefused) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const auto refused = [](int answer, float origin, float direction) {
        const CameraFrame camera([=](float, float, RTScameraray* ray) {
            *ray = {{origin, 0, 0}, {0, direction, 0}, 0.0f, kInf, nullptr};
            return answer;
        });
        Ray ray;
        return !CameraRays(camera.frame).make(1.0, 1.0, ray);
    };
    EXPECT_FALSE(refused(0, 1.0f, 2.0f));
    EXPECT_TRUE(refused(1, 1.0f, 2.0f));
    EXPECT_TRUE(refused(0, nan, 2.0f));
    EXPECT_TRUE(refused(0, kInf, 2.0f));
    EXPECT_TRUE(refused(0, 1.0f, nan));
    EXPECT_TRUE(refused(0, 1.0f, 0.0f));
    EXPECT_TRUE(refused(0, 1.0f, kInf));
    EXPECT_FALSE(refused(0, 1.0f, 1e-38f)); // short, but a direction
    EXPECT_FALSE(refused(0, 1.0f, 1e38f));
}

} // namespace
} // namespace smart::test
