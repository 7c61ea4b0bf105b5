// SPDX-License-Identifier: MIT
#include "samples/common/view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

#include "samples/common/orbit_camera.h"

namespace samples {
namespace {

SceneDescription boxAt(const glm::vec3& low, const glm::vec3& high) {
    SceneDescription scene;
    MeshPart part;
    part.positions = {low, high, {low.x, high.y, low.z}};
    scene.meshes.emplace_back().parts.push_back(part);
    scene.instances.emplace_back();
    return scene;
}

/// Where a point appears, -1 to 1 in both directions.
glm::vec2 projected(const View& view, float aspect, const glm::vec3& point) {
    const glm::mat4 m = glm::perspective(glm::radians(view.fovDegrees), aspect, 1e-3f, 1e6f) *
                        glm::lookAt(view.eye, view.target, view.up);
    const glm::vec4 clip = m * glm::vec4(point, 1.0f);
    return glm::vec2(clip) / clip.w;
}

TEST(View, BoundsFollowInstancesAndLeaveOutWhatIsNotFinite) {
    SceneDescription scene = boxAt({0, 0, 0}, {1, 2, 3});
    scene.meshes[0].parts[0].positions.emplace_back(std::numeric_limits<float>::quiet_NaN());
    scene.instances.push_back({0, glm::translate(glm::dmat4(1.0), {10, 0, 0})});
    const Bounds bounds = boundsOf(scene);
    EXPECT_EQ(bounds.low, glm::vec3(0, 0, 0));
    EXPECT_EQ(bounds.high, glm::vec3(11, 2, 3));
    EXPECT_TRUE(boundsOf(SceneDescription()).empty());
}

TEST(View, TheAutomaticViewShowsEverything) {
    for (float aspect : {0.3f, 1.0f, 2.5f}) {
        for (float scale : {1e-4f, 1.0f, 1e5f}) {
            const SceneDescription scene =
                boxAt(glm::vec3(-1, 0, -4) * scale, glm::vec3(2, 1, 3) * scale);
            const Bounds bounds = boundsOf(scene);
            const View view = defaultView(scene, bounds, aspect);
            for (int corner = 0; corner < 8; ++corner) {
                const glm::vec3 p(corner & 1 ? bounds.low.x : bounds.high.x,
                                  corner & 2 ? bounds.low.y : bounds.high.y,
                                  corner & 4 ? bounds.low.z : bounds.high.z);
                const glm::vec2 place = projected(view, aspect, p / scale * 1.0f * scale);
                EXPECT_LE(std::max(std::abs(place.x), std::abs(place.y)), 1.001f);
            }
        }
    }
}

TEST(View, TheFilesFirstCameraComesFirst) {
    SceneDescription scene = boxAt({0, 0, 0}, {1, 1, 1});
    scene.cameras.push_back({{5, 5, 5}, {0, 0, -2}, {0, 1, 0}, 33.0f});
    const View view = defaultView(scene, boundsOf(scene), 1.0f);
    EXPECT_EQ(view.eye, glm::vec3(5, 5, 5));
    EXPECT_EQ(view.fovDegrees, 33.0f);
    EXPECT_GT(view.eye.z, view.target.z);
    EXPECT_EQ(view.target.x, 5.0f);
}

TEST(OrbitCamera, OrbitsAtConstantDistanceAndStopsAtThePoles) {
    View start;
    start.eye = {0, 0, 4};
    OrbitCamera camera(start);
    camera.orbit(glm::radians(90.0f), 0);
    EXPECT_LT(glm::distance(camera.view().eye, glm::vec3(-4, 0, 0)), 1e-5f);
    for (int i = 0; i < 100; ++i) camera.orbit(0.1f, 0.3f);
    EXPECT_NEAR(glm::length(camera.view().eye), 4.0f, 1e-3f);
    EXPECT_GT(camera.view().eye.y, 3.9f);
    EXPECT_GT(std::hypot(camera.view().eye.x, camera.view().eye.z), 0.01f);
    camera.reset();
    EXPECT_EQ(camera.view().eye, start.eye);
}

TEST(OrbitCamera, FocusMovesTheCentreAndNotThePicture) {
    View start;
    start.eye = {0, 0, 4};
    OrbitCamera camera(start);
    camera.focus(10.0f);
    EXPECT_EQ(camera.view().eye, start.eye);
    EXPECT_EQ(camera.view().target, glm::vec3(0, 0, -6));
    camera.orbit(glm::radians(180.0f), 0);
    EXPECT_LT(glm::distance(camera.view().eye, glm::vec3(0, 0, -16)), 1e-4f);
}

TEST(OrbitCamera, PanningMovesTheTargetWithThePointer) {
    View start;
    start.eye = {0, 0, 4};
    OrbitCamera camera(start);
    camera.pan(0.25f, 0.1f); // shares of the picture's height
    const glm::vec2 place = projected(camera.view(), 1.0f, start.target);
    EXPECT_NEAR(place.x, 0.5f, 1e-4f);
    EXPECT_NEAR(place.y, 0.2f, 1e-4f);
    camera.zoom(2.0f);
    EXPECT_NEAR(glm::distance(camera.view().eye, camera.view().target), 2.0f, 1e-5f);
}

TEST(OrbitCamera, AnOrthographicViewPansAndZoomsByItsHeight) {
    View start;
    start.eye = {0, 0, 4};
    start.height = 2.0f;
    OrbitCamera camera(start);
    camera.pan(0.25f, 0.0f);
    EXPECT_LT(glm::distance(camera.view().target, glm::vec3(-0.5f, 0, 0)), 1e-5f);
    camera.zoom(4.0f);
    EXPECT_EQ(camera.view().height, 0.5f);
    EXPECT_NEAR(glm::distance(camera.view().eye, camera.view().target), 4.0f, 1e-5f);
}

} // namespace
} // namespace samples
