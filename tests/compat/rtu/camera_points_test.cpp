// SPDX-License-Identifier: MIT
// Where cameras see points: 10,000 points that camera rays meet, projected by the closed form of
// the camera, lie at the middles of their pixels.
#include <gtest/gtest.h>
#include <openrt/rt.h>
#include <openrt/rtu.h>

#include <cmath>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <numbers>
#include <openrt/shader.hpp>
#include <vector>

namespace {

constexpr unsigned kWidth = 125, kHeight = 80;
using Window = glm::dvec2;
using Projection = std::function<Window(const glm::dvec3&)>;

struct ShowPosition {
    void registerParams(const openrt::ShaderRegistrator&) const {}
    void shade(openrt::TraceContext& c) const {
        const openrt::Vec3 p = c.position();
        c.setRadiance(openrt::Color(p.x, p.y, p.z));
    }
};

/// x and y of the cube from -1 to 1, in pixels.
Window inPixels(double x, double y) { return {(x + 1) / 2 * kWidth, (y + 1) / 2 * kHeight}; }

Projection byMatrix(const glm::dmat4& clipFromSeen) {
    return [=](const glm::dvec3& p) {
        const glm::dvec4 clip = clipFromSeen * glm::dvec4(p, 1);
        return inPixels(clip.x / clip.w, clip.y / clip.w);
    };
}

/// The x and y for which corner + x horizontal + y vertical + z along = p.
Window inRectangle(const glm::dvec3& p, const glm::dvec3& corner, const glm::dvec3& horizontal,
                   const glm::dvec3& vertical, const glm::dvec3& along) {
    const glm::dvec3 xyz = glm::inverse(glm::dmat3(horizontal, vertical, along)) * (p - corner);
    return {xyz.x * kWidth, xyz.y * kHeight};
}

/// Through the eye: a rectangle from the eye's point of view.
Projection throughRectangle(const glm::dvec3& eye, const glm::dvec3& corner,
                            const glm::dvec3& horizontal, const glm::dvec3& vertical) {
    return [=](const glm::dvec3& p) {
        return inRectangle(glm::dvec3(0), corner, horizontal, vertical, eye - p);
    };
}

struct CameraPoints : testing::Test {
    void SetUp() override {
        rtInit(nullptr, nullptr);
        rtThreads(2);
        rtRegisterShaderClass(openrt::shaderClass<ShowPosition>("ShowPosition"));
        surface_ = rtGenNewShader();
        rtSetFrameBuffer(reinterpret_cast<RTubyte*>(positions.data()), kWidth, kHeight,
                         RT_RGB_32F);
    }
    void TearDown() override { rtExit(); }

    /// A rough surface all around the origin, 5 to 8 away from it, with the camera's place at
    /// `about`.
    void surroundings(const glm::dvec3& about) const {
        constexpr int kRows = 24, kColumns = 48;
        const auto vertex = [&](int row, int column) {
            const double latitude = (double(row) / kRows - 0.5) * std::numbers::pi;
            const double longitude = 2 * std::numbers::pi * (column % kColumns) / kColumns;
            const double radius = 6.5 + 1.5 * std::sin(7.0 * row + 13.0 * (column % kColumns));
            rtVertex3d(about.x + radius * std::cos(latitude) * std::cos(longitude),
                       about.y + radius * std::sin(latitude),
                       about.z + radius * std::cos(latitude) * std::sin(longitude));
        };
        rtBindShader(surface_);
        for (int row = 0; row < kRows; ++row) {
            rtBegin(RT_TRIANGLE_STRIP);
            for (int column = 0; column <= kColumns; ++column) {
                vertex(row, column);
                vertex(row + 1, column);
            }
            rtEnd();
        }
    }

    /// The largest distance of a point's projection from the middle of its pixel, in pixels.
    double largestError(const Projection& project, const glm::dvec3& about = glm::dvec3(0)) {
        surroundings(about);
        rtRender();
        EXPECT_EQ(rtGetError(), RTenum(RT_NO_ERROR)) << rtGetErrorText();
        double largest = 0;
        for (unsigned y = 0; y < kHeight; ++y)
            for (unsigned x = 0; x < kWidth; ++x) {
                const Window seen = project(positions[y * kWidth + x]);
                const double error = glm::length(seen - Window(x + 0.5, y + 0.5));
                if (!(error <= largest)) largest = error;
            }
        return largest;
    }

