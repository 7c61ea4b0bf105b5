// SPDX-License-Identifier: MIT
// Cameras against the projections that they stand for, in double.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "libsmart/shading/builtin/environments.h"
#include "openrt/shader.hpp"
#include "tests/libsmart/shading/fake_tracer.h"

namespace smart {
namespace {

using openrt::Mat4;
using openrt::Vec3;
using openrt::Vec4;
using test::FakeTracer;
using test::MadeShader;

constexpr float kInfinity = std::numeric_limits<float>::infinity();

RTScameraray rayOf(const ShaderObject& camera, float x, float y, FakeTracer* tracer = nullptr) {
    RTScameraray ray{};
    ray.state = tracer ? &tracer->state : nullptr;
    EXPECT_EQ(camera.functions().cameraRay(camera.block(), x, y, &ray), 0);
    return ray;
}

TEST(CamerasTest, PinholeAndOrthographicRays) {
    for (const char* name : {"PinholeCameraShader", "Pinhole"}) {
        const auto pinhole = MadeShader(name)
                                 .set("origin", Vec3(1, 2, 3))
                                 .set("lowerLeft", Vec3(-2, -1, -5))
                                 .set("horizontal", Vec3(4, 0, 0))
                                 .set("vertical", Vec3(0, 2, 1))
                                 .make();
        const RTScameraray ray = rayOf(*pinhole, 0.25f, 0.5f);
        EXPECT_EQ(Vec3(ray.origin), Vec3(1, 2, 3));
        EXPECT_EQ(Vec3(ray.direction), Vec3(-1, 0, -4.5f));
        EXPECT_EQ(ray.tnear, 0);
        EXPECT_EQ(ray.tfar, kInfinity);
    }
    const auto parallel = MadeShader("Orthographic").set("direction", Vec3(0, -1, 0)).make();
    const RTScameraray ray = rayOf(*parallel, 1, 0.5f);
    EXPECT_EQ(Vec3(ray.origin), Vec3(1, 0, 0));
    EXPECT_EQ(Vec3(ray.direction), Vec3(0, -1, 0));
}

MadeShader lens() {
    return MadeShader("ThinLens")
        .set("origin", Vec3(1, 2, 3))
        .set("lowerLeft", Vec3(-2, -1, -5))
        .set("horizontal", Vec3(4, 0, 0))
        .set("vertical", Vec3(0, 2, 0));
}

TEST(ThinLensTest, WithoutApertureItIsAPinholeToTheBit) {
    const auto pinhole = MadeShader("Pinhole")
                             .set("origin", Vec3(1, 2, 3))
                             .set("lowerLeft", Vec3(-2, -1, -5))
                             .set("horizontal", Vec3(4, 0, 0))
                             .set("vertical", Vec3(0, 2, 0))
                             .make();
    const auto camera = lens().set("focusDistance", 7.0f).make();
    for (const float x : {0.0f, 0.3f, 0.9f}) {
        const RTScameraray a = rayOf(*camera, x, 1 - x), b = rayOf(*pinhole, x, 1 - x);
        EXPECT_EQ(Vec3(a.origin), Vec3(b.origin));
        EXPECT_EQ(Vec3(a.direction), Vec3(b.direction));
    }
}

TEST(ThinLensTest, AllRaysOfAPointMeetInTheFocalPlane) {
    const auto camera = lens().set("aperture", 0.5f).set("focusDistance", 10.0f).make();
    FakeTracer tracer;
    std::mt19937 generator(2);
    tracer.nextRandom = [&] { return float(generator() >> 8) * 0x1p-24f; };
    double mean[2] = {0, 0}, squares = 0, farthest = 0;
    const int count = 4000;
    for (int i = 0; i < count; ++i) {
        const float x = float(i % 7) / 6, y = float(i % 5) / 4;
        const RTScameraray ray = rayOf(*camera, x, y, &tracer);
        // Where the pinhole's ray meets the plane 10 before the lens.
        const double wanted[3] = {1 + (-2 + 4 * double(x)) * 2, 2 + (-1 + 2 * double(y)) * 2, -7};
        const double t = (wanted[2] - ray.origin[2]) / ray.direction[2];
        for (int k = 0; k < 3; ++k)
            EXPECT_NEAR(ray.origin[k] + t * ray.direction[k], wanted[k], 1e-5);
        EXPECT_FLOAT_EQ(ray.origin[2], 3); // in the lens's plane
        const double dx = ray.origin[0] - 1.0, dy = ray.origin[1] - 2.0;
        mean[0] += dx / count;
        mean[1] += dy / count;
        squares += (dx * dx + dy * dy) / count;
        farthest = std::fmax(farthest, std::hypot(dx, dy));
    }
    EXPECT_NEAR(mean[0], 0, 0.02);
    EXPECT_NEAR(mean[1], 0, 0.02);
    EXPECT_NEAR(squares, 0.125, 0.01); // half of the radius squared on a disk
    EXPECT_LE(farthest, 0.5000001);
    EXPECT_GT(farthest, 0.49);
}

TEST(ThinLensTest, FocusedAtInfinityTheRaysOfAPointAreParallel) {
    const auto camera = lens().set("aperture", 0.5f).set("focusDistance", kInfinity).make();
    FakeTracer tracer;
    tracer.nextRandom = [] { return 0.75f; };
    const RTScameraray ray = rayOf(*camera, 0.25f, 1, &tracer);
    EXPECT_EQ(Vec3(ray.direction), Vec3(-1, 1, -5));
    EXPECT_NEAR(std::hypot(ray.origin[0] - 1, ray.origin[1] - 2), 0.5 * std::sqrt(0.75), 1e-6);
}

TEST(PanoramaTest, ItsPictureIsAnEnvironmentImage) {
    // What the image environment looks up in the camera's direction is the camera's (x, y).
    for (const float rotation : {0.0f, 90.0f, -33.0f}) {
        const auto camera = MadeShader("Panorama")
                                .set("origin", Vec3(4, 5, 6))
                                .set("rotation", rotation)
                                .make();
        const auto sky =
            MadeShader("ImageEnvironment").set("texture", 1).set("rotation", rotation).make();
        RTSfunctions functions = {};
        functions.structSize = sizeof functions;
        functions.texture = [](RTSstate*, RTuint, float s, float t, float rgba[4]) {
            rgba[0] = s;
            rgba[1] = t;
        };
        for (const float x : {0.05f, 0.25f, 0.5f, 0.93f})
            for (const float y : {0.02f, 0.4f, 0.5f, 0.97f}) {
                const RTScameraray ray = rayOf(*camera, x, y);
                EXPECT_EQ(Vec3(ray.origin), Vec3(4, 5, 6));
                EXPECT_NEAR(length(Vec3(ray.direction)), 1, 1e-6f);
                RTSstate state{};
                state.functions = &functions;
                std::copy_n(ray.direction, 3, state.rayDirection);
                ASSERT_EQ(sky->functions().shade(sky->block(), &state), 0);
                const float s = state.result[0] - std::floor(state.result[0]);
                EXPECT_NEAR(s, x, 1e-5f);
                EXPECT_NEAR(state.result[1], y, 1e-5f);
            }
    }
    const auto ahead = rayOf(*MadeShader("Panorama").make(), 0.75f, 0.5f);
    EXPECT_NEAR(ahead.direction[0], 1, 1e-6f); // to the right of -z
}

/// OpenGL's matrices.
Mat4 frustum(double l, double r, double b, double t, double n, double f) {
    Mat4 m;
    for (float& x : m.m) x = 0;
    m.m[0] = float(2 * n / (r - l));
    m.m[5] = float(2 * n / (t - b));
    m.m[8] = float((r + l) / (r - l));
    m.m[9] = float((t + b) / (t - b));
    m.m[10] = float(-(f + n) / (f - n));
    m.m[11] = -1;
    m.m[14] = float(-2 * f * n / (f - n));
    return m;
}
Mat4 orthographic(double l, double r, double b, double t, double n, double f) {
    Mat4 m;
    m.m[0] = float(2 / (r - l));
    m.m[5] = float(2 / (t - b));
    m.m[10] = float(-2 / (f - n));
    m.m[12] = float(-(r + l) / (r - l));
    m.m[13] = float(-(t + b) / (t - b));
    m.m[14] = float(-(f + n) / (f - n));
    return m;
}
/// A turn about y after one about x, then a translation: world to eye.
Mat4 view() {
    Mat4 m;
    const double ca = std::cos(0.7), sa = std::sin(0.7), cb = std::cos(-0.4), sb = std::sin(-0.4);
    const double rows[3][3] = {{ca, sa * sb, sa * cb}, {0, cb, -sb}, {-sa, ca * sb, ca * cb}};
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) m.m[4 * column + row] = float(rows[row][column]);
    m.m[12] = 1;
    m.m[13] = -2;
    m.m[14] = -7;
    return m;
}
/// Clip coordinates divided by w.
std::array<double, 3> project(const Mat4& projection, const Mat4& modelView,
                              const std::array<double, 3>& p) {
    std::array<double, 4> v = {p[0], p[1], p[2], 1};
    for (const Mat4* m : {&modelView, &projection}) {
        std::array<double, 4> r = {};
        for (std::size_t row = 0; row < 4; ++row)
            for (std::size_t column = 0; column < 4; ++column)
                r[row] += double((*m)(int(row), int(column))) * v[column];
        v = r;
    }
    return {v[0] / v[3], v[1] / v[3], v[2] / v[3]};
}

void expectProjects(const Mat4& projection, const Mat4& modelView, bool farthest) {
    const auto camera = MadeShader("Matrix")
                            .set("projection", projection)
                            .set("modelView", modelView)
                            .make();
    for (const float x : {0.0f, 0.3f, 1.0f})
        for (const float y : {0.1f, 0.5f, 0.8f}) {
            const RTScameraray ray = rayOf(*camera, x, y);
            const auto at = [&](double t) {
                return project(projection, modelView,
                               {ray.origin[0] + t * ray.direction[0],
                                ray.origin[1] + t * ray.direction[1],
                                ray.origin[2] + t * ray.direction[2]});
            };
            const double end = farthest ? double(ray.tfar) : ray.tnear + 10.0;
            for (const double t : {double(ray.tnear) + 1e-3, (ray.tnear + end) / 2, end}) {
                EXPECT_NEAR(at(t)[0], 2 * x - 1, 3e-5);
                EXPECT_NEAR(at(t)[1], 2 * y - 1, 3e-5);
            }
            EXPECT_NEAR(at(ray.tnear)[2], -1, 1e-4);
            if (farthest) {
                EXPECT_NEAR(at(ray.tfar)[2], 1, 1e-4);
            } else {
                EXPECT_EQ(ray.tfar, kInfinity);
            }
        }
}

TEST(MatrixCameraTest, RaysProjectToTheirPointOfThePicture) {
    expectProjects(frustum(-1, 2, -0.5, 1, 1, 50), view(), true);
    expectProjects(orthographic(-3, 1, -2, 2, -1, 9), view(), true);
    expectProjects(frustum(-0.1, 0.1, -0.1, 0.1, 0.1, 100), Mat4(), true);
    Mat4 endless = frustum(-1, 1, -1, 1, 1, 2); // the far plane at infinity
    endless.m[10] = -1;
    endless.m[14] = -2;
    expectProjects(endless, view(), false);
}

TEST(MatrixCameraTest, PerspectiveRaysStartInTheEye) {
    const auto camera = MadeShader("Matrix")
                            .set("projection", frustum(-1, 1, -1, 1, 2, 20))
                            .set("modelView", Mat4())
                            .make();
    const RTScameraray ray = rayOf(*camera, 0.75f, 0.5f);
    for (const float x : ray.origin) EXPECT_NEAR(x, 0, 1e-6f);
    EXPECT_NEAR(ray.direction[0] / ray.direction[2], -0.25, 1e-6);
    EXPECT_LT(ray.direction[2], 0);
}

TEST(MatrixCameraTest, WithoutInverseThereAreNoRays) {
    Mat4 flat;
    flat.m[0] = 0;
    Mat4 dependent = frustum(-1, 1, -1, 1, 1, 10);
    for (int row = 0; row < 4; ++row) dependent.m[4 + row] = 3 * dependent.m[row];
    Mat4 zero, nan;
    for (float& x : zero.m) x = 0;
    nan.m[6] = std::numeric_limits<float>::quiet_NaN();
    for (const Mat4& projection : {flat, dependent, zero, nan})
        for (const Mat4& modelView : {Mat4(), view()}) {
            const auto camera = MadeShader("Matrix")
                                    .set("projection", projection)
                                    .set("modelView", modelView)
                                    .make();
            const RTScameraray ray = rayOf(*camera, 0.5f, 0.5f);
            EXPECT_EQ(Vec3(ray.direction), Vec3());
        }
    // Badly scaled is not singular.
    Mat4 tiny;
    for (int k = 0; k < 3; ++k) tiny.m[5 * k] = 1e-20f;
    const auto camera = MadeShader("Matrix").set("modelView", tiny).make();
    EXPECT_NE(Vec3(rayOf(*camera, 0.5f, 0.5f).direction), Vec3());
}

} // namespace
} // namespace smart
