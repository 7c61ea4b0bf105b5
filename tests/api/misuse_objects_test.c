/* SPDX-License-Identifier: MIT */
#include "misuse.h"

static RTuint newObject(void) { return rtNewObject(RT_DEFINE); }
static RTuint newObjectUnknown(void) { return rtNewObject(0x202); }
static RTuint endObject(void) { return rtEndObject(), 0u; }
static RTuint instantiate(void) { return rtInstantiateObject(ids.object), 0u; }
static RTuint instantiateUnknown(void) { return rtInstantiateObject(4711), 0u; }
static RTuint instantiateZero(void) { return rtInstantiateObject(0), 0u; }
static RTuint instantiateOpen(void) { return rtInstantiateObject(ids.openObject), 0u; }
static RTuint instantiateProjective(void) {
    rtPushMatrix();
    rtFrustum(-1, 1, -1, 1, 1, 10);
    rtInstantiateObject(ids.object);
    rtPopMatrix();
    return 0;
}
static RTuint newObjectProjective(void) {
    RTuint object;
    rtPushMatrix();
    rtFrustum(-1, 1, -1, 1, 1, 10);
    object = rtNewObject(RT_DEFINE_AND_INSTANTIATE);
    rtPopMatrix();
    return object;
}
static RTuint removeObject(void) { return rtRemoveObject(ids.object), 0u; }
static RTuint removeUnknown(void) { return rtRemoveObject(4711), 0u; }
static RTuint removeZero(void) { return rtRemoveObject(0), 0u; }
static RTuint replace(void) { return rtReplaceObject(ids.object), 0u; }
static RTuint replaceUnknown(void) { return rtReplaceObject(4711), 0u; }
static RTuint update(void) {
    static const RTfloat xyz[3] = {0, 0, 0};
    return rtUpdateObject(ids.object, 0, 1, xyz), 0u;
}
static RTuint updateUnknown(void) {
    static const RTfloat xyz[3] = {0, 0, 0};
    return rtUpdateObject(4711, 0, 1, xyz), 0u;
}
static RTuint updateNull(void) { return rtUpdateObject(ids.object, 0, 1, NULL), 0u; }
static RTuint updateNegative(void) {
    static const RTfloat xyz[3] = {0, 0, 0};
    return rtUpdateObject(ids.object, 0, -1, xyz), 0u;
}
static RTuint updateOutside(void) {
    static const RTfloat xyz[3] = {0, 0, 0};
    return rtUpdateObject(ids.object, 1000, 1, xyz), 0u;
}
static RTuint reshadeUnknownObject(void) {
    return rtInstantiateObjectShader(4711, ids.surface), 0u;
}
static RTuint reshadeUnknownShader(void) { return rtInstantiateObjectShader(ids.object, 4711), 0u; }
static RTuint reshadeByLight(void) { return rtInstantiateObjectShader(ids.object, ids.light), 0u; }
static RTuint reshadeSetTooMany(void) {
    const RTuint shaders[3] = {ids.surface, ids.surface, ids.surface};
    return rtInstantiateObjectShaders(ids.object, 3, shaders), 0u;
}
static RTuint reshadeSetFarTooMany(void) {
    return rtInstantiateObjectShaders(ids.object, 500000000, &ids.surface), 0u;
}
static RTuint reshadeSetNegative(void) {
    return rtInstantiateObjectShaders(ids.object, -1, &ids.surface), 0u;
}
static RTuint reshadeSetNull(void) { return rtInstantiateObjectShaders(ids.object, 1, NULL), 0u; }
static RTuint reshadeSetByLight(void) {
    return rtInstantiateObjectShaders(ids.object, 1, &ids.light), 0u;
}
static RTuint reshadeSetUnknown(void) {
    const RTuint unknown = 4711;
    return rtInstantiateObjectShaders(ids.object, 1, &unknown), 0u;
}
static RTuint hintUnknown(void) { return rtObjectHint(RT_FOG_HINT, RT_NICEST), 0u; }
static RTuint hintValue(void) { return rtObjectHint(RT_BUILD_QUALITY, RT_TRUE), 0u; }
static RTuint hintLazy(void) { return rtObjectHint(RT_LAZY_BUILD, RT_NICEST), 0u; }
static RTuint hint(void) { return rtObjectHint(RT_LAZY_BUILD, RT_TRUE), 0u; }
static RTuint getUnknown(void) {
    RTint value = 7;
    rtGetObjectiv(4711, RT_OBJECT_SHADER_COUNT, &value);
    return value == 7 ? 0 : 1;
}
static RTuint getName(void) {
    RTint value = 7;
    rtGetObjectiv(ids.object, RT_STAT_BYTES, &value);
    return value == 7 ? 0 : 1;
}
static RTuint getNull(void) { return rtGetObjectiv(ids.object, RT_OBJECT_SHADERS, NULL), 0u; }

int main(void) {
    static const Misuse misuses[] = {
        MISUSE_ID(newObject, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE_ID(newObject, IN_OBJECT, RT_INVALID_OPERATION),
        MISUSE_ID(newObjectUnknown, OUTSIDE, RT_INVALID_ENUM),
        MISUSE_ID(newObjectUnknown, IN_OBJECT, RT_INVALID_OPERATION),
        MISUSE_ID(newObjectProjective, OUTSIDE, RT_INVALID_OPERATION),
        MISUSE(endObject, OUTSIDE, RT_INVALID_OPERATION),
        MISUSE(endObject, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(instantiate, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(instantiateUnknown, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(instantiateUnknown, IN_OBJECT, RT_INVALID_VALUE),
        MISUSE(instantiateZero, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(instantiateOpen, IN_OBJECT, RT_INVALID_OPERATION),
        MISUSE(instantiateProjective, OUTSIDE, RT_INVALID_OPERATION),
        MISUSE(removeObject, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(removeObject, IN_OBJECT, RT_INVALID_OPERATION),
        MISUSE(removeUnknown, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(removeZero, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(replace, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(replace, IN_OBJECT, RT_INVALID_OPERATION),
        MISUSE(replaceUnknown, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(update, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(update, IN_OBJECT, RT_INVALID_OPERATION),
        MISUSE(updateUnknown, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(updateNull, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(updateNegative, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(updateOutside, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(reshadeUnknownObject, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(reshadeUnknownShader, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(reshadeByLight, OUTSIDE, RT_INVALID_OPERATION),
        MISUSE(reshadeSetTooMany, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(reshadeSetFarTooMany, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(reshadeSetNegative, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(reshadeSetNull, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(reshadeSetByLight, OUTSIDE, RT_INVALID_OPERATION),
        MISUSE(reshadeSetUnknown, IN_OBJECT, RT_INVALID_VALUE),
        MISUSE(hintUnknown, OUTSIDE, RT_INVALID_ENUM),
        MISUSE(hintValue, OUTSIDE, RT_INVALID_ENUM),
        MISUSE(hintLazy, IN_OBJECT, RT_INVALID_ENUM),
        MISUSE(hint, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(getUnknown, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(getName, OUTSIDE, RT_INVALID_ENUM),
        MISUSE(getNull, OUTSIDE, RT_INVALID_VALUE),
    };
    return CHECK_MISUSES(misuses);
}
