// SPDX-License-Identifier: MIT
#include "compat/recorder/transforms.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <initializer_list>
#include <limits>

#include "libsmart/base/error.h"

namespace smart::compat {

namespace {

constexpr double kPi = 3.14159265358979323846;

[[noreturn]] void refuse(const char* reason) {
    throw Error(ErrorCode::InvalidValue, reason);
}

bool allFinite(std::initializer_list<double> values) {
    for (double value : values)
        if (!std::isfinite(value)) return false;
    return true;
}

bool isFinite(const glm::dmat4& matrix) {
    for (int c = 0; c < 4; ++c)
        if (!allFinite({matrix[c][0], matrix[c][1], matrix[c][2], matrix[c][3]})) return false;
    return true;
}

const glm::dmat4& requireFinite(const glm::dmat4& matrix) {
    if (!isFinite(matrix)) refuse("the matrix would not be finite");
    return matrix;
}

// Sine and cosine for |x| <= pi/4: Taylor series to x^17 and x^18, below half a unit in the last
// place of the result.
double sinSeries(double x) {
    const double z = x * x;
    double sum = 0;
    for (int n = 17; n > 1; n -= 2) sum = (1 + sum) * -z / (n * (n - 1));
    return x + x * sum;
}
double cosSeries(double x) {
    const double z = x * x;
    double sum = 0;
    for (int n = 18; n > 1; n -= 2) sum = (1 + sum) * -z / (n * (n - 1));
    return 1 + sum;
}

} // namespace

SinCos sinCosDegrees(double degrees) {
    if (!std::isfinite(degrees)) {
        const double nan = std::numeric_limits<double>::quiet_NaN();
        return {nan, nan};
    }
    // Reduce exactly: to (-360, 360), then to within 45 degrees of a multiple of 90.
    const double turn = std::fmod(degrees, 360.0);
    const double quarters = std::floor(turn / 90.0 + 0.5);
    const double x = (turn - 90.0 * quarters) * (kPi / 180.0);
    const double s = sinSeries(x), c = cosSeries(x);
    switch ((int(quarters) + 8) & 3) {
    case 0: return {s, c};
    case 1: return {c, -s};
    case 2: return {-s, -c};
    default: return {-c, s};
    }
}

glm::dmat4 makeTranslation(const glm::dvec3& offset) {
    glm::dmat4 m(1.0);
    m[3] = glm::dvec4(offset, 1.0);
    return m;
}

glm::dmat4 makeScaling(const glm::dvec3& factors) {
    glm::dmat4 m(1.0);
    for (int k = 0; k < 3; ++k) m[k][k] = factors[k];
    return m;
}

glm::dmat4 makeRotation(double degrees, const glm::dvec3& axis) {
    const double length = glm::length(axis);
    if (length == 0) return glm::dmat4(1.0);
    const glm::dvec3 a = axis / length;
    const auto [s, c] = sinCosDegrees(degrees);
    const double d = 1 - c;
    glm::dmat4 m(1.0);
    m[0] = {a.x * a.x * d + c, a.y * a.x * d + a.z * s, a.x * a.z * d - a.y * s, 0};
    m[1] = {a.x * a.y * d - a.z * s, a.y * a.y * d + c, a.y * a.z * d + a.x * s, 0};
    m[2] = {a.x * a.z * d + a.y * s, a.y * a.z * d - a.x * s, a.z * a.z * d + c, 0};
    return m;
}

glm::dmat4 makeFrustum(double left, double right, double bottom, double top, double zNear,
                       double zFar) {
    if (!allFinite({left, right, bottom, top, zNear, zFar})) refuse("an argument is not finite");
    if (zNear <= 0 || zFar <= 0) refuse("the near and far distances have to be above 0");
    if (left == right || bottom == top || zNear == zFar) refuse("the frustum is empty");
    glm::dmat4 m(0.0);
    m[0][0] = 2 * zNear / (right - left);
    m[1][1] = 2 * zNear / (top - bottom);
    m[2] = {(right + left) / (right - left), (top + bottom) / (top - bottom),
            -(zFar + zNear) / (zFar - zNear), -1};
    m[3][2] = -2 * zFar * zNear / (zFar - zNear);
    return requireFinite(m);
}

glm::dmat4 makeOrtho(double left, double right, double bottom, double top, double zNear,
                     double zFar) {
    if (!allFinite({left, right, bottom, top, zNear, zFar})) refuse("an argument is not finite");
    if (left == right || bottom == top || zNear == zFar) refuse("the box is empty");
    glm::dmat4 m(1.0);
    m[0][0] = 2 / (right - left);
    m[1][1] = 2 / (top - bottom);
    m[2][2] = -2 / (zFar - zNear);
    m[3] = {-(right + left) / (right - left), -(top + bottom) / (top - bottom),
            -(zFar + zNear) / (zFar - zNear), 1};
    return requireFinite(m);
}

glm::dmat4 makePerspective(double fovyDegrees, double aspect, double zNear, double zFar) {
    if (!allFinite({fovyDegrees, aspect, zNear, zFar})) refuse("an argument is not finite");
    if (fovyDegrees <= 0 || fovyDegrees >= 180)
        refuse("the field of view has to be between 0 and 180 degrees");
    if (aspect <= 0) refuse("the aspect ratio has to be above 0");
    if (zNear <= 0 || zFar <= 0 || zNear == zFar)
        refuse("the near and far distances have to be above 0 and differ");
    const auto [s, c] = sinCosDegrees(fovyDegrees / 2);
    glm::dmat4 m(0.0);
    m[0][0] = c / s / aspect;
    m[1][1] = c / s;
    m[2] = {0, 0, -(zFar + zNear) / (zFar - zNear), -1};
    m[3][2] = -2 * zFar * zNear / (zFar - zNear);
    return requireFinite(m);
}

glm::dmat4 makeLookAt(const glm::dvec3& eye, const glm::dvec3& center, const glm::dvec3& up) {
    const glm::dvec3 toCenter = center - eye;
    const double distance = glm::length(toCenter);
    if (!std::isfinite(distance) || distance == 0)
        refuse("eye and centre have to be finite and differ");
    const glm::dvec3 forward = toCenter / distance;
    const glm::dvec3 across = glm::cross(forward, up);
    const double length = glm::length(across);
    if (!std::isfinite(length) || length == 0)
        refuse("the up vector has to be finite and not along the line of sight");
    const glm::dvec3 side = across / length;
    const glm::dvec3 upright = glm::cross(side, forward);
    glm::dmat4 m(1.0);
    for (int k = 0; k < 3; ++k) m[k] = {side[k], upright[k], -forward[k], 0};
    m[3] = {-glm::dot(side, eye), -glm::dot(upright, eye), glm::dot(forward, eye), 1};
    return requireFinite(m);
}

glm::dmat3 makeNormalMatrix(const glm::dmat4& matrix) {
    const glm::dvec3 x(matrix[0]), y(matrix[1]), z(matrix[2]);
    const glm::dmat3 cofactors(glm::cross(y, z), glm::cross(z, x), glm::cross(x, y));
    const double determinant = glm::dot(x, cofactors[0]);
    const double scale = 1 / determinant;
    return std::isfinite(scale) ? cofactors * scale : cofactors;
}

glm::dmat4x3 makeAffine(const glm::dmat4& m) {
    const double k = m[3][3];
    const bool rowFinite = allFinite({m[0][3], m[1][3], m[2][3], k});
    if (rowFinite && (m[0][3] != 0 || m[1][3] != 0 || m[2][3] != 0))
        throw Error(ErrorCode::InvalidOperation,
                    "the last row of an instance's matrix has to be a multiple of (0, 0, 0, 1)");
    if (!rowFinite) return glm::dmat4x3(std::numeric_limits<double>::quiet_NaN());
    if (k == 0) return glm::dmat4x3(0.0);
    glm::dmat4x3 affine;
    for (int c = 0; c < 4; ++c) affine[c] = k == 1 ? glm::dvec3(m[c]) : glm::dvec3(m[c]) / k;
    return affine;
}

bool invert(const glm::dmat4& matrix, glm::dmat4& inverse) {
    if (!isFinite(matrix) || glm::determinant(matrix) == 0) return false;
    const glm::dmat4 result = glm::inverse(matrix);
    if (!isFinite(result)) return false;
    inverse = result;
    return true;
}

} // namespace smart::compat
