// SPDX-License-Identifier: MIT
// Generated texture coordinates (OpenGL 1.5, section 2.10.4).
#include "compat/openrt/call_values.h"
#include "compat/openrt/fixed_tokens.h"
#include "compat/recorder/transforms.h"
#include "openrt/rt_fixed.h"

using namespace smart;
using namespace smart::compat;

namespace {

int genValues(RTenum pname) {
    return pname == RT_OBJECT_PLANE || pname == RT_EYE_PLANE ? 4 : 1;
}

int coordinateNumber(RTenum coord) {
    if (coord < RT_S || coord > RT_Q)
        throwError(ErrorCode::InvalidEnum, "a coordinate is RT_S, RT_T, RT_R or RT_Q");
    return int(coord - RT_S);
}

TexGenMode modeFor(RTenum coord, RTenum token) {
    const TexGenMode mode = texGenModeOf(token);
    const bool spherical = mode == TexGenMode::SphereMap;
    const bool vectorial = mode == TexGenMode::NormalMap || mode == TexGenMode::ReflectionMap;
    if ((spherical && (coord == RT_R || coord == RT_Q)) || (vectorial && coord == RT_Q))
        throwError(ErrorCode::InvalidEnum, "this coordinate can not be generated this way");
    return mode;
}

void setTexGen(const char* function, RTenum coord, RTenum pname,
               const CallValues& values) noexcept {
    recorded(function, [=](Context& c) {
        FixedStateRecorder& fixed = c.recorder().fixedState();
        const int i = coordinateNumber(coord);
        TexGen generate = fixed.texture().generate[i];
        switch (pname) {
        case RT_TEXTURE_GEN_MODE: generate.mode = modeFor(coord, values.token()); break;
        case RT_OBJECT_PLANE: generate.objectPlane = values.vector(); break;
        case RT_EYE_PLANE: {
            const glm::dvec4 plane = values.doubles();
            glm::dmat4 eyeToObject;
            if (!invert(c.recorder().matrices().modelView(), eyeToObject))
                throwError(ErrorCode::InvalidOperation, "the model-view matrix has no inverse");
            generate.eyePlane = glm::vec4(plane * eyeToObject);
            break;
        }
        default: throwError(ErrorCode::InvalidEnum, "unknown property of a generated coordinate");
        }
        fixed.changeTexture().generate[i] = generate;
    });
}

template <class T>
void getTexGen(const char* function, RTenum coord, RTenum pname, T* params) noexcept {
    guarded(function, [&](Context& c) {
        c.recorder().requireOutsidePrimitive();
        const TexGen& generate =
            c.recorder().fixedTextureNow().generate[coordinateNumber(coord)];
        switch (pname) {
        case RT_TEXTURE_GEN_MODE: return give(StateValue::number(tokenOf(generate.mode)), params);
        case RT_OBJECT_PLANE: return give(StateValue::vector(generate.objectPlane, false), params);
        case RT_EYE_PLANE: return give(StateValue::vector(generate.eyePlane, false), params);
        default: throwError(ErrorCode::InvalidEnum, "unknown property of a generated coordinate");
        }
    });
}

} // namespace

RTAPI void RTAPIENTRY rtTexGend(RTenum coord, RTenum pname, RTdouble param) {
    setTexGen(__func__, coord, pname, CallValues::one(param));
}
RTAPI void RTAPIENTRY rtTexGenf(RTenum coord, RTenum pname, RTfloat param) {
    setTexGen(__func__, coord, pname, CallValues::one(param));
}
RTAPI void RTAPIENTRY rtTexGeni(RTenum coord, RTenum pname, RTint param) {
    setTexGen(__func__, coord, pname, CallValues::one(param));
}
RTAPI void RTAPIENTRY rtTexGendv(RTenum coord, RTenum pname, const RTdouble* params) {
    setTexGen(__func__, coord, pname, CallValues::array(params, genValues(pname)));
}
RTAPI void RTAPIENTRY rtTexGenfv(RTenum coord, RTenum pname, const RTfloat* params) {
    setTexGen(__func__, coord, pname, CallValues::array(params, genValues(pname)));
}
RTAPI void RTAPIENTRY rtTexGeniv(RTenum coord, RTenum pname, const RTint* params) {
    setTexGen(__func__, coord, pname, CallValues::array(params, genValues(pname)));
}
RTAPI void RTAPIENTRY rtGetTexGendv(RTenum coord, RTenum pname, RTdouble* params) {
    getTexGen(__func__, coord, pname, params);
}
RTAPI void RTAPIENTRY rtGetTexGenfv(RTenum coord, RTenum pname, RTfloat* params) {
    getTexGen(__func__, coord, pname, params);
}
RTAPI void RTAPIENTRY rtGetTexGeniv(RTenum coord, RTenum pname, RTint* params) {
    getTexGen(__func__, coord, pname, params);
}
