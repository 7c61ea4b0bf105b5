// SPDX-License-Identifier: MIT
#include "samples/vr/cave_room.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <stdexcept>

#include "samples/vr/head_path.h"
#include "tests/samples/temporary_folder.h"

namespace samples {
namespace {

void expectNear(const glm::dvec3& a, const glm::dvec3& b) {
    EXPECT_LT(glm::length(a - b), 1e-12) << a.x << ' ' << a.y << ' ' << a.z;
}

TEST(CaveRoom, WallsMeetAtTheirEdgesAndFaceTheMiddle) {
    const auto walls = caveWalls(3);
    const CaveWall &front = walls[0], &left = walls[1], &right = walls[2], &floor = walls[3];
    expectNear(front.lowerLeft, left.lowerRight);
    expectNear(front.lowerRight, right.lowerLeft);
    expectNear(front.lowerLeft, floor.upperLeft);
    expectNear(left.lowerLeft, floor.lowerLeft);
    expectNear(right.lowerRight, floor.lowerRight);
    for (const CaveWall& wall : walls) {
        const glm::dvec3 across = wall.lowerRight - wall.lowerLeft;
        const glm::dvec3 up = wall.upperLeft - wall.lowerLeft;
        EXPECT_DOUBLE_EQ(glm::length(across), 3);
        EXPECT_DOUBLE_EQ(glm::length(up), 3);
        EXPECT_DOUBLE_EQ(glm::dot(across, up), 0);
        const glm::dvec3 inwards = glm::dvec3(0, 1.5, 0) - (wall.lowerLeft + (across + up) * 0.5);
        EXPECT_GT(glm::dot(glm::cross(across, up), inwards), 0) << wall.name;
    }
}

TEST(CaveRoom, StandsWhereTheViewIs) {
    View view;
    view.eye = {10, 2, 5};
    view.target = {20, -3, 5}; // along x, and down
    const CavePlace place(view, 2);
    expectNear(place.toScene({0, 1.7, 0}), {10, 2, 5});
    expectNear(place.toScene({0, 1.7, -1}), {12, 2, 5}); // level
    expectNear(place.toScene({1, 1.7, 0}), {10, 2, 7});
    expectNear(place.toScene({0, 2.7, 0}), {10, 4, 5});
    view.target = {10, -3, 5};
    EXPECT_THROW(CavePlace(view, 1), std::runtime_error);
}

TEST(HeadPose, TurnsAsItsAnglesSay) {
    HeadPose pose;
    pose.position = {1, 2, 3};
    pose.angles = {90, 0, 0}; // to the left: looks along -x
    expectNear(pose.orientation() * glm::dvec3(0, 0, -1), {-1, 0, 0});
    expectNear(pose.eye(1, 0.06), {1, 2, 3 - 0.03}); // the right eye
    expectNear(pose.eye(-1, 0.06), {1, 2, 3 + 0.03});
    pose.angles = {0, 90, 0};
    expectNear(pose.orientation() * glm::dvec3(0, 0, -1), {0, 1, 0});
    pose.angles = {0, 0, 90}; // the head's right side goes up
    expectNear(pose.eye(1, 2), {1, 3, 3});
}

class HeadPathFile : public testing::Test {
protected:
    HeadPath read(const char* text) {
        const std::filesystem::path file = folder_.path() / "head.path";
        std::ofstream(file) << text;
        return HeadPath(file);
    }
    std::string refusal(const char* text) {
        try {
            read(text);
        } catch (const std::runtime_error& error) {
            return error.what();
        }
        return "none";
    }
    test::TemporaryFolder folder_;
};

TEST_F(HeadPathFile, GoesFromSampleToSample) {
    const HeadPath path = read("# a comment\n0 0 1 0 350 0 0\n\n2 2 1 4 10 20 0 # the end\n");
    EXPECT_DOUBLE_EQ(path.end(), 2);
    expectNear(path.at(0.5).position, {0.5, 1, 1});
    EXPECT_NEAR(path.at(1).angles.x, 360, 1e-12); // not by way of 180
    EXPECT_NEAR(path.at(1).angles.y, 10, 1e-12);
    expectNear(path.at(-7).position, {0, 1, 0});
    expectNear(path.at(7).position, {2, 1, 4});
}

TEST_F(HeadPathFile, TellsWhatIsWrong) {
    EXPECT_NE(refusal("0 0 0 0 0 0\n").find("line 1"), std::string::npos);
    EXPECT_NE(refusal("0 0 0 0 0 0 0\n1 0 0 0 0 0 0 0\n").find("line 2"), std::string::npos);
    EXPECT_NE(refusal("0 0 0 0 0 0 0\n0 0 0 0 0 0 0\n").find("line 2"), std::string::npos);
    EXPECT_NE(refusal("0 0 0 nan 0 0 0\n").find("line 1"), std::string::npos);
    EXPECT_NE(refusal("0 0 1e999 0 0 0 0\n").find("line 1"), std::string::npos);
    EXPECT_NE(refusal("-1.7e308 0 0 0 0 0 0\n").find("line 1"), std::string::npos);
    EXPECT_NE(refusal("").find("no pose"), std::string::npos);
    EXPECT_THROW(HeadPath(folder_.path() / "nothing"), std::runtime_error);
}

} // namespace
} // namespace samples
