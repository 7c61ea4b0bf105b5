// SPDX-License-Identifier: MIT
#pragma once

#include "libsmart/base/aabb.h"

namespace smart {

/// Box of the part of a triangle inside `cell`; empty if they are disjoint. Conservative: the cell
/// counts as enlarged by 2 to 4 units in the last place of its largest coordinate on each axis,
/// and ends that clipping makes are moved outward as far. The result lies within the cell. Ends
/// at the triangle's own vertices are exact.
Aabb clipTriangle(const float v0[3], const float v1[3], const float v2[3], const Aabb& cell);

} // namespace smart
