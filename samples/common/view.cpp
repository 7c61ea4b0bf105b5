// SPDX-License-Identifier: MIT
#include "samples/common/view.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace samples {

float Bounds::diagonal() const { return empty() ? 0.0f : glm::length(high - low); }

Bounds boundsOf(const SceneDescription& scene) {
    std::vector<Bounds> meshBounds;
    for (const MeshDescription& mesh : scene.meshes) {
        Bounds& bounds = meshBounds.emplace_back();
        for (const MeshPart& part : mesh.parts) {
            for (const glm::vec3& p : part.positions) {
                if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) continue;
                bounds.low = glm::min(bounds.low, p);
                bounds.high = glm::max(bounds.high, p);
            }
        }
    }
    Bounds whole;
    for (const InstanceDescription& instance : scene.instances) {
        const Bounds& bounds = meshBounds[instance.mesh];
        if (bounds.empty()) continue;
        for (int corner = 0; corner < 8; ++corner) {
            const glm::dvec4 p(corner & 1 ? bounds.high.x : bounds.low.x,
                               corner & 2 ? bounds.high.y : bounds.low.y,
                               corner & 4 ? bounds.high.z : bounds.low.z, 1.0);
            const glm::vec3 q(instance.transform * p);
            whole.low = glm::min(whole.low, q);
            whole.high = glm::max(whole.high, q);
        }
    }
    return whole;
}

View defaultView(const SceneDescription& scene, const Bounds& bounds, float aspect) {
    View view;
    if (!scene.cameras.empty()) {
        const CameraDescription& camera = scene.cameras.front();
        const glm::vec3 forward = glm::normalize(camera.direction);
        // The point to orbit: the depth at which the scene's middle lies, if that is in front.
        const float depth = bounds.empty() ? 1.0f : glm::dot(bounds.centre() - camera.eye, forward);
        view.eye = camera.eye;
        view.target = camera.eye + forward * std::max(depth, 0.1f * bounds.diagonal() + 1e-3f);
        view.up = camera.up;
        view.fovDegrees = camera.fovDegrees;
        view.height = camera.height;
        return view;
    }
    if (bounds.empty()) return view;
    // As near as the box's corners allow.
    constexpr float kMargin = 1.06f;
    const glm::vec3 arm = glm::normalize(glm::vec3(0.55f, 0.4f, 1.0f));
    const glm::vec3 side = glm::normalize(glm::cross(view.up, arm));
    const glm::vec3 above = glm::cross(arm, side);
    const float tanHigh = std::tan(glm::radians(view.fovDegrees) * 0.5f);
    const float tanWide = tanHigh * aspect;
    float distance = std::numeric_limits<float>::min();
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 p = glm::vec3(corner & 1 ? bounds.high.x : bounds.low.x,
                                      corner & 2 ? bounds.high.y : bounds.low.y,
                                      corner & 4 ? bounds.high.z : bounds.low.z) -
                            bounds.centre();
        distance = std::max({distance, glm::dot(p, arm) + std::abs(glm::dot(p, side)) / tanWide,
                             glm::dot(p, arm) + std::abs(glm::dot(p, above)) / tanHigh});
    }
    view.target = bounds.centre();
    view.eye = view.target + arm * (distance * kMargin);
    return view;
}

} // namespace samples
