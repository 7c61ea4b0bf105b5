/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "misuse.h"

static RTuint enableUnknown(void) { return rtEnable(0xABCD), 0u; }
static RTuint enableStencil(void) { return rtEnable(RT_STENCIL_TEST), 0u; }
static RTuint enable3D(void) { return rtEnable(RT_TEXTURE_3D), 0u; }
static RTuint enableArray(void) { return rtEnable(RT_VERTEX_ARRAY), 0u; }
static RTuint disableUnknown(void) { return rtDisable(0xABCD), 0u; }
static RTuint isEnabledUnknown(void) { return rtIsEnabled(0xABCD); }
static RTuint isEnabled(void) { return rtIsEnabled(RT_FOG); }
static RTuint enable(void) { return rtEnable(RT_MULTISAMPLE), 0u; }
static RTuint viewportNegative(void) { return rtViewport(0, 0, -1, 4), 0u; }
static RTuint viewport(void) { return rtViewport(0, 0, 4, 4), 0u; }
static RTuint clearColor(void) { return rtClearColor(1, 1, 1, 1), 0u; }
static RTuint hintUnknown(void) { return rtHint(0xABCD, RT_NICEST), 0u; }
static RTuint hintMode(void) { return rtHint(RT_PRECISION_HINT, RT_TRUE), 0u; }
static RTuint hintFogMode(void) { return rtHint(RT_FOG_HINT, RT_TRUE), 0u; }
static RTuint hint(void) { return rtHint(RT_PRECISION_HINT, RT_FASTEST), 0u; }
static RTuint stringUnknown(void) { return rtGetString(0xABCD) ? 1u : 0u; }
static RTuint string(void) { return rtGetString(RT_VERSION) ? 1u : 0u; }
static RTuint getUnknown(void) {
    RTint value = 7;
    rtGetIntegerv(0xABCD, &value);
    return value == 7 ? 0 : 1;
}
static RTuint getRefused(void) {
    RTint value = 7;
    rtGetIntegerv(RT_MAP1_GRID_SEGMENTS, &value);
    return value == 7 ? 0 : 1;
}
static RTuint getNull(void) { return rtGetDoublev(RT_CURRENT_COLOR, NULL), 0u; }
static RTuint get(void) {
    RTfloat color[4] = {7, 7, 7, 7};
    rtGetFloatv(RT_CURRENT_COLOR, color);
    return color[0] == 7 ? 0 : 1;
}
static RTuint callback(void) { return rtErrorCallback(NULL, NULL), 0u; }
static RTuint getError(void) { return rtGetError(); }
static RTuint init(void) { return rtInit(NULL, NULL), 0u; }

