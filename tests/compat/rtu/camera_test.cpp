// SPDX-License-Identifier: MIT
// Cameras of virtual reality: the picture of a scene whose every pixel is known.
#include <gtest/gtest.h>
#include <openrt/rt.h>
#include <openrt/rtu.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

namespace {

constexpr unsigned kWidth = 40, kHeight = 30;

struct Cameras : testing::Test {
    void SetUp() override {
        rtInit(nullptr, nullptr);
        rtThreads(1);
        rtSetFrameBuffer(pixels.data(), kWidth, kHeight, RT_RGBA_8);
        rtSetAuxBuffer(RT_OBJECT_ID, ids.data(), RT_UNSIGNED_INT);
    }
    void TearDown() override { rtExit(); }

    static void quad(double x0, double y0, double x1, double y1, double z) {
        rtBegin(RT_QUADS);
        rtVertex3d(x0, y0, z);
        rtVertex3d(x1, y0, z);
        rtVertex3d(x1, y1, z);
        rtVertex3d(x0, y1, z);
        rtEnd();
    }
    bool isHit(unsigned x, unsigned y) const { return ids[y * kWidth + x] != RT_INVALID; }

    std::vector<RTubyte> pixels = std::vector<RTubyte>(kWidth * kHeight * 4);
    std::vector<RTuint> ids = std::vector<RTuint>(kWidth * kHeight);
    const double lowerLeft[3] = {-2, 1, -3}, lowerRight[3] = {2, 1, -3}, upperLeft[3] = {-2, 4, -3};
    const double eye[3] = {0.7, 1.5, 2};
    const double identity[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
};

TEST_F(Cameras, matricesGiveThePictureOfTheMatrixStacks) {
    const auto describe = [] {
        quad(-1, -1, 0.5, 0.8, -4);
        quad(0.2, 0.1, 1.4, 1.1, -6);
    };
    double projection[16], modelview[16];
    rtMatrixMode(RT_PROJECTION);
    rtFrustum(-0.4, 0.6, -0.3, 0.4, 1, 50);
    rtGetDoublev(RT_PROJECTION_MATRIX, projection);
    rtMatrixMode(RT_MODELVIEW);
    rtLookAt(1, 0.5, 0, 0, 0, -5, 0, 1, 0);
    rtGetDoublev(RT_MODELVIEW_MATRIX, modelview);
    describe();
    rtRender();
    const std::vector<RTuint> expected = ids;
    rtLoadIdentity();
    rtuCameraFromMatrices(projection, modelview);
    describe();
    rtRender();
    ASSERT_EQ(rtGetError(), RTenum(RT_NO_ERROR)) << rtGetErrorText();
    unsigned different = 0, hits = 0;
    for (std::size_t i = 0; i < ids.size(); ++i) {
        different += (ids[i] == RT_INVALID) != (expected[i] == RT_INVALID);
        hits += ids[i] != RT_INVALID;
    }
    EXPECT_LE(different, 2u) << "edges through pixel centres may round otherwise";
    EXPECT_GT(hits, 100u);
    EXPECT_LT(hits, kWidth * kHeight);
}

TEST_F(Cameras, aWallIsSeenAsItsPicture) {
    // The left half of the wall, and what would be seen beside it.
    quad(-2, 0, 0, 5, -3);
    rtuCameraFromWall(lowerLeft, lowerRight, upperLeft, eye);
    rtRender();
    ASSERT_EQ(rtGetError(), RTenum(RT_NO_ERROR)) << rtGetErrorText();
    for (unsigned y = 0; y < kHeight; ++y)
        for (unsigned x = 0; x < kWidth; ++x) ASSERT_EQ(isHit(x, y), x < kWidth / 2) << x;
}

TEST_F(Cameras, aPointBehindTheWallIsSeenAlongItsRay) {
    // At twice the distance a window in the wall is twice as large, seen from the eye.
    const auto farther = [&](double corner, int axis) {
        return eye[axis] + 2 * (corner - eye[axis]);
    };
    quad(farther(-1, 0), farther(1.9, 1), farther(1, 0), farther(3.1, 1), farther(-3, 2));
    rtuCameraFromWall(lowerLeft, lowerRight, upperLeft, eye);
    rtRender();
    for (unsigned y = 0; y < kHeight; ++y)
        for (unsigned x = 0; x < kWidth; ++x)
            ASSERT_EQ(isHit(x, y), x >= 10 && x < 30 && y >= 9 && y < 21) << x << ' ' << y;
}

TEST_F(Cameras, anglesOfViewBoundTheFrustum) {
    // The eye at (5, 0, 0) looking along +x; a quad in x = 7 that fills the upper right quarter.
    const double pose[16] = {0, 0, 1, 0, 0, 1, 0, 0, -1, 0, 0, 0, 5, 0, 0, 1};
    const double right = std::atan(0.75), up = std::atan(0.5), left = std::atan(-0.25),
                 down = std::atan(-0.5);
    rtBegin(RT_QUADS); // right of the eye is +z; the middle of the view is at z = 0.5
    rtVertex3d(7, 0, 0.5);
    rtVertex3d(7, 9, 0.5);
    rtVertex3d(7, 9, 9);
    rtVertex3d(7, 0, 9);
    rtEnd();
    rtuCameraFromFov(pose, left, right, up, down);
    rtRender();
    ASSERT_EQ(rtGetError(), RTenum(RT_NO_ERROR)) << rtGetErrorText();
    for (unsigned y = 0; y < kHeight; ++y)
        for (unsigned x = 0; x < kWidth; ++x)
            ASSERT_EQ(isHit(x, y), x >= kWidth / 2 && y >= kHeight / 2) << x << ' ' << y;
}

TEST_F(Cameras, theBoundShaderStaysBound) {
    const RTuint shaderClass = rtGenNewShaderClass("ConstantShader", nullptr);
    const RTuint shader = rtGenNewShader();
    rtuCameraFromMatrices(identity, identity);
    RTint bound = 0;
    rtGetIntegerv(RT_SHADER_BINDING, &bound);
    EXPECT_EQ(RTuint(bound), shader);
    rtGetIntegerv(RT_SHADER_CLASS_BINDING, &bound);
    EXPECT_EQ(RTuint(bound), shaderClass);
    rtBindShader(0);
    rtRender();
    rtuCameraFromMatrices(identity, identity);
    rtGetIntegerv(RT_SHADER_BINDING, &bound);
    EXPECT_EQ(bound, 0);
    EXPECT_EQ(rtGetError(), RTenum(RT_NO_ERROR));
}

TEST_F(Cameras, listsKeepCamerasWithWhatTheyPointTo) {
    const RTuint shaderClass = rtGenNewShaderClass("ConstantShader", nullptr);
    const RTuint shader = rtGenNewShader();
    const auto bound = [](RTenum name) {
        RTint value = -1;
        rtGetIntegerv(name, &value);
        return RTuint(value);
    };
    const auto makeCamera = [&](RTuint which) {
        double corner[3], pose[16];
        std::memcpy(corner, lowerLeft, sizeof corner);
        std::memcpy(pose, identity, sizeof pose);
        if (which == 1) rtuCameraFromMatrices(pose, pose);
        if (which == 2) rtuCameraFromWall(corner, lowerRight, upperLeft, eye);
        if (which == 3) rtuCameraFromFov(pose, -0.5, 0.5, 0.5, -0.5);
    };
    const auto picture = [&] {
        quad(-1, 0.1, 0.8, 5, -3);
        quad(0.1, -2, 0.6, 0.4, 0.2);
        rtRender();
        return ids;
    };
    for (const RTuint list : {1, 2, 3}) {
        makeCamera(list);
        const std::vector<RTuint> expected = picture();
        rtNewList(list, RT_COMPILE);
        makeCamera(list);
        rtEndList();
        for (int time = 0; time < 2; ++time) {
            rtCallList(list);
            EXPECT_EQ(bound(RT_SHADER_CLASS_BINDING), shaderClass);
            EXPECT_EQ(bound(RT_SHADER_BINDING), shader);
            EXPECT_EQ(picture(), expected) << list;
        }
        ASSERT_EQ(rtGetError(), RTenum(RT_NO_ERROR)) << rtGetErrorText();
    }
    rtNewList(4, RT_COMPILE);
    rtuCameraFromMatrices(nullptr, identity);
    rtEndList();
    EXPECT_EQ(rtGetError(), RTenum(RT_NO_ERROR));
    rtCallList(4);
    EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_VALUE)) << "errors show when the list is called";
    rtCallList(1);
    EXPECT_EQ(rtGetError(), RTenum(RT_NO_ERROR)) << "which gave the frame no camera";
}

