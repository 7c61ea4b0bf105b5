// SPDX-License-Identifier: MIT
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <limits>

#include "compat/recorder/transforms.h"
#include "compat/rtu/report.h"
#include "openrt/rtu.h"

using namespace smart;
using namespace smart::compat;

namespace {

glm::dmat4 matrixOf(const RTdouble* m) {
    glm::dmat4 matrix;
    for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = m[i];
    return matrix;
}

template <class... Pointers>
bool anyMissing(const char* function, Pointers... pointers) {
    return (isMissing(pointers, function, "a pointer is NULL") || ...);
}

double toNdc(double window, int origin, int size) {
    return (window - origin) / size * 2 - 1;
}

/// A matrix that is not finite is refused, with the current one left as it is.
void multiply(const char* function, const glm::dmat4& matrix) {
    double m[16];
    bool isFinite = true;
    for (int i = 0; i < 16; ++i) {
        m[i] = matrix[i / 4][i % 4];
        isFinite = isFinite && std::isfinite(m[i]);
    }
    if (!isFinite)
        return recordError(ErrorCode::InvalidValue, function, "the matrix would not be finite");
    rtMultMatrixd(m);
}

/// Zero where it has no length; not a number where that is beyond all numbers.
glm::dvec3 direction(const glm::dvec3& v) {
    const double length = glm::length(v);
    if (!std::isfinite(length)) return glm::dvec3(std::numeric_limits<double>::quiet_NaN());
    return length == 0 ? v : v / length;
}

} // namespace

RTAPI void RTAPIENTRY rtuPerspective(RTdouble fovy, RTdouble aspect, RTdouble zNear,
                                     RTdouble zFar) {
    if (!std::isfinite(fovy) || !std::isfinite(aspect) || !std::isfinite(zNear) ||
        !std::isfinite(zFar))
        return recordError(ErrorCode::InvalidValue, __func__, "an argument is not finite");
    const auto [s, c] = sinCosDegrees(fovy / 2);
    if (s == 0 || aspect == 0 || zNear == zFar) return;
    glm::dmat4 m(0.0);
    m[0][0] = c / s / aspect;
    m[1][1] = c / s;
    m[2] = {0, 0, -(zFar + zNear) / (zFar - zNear), -1};
    m[3][2] = -2 * zFar * zNear / (zFar - zNear);
    multiply(__func__, m);
}

RTAPI void RTAPIENTRY rtuLookAt(RTdouble eyeX, RTdouble eyeY, RTdouble eyeZ, RTdouble centerX,
                                RTdouble centerY, RTdouble centerZ, RTdouble upX, RTdouble upY,
                                RTdouble upZ) {
    const glm::dvec3 eye(eyeX, eyeY, eyeZ);
    const glm::dvec3 forward = direction(glm::dvec3(centerX, centerY, centerZ) - eye);
    const glm::dvec3 side = direction(glm::cross(forward, glm::dvec3(upX, upY, upZ)));
    const glm::dvec3 upright = glm::cross(side, forward);
    glm::dmat4 m(1.0);
    for (int k = 0; k < 3; ++k) m[k] = {side[k], upright[k], -forward[k], 0};
    m[3] = {-glm::dot(side, eye), -glm::dot(upright, eye), glm::dot(forward, eye), 1};
    multiply(__func__, m);
}

RTAPI void RTAPIENTRY rtuOrtho2D(RTdouble left, RTdouble right, RTdouble bottom, RTdouble top) {
    rtOrtho(left, right, bottom, top, -1, 1);
}

RTAPI void RTAPIENTRY rtuPickMatrix(RTdouble x, RTdouble y, RTdouble delX, RTdouble delY,
                                    const RTint* viewport) {
    if (anyMissing(__func__, viewport) || !(delX > 0 && delY > 0)) return;
    rtTranslated((viewport[2] - 2 * (x - viewport[0])) / delX,
                 (viewport[3] - 2 * (y - viewport[1])) / delY, 0);
    rtScaled(viewport[2] / delX, viewport[3] / delY, 1);
}

