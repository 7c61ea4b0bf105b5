// SPDX-License-Identifier: MIT
#include "libsmart/render/polygon_raster.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace smart {
namespace {

constexpr double kSnap = 0x1p20;        // steps in a pixel
constexpr double kFarthest = 0x1p40;    // of snapped coordinates: beyond this nothing is known

__extension__ using Wide = __int128;

// Twice the area of (a, b, p), positive where they go round counterclockwise.
Wide edge(int64_t ax, int64_t ay, int64_t bx, int64_t by, int64_t px, int64_t py) {
    return Wide(bx - ax) * Wide(py - ay) - Wide(by - ay) * Wide(px - ax);
}

} // namespace

// The corners' clip coordinates x, y, w as the columns of a matrix: its determinant is positive
// where they wind counterclockwise on the screen, for w > 0. By the Cauchy-Binet formula it is a
// linear function of the triangle's plane, whose coefficients are the minors of the projection's
// rows x, y and w.
PolygonRaster::PolygonRaster(const Frame& layer) : layer_(layer) {
    const glm::dmat4& m = layer.matrixCamera.projection;
    const auto minorWithout = [&](int column) {
        glm::dmat3 minor;
        for (int k = 0, at = 0; k < 4; ++k)
            if (k != column) minor[at++] = {m[k].x, m[k].y, m[k].w};
        return glm::determinant(minor);
    };
    eye_ = {minorWithout(0), -minorWithout(1), minorWithout(2)};
    plane_ = minorWithout(3);
}

bool PolygonRaster::isCounterclockwise(const RasterTriangle& triangle, const Ray& ray) const {
    if (layer_.camera)
        return glm::dot(triangle.normal, glm::dvec3(ray.dir[0], ray.dir[1], ray.dir[2])) < 0.0;
    return glm::dot(eye_, triangle.normal) +
               plane_ * glm::dot(triangle.normal, triangle.corners[0]) >
           0.0;
}

PolygonRaster::Plane PolygonRaster::planeOf(const RasterTriangle& triangle) const {
    Plane result;
    if (layer_.camera) return result;
    const glm::dvec4 plane(triangle.normal, -glm::dot(triangle.normal, triangle.corners[0]));
    const glm::dmat4& inverse = layer_.matrixCamera.inverse;
    double(&clip)[4] = result.clip;
    for (int k = 0; k < 4; ++k) clip[k] = glm::dot(plane, inverse[k]);
    const double size = std::fabs(clip[0]) + std::fabs(clip[1]) + std::fabs(clip[3]);
    if (!(std::fabs(clip[2]) > 0x1p-40 * size)) return result;
    const double range = double(layer_.depthFar) - layer_.depthNear;
    result.slope = std::fabs(range / clip[2]) *
                   std::max(std::fabs(clip[0]) / layer_.viewport.width,
                            std::fabs(clip[1]) / layer_.viewport.height);
    result.hasDepth = true;
    return result;
}

PolygonRaster::Depth PolygonRaster::depthAt(const Plane& plane, const glm::dvec2& at) const {
    const Viewport& viewport = layer_.viewport;
    const double x = 2.0 * (at.x - viewport.x) / viewport.width - 1.0;
    const double y = 2.0 * (at.y - viewport.y) / viewport.height - 1.0;
    const double z = -(plane.clip[0] * x + plane.clip[1] * y + plane.clip[3]) / plane.clip[2];
    const double range = double(layer_.depthFar) - layer_.depthNear;
    return {layer_.depthNear + range * (std::clamp(z, -1.0, 1.0) * 0.5 + 0.5), plane.slope};
}

bool PolygonRaster::snap(const RasterTriangle& triangle, SnappedTriangle& snapped) const {
    if (layer_.camera) return false;
    const Viewport& viewport = layer_.viewport;
    for (int i = 0; i < 3; ++i) {
        const glm::dvec4 clip =
            layer_.matrixCamera.projection * glm::dvec4(triangle.corners[i], 1.0);
        const double x = (clip.x / clip.w * 0.5 + 0.5) * viewport.width + viewport.x;
        const double y = (clip.y / clip.w * 0.5 + 0.5) * viewport.height + viewport.y;
        if (!(clip.w > 0.0) || !(std::fabs(x) * kSnap < kFarthest) ||
            !(std::fabs(y) * kSnap < kFarthest))
            return false;
        snapped.x[i] = std::llround(x * kSnap);
        snapped.y[i] = std::llround(y * kSnap);
    }
    return true;
}

Coverage PolygonRaster::coverage(const SnappedTriangle& t, const glm::dvec2& at) {
    const int64_t px = std::llround(at.x * kSnap), py = std::llround(at.y * kSnap);
    const Wide area = edge(t.x[0], t.y[0], t.x[1], t.y[1], t.x[2], t.y[2]);
    if (area == 0) return Coverage::Boundary;
    const int second = area > 0 ? 1 : 2, third = 3 - second;
    const int round[4] = {0, second, third, 0};
    Coverage found = Coverage::Owned;
    for (int i = 0; i < 3; ++i) {
        const int a = round[i], b = round[i + 1];
        const Wide side = edge(t.x[a], t.y[a], t.x[b], t.y[b], px, py);
        if (side < 0) return Coverage::Outside;
        const int64_t dx = t.x[b] - t.x[a], dy = t.y[b] - t.y[a];
        const bool filled = dy < 0 || (dy == 0 && dx > 0);
        if (side == 0 && !filled) found = Coverage::Boundary;
    }
    return found;
}

} // namespace smart
