// SPDX-License-Identifier: MIT
#include "compat/openrt/guard.h"
#include "compat/openrt/tokens.h"
#include "openrt/rt_objects.h"

using namespace smart;
using namespace smart::compat;

namespace {

/// An object is no part of a display list.
void requireNoList(Context& c) {
    if (c.lists().recording())
        throwError(ErrorCode::InvalidOperation, "not legal while a display list is compiled");
}

} // namespace

RTAPI void RTAPIENTRY rtBegin(RTenum mode) {
    const bool filled = mode >= RT_TRIANGLES && mode <= RT_POLYGON;
    recordedAs(filled ? ListOp::BeginFilled : ListOp::BeginOther, __func__, 0, [=](Context& c) {
        c.recorder().requireOutsidePrimitive();
        c.recorder().begin(primitiveOf(mode));
    });
}
RTAPI void RTAPIENTRY rtEnd(void) {
    recordedAs(ListOp::End, __func__, 0, [](Context& c) { c.recorder().end(); });
}

RTAPI RTuint RTAPIENTRY rtNewObject(RTenum mode) {
    return guardedOr<RTuint>(RT_INVALID, __func__, [&](Context& c) {
        c.recorder().requireOutsideObject();
        requireNoList(c);
        if (mode != RT_DEFINE && mode != RT_DEFINE_AND_INSTANTIATE)
            throwError(ErrorCode::InvalidEnum, "unknown object mode");
        return c.recorder().newObject(mode == RT_DEFINE ? ObjectMode::Define
                                                        : ObjectMode::DefineAndInstantiate);
    });
}
RTAPI void RTAPIENTRY rtEndObject(void) {
    guarded(__func__, [](Context& c) { c.recorder().endObject(); });
}
RTAPI void RTAPIENTRY rtReplaceObject(RTuint object) {
    guarded(__func__, [&](Context& c) {
        requireNoList(c);
        c.recorder().replaceObject(object);
    });
}
RTAPI void RTAPIENTRY rtUpdateObject(RTuint object, RTuint first, RTsizei count,
                                     const RTfloat* xyz) {
    guarded(__func__, [&](Context& c) {
        c.recorder().requireVertices(object, first, 0);
        if (count < 0) throwError(ErrorCode::InvalidValue, "count is negative");
        if (count > 0) requirePointer(xyz, "xyz");
        c.recorder().updateObject(object, first, uint32_t(count), xyz);
    });
}
RTAPI void RTAPIENTRY rtRemoveObject(RTuint object) {
    guarded(__func__, [&](Context& c) { c.recorder().removeObject(object); });
}

RTAPI void RTAPIENTRY rtInstantiateObject(RTuint object) {
    recorded(__func__, [=](Context& c) { c.recorder().instantiate(object); });
}
RTAPI void RTAPIENTRY rtInstantiateObjectShader(RTuint object, RTuint shader) {
    recorded(__func__, [=](Context& c) { c.recorder().instantiateWithShader(object, shader); });
}
RTAPI void RTAPIENTRY rtInstantiateObjectShaders(RTuint object, RTsizei n, const RTuint* shaders) {
    guarded(__func__, [&](Context& c) {
        if (n < 0) throwError(ErrorCode::InvalidValue, "n is negative");
        if (n > 0) requirePointer(shaders, "shaders");
        ListRecording* const list = c.lists().recording();
        // Before they are read: there may be no memory behind a number that is too large. A list may
        // be called when there is the object.
        if ((!list || c.recorder().hasObject(object)) &&
            std::size_t(n) > c.recorder().objectShaders(object).size())
            throwError(ErrorCode::InvalidValue, "the object has fewer shaders");
        const auto body = [object, kept = std::vector(shaders, shaders + n)](Context& context) {
            context.recorder().instantiateWithShaders(object, kept);
        };
        if (list && !keepIn(*list, ListOp::Call, "rtInstantiateObjectShaders", 0, body)) return;
        body(c);
    });
}

RTAPI void RTAPIENTRY rtObjectHint(RTenum hint, RTenum value) {
    guarded(__func__, [&](Context& c) {
        BuildHints& hints = c.recorder().buildHints();
        if (hint == RT_BUILD_QUALITY && value == RT_NICEST)
            hints.quality = BuildQuality::Nicest;
        else if (hint == RT_BUILD_QUALITY && value == RT_DONT_CARE)
            hints.quality = BuildQuality::DontCare;
        else if (hint == RT_BUILD_QUALITY && value == RT_FASTEST)
            hints.quality = BuildQuality::Fastest;
        else if (hint == RT_BUILD_QUALITY && value == RT_KD_TREE)
            hints.quality = BuildQuality::KdTree;
        else if (hint == RT_LAZY_BUILD && (value == RT_TRUE || value == RT_FALSE))
            hints.lazy = value == RT_TRUE;
        else
            throwError(ErrorCode::InvalidEnum, "no such hint, or not a value of it");
    });
}

RTAPI void RTAPIENTRY rtGetObjectiv(RTuint object, RTenum pname, RTint* params) {
    guarded(__func__, [&](Context& c) {
        const std::vector<UsedShader>& shaders = c.recorder().objectShaders(object);
        if (pname != RT_OBJECT_SHADERS && pname != RT_OBJECT_SHADER_COUNT)
            throwError(ErrorCode::InvalidEnum, "objects have no such value");
        requirePointer(params, "params");
        if (pname == RT_OBJECT_SHADER_COUNT)
            *params = RTint(shaders.size());
        else
            for (const UsedShader& shader : shaders) *params++ = RTint(shader.id);
    });
}
