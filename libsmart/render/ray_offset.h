// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>

#include "libsmart/scene/hit_chain.h"

namespace smart {

/// How far, at most, a point with these barycentric coordinates lies from its triangle's plane
/// after it was rounded to float in world space, and as the origin of a ray in the space of each
/// model on the way down. World units.
float surfaceError(const HitChain& chain, const float position[3], float u, float v);

/// Origin for a ray that leaves the surface at `position` in `direction`: moved off the plane by
/// `error` along the unit normal, to the side that the ray goes to; along the surface, to the
/// side of `incoming`'s origin. So the ray does not meet the triangle that it leaves, at any
/// scale; a constant epsilon fails both for small scenes and far from the origin.
glm::vec3 leaveSurface(const float position[3], const float normal[3], const float incoming[3],
                       const glm::vec3& direction, float error);

} // namespace smart
