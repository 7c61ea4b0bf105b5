// SPDX-License-Identifier: MIT
// Fog (OpenGL 1.5, section 3.10).
#include <glm/common.hpp>

#include "compat/openrt/call_values.h"
#include "compat/openrt/fixed_tokens.h"
#include "openrt/rt_fixed.h"

using namespace smart;
using namespace smart::compat;

namespace {

int fogValues(RTenum pname) {
    switch (pname) {
    case RT_FOG_COLOR: return 4;
    case RT_FOG_MODE:
    case RT_FOG_DENSITY:
    case RT_FOG_START:
    case RT_FOG_END:
    case RT_FOG_INDEX:
    case RT_FOG_COORDINATE_SOURCE: return 1;
    default: return 0;
    }
}

void setFog(const char* function, RTenum pname, const CallValues& values) noexcept {
    recorded(function, [=](Context& c) {
        FixedStateRecorder& fixed = c.recorder().fixedState();
        FixedFog fog = fixed.state().fog;
        switch (pname) {
        case RT_FOG_MODE: fog.mode = fogModeOf(values.token()); break;
        case RT_FOG_DENSITY:
            fog.density = values.number();
            if (!(fog.density >= 0)) throwError(ErrorCode::InvalidValue, "a density is below 0");
            break;
        case RT_FOG_START: fog.start = values.number(); break;
        case RT_FOG_END: fog.end = values.number(); break;
        case RT_FOG_COLOR:
            fog.color = glm::clamp(values.color(), glm::vec4(0.0f), glm::vec4(1.0f));
            break;
        case RT_FOG_INDEX:
            throwError(ErrorCode::InvalidOperation, "there are no colour indices");
        case RT_FOG_COORDINATE_SOURCE: {
            const RTenum source = values.token();
            if (source != RT_FOG_COORDINATE && source != RT_FRAGMENT_DEPTH)
                throwError(ErrorCode::InvalidEnum, "unknown source of fog coordinates");
            fog.fromCoordinate = source == RT_FOG_COORDINATE;
            break;
        }
        default: throwError(ErrorCode::InvalidEnum, "unknown property of fog");
        }
        fixed.change().fog = fog;
    });
}

} // namespace

RTAPI void RTAPIENTRY rtFogf(RTenum pname, RTfloat param) {
    setFog(__func__, pname, CallValues::one(param));
}
RTAPI void RTAPIENTRY rtFogi(RTenum pname, RTint param) {
    setFog(__func__, pname, CallValues::one(param));
}
RTAPI void RTAPIENTRY rtFogfv(RTenum pname, const RTfloat* params) {
    setFog(__func__, pname, CallValues::array(params, fogValues(pname)));
}
RTAPI void RTAPIENTRY rtFogiv(RTenum pname, const RTint* params) {
    setFog(__func__, pname, CallValues::array(params, fogValues(pname)));
}
