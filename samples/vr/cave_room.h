// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "samples/common/view.h"

namespace samples {

/// A wall of a room of screens, by three of its corners as a viewer inside sees them.
struct CaveWall {
    const char* name;
    glm::dvec3 lowerLeft, lowerRight, upperLeft;
};

/// The four walls of a CAVE (Cruz-Neira, Sandin, DeFanti, "Surround-screen projection-based virtual
/// reality", SIGGRAPH 1993): a cube with the floor's middle as origin, y up, -z to the front. The
/// lower edge of the floor is the one away from the front wall.
std::array<CaveWall, 4> caveWalls(double side);

/// Where the room stands in a scene: a viewer of average height in its middle looks as the view
/// does, upright.
class CavePlace {
public:
    /// scale: units of the scene to the metre.
    CavePlace(const View& view, double scale);

    glm::dvec3 toScene(const glm::dvec3& inRoom) const {
        return origin_ + axes_ * (inRoom * scale_);
    }

private:
    glm::dmat3 axes_; ///< columns: right, up, back
    glm::dvec3 origin_;
    double scale_;
};

} // namespace samples
