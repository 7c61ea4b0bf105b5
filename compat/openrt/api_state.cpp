// SPDX-License-Identifier: MIT
#include <algorithm>

#include "compat/openrt/guard.h"
#include "compat/openrt/state_values.h"
#include "compat/openrt/tokens.h"
#include "openrt/rt_state.h"

using namespace smart;
using namespace smart::compat;

namespace {

/// The switch itself.
bool& capability(FrameSettings& settings, RTenum cap) {
    switch (cap) {
    case RT_FRAMEBUFFER_SRGB: return settings.target.srgb;
    case RT_MULTISAMPLE: return settings.multisample;
    default:
        if (isCapability(cap))
            throwError(ErrorCode::InvalidOperation, "this switch is not part of this release");
        throwError(ErrorCode::InvalidEnum, "no such switch");
    }
}

void setCapability(const char* function, RTenum cap, bool on) noexcept {
    guarded(function, [&](Context& c) {
        c.recorder().requireOutsideObject();
        capability(c.recorder().frameSettings(), cap) = on;
    });
}

float clamped(RTclampf value) {
    return value > 0 ? std::min(value, 1.0f) : 0.0f;
}

template <class T>
void get(const char* function, RTenum pname, T* params) noexcept {
    guarded(function, [&](Context& c) {
        const StateValue value = stateValue(c, pname);
        requirePointer(params, "params");
        for (int i = 0; i < value.count; ++i) params[i] = value.as<T>(i);
    });
}

} // namespace

RTAPI void RTAPIENTRY rtViewport(RTint x, RTint y, RTsizei width, RTsizei height) {
    guarded(__func__, [&](Context& c) {
        c.recorder().requireOutsideObject();
        if (width < 0 || height < 0)
            throwError(ErrorCode::InvalidValue, "a viewport's size is negative");
        c.recorder().frameSettings().viewport =
            Viewport{x, y, std::min(uint32_t(width), kMaxViewport),
                     std::min(uint32_t(height), kMaxViewport)};
    });
}

RTAPI void RTAPIENTRY rtClearColor(RTclampf red, RTclampf green, RTclampf blue, RTclampf alpha) {
    guarded(__func__, [&](Context& c) {
        c.recorder().requireOutsideObject();
        c.recorder().frameSettings().clearColor = {clamped(red), clamped(green), clamped(blue),
                                                   clamped(alpha)};
    });
}

RTAPI void RTAPIENTRY rtEnable(RTenum cap) {
    setCapability(__func__, cap, true);
}
RTAPI void RTAPIENTRY rtDisable(RTenum cap) {
    setCapability(__func__, cap, false);
}
RTAPI RTboolean RTAPIENTRY rtIsEnabled(RTenum cap) {
    return guardedOr<RTboolean>(RT_FALSE, __func__, [&](Context& c) -> RTboolean {
        return capability(c.recorder().frameSettings(), cap) ? RT_TRUE : RT_FALSE;
    });
}

RTAPI void RTAPIENTRY rtGetBooleanv(RTenum pname, RTboolean* params) {
    get(__func__, pname, params);
}
RTAPI void RTAPIENTRY rtGetIntegerv(RTenum pname, RTint* params) {
    get(__func__, pname, params);
}
RTAPI void RTAPIENTRY rtGetInteger64v(RTenum pname, RTint64* params) {
    get(__func__, pname, params);
}
RTAPI void RTAPIENTRY rtGetFloatv(RTenum pname, RTfloat* params) {
    get(__func__, pname, params);
}
RTAPI void RTAPIENTRY rtGetDoublev(RTenum pname, RTdouble* params) {
    get(__func__, pname, params);
}
