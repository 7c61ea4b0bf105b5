// SPDX-License-Identifier: MIT
#include <algorithm>

#include "compat/openrt/capabilities.h"
#include "compat/openrt/guard.h"
#include "compat/openrt/state_values.h"
#include "openrt/rt_core.h"
#include "openrt/rt_state.h"

using namespace smart;
using namespace smart::compat;

namespace {

/// A hint that no picture depends on; nullptr: none of them.
HintMode* idleHint(IdleHints& hints, RTenum target) {
    switch (target) {
    case RT_PERSPECTIVE_CORRECTION_HINT: return &hints.perspectiveCorrection;
    case RT_POINT_SMOOTH_HINT: return &hints.pointSmooth;
    case RT_LINE_SMOOTH_HINT: return &hints.lineSmooth;
    case RT_POLYGON_SMOOTH_HINT: return &hints.polygonSmooth;
    case RT_FOG_HINT: return &hints.fog;
    case RT_GENERATE_MIPMAP_HINT: return &hints.generateMipmap;
    case RT_TEXTURE_COMPRESSION_HINT: return &hints.textureCompression;
    default: return nullptr;
    }
}

void setHint(Context& c, RTenum target, HintMode mode) {
    if (HintMode* const hint = idleHint(c.recorder().idleState().hints, target)) {
        *hint = mode;
        return;
    }
    if (target != RT_PRECISION_HINT) throwError(ErrorCode::InvalidEnum, "no such hint");
    c.recorder().frameSettings().precision = mode == HintMode::Fastest  ? Precision::Fast
                                             : mode == HintMode::Nicest ? Precision::Precise
                                                                        : Precision::Watertight;
}

HintMode hintModeOf(RTenum mode) {
    switch (mode) {
    case RT_FASTEST: return HintMode::Fastest;
    case RT_DONT_CARE: return HintMode::DontCare;
    case RT_NICEST: return HintMode::Nicest;
    default:
        throwError(ErrorCode::InvalidEnum, "a hint is RT_FASTEST, RT_DONT_CARE or RT_NICEST");
    }
}

void enable(const char* function, RTenum cap, bool on) noexcept {
    recorded(function, [=](Context& c) {
        c.recorder().requireOutsideObject();
        setCapability(c, cap, on);
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
    recorded(__func__, [=](Context& c) {
        c.recorder().requireOutsideObject();
        if (width < 0 || height < 0)
            throwError(ErrorCode::InvalidValue, "a viewport's size is negative");
        c.recorder().frameSettings().viewport =
            Viewport{x, y, std::min(uint32_t(width), kMaxViewport),
                     std::min(uint32_t(height), kMaxViewport)};
    });
}

RTAPI void RTAPIENTRY rtClearColor(RTclampf red, RTclampf green, RTclampf blue, RTclampf alpha) {
    recorded(__func__, [=](Context& c) {
        c.recorder().requireOutsideObject();
        c.recorder().frameSettings().clearColor = {clamped(red), clamped(green), clamped(blue),
                                                   clamped(alpha)};
    });
}

RTAPI void RTAPIENTRY rtEnable(RTenum cap) {
    enable(__func__, cap, true);
}
RTAPI void RTAPIENTRY rtDisable(RTenum cap) {
    enable(__func__, cap, false);
}
RTAPI RTboolean RTAPIENTRY rtIsEnabled(RTenum cap) {
    return guardedOr<RTboolean>(RT_FALSE, __func__, [&](Context& c) -> RTboolean {
        c.recorder().requireOutsidePrimitive();
        return isEnabled(c, cap) ? RT_TRUE : RT_FALSE;
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

RTAPI void RTAPIENTRY rtHint(RTenum target, RTenum mode) {
    recorded(__func__, [=](Context& c) {
        c.recorder().requireOutsideObject();
        setHint(c, target, hintModeOf(mode));
    });
}
