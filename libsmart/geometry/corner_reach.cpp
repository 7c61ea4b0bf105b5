// SPDX-License-Identifier: MIT
#include "libsmart/geometry/corner_reach.h"

#include <algorithm>
#include <cmath>

namespace smart {
namespace {

constexpr std::size_t kMostTriangles = std::size_t(1) << 16;
/// Turned by any angle, an ellipsoid of this reach gains nothing worth its square roots.
constexpr double kNoGain = 1.6;

} // namespace

double cornerReach(const std::vector<Triangle>& triangles, const TriangleBoxes& boxes) {
    const Aabb& bounds = boxes.bounds;
    if (bounds.empty() || triangles.size() > kMostTriangles) return kReachesCorners;
    double centre[3], inverse[3];
    for (int k = 0; k < 3; ++k) {
        const double half = 0.5 * (double(bounds.hi[k]) - double(bounds.lo[k]));
        centre[k] = 0.5 * (double(bounds.lo[k]) + double(bounds.hi[k]));
        inverse[k] = half > 0 ? 1 / half : 0;
    }
    double farthest = 1;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        if (boxes.boxes[i].empty()) continue;
        const Triangle& triangle = triangles[i];
        for (const float* const vertex : {triangle.v0, triangle.v1, triangle.v2}) {
            double square = 0;
            for (int k = 0; k < 3; ++k) {
                const double part = (double(vertex[k]) - centre[k]) * inverse[k];
                square += part * part;
            }
            farthest = std::max(farthest, square);
        }
        if (farthest > kNoGain * kNoGain) return kReachesCorners;
    }
    return std::sqrt(farthest) * (1 + 0x1p-40); // more than what was rounded
}

} // namespace smart
