// SPDX-License-Identifier: MIT
// Cameras of virtual reality: each becomes a built-in Matrix camera of the frame under way.
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include "compat/openrt/guard.h"
#include "compat/recorder/transforms.h"
#include "openrt/rt.h"
#include "openrt/rtu.h"

using namespace smart;
using namespace smart::compat;

namespace {

[[noreturn]] void refuse(const char* text) { throwError(ErrorCode::InvalidValue, text); }

glm::dmat4 matrixOf(const RTdouble* m, const char* name) {
    requirePointer(m, name);
    glm::dmat4 matrix;
    for (int i = 0; i < 16; ++i) {
        if (!std::isfinite(m[i])) refuse("a number of a matrix is not finite");
        matrix[i / 4][i % 4] = m[i];
    }
    return matrix;
}

glm::dvec3 pointOf(const RTdouble* p, const char* name) {
    requirePointer(p, name);
    for (int k = 0; k < 3; ++k)
        if (!std::isfinite(p[k])) refuse("a coordinate is not finite");
    return {p[0], p[1], p[2]};
}

/// Class and shader bound now are bound again at the end.
class KeepBinding {
public:
    KeepBinding() {
        rtGetIntegerv(RT_SHADER_CLASS_BINDING, &shaderClass_);
        rtGetIntegerv(RT_SHADER_BINDING, &shader_);
    }
    ~KeepBinding() {
        rtBindShaderClass(RTuint(shaderClass_));
        if (shader_ != 0) rtBindShader(RTuint(shader_));
    }
    KeepBinding(const KeepBinding&) = delete;
    KeepBinding& operator=(const KeepBinding&) = delete;

private:
    RTint shaderClass_ = 0, shader_ = 0;
};

void setMatrix(const char* parameter, const glm::dmat4& matrix) {
    float values[16];
    for (int i = 0; i < 16; ++i) values[i] = float(matrix[i / 4][i % 4]);
    rtParameter16fv(rtParameterHandle(parameter), values);
}

void useCamera(Context& context, const glm::dmat4& projection, const glm::dmat4& modelView) {
    context.recorder().requireOutsideObject();
    glm::dmat4 inverse;
    if (!invert(projection * modelView, inverse)) refuse("the matrices have no inverse");
    const KeepBinding keep;
    const RTuint shaderClass = rtGenNewShaderClass("Matrix", nullptr);
    const RTuint camera = rtGenNewShader();
    if (camera == RT_INVALID) return;
    setMatrix("projection", projection);
    setMatrix("modelView", modelView);
    rtUseCamera(camera);
    // The frame keeps the shader; its ids are of no use to anyone.
    rtRemoveShader(camera);
    rtRemoveShaderClass(shaderClass);
}

} // namespace

RTAPI void RTAPIENTRY rtuCameraFromMatrices(const RTdouble projection[16],
                                            const RTdouble modelview[16]) {
    guarded(__func__, [&](Context& c) {
        const glm::dmat4 p = matrixOf(projection, "projection");
        useCamera(c, p, matrixOf(modelview, "modelview"));
    });
}

// The screen in coordinates of its own: from the eye, in half widths, half heights and the way to
// its middle. Clip coordinates are these, so any parallelogram will do (Kooima, Generalized
// Perspective Projection, 2009, has the rectangular case).
RTAPI void RTAPIENTRY rtuCameraFromWall(const RTdouble lowerLeft[3], const RTdouble lowerRight[3],
                                        const RTdouble upperLeft[3], const RTdouble eye[3]) {
    guarded(__func__, [&](Context& c) {
        const glm::dvec3 corner = pointOf(lowerLeft, "lowerLeft");
        const glm::dvec3 right = (pointOf(lowerRight, "lowerRight") - corner) * 0.5;
        const glm::dvec3 up = (pointOf(upperLeft, "upperLeft") - corner) * 0.5;
        const glm::dvec3 centre = pointOf(eye, "eye");
        const glm::dvec3 toMiddle = corner + right + up - centre;
        const glm::dmat4 toWorld(glm::dvec4(right, 0), glm::dvec4(up, 0), glm::dvec4(toMiddle, 0),
                                 glm::dvec4(centre, 1));
        const double volume = glm::dot(glm::cross(right, up), toMiddle);
        const double size = glm::length(right) * glm::length(up) * glm::length(toMiddle);
        glm::dmat4 toScreen;
        if (!(std::fabs(volume) > 1e-12 * size) || !invert(toWorld, toScreen))
            refuse("the screen has no area, or the eye is in its plane");
        constexpr double kNear = 0.01; // of the eye's distance from the plane; far: infinity
        const glm::dmat4 projection(glm::dvec4(1, 0, 0, 0), glm::dvec4(0, 1, 0, 0),
                                    glm::dvec4(0, 0, 1, 1), glm::dvec4(0, 0, -2 * kNear, 0));
        useCamera(c, projection, toScreen);
    });
}

RTAPI void RTAPIENTRY rtuCameraFromFov(const RTdouble pose[16], RTdouble left, RTdouble right,
                                       RTdouble up, RTdouble down) {
    guarded(__func__, [&](Context& c) {
        const glm::dmat4 toWorld = matrixOf(pose, "pose");
        constexpr double kQuarter = 1.5707963267948966, kDegrees = 57.295779513082321;
        double slope[4]; // of the sides: left, right, down, up
        const double angles[4] = {left, right, down, up};
        for (int i = 0; i < 4; ++i) {
            if (!(std::fabs(angles[i]) < kQuarter)) refuse("an angle is not below 90 degrees");
            const SinCos direction = sinCosDegrees(angles[i] * kDegrees);
            slope[i] = direction.sin / direction.cos;
        }
        if (!(slope[0] < slope[1] && slope[2] < slope[3])) refuse("the view has no extent");
        glm::dmat4 modelView;
        if (!invert(toWorld, modelView)) refuse("the pose has no inverse");
        constexpr double kNear = 0.01;
        glm::dmat4 projection(0.0);
        projection[0][0] = 2 / (slope[1] - slope[0]);
        projection[1][1] = 2 / (slope[3] - slope[2]);
        projection[2] = {(slope[1] + slope[0]) / (slope[1] - slope[0]),
                         (slope[3] + slope[2]) / (slope[3] - slope[2]), -1, -1};
        projection[3][2] = -2 * kNear;
        useCamera(c, projection, modelView);
    });
}
