// SPDX-License-Identifier: MIT
#include "libsmart/accel/triangle_clip.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace smart {
namespace {

/// A corner of the polygon. A corner made by clipping has slack 1: its coordinates are rounded.
struct Corner {
    double x[3];
    double slack;
};

constexpr int kMaxCorners = 9; // three, and one more for each of six planes

/// Keeps the part of a convex polygon where sign * (x[axis] - plane) <= 0; how many corners remain.
int clipToHalfSpace(const Corner* in, int count, int axis, double plane, double sign,
                    Corner* out) {
    int kept = 0;
    const Corner* previous = &in[count - 1];
    double previousOut = sign * (previous->x[axis] - plane);
    for (int i = 0; i < count; ++i) {
        const Corner* current = &in[i];
        const double currentOut = sign * (current->x[axis] - plane);
        if ((previousOut <= 0) != (currentOut <= 0)) {
            Corner& crossing = out[kept++];
            const double along = previousOut / (previousOut - currentOut);
            for (int k = 0; k < 3; ++k) {
                crossing.x[k] = previous->x[k] + along * (current->x[k] - previous->x[k]);
            }
            crossing.x[axis] = plane;
            crossing.slack = 1;
        }
        if (currentOut <= 0) out[kept++] = *current;
        previous = current;
        previousOut = currentOut;
    }
    return kept;
}

} // namespace

// Sutherland, Hodgman, "Reentrant polygon clipping", CACM 17(1), 1974; in double, and only against
// the planes that the triangle's box crosses.
Aabb clipTriangle(const float v0[3], const float v1[3], const float v2[3], const Aabb& cell) {
    Aabb box;
    box.add(v0);
    box.add(v1);
    box.add(v2);

    double pad[3], lo[3], hi[3];
    bool inside = true;
    for (int k = 0; k < 3; ++k) {
        const double scale = std::max(std::fabs(double(cell.lo[k])), std::fabs(double(cell.hi[k])));
        pad[k] = scale * 0x1p-22 + 0x1p-148; // not less than a float's rounding, denormal or not
        lo[k] = cell.lo[k] - pad[k];
        hi[k] = cell.hi[k] + pad[k];
        if (box.lo[k] > hi[k] || box.hi[k] < lo[k]) return Aabb{};
        inside = inside && box.lo[k] >= cell.lo[k] && box.hi[k] <= cell.hi[k];
    }
    if (inside) return box;

    Corner buffers[2][kMaxCorners];
    Corner *polygon = buffers[0], *clipped = buffers[1];
    int count = 3;
    for (int k = 0; k < 3; ++k) {
        polygon[0].x[k] = v0[k];
        polygon[1].x[k] = v1[k];
        polygon[2].x[k] = v2[k];
        polygon[k].slack = 0;
    }
    for (int k = 0; k < 3; ++k) {
        if (box.lo[k] < lo[k]) {
            count = clipToHalfSpace(polygon, count, k, lo[k], -1, clipped);
            if (count == 0) return Aabb{};
            std::swap(polygon, clipped);
        }
        if (box.hi[k] > hi[k]) {
            count = clipToHalfSpace(polygon, count, k, hi[k], 1, clipped);
            if (count == 0) return Aabb{};
            std::swap(polygon, clipped);
        }
    }

    Aabb result;
    for (int k = 0; k < 3; ++k) {
        double least = polygon[0].x[k] - polygon[0].slack * pad[k];
        double most = polygon[0].x[k] + polygon[0].slack * pad[k];
        for (int i = 1; i < count; ++i) {
            least = std::min(least, polygon[i].x[k] - polygon[i].slack * pad[k]);
            most = std::max(most, polygon[i].x[k] + polygon[i].slack * pad[k]);
        }
        result.lo[k] = std::clamp(std::max(float(least), box.lo[k]), cell.lo[k], cell.hi[k]);
        result.hi[k] = std::clamp(std::min(float(most), box.hi[k]), cell.lo[k], cell.hi[k]);
    }
    return result;
}

} // namespace smart