RTAPI RTint RTAPIENTRY rtuProject(RTdouble objX, RTdouble objY, RTdouble objZ,
                                  const RTdouble* model, const RTdouble* proj, const RTint* view,
                                  RTdouble* winX, RTdouble* winY, RTdouble* winZ) {
    if (anyMissing(__func__, model, proj, view, winX, winY, winZ)) return RT_FALSE;
    const glm::dvec4 clip =
        matrixOf(proj) * (matrixOf(model) * glm::dvec4(objX, objY, objZ, 1));
    if (clip.w == 0) return RT_FALSE;
    *winX = (clip.x / clip.w * 0.5 + 0.5) * view[2] + view[0];
    *winY = (clip.y / clip.w * 0.5 + 0.5) * view[3] + view[1];
    *winZ = clip.z / clip.w * 0.5 + 0.5;
    return RT_TRUE;
}

RTAPI RTint RTAPIENTRY rtuUnProject(RTdouble winX, RTdouble winY, RTdouble winZ,
                                    const RTdouble* model, const RTdouble* proj, const RTint* view,
                                    RTdouble* objX, RTdouble* objY, RTdouble* objZ) {
    if (anyMissing(__func__, objX, objY, objZ)) return RT_FALSE;
    double x, y, z, w;
    if (!rtuUnProject4(winX, winY, winZ, 1, model, proj, view, 0, 1, &x, &y, &z, &w))
        return RT_FALSE;
    *objX = x / w;
    *objY = y / w;
    *objZ = z / w;
    return RT_TRUE;
}

RTAPI RTint RTAPIENTRY rtuUnProject4(RTdouble winX, RTdouble winY, RTdouble winZ, RTdouble clipW,
                                     const RTdouble* model, const RTdouble* proj,
                                     const RTint* view, RTdouble nearVal, RTdouble farVal,
                                     RTdouble* objX, RTdouble* objY, RTdouble* objZ,
                                     RTdouble* objW) {
    if (anyMissing(__func__, model, proj, view, objX, objY, objZ, objW)) return RT_FALSE;
    glm::dmat4 inverse;
    if (!invert(matrixOf(proj) * matrixOf(model), inverse)) return RT_FALSE;
    const glm::dvec4 object =
        inverse * glm::dvec4(toNdc(winX, view[0], view[2]), toNdc(winY, view[1], view[3]),
                             (winZ - nearVal) / (farVal - nearVal) * 2 - 1, clipW);
    if (object.w == 0) return RT_FALSE;
    *objX = object.x;
    *objY = object.y;
    *objZ = object.z;
    *objW = object.w;
    return RT_TRUE;
}

RTAPI RTint RTAPIENTRY rtuPickRay(RTdouble winX, RTdouble winY, const RTdouble* model,
                                  const RTdouble* proj, const RTint* view, RTfloat* origin,
                                  RTfloat* direction) {
    if (anyMissing(__func__, model, proj, view, origin, direction)) return RT_FALSE;
    glm::dmat4 inverse(0);
    const bool regular = invert(matrixOf(proj) * matrixOf(model), inverse);
    const glm::dvec4 step = inverse[2];
    const glm::dvec4 start = inverse * glm::dvec4(toNdc(winX, view[0], view[2]),
                                                  toNdc(winY, view[1], view[3]), -1, 1);
    // Which way the point of depth z moves as z grows: the derivative of xyz / w, times w squared.
    const glm::dvec3 motion = start.w * glm::dvec3(step) - step.w * glm::dvec3(start);
    const double length = glm::length(motion);
    if (!regular || start.w == 0 || !(length > 0) || !std::isfinite(length)) {
        recordError(ErrorCode::InvalidValue, __func__, "no ray leads through this position");
        return RT_FALSE;
    }
    for (int k = 0; k < 3; ++k) {
        origin[k] = float(start[k] / start.w);
        direction[k] = float(motion[k] / length);
    }
    return RT_TRUE;
}
