/* SPDX-License-Identifier: MIT */
#include "misuse.h"
#include "openrt/rts.h"

static RTuint classNull(void) { return rtGenNewShaderClass(NULL, NULL); }
static RTuint classUnknown(void) { return rtGenNewShaderClass("NoSuchShader", NULL); }
static RTuint classFromFile(void) { return rtGenNewShaderClass("DiffuseShader", "./wood.so"); }
static RTuint classAgain(void) { return rtGenNewShaderClass("DiffuseShader", NULL); }
static RTuint registerNull(void) { return rtRegisterShaderClass(NULL); }
static RTuint registerEmpty(void) {
    static const RTshaderclass empty;
    return rtRegisterShaderClass(&empty);
}
static RTuint registerNameless(void) {
    RTshaderclass nameless = {0};
    nameless.structSize = sizeof nameless;
    nameless.interfaceVersion = RTS_INTERFACE_VERSION;
    nameless.kind = RT_SURFACE_SHADER;
    return rtRegisterShaderClass(&nameless);
}
static RTuint bindClassUnknown(void) { return rtBindShaderClass(4711), 0u; }
static RTuint bindClass(void) { return rtBindShaderClass(ids.surfaceClass), 0u; }
static RTuint removeClassUnknown(void) { return rtRemoveShaderClass(4711), 0u; }
static RTuint removeClassZero(void) { return rtRemoveShaderClass(0), 0u; }
static RTuint newShader(void) { return rtGenNewShader(); }
static RTuint newShaderWithoutClass(void) {
    RTint shader, shaderClass;
    RTuint result;
    rtGetIntegerv(RT_SHADER_BINDING, &shader);
    rtGetIntegerv(RT_SHADER_CLASS_BINDING, &shaderClass);
    rtBindShaderClass(0);
    result = rtGenNewShader();
    rtBindShaderClass((RTuint)shaderClass);
    rtBindShader((RTuint)shader);
    return result;
}
static RTuint bindUnknown(void) { return rtBindShader(4711), 0u; }
static RTuint bind(void) { return rtBindShader(ids.surface), 0u; }
static RTuint removeUnknown(void) { return rtRemoveShader(4711), 0u; }
static RTuint removeZero(void) { return rtRemoveShader(0), 0u; }

static RTuint handleWithoutClass(void) { return rtParameterHandle("color"); }
static RTuint handleNull(void) { return rtParameterHandle(NULL); }
/* The calls below bind the surface, and shader 0 again. */
static RTuint bound(void) { return rtBindShader(ids.surface), 0u; }
static RTuint unbound(void) { return rtBindShader(0), 0u; }
static RTuint handleUnknown(void) {
    RTuint handle;
    bound();
    handle = rtParameterHandle("colour");
    unbound();
    return handle;
}
static RTuint parameterUnbound(void) { return rtParameter3f(ids.colorHandle, 1, 1, 1), 0u; }
static RTuint parameterUnknown(void) { return rtParameter3f(4711, 1, 1, 1), 0u; }
static RTuint parameterZero(void) { return rtParameter3f(0, 1, 1, 1), 0u; }
static RTuint parameterOfOtherClass(void) {
    bound();
    rtParameter3f(ids.lightHandle, 1, 1, 1);
    return unbound();
}
static RTuint parameterInt(void) {
    bound();
    rtParameter3i(ids.colorHandle, 1, 1, 1);
    return unbound();
}
static RTuint parameterShort(void) {
    bound();
    rtParameter2f(ids.colorHandle, 1, 1);
    return unbound();
}
static RTuint parameterLong(void) {
    bound();
    rtParameter4f(ids.colorHandle, 1, 1, 1, 1);
    return unbound();
}
static RTuint parameterRaw(void) {
    static const RTfloat black[3] = {0, 0, 0};
    bound();
    rtParameterRaw(ids.colorHandle, black, sizeof black);
    return unbound();
}
static RTuint parameterString(void) {
    bound();
    rtParameterString(ids.colorHandle, "red");
    return unbound();
}
static RTuint parameterNull(void) {
    bound();
    rtParameter3fv(ids.colorHandle, NULL);
    return unbound();
}
static RTuint rawNull(void) { return rtParameterRaw(ids.colorHandle, NULL, 12), 0u; }
static RTuint stringNull(void) { return rtParameterString(ids.colorHandle, NULL), 0u; }

int main(void) {
    static const Misuse misuses[] = {
        MISUSE_ID(classNull, OUTSIDE, RT_INVALID_VALUE),
        MISUSE_ID(classUnknown, OUTSIDE, RT_INVALID_VALUE),
        MISUSE_ID(classFromFile, OUTSIDE, RT_INVALID_VALUE),
        MISUSE_ID(classAgain, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE_ID(registerNull, OUTSIDE, RT_INVALID_VALUE),
        MISUSE_ID(registerEmpty, OUTSIDE, RT_INVALID_VALUE),
        MISUSE_ID(registerNameless, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(bindClassUnknown, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(bindClass, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(removeClassUnknown, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(removeClassZero, OUTSIDE, RT_INVALID_VALUE),
        MISUSE_ID(newShader, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE_ID(newShaderWithoutClass, OUTSIDE, RT_INVALID_OPERATION),
        MISUSE(bindUnknown, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(bindUnknown, IN_OBJECT, RT_INVALID_VALUE),
        MISUSE(bind, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(removeUnknown, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(removeZero, OUTSIDE, RT_INVALID_VALUE),
        MISUSE_ID(handleWithoutClass, OUTSIDE, RT_INVALID_OPERATION),
        MISUSE_ID(handleNull, OUTSIDE, RT_INVALID_VALUE),
        MISUSE_ID(handleNull, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE_ID(handleUnknown, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(parameterUnbound, OUTSIDE, RT_INVALID_OPERATION),
        MISUSE(parameterUnbound, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(parameterUnknown, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(parameterZero, IN_PRIMITIVE, RT_INVALID_VALUE),
        MISUSE(parameterOfOtherClass, OUTSIDE, RT_INVALID_OPERATION),
        MISUSE(parameterInt, OUTSIDE, RT_INVALID_OPERATION),
        MISUSE(parameterShort, OUTSIDE, RT_INVALID_OPERATION),
        MISUSE(parameterLong, OUTSIDE, RT_INVALID_OPERATION),
        MISUSE(parameterRaw, OUTSIDE, RT_INVALID_OPERATION),
        MISUSE(parameterString, OUTSIDE, RT_INVALID_OPERATION),
        MISUSE(parameterNull, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(rawNull, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(stringNull, IN_PRIMITIVE, RT_INVALID_VALUE),
    };
    return CHECK_MISUSES(misuses);
}
