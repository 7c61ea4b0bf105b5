// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>

#include "samples/common/scene_description.h"

namespace samples {

/// Axis-aligned box around what a scene shows; empty scenes have none (low > high).
struct Bounds {
    glm::vec3 low{std::numeric_limits<float>::infinity()};
    glm::vec3 high{-std::numeric_limits<float>::infinity()};

    bool empty() const { return !(low.x <= high.x); }
    glm::vec3 centre() const { return (low + high) * 0.5f; }
    float diagonal() const;
};

/// Of all instances, vertices that are not finite left out.
Bounds boundsOf(const SceneDescription& scene);

/// Where the picture is taken from.
struct View {
    glm::vec3 eye{0.0f, 0.0f, 3.0f}, target{0.0f}, up{0.0f, 1.0f, 0.0f};
    float fovDegrees = 45.0f; ///< vertical
    float height = 0.0f;      ///< of what an orthographic view shows; 0: perspective
};

/// The first camera of the file; without one a three-quarter view that frames the bounds.
View defaultView(const SceneDescription& scene, const Bounds& bounds, float aspect);

} // namespace samples
