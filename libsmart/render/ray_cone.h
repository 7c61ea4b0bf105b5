// SPDX-License-Identifier: MIT
// How much of the scene a ray stands for, so that textures are filtered over as much.
//
// Akenine-Moeller, Nilsson, Andersson, Barre-Brisebois, Toth, Karras: "Texture Level of Detail
// Strategies for Real-Time Ray Tracing", Ray Tracing Gems, chapter 20, 2019; the growth along a
// path after Akenine-Moeller, Crassin, Boksansky, Belcour, Panteleev, Wright: "Improved Shader and
// Texture Level of Detail Using Ray Cones", Journal of Computer Graphics Techniques 10(1), 2021,
// with surfaces taken as flat. Angles are small: their tangents stand for them.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "openrt/rts.h"

namespace smart {

/// A cone around a ray.
struct RayCone {
    float width = 0.0f;  ///< across the ray, where it starts
    float spread = 0.0f; ///< what the width gains on a unit of length

    /// The cone of a ray that goes on from the point at `distance`: mirrored, refracted, straight.
    RayCone after(float distance) const { return {width + spread * distance, spread}; }
};

/// Side of a square of the given area, times `scale`; 0 if that is no number.
inline float coneSide(double area, double scale) {
    const float length = float(scale * std::sqrt(area));
    return std::isfinite(length) ? length : 0.0f;
}

/// The cone that covers as much as lies between a camera ray, of direction length 1, and its
/// neighbours: `origin` and `direction` are what those differ by from it, for a step of one pixel
/// to the right and one up. `scale`: share of a pixel's side that a sample stands for.
inline RayCone coneBetween(const glm::dvec3& along, const glm::dvec3 (&origin)[2],
                           const glm::dvec3 (&direction)[2], double scale) {
    const auto side = [&](const glm::dvec3& right, const glm::dvec3& up) {
        return coneSide(std::fabs(glm::dot(glm::cross(right, up), along)), scale);
    };
    return {side(origin[0], origin[1]), side(direction[0], direction[1])};
}

/// Size in texture coordinates of the footprint at a shaded point, in the direction in which the
/// surface lies most oblique to the ray: (width of the cone) * density / |n.d|. 0: unknown.
inline float textureFootprint(float width, float density, const glm::vec3& n, const glm::vec3& d) {
    const float size = width * density;
    if (!(size > 0.0f)) return 0.0f;
    return size / std::fabs(n.x * d.x + n.y * d.y + n.z * d.z);
}
inline float textureFootprint(const RTSstate& state) {
    const float* n = state.geometricNormal;
    const float* d = state.rayDirection;
    return textureFootprint(state.footprint, state.texCoordDensity, {n[0], n[1], n[2]},
                            {d[0], d[1], d[2]});
}

} // namespace smart