    RTuint camera(const char* name) {
        rtGenNewShaderClass(name, nullptr);
        return rtGenNewShader();
    }
    static void set(const char* parameter, const glm::dvec3& value) {
        rtParameter3f(rtParameterHandle(parameter), float(value.x), float(value.y),
                      float(value.z));
    }

    std::vector<glm::vec3> positions = std::vector<glm::vec3>(kWidth * kHeight);
    RTuint surface_ = 0;
};

constexpr double kAllowed = 0.01;

TEST_F(CameraPoints, matrixStacks) {
    // Without a camera shader positions are in eye space.
    rtMatrixMode(RT_PROJECTION);
    rtFrustum(-0.4, 0.7, -0.3, 0.5, 1, 100);
    rtMatrixMode(RT_MODELVIEW);
    EXPECT_LT(largestError(byMatrix(glm::frustum(-0.4, 0.7, -0.3, 0.5, 1.0, 100.0))), kAllowed);
    rtMatrixMode(RT_PROJECTION);
    rtLoadIdentity();
    rtPerspective(70, 1.4, 0.1, 100);
    rtMatrixMode(RT_MODELVIEW);
    const glm::dmat4 perspective =
        glm::perspective(70 * std::numbers::pi / 180, 1.4, 0.1, 100.0);
    EXPECT_LT(largestError(byMatrix(perspective)), kAllowed);
    rtMatrixMode(RT_PROJECTION);
    rtLoadIdentity();
    rtOrtho(-3, 2, -1, 3, 0.5, 50);
    rtMatrixMode(RT_MODELVIEW);
    EXPECT_LT(largestError(byMatrix(glm::ortho(-3.0, 2.0, -1.0, 3.0, 0.5, 50.0))), kAllowed);
}

TEST_F(CameraPoints, noticesHalfAPixel) {
    rtMatrixMode(RT_PROJECTION);
    rtFrustum(-0.4, 0.7, -0.3, 0.5, 1, 100);
    const double half = 0.5 * 1.1 / kWidth;
    EXPECT_NEAR(largestError(byMatrix(glm::frustum(-0.4 + half, 0.7 + half, -0.3, 0.5, 1.0,
                                                   100.0))),
                0.5, 0.01);
}

TEST_F(CameraPoints, matrices) {
    const glm::dvec3 eye(3, -2, 5);
    const glm::dmat4 view = glm::lookAt(eye, glm::dvec3(4, 1, 1), glm::dvec3(0.2, 1, 0));
    const glm::dmat4 mirror = glm::scale(glm::dmat4(1), glm::dvec3(-1, 1, 1));
    for (const glm::dmat4& projection :
         {glm::frustum(-0.4, 0.7, -0.3, 0.5, 1.0, 100.0),
          glm::ortho(-2.0, 2.0, -1.0, 1.5, 0.5, 50.0),
          glm::frustum(-0.4, 0.7, -0.3, 0.5, 1.0, 100.0) * mirror}) {
        rtuCameraFromMatrices(glm::value_ptr(projection), glm::value_ptr(view));
        EXPECT_LT(largestError(byMatrix(projection * view), eye), kAllowed);
    }
}

TEST_F(CameraPoints, walls) {
    const glm::dvec3 eye(0.7, 1.5, 2), lowerLeft(-2, 1, -1.5);
    // Upright, and a rectangle that leans in all directions; the eye off the middle.
    const glm::dmat3 lean(glm::rotate(glm::dmat4(1), 0.7, glm::dvec3(1, 2, 3)));
    for (const glm::dmat3& axes : {glm::dmat3(1), lean}) {
        const glm::dvec3 horizontal = axes * glm::dvec3(4, 0, 0);
        const glm::dvec3 vertical = axes * glm::dvec3(0, 3, 0);
        const glm::dvec3 lowerRight = lowerLeft + horizontal, upperLeft = lowerLeft + vertical;
        rtuCameraFromWall(&lowerLeft.x, &lowerRight.x, &upperLeft.x, &eye.x);
        EXPECT_LT(largestError([&](const glm::dvec3& p) {
                      return inRectangle(eye, lowerLeft, horizontal, vertical, eye - p);
                  }, eye),
                  kAllowed);
    }
}

TEST_F(CameraPoints, fieldsOfView) {
    const glm::dmat4 pose = glm::rotate(glm::translate(glm::dmat4(1), glm::dvec3(1, 2, -3)), 2.1,
                                        glm::dvec3(1, -1, 0.5));
    const double left = -0.9, right = 0.7, up = 0.8, down = -0.95;
    rtuCameraFromFov(glm::value_ptr(pose), left, right, up, down);
    const auto project = [&](const glm::dvec3& p) {
        const glm::dvec4 seen = glm::inverse(pose) * glm::dvec4(p, 1);
        const auto share = [](double tangent, double from, double to) {
            return (tangent - std::tan(from)) / (std::tan(to) - std::tan(from));
        };
        return Window(share(seen.x / -seen.z, left, right) * kWidth,
                      share(seen.y / -seen.z, down, up) * kHeight);
    };
    EXPECT_LT(largestError(project, glm::dvec3(pose[3])), kAllowed);
}

TEST_F(CameraPoints, shadersOfACorner) {
    const glm::dvec3 eye(-1, 0.5, 2), corner(-1, -0.5, -1), horizontal(2, 0.25, 0.5),
        vertical(0, 1.5, -0.25);
    for (const char* name : {"PinholeCameraShader", "Pinhole", "ThinLens"}) {
        const RTuint shader = camera(name);
        set("origin", eye);
        set("lowerLeft", corner);
        set("horizontal", horizontal);
        set("vertical", vertical);
        rtUseCamera(shader);
        EXPECT_LT(largestError(throughRectangle(eye, corner, horizontal, vertical), eye), kAllowed)
            << name;
    }
    const RTuint shader = camera("Orthographic");
    set("direction", glm::dvec3(0.25, -0.5, -1));
    set("lowerLeft", corner);
    set("horizontal", horizontal);
    set("vertical", vertical);
    rtUseCamera(shader);
    const auto project = [&](const glm::dvec3& p) {
        return inRectangle(p, corner, horizontal, vertical, glm::dvec3(0.25, -0.5, -1));
    };
    EXPECT_LT(largestError(project), kAllowed);
}

TEST_F(CameraPoints, panorama) {
    const RTuint shader = camera("Panorama");
    const glm::dvec3 eye(1, 2, 3);
    set("origin", eye);
    rtUseCamera(shader);
    const auto project = [&](const glm::dvec3& p) {
        const glm::dvec3 d = glm::normalize(p - eye);
        return Window((std::atan2(d.x, -d.z) / (2 * std::numbers::pi) + 0.5) * kWidth,
                      (std::asin(d.y) / std::numbers::pi + 0.5) * kHeight);
    };
    EXPECT_LT(largestError(project, eye), kAllowed);
}

/// Of points at a distance z from the eyes, which are `apart`, on a screen at the distance d: their
/// images lie apart (1 - d/z) on it, uncrossed behind the screen and crossed before it.
TEST_F(CameraPoints, disparityOfTheEyes) {
    const double apart = 0.064, screen = 1.5, width = 3;
    const auto positionsFrom = [&](double eyeX, double z) {
        const double low[3] = {-1.5, -0.96, -screen}, right[3] = {1.5, -0.96, -screen},
                     up[3] = {-1.5, 0.96, -screen}, eye[3] = {eyeX, 0.1, 0};
        rtuCameraFromWall(low, right, up, eye);
        rtBindShader(surface_);
        rtBegin(RT_QUADS);
        rtVertex3d(-500, -500, -z);
        rtVertex3d(500, -500, -z);
        rtVertex3d(500, 500, -z);
        rtVertex3d(-500, 500, -z);
        rtEnd();
        rtRender();
        EXPECT_EQ(rtGetError(), RTenum(RT_NO_ERROR)) << rtGetErrorText();
        return positions;
    };
    for (const double z : {0.4, 1.0, 1.5, 4.0, 60.0}) {
        const std::vector<glm::vec3> left = positionsFrom(-apart / 2, z);
        const std::vector<glm::vec3> right = positionsFrom(apart / 2, z);
        const double expected = apart * (1 - screen / z) * kWidth / width;
        for (unsigned y = 0; y < kHeight; ++y) {
            const glm::vec3* const row = &right[y * kWidth];
            const double step = (double(row[kWidth - 1].x) - row[0].x) / (kWidth - 1);
            for (unsigned x = 0; x < kWidth; ++x) {
                const double inRight = (double(left[y * kWidth + x].x) - row[0].x) / step;
                ASSERT_NEAR(inRight - x, expected, 0.01) << z;
            }
        }
    }
}

} // namespace
