// SPDX-License-Identifier: MIT
#include <glm/matrix.hpp>
#include <optional>

#include "compat/openrt/guard.h"
#include "compat/openrt/tokens.h"
#include "compat/recorder/transforms.h"
#include "openrt/rt_state.h"

using namespace smart;
using namespace smart::compat;

namespace {

/// A copy of a call's matrix; empty for NULL.
using MatrixArgument = std::optional<glm::dmat4>;

template <class T>
MatrixArgument argument(const T* m) noexcept {
    if (!m) return std::nullopt;
    glm::dmat4 matrix;
    for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = m[i];
    return matrix;
}

const glm::dmat4& given(const MatrixArgument& m) {
    if (!m) throwError(ErrorCode::InvalidValue, "m is NULL");
    return *m;
}

/// make() checks its arguments, so it runs before anything changes.
template <class Make>
void load(const char* function, Make make) {
    recorded(function, [make](Context& c) {
        Matrices& matrices = c.recorder().matrices();
        matrices.current().load(make());
    });
}
template <class Make>
void multiply(const char* function, Make make) {
    recorded(function, [make](Context& c) {
        Matrices& matrices = c.recorder().matrices();
        matrices.current().multiply(make());
    });
}

} // namespace

RTAPI void RTAPIENTRY rtMatrixMode(RTenum mode) {
    recorded(__func__, [=](Context& c) { c.recorder().matrices().setMode(matrixModeOf(mode)); });
}
RTAPI void RTAPIENTRY rtPushMatrix(void) {
    recorded(__func__, [](Context& c) { c.recorder().matrices().current().push(); });
}
RTAPI void RTAPIENTRY rtPopMatrix(void) {
    recorded(__func__, [](Context& c) { c.recorder().matrices().current().pop(); });
}

RTAPI void RTAPIENTRY rtLoadIdentity(void) {
    load(__func__, [] { return glm::dmat4(1.0); });
}
RTAPI void RTAPIENTRY rtLoadMatrixf(const RTfloat* m) {
    load(__func__, [m = argument(m)] { return given(m); });
}
RTAPI void RTAPIENTRY rtLoadMatrixd(const RTdouble* m) {
    load(__func__, [m = argument(m)] { return given(m); });
}
RTAPI void RTAPIENTRY rtLoadTransposeMatrixf(const RTfloat* m) {
    load(__func__, [m = argument(m)] { return glm::transpose(given(m)); });
}
RTAPI void RTAPIENTRY rtLoadTransposeMatrixd(const RTdouble* m) {
    load(__func__, [m = argument(m)] { return glm::transpose(given(m)); });
}
RTAPI void RTAPIENTRY rtMultMatrixf(const RTfloat* m) {
    multiply(__func__, [m = argument(m)] { return given(m); });
}
RTAPI void RTAPIENTRY rtMultMatrixd(const RTdouble* m) {
    multiply(__func__, [m = argument(m)] { return given(m); });
}
RTAPI void RTAPIENTRY rtMultTransposeMatrixf(const RTfloat* m) {
    multiply(__func__, [m = argument(m)] { return glm::transpose(given(m)); });
}
RTAPI void RTAPIENTRY rtMultTransposeMatrixd(const RTdouble* m) {
    multiply(__func__, [m = argument(m)] { return glm::transpose(given(m)); });
}

RTAPI void RTAPIENTRY rtRotatef(RTfloat angle, RTfloat x, RTfloat y, RTfloat z) {
    multiply(__func__, [=] { return makeRotation(angle, {x, y, z}); });
}
RTAPI void RTAPIENTRY rtRotated(RTdouble angle, RTdouble x, RTdouble y, RTdouble z) {
    multiply(__func__, [=] { return makeRotation(angle, {x, y, z}); });
}
RTAPI void RTAPIENTRY rtScalef(RTfloat x, RTfloat y, RTfloat z) {
    multiply(__func__, [=] { return makeScaling({x, y, z}); });
}
RTAPI void RTAPIENTRY rtScaled(RTdouble x, RTdouble y, RTdouble z) {
    multiply(__func__, [=] { return makeScaling({x, y, z}); });
}
RTAPI void RTAPIENTRY rtTranslatef(RTfloat x, RTfloat y, RTfloat z) {
    multiply(__func__, [=] { return makeTranslation({x, y, z}); });
}
RTAPI void RTAPIENTRY rtTranslated(RTdouble x, RTdouble y, RTdouble z) {
    multiply(__func__, [=] { return makeTranslation({x, y, z}); });
}

RTAPI void RTAPIENTRY rtFrustum(RTdouble left, RTdouble right, RTdouble bottom, RTdouble top,
                                RTdouble zNear, RTdouble zFar) {
    multiply(__func__, [=] { return makeFrustum(left, right, bottom, top, zNear, zFar); });
}
RTAPI void RTAPIENTRY rtOrtho(RTdouble left, RTdouble right, RTdouble bottom, RTdouble top,
                              RTdouble zNear, RTdouble zFar) {
    multiply(__func__, [=] { return makeOrtho(left, right, bottom, top, zNear, zFar); });
}
RTAPI void RTAPIENTRY rtPerspective(RTdouble fovy, RTdouble aspect, RTdouble zNear,
                                    RTdouble zFar) {
    multiply(__func__, [=] { return makePerspective(fovy, aspect, zNear, zFar); });
}
RTAPI void RTAPIENTRY rtLookAt(RTdouble eyeX, RTdouble eyeY, RTdouble eyeZ, RTdouble centerX,
                               RTdouble centerY, RTdouble centerZ, RTdouble upX, RTdouble upY,
                               RTdouble upZ) {
    multiply(__func__, [=] {
        return makeLookAt({eyeX, eyeY, eyeZ}, {centerX, centerY, centerZ}, {upX, upY, upZ});
    });
}