static RTuint textureTarget(void) { return rtBindTexture(0xABCD, 1), 0u; }
static RTuint texture3D(void) { return rtBindTexture(RT_TEXTURE_3D, 1), 0u; }
static RTuint textureOther(void) { return rtBindTexture(RT_TEXTURE_1D, ids.texture), 0u; }
static RTuint textureId(void) { return rtBindTexture(RT_TEXTURE_2D, 4000000000u), 0u; }
static RTuint bindTexture(void) { return rtBindTexture(RT_TEXTURE_2D, 0), 0u; }
static RTuint genNegative(void) {
    RTuint id;
    return rtGenTextures(-1, &id), 0u;
}
static RTuint genNull(void) { return rtGenTextures(1, NULL), 0u; }
static RTuint deleteNegative(void) { return rtDeleteTextures(-1, &ids.texture), 0u; }
static RTuint isTexture(void) { return rtIsTexture(ids.texture); }
static RTuint image(RTint level, RTint internal, RTsizei width, RTint border, RTenum format,
                    RTenum type) {
    static const RTubyte texels[64];
    rtTexImage2D(RT_TEXTURE_2D, level, internal, width, 1, border, format, type, texels);
    return 0;
}
static RTuint imageLevel(void) { return image(-1, RT_RGB, 1, 0, RT_RGB, RT_UNSIGNED_BYTE); }
static RTuint imageLevels(void) { return image(15, RT_RGB, 1, 0, RT_RGB, RT_UNSIGNED_BYTE); }
static RTuint imageLevelLarge(void) {
    return image(14, RT_RGB, 2, 0, RT_RGB, RT_UNSIGNED_BYTE);
}
static RTuint imageInternal(void) { return image(0, 99, 1, 0, RT_RGB, RT_UNSIGNED_BYTE); }
static RTuint imageDepth(void) {
    return image(0, RT_DEPTH_COMPONENT, 1, 0, RT_RGB, RT_UNSIGNED_BYTE);
}
static RTuint imageNegative(void) { return image(0, RT_RGB, -1, 0, RT_RGB, RT_UNSIGNED_BYTE); }
static RTuint imageLarge(void) { return image(0, RT_RGB, 1 << 20, 0, RT_RGB, RT_UNSIGNED_BYTE); }
static RTuint imageBorder(void) { return image(0, RT_RGB, 3, 1, RT_RGB, RT_UNSIGNED_BYTE); }
static RTuint imageBorderTwo(void) { return image(0, RT_RGB, 3, 2, RT_RGB, RT_UNSIGNED_BYTE); }
static RTuint imageFormat(void) { return image(0, RT_RGB, 1, 0, 0xABCD, RT_UNSIGNED_BYTE); }
static RTuint imageIndex(void) {
    return image(0, RT_RGB, 1, 0, RT_COLOR_INDEX, RT_UNSIGNED_BYTE);
}
static RTuint imageType(void) { return image(0, RT_RGB, 1, 0, RT_RGB, 0xABCD); }
static RTuint imageFields(void) {
    return image(0, RT_RGB, 1, 0, RT_RGBA, RT_UNSIGNED_SHORT_5_6_5);
}
static RTuint part(RTint level, RTint x, RTsizei width, RTenum format, RTenum type,
                   const void *pixels) {
    rtTexSubImage2D(RT_TEXTURE_2D, level, x, 0, width, 1, format, type, pixels);
    return 0;
}
static const RTubyte partTexels[64];
static RTuint partLevel(void) { return part(3, 0, 1, RT_RGB, RT_UNSIGNED_BYTE, partTexels); }
static RTuint partNoLevel(void) { return part(-1, 0, 1, RT_RGB, RT_UNSIGNED_BYTE, partTexels); }
static RTuint partLeft(void) { return part(0, -1, 1, RT_RGB, RT_UNSIGNED_BYTE, partTexels); }
static RTuint partRight(void) {
    return part(0, 2147483647, 1, RT_RGB, RT_UNSIGNED_BYTE, partTexels);
}
static RTuint partNegative(void) { return part(0, 0, -1, RT_RGB, RT_UNSIGNED_BYTE, partTexels); }
static RTuint partFormat(void) { return part(0, 0, 1, 0xABCD, RT_UNSIGNED_BYTE, partTexels); }
static RTuint partType(void) { return part(0, 0, 1, RT_RGB, RT_BITMAP, partTexels); }
static RTuint partNull(void) { return part(0, 0, 1, RT_RGB, RT_UNSIGNED_BYTE, NULL); }
static RTuint parameterName(void) {
    return rtTexParameteri(RT_TEXTURE_2D, 0xABCD, RT_REPEAT), 0u;
}
static RTuint parameterValue(void) {
    return rtTexParameteri(RT_TEXTURE_2D, RT_TEXTURE_WRAP_S, RT_NEAREST), 0u;
}
static RTuint parameterMin(void) {
    return rtTexParameterf(RT_TEXTURE_2D, RT_TEXTURE_MIN_FILTER, 1e30f), 0u;
}
static RTuint parameterMag(void) {
    return rtTexParameteri(RT_TEXTURE_2D, RT_TEXTURE_MAG_FILTER, RT_LINEAR_MIPMAP_LINEAR), 0u;
}
static RTuint parameterBorder(void) {
    return rtTexParameteri(RT_TEXTURE_2D, RT_TEXTURE_BORDER_COLOR, 1), 0u;
}
static RTuint parameterDepth(void) {
    return rtTexParameteri(RT_TEXTURE_2D, RT_DEPTH_TEXTURE_MODE, RT_LUMINANCE), 0u;
}
static RTuint parameterBase(void) {
    return rtTexParameteri(RT_TEXTURE_2D, RT_TEXTURE_BASE_LEVEL, -1), 0u;
}
static RTuint parameterNan(void) {
    return rtTexParameterf(RT_TEXTURE_2D, RT_TEXTURE_LOD_BIAS, NAN), 0u;
}
static RTuint parameterNull(void) {
    return rtTexParameterfv(RT_TEXTURE_2D, RT_TEXTURE_BORDER_COLOR, NULL), 0u;
}
static RTuint parameterBorderNan(void) {
    static const RTfloat color[4] = {0, NAN, 0, 0};
    return rtTexParameterfv(RT_TEXTURE_2D, RT_TEXTURE_BORDER_COLOR, color), 0u;
}
static RTuint getParameterNull(void) {
    return rtGetTexParameteriv(RT_TEXTURE_2D, RT_TEXTURE_WRAP_S, NULL), 0u;
}
static RTuint getParameterName(void) {
    RTint value = 7;
    rtGetTexParameteriv(RT_TEXTURE_2D, 0xABCD, &value);
    return value == 7 ? 0 : 1;
}
static RTuint getLevelName(void) {
    RTfloat value = 7;
    rtGetTexLevelParameterfv(RT_TEXTURE_2D, 0, RT_TEXTURE_WRAP_S, &value);
    return value == 7 ? 0 : 1;
}
static RTuint getLevelLevel(void) {
    RTint value = 7;
    rtGetTexLevelParameteriv(RT_TEXTURE_2D, 15, RT_TEXTURE_WIDTH, &value);
    return value == 7 ? 0 : 1;
}
static RTuint proxyBound(void) { return rtBindTexture(RT_PROXY_TEXTURE_2D, 1), 0u; }
static RTuint proxyEnabled(void) { return rtEnable(RT_PROXY_TEXTURE_2D), 0u; }
static RTuint proxyPart(void) {
    rtTexSubImage2D(RT_PROXY_TEXTURE_2D, 0, 0, 0, 1, 1, RT_RGB, RT_UNSIGNED_BYTE, partTexels);
    return 0;
}
static RTuint proxyCopy(void) {
    return rtCopyTexImage2D(RT_PROXY_TEXTURE_2D, 0, RT_RGB, 0, 0, 1, 1, 0), 0u;
}
static RTuint proxyParameter(void) {
    return rtTexParameteri(RT_PROXY_TEXTURE_2D, RT_TEXTURE_WRAP_S, RT_REPEAT), 0u;
}
static RTuint proxyGetParameter(void) {
    RTint value = 7;
    rtGetTexParameteriv(RT_PROXY_TEXTURE_1D, RT_TEXTURE_WRAP_S, &value);
    return value == 7 ? 0 : 1;
}
static RTuint proxyGetImage(void) {
    RTubyte texel[4] = {7, 7, 7, 7};
    rtGetTexImage(RT_PROXY_TEXTURE_2D, 0, RT_RGBA, RT_UNSIGNED_BYTE, texel);
    return texel[0] == 7 ? 0 : 1;
}
static RTuint proxyGetLevel(void) {
    RTint value = 7;
    rtGetTexLevelParameteriv(RT_PROXY_TEXTURE_2D, 15, RT_TEXTURE_WIDTH, &value);
    return value == 7 ? 0 : 1;
}
static RTuint proxyLevel(void) {
    rtTexImage2D(RT_PROXY_TEXTURE_2D, 15, RT_RGB, 1, 1, 0, RT_RGB, RT_UNSIGNED_BYTE, NULL);
    return 0;
}
static RTuint proxyDimensions(void) {
    rtTexImage1D(RT_PROXY_TEXTURE_2D, 0, RT_RGB, 1, 0, RT_RGB, RT_UNSIGNED_BYTE, NULL);
    return 0;
}
static RTuint proxyCube(void) {
    rtTexImage2D(RT_PROXY_TEXTURE_CUBE_MAP, 0, RT_RGB, 1, 1, 0, RT_RGB, RT_UNSIGNED_BYTE, NULL);
    return 0;
}
static RTuint storeUnknown(void) { return rtPixelStorei(0xABCD, 1), 0u; }
static RTuint storeAlignment(void) { return rtPixelStorei(RT_UNPACK_ALIGNMENT, 3), 0u; }
static RTuint storeNegative(void) { return rtPixelStoref(RT_UNPACK_ROW_LENGTH, -1), 0u; }
static RTuint storePack(void) { return rtPixelStorei(RT_PACK_SKIP_IMAGES, 4), 0u; }
static RTuint store(void) { return rtPixelStorei(RT_UNPACK_ALIGNMENT, 1), 0u; }
static RTuint accumulate(void) { return rtAccum(RT_ACCUM, 1), 0u; }
static RTuint select(void) { return rtRenderMode(RT_SELECT) ? 1u : 0u; }
static RTuint map(void) { return rtMapBuffer(RT_ARRAY_BUFFER, RT_READ_ONLY) ? 1u : 0u; }

