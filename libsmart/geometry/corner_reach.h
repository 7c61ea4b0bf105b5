// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "libsmart/geometry/triangle_boxes.h"

namespace smart {

/// Of what fills its box up to a corner, and more than can be.
inline constexpr double kReachesCorners = 2.0;

/// How far triangles reach into the corners of their bounds: the largest distance of a vertex from
/// the centre, in units of the bounds' half sizes. A ball has 1, a cube the square root of 3. So
/// many times as large as the ellipsoid inside the bounds, one holds all vertices; turned, it takes
/// less room than the turned bounds. kReachesCorners where there is nothing to gain by that, or too
/// many triangles to look at again: models of so many are in few places.
double cornerReach(const std::vector<Triangle>& triangles, const TriangleBoxes& boxes);

} // namespace smart
