// SPDX-License-Identifier: MIT
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/mat4x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace smart::compat {

// Matrices of OpenGL's and GLU's calls, column-major, in double. Projections throw Error
// (InvalidValue) for arguments that OpenGL refuses, or where the result would not be finite.

glm::dmat4 makeTranslation(const glm::dvec3& offset);
glm::dmat4 makeScaling(const glm::dvec3& factors);
/// A zero axis: the identity. Multiples of 90 degrees about a coordinate axis are exact.
glm::dmat4 makeRotation(double degrees, const glm::dvec3& axis);
glm::dmat4 makeFrustum(double left, double right, double bottom, double top, double zNear,
                       double zFar);
glm::dmat4 makeOrtho(double left, double right, double bottom, double top, double zNear,
                     double zFar);
glm::dmat4 makePerspective(double fovyDegrees, double aspect, double zNear, double zFar);
glm::dmat4 makeLookAt(const glm::dvec3& eye, const glm::dvec3& center, const glm::dvec3& up);

struct SinCos {
    double sin, cos;
};
/// In double without the C library, whose last bits depend on the machine; multiples of 30 and 45
/// degrees symmetric, of 90 degrees exact. Not finite: NaN.
SinCos sinCosDegrees(double degrees);

/// Inverse transpose of the upper left 3x3 part; of a singular one the cofactors.
glm::dmat3 makeNormalMatrix(const glm::dmat4& matrix);

/// The matrix without its last row, which has to be a multiple k of (0, 0, 0, 1), divided by k;
/// throws Error (InvalidOperation) where it is not. k = 0 gives a singular matrix.
glm::dmat4x3 makeAffine(const glm::dmat4& matrix);

/// False where the matrix is singular or not finite.
bool invert(const glm::dmat4& matrix, glm::dmat4& inverse);

} // namespace smart::compat
