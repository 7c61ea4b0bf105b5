// SPDX-License-Identifier: MIT
#include "samples/vr/cave_room.h"

#include <glm/geometric.hpp>
#include <stdexcept>

namespace samples {

namespace {

constexpr double kEyeHeight = 1.7;

} // namespace

std::array<CaveWall, 4> caveWalls(double side) {
    const double h = side / 2;
    return {{{"front", {-h, 0, -h}, {h, 0, -h}, {-h, side, -h}},
             {"left", {-h, 0, h}, {-h, 0, -h}, {-h, side, h}},
             {"right", {h, 0, -h}, {h, 0, h}, {h, side, -h}},
             {"floor", {-h, 0, h}, {h, 0, h}, {-h, 0, -h}}}};
}

CavePlace::CavePlace(const View& view, double scale) : scale_(scale) {
    const glm::dvec3 up = glm::normalize(glm::dvec3(view.up));
    const glm::dvec3 back(view.eye - view.target);
    glm::dvec3 level = back - up * glm::dot(back, up);
    if (!(glm::length(level) > 1e-6 * glm::length(back)))
        throw std::runtime_error("the view looks straight up or down: a room can not stand there");
    level = glm::normalize(level);
    axes_ = glm::dmat3(glm::cross(up, level), up, level);
    origin_ = glm::dvec3(view.eye) - up * (kEyeHeight * scale);
}

} // namespace samples
