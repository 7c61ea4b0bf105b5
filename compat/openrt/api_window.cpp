// SPDX-License-Identifier: MIT
// The window's buffers: what is cleared, what may be drawn.
#include <algorithm>

#include "compat/openrt/guard.h"
#include "compat/openrt/tokens.h"
#include "openrt/rt_window.h"

using namespace smart;
using namespace smart::compat;

namespace {

double clamped(RTclampd value) {
    return value > 0.0 ? std::min(value, 1.0) : 0.0;
}

/// Throws unless it names the one buffer that there is.
void checkBuffer(RTenum mode) {
    switch (mode) {
    case RT_FRONT:
    case RT_BACK:
    case RT_LEFT:
    case RT_FRONT_LEFT:
    case RT_BACK_LEFT: return;
    case RT_RIGHT:
    case RT_FRONT_RIGHT:
    case RT_BACK_RIGHT:
    case RT_AUX0:
    case RT_AUX1:
    case RT_AUX2:
    case RT_AUX3: throwError(ErrorCode::InvalidOperation, "there is no such buffer");
    default: throwError(ErrorCode::InvalidEnum, "unknown buffer");
    }
}

/// Of the frame, which must not change inside objects.
FrameSettings& frame(Context& c) {
    c.recorder().requireOutsideObject();
    return c.recorder().frameSettings();
}

} // namespace

RTAPI void RTAPIENTRY rtClear(RTbitfield mask) {
    recorded(__func__, [=](Context& c) {
        frame(c);
        constexpr RTbitfield kKnown = RT_COLOR_BUFFER_BIT | RT_DEPTH_BUFFER_BIT |
                                      RT_STENCIL_BUFFER_BIT | RT_ACCUM_BUFFER_BIT;
        if (mask & ~kKnown) throwError(ErrorCode::InvalidValue, "unknown buffers");
        c.recorder().clear((mask & RT_COLOR_BUFFER_BIT) != 0, (mask & RT_DEPTH_BUFFER_BIT) != 0);
    });
}

RTAPI void RTAPIENTRY rtClearDepth(RTclampd depth) {
    recorded(__func__, [=](Context& c) { frame(c).clearDepth = clamped(depth); });
}

RTAPI void RTAPIENTRY rtScissor(RTint x, RTint y, RTsizei width, RTsizei height) {
    recorded(__func__, [=](Context& c) {
        FrameSettings& settings = frame(c);
        if (width < 0 || height < 0)
            throwError(ErrorCode::InvalidValue, "the scissor's size is negative");
        settings.scissor = Viewport{x, y, uint32_t(width), uint32_t(height)};
    });
}

RTAPI void RTAPIENTRY rtDepthRange(RTclampd near_val, RTclampd far_val) {
    recorded(__func__, [=](Context& c) {
        FrameSettings& settings = frame(c);
        settings.depthNear = clamped(near_val);
        settings.depthFar = clamped(far_val);
    });
}

RTAPI void RTAPIENTRY rtDrawBuffer(RTenum mode) {
    recorded(__func__, [=](Context& c) {
        FrameSettings& settings = frame(c);
        if (mode != RT_NONE && mode != RT_FRONT_AND_BACK) checkBuffer(mode);
        settings.drawsColor = mode != RT_NONE;
        settings.drawBuffer = mode;
    });
}

RTAPI void RTAPIENTRY rtReadBuffer(RTenum mode) {
    recorded(__func__, [=](Context& c) {
        FrameSettings& settings = frame(c);
        checkBuffer(mode);
        settings.readBuffer = mode;
    });
}
