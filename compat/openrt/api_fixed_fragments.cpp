// SPDX-License-Identifier: MIT
// What becomes of fragments (OpenGL 1.5, chapter 4): tests, blending, masks, clear values.
#include <algorithm>

#include "compat/openrt/call_values.h"
#include "compat/openrt/fixed_tokens.h"
#include "compat/openrt/guard.h"
#include "openrt/rt_fixed.h"

using namespace smart;
using namespace smart::compat;

namespace {

float clamped(RTfloat value, float low = 0.0f) {
    requireNumber(value);
    return std::clamp(value, low, 1.0f);
}

void setBlendFunction(const char* function, RTenum sourceRgb, RTenum destinationRgb,
                      RTenum sourceAlpha, RTenum destinationAlpha) noexcept {
    recorded(function, [=](Context& c) {
        FixedStateRecorder& fixed = c.recorder().fixedState();
        FixedFragmentOps ops = fixed.state().ops;
        ops.sourceRgb = sourceFactorOf(sourceRgb);
        ops.destinationRgb = destinationFactorOf(destinationRgb);
        ops.sourceAlpha = sourceFactorOf(sourceAlpha);
        ops.destinationAlpha = destinationFactorOf(destinationAlpha);
        fixed.change().ops = ops;
    });
}

StencilOperation stencilOperationOf(RTenum operation) {
    switch (operation) {
    case RT_KEEP: return StencilOperation::Keep;
    case RT_ZERO: return StencilOperation::Zero;
    case RT_REPLACE: return StencilOperation::Replace;
    case RT_INCR: return StencilOperation::Increment;
    case RT_DECR: return StencilOperation::Decrement;
    case RT_INVERT: return StencilOperation::Invert;
    case RT_INCR_WRAP: return StencilOperation::IncrementWrap;
    case RT_DECR_WRAP: return StencilOperation::DecrementWrap;
    default: throwError(ErrorCode::InvalidEnum, "unknown stencil operation");
    }
}

} // namespace

RTAPI void RTAPIENTRY rtAlphaFunc(RTenum func, RTclampf ref) {
    recorded(__func__, [=](Context& c) {
        FixedStateRecorder& fixed = c.recorder().fixedState();
        const CompareFunction comparison = compareFunctionOf(func);
        const float reference = clamped(ref);
        FixedFragmentOps& ops = fixed.change().ops;
        ops.alphaFunction = comparison;
        ops.alphaReference = reference;
    });
}

RTAPI void RTAPIENTRY rtBlendFunc(RTenum sfactor, RTenum dfactor) {
    setBlendFunction(__func__, sfactor, dfactor, sfactor, dfactor);
}
RTAPI void RTAPIENTRY rtBlendFuncSeparate(RTenum sfactorRGB, RTenum dfactorRGB,
                                          RTenum sfactorAlpha, RTenum dfactorAlpha) {
    setBlendFunction(__func__, sfactorRGB, dfactorRGB, sfactorAlpha, dfactorAlpha);
}

RTAPI void RTAPIENTRY rtBlendEquation(RTenum mode) {
    recorded(__func__, [=](Context& c) {
        FixedStateRecorder& fixed = c.recorder().fixedState();
        const BlendEquation equation = blendEquationOf(mode);
        fixed.change().ops.blendEquation = equation;
    });
}

RTAPI void RTAPIENTRY rtBlendColor(RTclampf red, RTclampf green, RTclampf blue, RTclampf alpha) {
    recorded(__func__, [=](Context& c) {
        FixedStateRecorder& fixed = c.recorder().fixedState();
        const glm::vec4 color(clamped(red), clamped(green), clamped(blue), clamped(alpha));
        fixed.change().ops.blendColor = color;
    });
}

RTAPI void RTAPIENTRY rtLogicOp(RTenum opcode) {
    recorded(__func__, [=](Context& c) {
        FixedStateRecorder& fixed = c.recorder().fixedState();
        if (opcode < RT_CLEAR || opcode > RT_SET)
            throwError(ErrorCode::InvalidEnum, "unknown logical operation");
        fixed.change().ops.logicOp = uint8_t(opcode & 15);
    });
}

RTAPI void RTAPIENTRY rtDepthFunc(RTenum func) {
    recorded(__func__, [=](Context& c) {
        FixedStateRecorder& fixed = c.recorder().fixedState();
        const CompareFunction comparison = compareFunctionOf(func);
        fixed.change().ops.depthFunction = comparison;
    });
}

RTAPI void RTAPIENTRY rtDepthMask(RTboolean flag) {
    recorded(__func__, [=](Context& c) {
        c.recorder().fixedState().change().ops.depthMask = flag != RT_FALSE;
    });
}

RTAPI void RTAPIENTRY rtColorMask(RTboolean red, RTboolean green, RTboolean blue,
                                  RTboolean alpha) {
    recorded(__func__, [=](Context& c) {
        bool(&mask)[4] = c.recorder().fixedState().change().ops.colorMask;
        mask[0] = red != RT_FALSE;
        mask[1] = green != RT_FALSE;
        mask[2] = blue != RT_FALSE;
        mask[3] = alpha != RT_FALSE;
    });
}

RTAPI void RTAPIENTRY rtStencilFunc(RTenum func, RTint, RTuint mask) {
    // The reference value is clamped to what a buffer of no bits can hold.
    recorded(__func__, [=](Context& c) {
        IdleStencil& stencil = c.recorder().idleState().stencil;
        stencil.function = compareFunctionOf(func);
        stencil.valueMask = mask;
    });
}

RTAPI void RTAPIENTRY rtStencilOp(RTenum fail, RTenum zfail, RTenum zpass) {
    recorded(__func__, [=](Context& c) {
        IdleStencil& stencil = c.recorder().idleState().stencil;
        const StencilOperation operations[] = {
            stencilOperationOf(fail), stencilOperationOf(zfail), stencilOperationOf(zpass)};
        stencil.fail = operations[0];
        stencil.depthFail = operations[1];
        stencil.depthPass = operations[2];
    });
}

RTAPI void RTAPIENTRY rtStencilMask(RTuint mask) {
    recorded(__func__, [=](Context& c) { c.recorder().idleState().stencil.writeMask = mask; });
}

RTAPI void RTAPIENTRY rtClearStencil(RTint s) {
    recorded(__func__, [=](Context& c) { c.recorder().idleState().stencil.clear = s; });
}

RTAPI void RTAPIENTRY rtClearAccum(RTfloat red, RTfloat green, RTfloat blue, RTfloat alpha) {
    recorded(__func__, [=](Context& c) {
        IdleState& idle = c.recorder().idleState();
        idle.accumClear = {clamped(red, -1), clamped(green, -1), clamped(blue, -1),
                           clamped(alpha, -1)};
    });
}

RTAPI void RTAPIENTRY rtSampleCoverage(RTclampf value, RTboolean invert) {
    recorded(__func__, [=](Context& c) {
        IdleState& idle = c.recorder().idleState();
        idle.sampleCoverage = clamped(value);
        idle.sampleCoverageInvert = invert != RT_FALSE;
    });
}
