// SPDX-License-Identifier: MIT
#include "libsmart/render/polygon_raster.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <random>
#include <vector>

#include "tests/libsmart/render/picture_scene.h"

namespace smart::test {
namespace {

RasterTriangle triangleOf(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    RasterTriangle triangle;
    triangle.corners[0] = a;
    triangle.corners[1] = b;
    triangle.corners[2] = c;
    triangle.normal = glm::cross(b - a, c - a);
    return triangle;
}

glm::dvec3 window(const Frame& frame, const glm::dvec3& point) {
    const glm::dvec4 clip = frame.matrixCamera.projection * glm::dvec4(point, 1.0);
    const glm::dvec3 ndc = glm::dvec3(clip) / clip.w;
    return {(ndc.x * 0.5 + 0.5) * frame.viewport.width + frame.viewport.x,
            (ndc.y * 0.5 + 0.5) * frame.viewport.height + frame.viewport.y,
            (ndc.z * 0.5 + 0.5) * (frame.depthFar - frame.depthNear) + frame.depthNear};
}

// Projections of all kinds, mirrored ones among them.
std::vector<glm::dmat4> projections() {
    const glm::dmat4 perspective = glm::perspective(1.0, 1.5, 0.5, 100.0);
    const glm::dmat4 ortho = glm::ortho(-4.0, 4.0, -3.0, 3.0, 0.5, 100.0);
    const glm::dmat4 mirrored = glm::scale(glm::dmat4(1.0), glm::dvec3(-1, 1, 1)) * perspective;
    return {perspective, ortho, mirrored, glm::ortho(4.0, -4.0, -3.0, 3.0, 0.5, 100.0),
            glm::frustum(0.2, 0.9, -0.6, 0.1, 0.5, 100.0)};
}

TEST(PolygonRaster, WindingOnTheScreenAndDepthAgainstProjectedCorners) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> across(-3.0, 3.0), along(-20.0, -1.0), share(0.05, 0.9);
    int front = 0, cases = 0;
    for (const glm::dmat4& projection : projections()) {
        Frame frame;
        frame.matrixCamera = cameraOf(projection);
        frame.viewport = {7, -3, 120, 80};
        frame.depthNear = 0.25f;
        frame.depthFar = 0.75f;
        const PolygonRaster raster(frame);
        for (int i = 0; i < 2000; ++i) {
            glm::dvec3 p[3];
            for (glm::dvec3& corner : p) corner = {across(random), across(random), along(random)};
            const RasterTriangle triangle = triangleOf(p[0], p[1], p[2]);
            const glm::dvec3 w[3] = {window(frame, p[0]), window(frame, p[1]),
                                     window(frame, p[2])};
            const double area = (w[1].x - w[0].x) * (w[2].y - w[0].y) -
                                (w[1].y - w[0].y) * (w[2].x - w[0].x);
            if (std::fabs(area) < 1.0) continue;
            ++cases;
            front += area > 0;
            EXPECT_EQ(raster.isCounterclockwise(triangle, Ray{}), area > 0) << cases;

            // Window depth is linear on the screen.
            const double b = share(random), c = share(random) * (1.0 - b);
            const glm::dvec3 at = (1.0 - b - c) * w[0] + b * w[1] + c * w[2];
            if (at.z < 0.25 || at.z > 0.75) continue;
            const PolygonRaster::Plane plane = raster.planeOf(triangle);
            ASSERT_TRUE(plane.hasDepth);
            const PolygonRaster::Depth depth = raster.depthAt(plane, glm::dvec2(at));
            EXPECT_NEAR(depth.window, at.z, 1e-9) << cases;
            const glm::dvec3 u = w[1] - w[0], v = w[2] - w[0];
            const double x = (u.z * v.y - v.z * u.y) / area, y = (u.x * v.z - v.x * u.z) / area;
            EXPECT_NEAR(depth.slope / std::max(std::fabs(x), std::fabs(y)), 1.0, 1e-6);
        }
    }
    EXPECT_GT(cases, 5000);
    EXPECT_GT(front, cases / 3);
    EXPECT_LT(front, cases * 2 / 3);
}

TEST(PolygonRaster, EdgeOnThereIsNoDepth) {
    Frame frame;
    frame.matrixCamera = cameraOf(glm::ortho(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0));
    frame.viewport = {0, 0, 16, 16};
    const PolygonRaster raster(frame);
    const RasterTriangle triangle = triangleOf({0, -1, 0.5}, {0, 1, 0.5}, {0, 0, -0.5});
    EXPECT_FALSE(raster.planeOf(triangle).hasDepth);
}

SnappedTriangle snapped(const std::vector<glm::dvec2>& corners) {
    SnappedTriangle triangle{};
    for (size_t i = 0; i < 3; ++i) {
        triangle.x[i] = std::llround(corners[i].x * 0x1p20);
        triangle.y[i] = std::llround(corners[i].y * 0x1p20);
    }
    return triangle;
}

TEST(PolygonRaster, LeftAndLowerEdgesAreFilled) {
    const SnappedTriangle lower = snapped({{0, 0}, {4, 0}, {4, 4}});
    const SnappedTriangle upper = snapped({{0, 4}, {0, 0}, {4, 4}});
    using enum Coverage;
    const auto of = [](const SnappedTriangle& triangle, double x, double y) {
        return PolygonRaster::coverage(triangle, {x, y});
    };
    EXPECT_EQ(of(lower, 3, 1), Owned);
    EXPECT_EQ(of(lower, 2, 0), Owned);    // the bottom
    EXPECT_EQ(of(lower, 4, 2), Boundary); // the right
    EXPECT_EQ(of(upper, 0, 2), Owned);    // the left
    EXPECT_EQ(of(upper, 2, 4), Boundary); // the top
    EXPECT_EQ(of(upper, 1, 0.5), Outside);
    EXPECT_NE(of(lower, 2, 2) == Owned, of(upper, 2, 2) == Owned); // the diagonal: one of them
    EXPECT_EQ(of(upper, 0, 0) == Owned ? 1 : 0, of(lower, 0, 0) == Owned ? 0 : 1);
    EXPECT_NE(of(lower, 4, 4), Owned);
    EXPECT_NE(of(upper, 4, 4), Owned);
}

// A fan around each point of a grid, with all edges through other points of it: each point belongs
// to one triangle, whichever way round the corners are given.
TEST(PolygonRaster, PointsOnSharedEdgesHaveOneOwner) {
    std::mt19937 random(3);
    std::vector<SnappedTriangle> mesh;
    constexpr int kSide = 8;
    const auto add = [&](glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
        if (random() % 2) std::swap(b, c);
        mesh.push_back(snapped({a, b, c}));
    };
    for (int y = 0; y < kSide; y += 2)
        for (int x = 0; x < kSide; x += 2) {
            const glm::dvec2 o(x, y), centre(x + 1, y + 1);
            const glm::dvec2 ring[] = {{0, 0}, {1, 0}, {2, 0}, {2, 1},
                                       {2, 2}, {1, 2}, {0, 2}, {0, 1}};
            for (int i = 0; i < 8; ++i) add(centre, o + ring[i], o + ring[(i + 1) % 8]);
        }
    for (int y = 0; y <= 2 * kSide; ++y)
        for (int x = 0; x <= 2 * kSide; ++x) {
            int owners = 0, touching = 0;
            for (const SnappedTriangle& triangle : mesh) {
                const Coverage found = PolygonRaster::coverage(triangle, {x / 2.0, y / 2.0});
                owners += found == Coverage::Owned;
                touching += found != Coverage::Outside;
            }
            const bool inside = x < 2 * kSide && y < 2 * kSide; // half open, as a rectangle
            EXPECT_EQ(owners, inside ? 1 : 0) << x << ' ' << y;
            EXPECT_GE(touching, 1);
        }
}

TEST(PolygonRaster, NothingBehindTheEyeIsSnapped) {
    Frame frame;
    frame.matrixCamera = cameraOf(glm::perspective(1.0, 1.0, 0.5, 100.0));
    frame.viewport = {0, 0, 64, 64};
    const PolygonRaster raster(frame);
    SnappedTriangle snap;
    EXPECT_TRUE(raster.snap(triangleOf({0, 0, -1}, {1, 0, -2}, {0, 1, -3}), snap));
    EXPECT_FALSE(raster.snap(triangleOf({0, 0, -1}, {1, 0, 2}, {0, 1, -3}), snap));
    EXPECT_FALSE(raster.snap(triangleOf({0, 0, 0}, {1, 0, -2}, {0, 1, -3}), snap));
}

} // namespace
} // namespace smart::test
