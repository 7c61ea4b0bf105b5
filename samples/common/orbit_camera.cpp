// SPDX-License-Identifier: MIT
#include "samples/common/orbit_camera.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

namespace samples {
namespace {

/// v turned about a unit axis (Rodrigues).
glm::vec3 turned(const glm::vec3& v, const glm::vec3& axis, float angle) {
    return v * std::cos(angle) + glm::cross(axis, v) * std::sin(angle) +
           axis * glm::dot(axis, v) * (1.0f - std::cos(angle));
}

} // namespace

OrbitCamera::OrbitCamera(const View& start) : start_(start), view_(start) {}

void OrbitCamera::orbit(float right, float up) {
    const glm::vec3 pole = glm::normalize(view_.up);
    glm::vec3 arm = view_.eye - view_.target;
    arm = turned(arm, pole, -right);
    // Stop short of the poles, where there is no right-hand side.
    constexpr float kLeast = 0.02f;
    const float fromPole = std::acos(std::clamp(glm::dot(glm::normalize(arm), pole), -1.0f, 1.0f));
    const float wanted = std::clamp(fromPole - up, kLeast, glm::pi<float>() - kLeast);
    const glm::vec3 side = glm::normalize(glm::cross(pole, arm));
    view_.eye = view_.target + turned(arm, side, wanted - fromPole);
}

void OrbitCamera::pan(float right, float up) {
    const glm::vec3 arm = view_.eye - view_.target;
    const glm::vec3 forward = -glm::normalize(arm);
    const glm::vec3 side = glm::normalize(glm::cross(forward, view_.up));
    const float height =
        view_.height > 0.0f
            ? view_.height
            : 2.0f * std::tan(glm::radians(view_.fovDegrees) * 0.5f) * glm::length(arm);
    const glm::vec3 step = (side * -right + glm::cross(side, forward) * -up) * height;
    view_.eye += step;
    view_.target += step;
}

void OrbitCamera::zoom(float factor) {
    if (view_.height > 0.0f) {
        view_.height /= factor;
    } else {
        view_.eye = view_.target + (view_.eye - view_.target) / factor;
    }
}

void OrbitCamera::focus(float distance) {
    for (View* view : {&start_, &view_}) {
        view->target = view->eye + glm::normalize(view->target - view->eye) * distance;
    }
}

} // namespace samples