static RTuint compile(void) { return rtCompileScene(); }
static RTuint release(void) { return rtReleaseScene(123456789), 0u; }

int main(void) {
    static const Misuse misuses[] = {
        MISUSE(enableUnknown, OUTSIDE, RT_INVALID_ENUM),
        MISUSE(enableStencil, OUTSIDE, RT_INVALID_OPERATION),
        MISUSE(enable3D, OUTSIDE, RT_INVALID_OPERATION),
        MISUSE(enableArray, OUTSIDE, RT_INVALID_ENUM),
        MISUSE(disableUnknown, OUTSIDE, RT_INVALID_ENUM),
        MISUSE(isEnabledUnknown, OUTSIDE, RT_INVALID_ENUM),
        MISUSE(isEnabled, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(enable, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(enable, IN_OBJECT, RT_INVALID_OPERATION),
        MISUSE(viewportNegative, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(viewport, IN_OBJECT, RT_INVALID_OPERATION),
        MISUSE(viewport, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(clearColor, IN_OBJECT, RT_INVALID_OPERATION),
        MISUSE(hintUnknown, OUTSIDE, RT_INVALID_ENUM),
        MISUSE(hintMode, OUTSIDE, RT_INVALID_ENUM),
        MISUSE(hintFogMode, OUTSIDE, RT_INVALID_ENUM),
        MISUSE(hint, IN_OBJECT, RT_INVALID_OPERATION),
        MISUSE(stringUnknown, OUTSIDE, RT_INVALID_ENUM),
        MISUSE(string, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(getUnknown, OUTSIDE, RT_INVALID_ENUM),
        MISUSE(getRefused, OUTSIDE, RT_INVALID_OPERATION),
        MISUSE(getNull, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(get, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(callback, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(getError, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(init, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(textureTarget, OUTSIDE, RT_INVALID_ENUM),
        MISUSE(texture3D, OUTSIDE, RT_INVALID_OPERATION),
        MISUSE(textureOther, OUTSIDE, RT_INVALID_OPERATION),
        MISUSE(textureId, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(bindTexture, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(genNegative, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(genNull, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(deleteNegative, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(isTexture, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(imageLevel, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(imageLevels, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(imageLevelLarge, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(imageInternal, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(imageDepth, OUTSIDE, RT_INVALID_OPERATION),
        MISUSE(imageNegative, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(imageLarge, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(imageBorder, OUTSIDE, RT_INVALID_OPERATION),
        MISUSE(imageBorderTwo, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(imageFormat, OUTSIDE, RT_INVALID_ENUM),
        MISUSE(imageIndex, OUTSIDE, RT_INVALID_OPERATION),
        MISUSE(imageType, OUTSIDE, RT_INVALID_ENUM),
        MISUSE(imageFields, OUTSIDE, RT_INVALID_OPERATION),
        MISUSE(partLevel, OUTSIDE, RT_INVALID_OPERATION),
        MISUSE(partNoLevel, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(partLeft, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(partRight, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(partNegative, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(partFormat, OUTSIDE, RT_INVALID_ENUM),
        MISUSE(partType, OUTSIDE, RT_INVALID_ENUM),
        MISUSE(partNull, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(parameterName, OUTSIDE, RT_INVALID_ENUM),
        MISUSE(parameterValue, OUTSIDE, RT_INVALID_ENUM),
        MISUSE(parameterMin, OUTSIDE, RT_INVALID_ENUM),
        MISUSE(parameterMag, OUTSIDE, RT_INVALID_ENUM),
        MISUSE(parameterBorder, OUTSIDE, RT_INVALID_ENUM),
        MISUSE(parameterDepth, OUTSIDE, RT_INVALID_OPERATION),
        MISUSE(parameterBase, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(parameterNan, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(parameterNull, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(parameterBorderNan, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(getParameterNull, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(getParameterName, OUTSIDE, RT_INVALID_ENUM),
        MISUSE(getLevelName, OUTSIDE, RT_INVALID_ENUM),
        MISUSE(getLevelLevel, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(proxyBound, OUTSIDE, RT_INVALID_ENUM),
        MISUSE(proxyEnabled, OUTSIDE, RT_INVALID_ENUM),
        MISUSE(proxyPart, OUTSIDE, RT_INVALID_ENUM),
        MISUSE(proxyCopy, OUTSIDE, RT_INVALID_ENUM),
        MISUSE(proxyParameter, OUTSIDE, RT_INVALID_ENUM),
        MISUSE(proxyGetParameter, OUTSIDE, RT_INVALID_ENUM),
        MISUSE(proxyGetImage, OUTSIDE, RT_INVALID_ENUM),
        MISUSE(proxyGetLevel, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(proxyLevel, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(proxyDimensions, OUTSIDE, RT_INVALID_ENUM),
        MISUSE(proxyCube, OUTSIDE, RT_INVALID_OPERATION),
        MISUSE(storeUnknown, OUTSIDE, RT_INVALID_ENUM),
        MISUSE(storeAlignment, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(storeNegative, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(storePack, OUTSIDE, RT_INVALID_OPERATION),
        MISUSE(store, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(accumulate, OUTSIDE, RT_INVALID_OPERATION),
        MISUSE(select, OUTSIDE, RT_INVALID_OPERATION),
        MISUSE(map, OUTSIDE, RT_INVALID_OPERATION),
        MISUSE_ID(compile, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(release, OUTSIDE, RT_INVALID_VALUE),
    };
    return CHECK_MISUSES(misuses);
}