TEST_F(Cameras, wrongArgumentsAreRefused) {
    const auto isRefused = [](auto&& call, RTenum error = RT_INVALID_VALUE) {
        call();
        return rtGetError() == error;
    };
    double bad[16];
    std::memcpy(bad, identity, sizeof bad);
    bad[5] = std::numeric_limits<double>::quiet_NaN();
    const double flat[16] = {1};
    EXPECT_TRUE(isRefused([&] { rtuCameraFromMatrices(nullptr, identity); }));
    EXPECT_TRUE(isRefused([&] { rtuCameraFromMatrices(identity, nullptr); }));
    EXPECT_TRUE(isRefused([&] { rtuCameraFromMatrices(bad, identity); }));
    EXPECT_TRUE(isRefused([&] { rtuCameraFromMatrices(flat, identity); }));
    EXPECT_TRUE(isRefused([&] { rtuCameraFromWall(nullptr, lowerRight, upperLeft, eye); }));
    EXPECT_TRUE(isRefused([&] { rtuCameraFromWall(lowerLeft, lowerLeft, upperLeft, eye); }));
    EXPECT_TRUE(isRefused([&] { rtuCameraFromWall(lowerLeft, lowerRight, upperLeft, lowerLeft); }));
    EXPECT_TRUE(isRefused([&] { rtuCameraFromFov(nullptr, -1, 1, 1, -1); }));
    EXPECT_TRUE(isRefused([&] { rtuCameraFromFov(identity, -1, 2, 1, -1); }));
    EXPECT_TRUE(isRefused([&] { rtuCameraFromFov(identity, 1, -1, 1, -1); }));
    EXPECT_TRUE(isRefused([&] { rtuCameraFromFov(identity, -1, 1, -1, 1); }));
    EXPECT_TRUE(isRefused([&] { rtuCameraFromFov(identity, -1, bad[5], 1, -1); }));
    EXPECT_TRUE(isRefused([&] { rtuCameraFromFov(flat, -1, 1, 1, -1); }));
    rtBegin(RT_TRIANGLES);
    rtuCameraFromMatrices(identity, identity);
    rtEnd();
    EXPECT_EQ(rtGetError(), RTenum(RT_INVALID_OPERATION));
    rtNewObject(RT_DEFINE);
    EXPECT_TRUE(isRefused([&] { rtuCameraFromMatrices(identity, identity); },
                          RT_INVALID_OPERATION));
    rtEndObject();
    // None of them gave the frame a camera.
    EXPECT_TRUE(isRefused([&] { rtuCameraFromMatrices(identity, identity); }, RT_NO_ERROR));
    EXPECT_TRUE(isRefused([&] { rtuCameraFromMatrices(identity, identity); },
                          RT_INVALID_OPERATION))
        << "one a frame";
}

} // namespace
