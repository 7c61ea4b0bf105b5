// SPDX-License-Identifier: MIT
#include "libsmart/render/ray_offset.h"

#include <algorithm>
#include <cmath>
#include <glm/mat3x3.hpp>

#include "libsmart/kernel/point_math.h"

namespace smart {
namespace {

constexpr double kUnit = 0x1p-23; // distance of floats at 1

double maxAbs(const glm::dvec3& p) {
    return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
}

// Bound of the length of matrix * x where no coordinate of x is above 1 in absolute value.
double rowSum(const glm::dmat3& matrix) {
    double sum = 0;
    for (int row = 0; row < 3; ++row)
        sum = std::max(
            sum, std::abs(matrix[0][row]) + std::abs(matrix[1][row]) + std::abs(matrix[2][row]));
    return sum;
}

glm::dmat3 linear(const glm::dmat4x3& matrix) {
    return {matrix[0], matrix[1], matrix[2]};
}

} // namespace

float surfaceError(const HitChain& chain, const float position[3], float u, float v) {
    const Triangle& triangle = chain.model->triangles[chain.triangle];
    const glm::dvec3 corner[3] = {{triangle.v0[0], triangle.v0[1], triangle.v0[2]},
                                  {triangle.v1[0], triangle.v1[1], triangle.v1[2]},
                                  {triangle.v2[0], triangle.v2[1], triangle.v2[2]}};
    // The point in the space of each instance's model, from the innermost out.
    glm::dvec3 point =
        corner[0] + double(u) * (corner[1] - corner[0]) + double(v) * (corner[2] - corner[0]);
    glm::dvec3 inModel[kMaxLevels];
    for (uint32_t level = chain.levels; level-- > 0;) {
        inModel[level] = point;
        point = toParent(*chain.instances[level]) * glm::dvec4(point, 1.0);
    }
    // Half a unit of each coordinate is lost where the point or the origin is rounded, and again
    // where the offset is added: below two units along any direction. Four leave a margin.
    double error = maxAbs({position[0], position[1], position[2]});
    glm::dmat3 toWorld(1.0);
    for (uint32_t level = 0; level < chain.levels; ++level) {
        toWorld = toWorld * linear(toParent(*chain.instances[level]));
        error += rowSum(toWorld) * maxAbs(inModel[level]);
    }
    // What interpolating in double loses where the corners are far away and the point is not.
    const double corners = std::max({maxAbs(corner[0]), maxAbs(corner[1]), maxAbs(corner[2])});
    return float(4.0 * kUnit * error + 0x1p-48 * rowSum(toWorld) * corners);
}

glm::vec3 leaveSurface(const float position[3], const float normal[3], const float incoming[3],
                       const glm::vec3& direction, float error) {
    const auto widened = [](const float* v) { return Real3{v[0], v[1], v[2]}; };
    const Real3 origin = offSurface(widened(position), widened(normal), widened(incoming),
                                    {direction.x, direction.y, direction.z}, error);
    return {float(origin.x), float(origin.y), float(origin.z)};
}

} // namespace smart
