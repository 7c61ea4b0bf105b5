// SPDX-License-Identifier: MIT
// Cameras of virtual reality: each becomes a built-in Matrix camera of the frame under way.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <optional>
#include <span>
#include <string>

#include "compat/openrt/guard.h"
#include "compat/recorder/transforms.h"
#include "openrt/rt.h"
#include "openrt/rtu.h"

using namespace smart;
using namespace smart::compat;

namespace {

[[noreturn]] void refuse(const std::string& text) { throwError(ErrorCode::InvalidValue, text); }

/// What an argument points to, as display lists keep it; none: the pointer is NULL.
template <std::size_t n>
using Numbers = std::optional<std::array<double, n>>;

template <std::size_t n>
Numbers<n> numbersAt(const RTdouble* p) {
    if (!p) return {};
    Numbers<n> numbers(std::in_place);
    std::copy_n(p, n, numbers->begin());
    return numbers;
}

template <std::size_t n>
const std::array<double, n>& finite(const Numbers<n>& numbers, const char* name) {
    requirePointer(numbers ? numbers->data() : nullptr, name);
    for (const double number : *numbers)
        if (!std::isfinite(number)) refuse(std::string(name) + " is not finite");
    return *numbers;
}

glm::dmat4 matrixOf(const Numbers<16>& numbers, const char* name) {
    return glm::make_mat4(finite(numbers, name).data());
}

glm::dvec3 pointOf(const Numbers<3>& numbers, const char* name) {
    return glm::make_vec3(finite(numbers, name).data());
}

/// A shader of the built-in class Matrix. It is bound from make() on; at the end its ids are gone
/// and what was bound before is bound again.
class MatrixCamera {
public:
    explicit MatrixCamera(ShaderCatalog& shaders)
        : shaders_(shaders), boundClass_(shaders.boundClass()), boundShader_(shaders.bound().id) {}
    ~MatrixCamera() {
        if (shader_ != 0) shaders_.removeShader(shader_);
        if (class_ != 0) shaders_.removeClass(class_);
        if (boundShader_ != 0)
            shaders_.bindShader(boundShader_);
        else
            shaders_.bindClass(boundClass_);
    }
    MatrixCamera(const MatrixCamera&) = delete;
    MatrixCamera& operator=(const MatrixCamera&) = delete;

    uint32_t make() {
        class_ = shaders_.addClass(findBuiltinClass("Matrix"));
        return shader_ = shaders_.newShader();
    }
    void set(const char* parameter, const glm::dmat4& matrix) {
        const glm::mat4 values(matrix);
        shaders_.setParameter(shaders_.parameterHandle(parameter),
                              {RTS_FLOAT16, std::as_bytes(std::span(&values, 1))});
    }

private:
    ShaderCatalog& shaders_;
    uint32_t boundClass_, boundShader_;
    uint32_t class_ = 0, shader_ = 0;
};

void useCamera(Recorder& recorder, const glm::dmat4& projection, const glm::dmat4& modelView) {
    recorder.requireOutsideObject();
    glm::dmat4 inverse;
    if (!invert(projection * modelView, inverse)) refuse("the matrices have no inverse");
    MatrixCamera camera(recorder.shaders());
    const uint32_t shader = camera.make();
    camera.set("projection", projection);
    camera.set("modelView", modelView);
    recorder.useUnique(UniqueShader::Camera, shader);
}

} // namespace

RTAPI void RTAPIENTRY rtuCameraFromMatrices(const RTdouble projection[16],
                                            const RTdouble modelview[16]) {
    recorded(__func__, [p = numbersAt<16>(projection), m = numbersAt<16>(modelview)](Context& c) {
        const glm::dmat4 toClip = matrixOf(p, "projection");
        useCamera(c.recorder(), toClip, matrixOf(m, "modelview"));
    });
}

// The screen in coordinates of its own: from the eye, in half widths, half heights and the way to
// its middle. Clip coordinates are these, so any parallelogram will do (Kooima, Generalized
// Perspective Projection, 2009, has the rectangular case).
RTAPI void RTAPIENTRY rtuCameraFromWall(const RTdouble lowerLeft[3], const RTdouble lowerRight[3],
                                        const RTdouble upperLeft[3], const RTdouble eye[3]) {
    recorded(__func__, [left = numbersAt<3>(lowerLeft), beside = numbersAt<3>(lowerRight),
                        above = numbersAt<3>(upperLeft), e = numbersAt<3>(eye)](Context& c) {
        const glm::dvec3 corner = pointOf(left, "lowerLeft");
        const glm::dvec3 right = (pointOf(beside, "lowerRight") - corner) * 0.5;
        const glm::dvec3 up = (pointOf(above, "upperLeft") - corner) * 0.5;
        const glm::dvec3 centre = pointOf(e, "eye");
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
        useCamera(c.recorder(), projection, toScreen);
    });
}

RTAPI void RTAPIENTRY rtuCameraFromFov(const RTdouble pose[16], RTdouble left, RTdouble right,
                                       RTdouble up, RTdouble down) {
    recorded(__func__, [=, numbers = numbersAt<16>(pose)](Context& c) {
        const glm::dmat4 toWorld = matrixOf(numbers, "pose");
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
        useCamera(c.recorder(), projection, modelView);
    });
}
