// SPDX-License-Identifier: MIT
// Selection and feedback, which there are not: as in OpenGL while neither is switched on.
#include "compat/openrt/guard.h"
#include "openrt/enums.h"
#include "openrt/rt_fixed.h"

using namespace smart;
using namespace smart::compat;

namespace {

/// Names and tokens mean nothing outside of selection and feedback.
void withoutEffect(const char* function) noexcept {
    recorded(function, [](Context& c) { c.recorder().requireOutsidePrimitive(); });
}

} // namespace

RTAPI RTint RTAPIENTRY rtRenderMode(RTenum mode) {
    guarded(__func__, [=](Context& c) {
        c.recorder().requireOutsideObject();
        if (mode == RT_RENDER) return;
        if (mode != RT_SELECT && mode != RT_FEEDBACK)
            throwError(ErrorCode::InvalidEnum, "unknown render mode");
        throwError(ErrorCode::InvalidOperation,
                   mode == RT_SELECT
                       ? "there is no selection: rtuPickRay and rtIntersect find what is there"
                       : "there is no feedback");
    });
    return 0;
}

RTAPI void RTAPIENTRY rtInitNames(void) {
    withoutEffect(__func__);
}
RTAPI void RTAPIENTRY rtLoadName(RTuint) {
    withoutEffect(__func__);
}
RTAPI void RTAPIENTRY rtPushName(RTuint) {
    withoutEffect(__func__);
}
RTAPI void RTAPIENTRY rtPopName(void) {
    withoutEffect(__func__);
}
RTAPI void RTAPIENTRY rtPassThrough(RTfloat) {
    withoutEffect(__func__);
}
