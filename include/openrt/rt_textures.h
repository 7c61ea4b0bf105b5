/* SPDX-License-Identifier: MIT */
/* Images for shaders. Part of openrt/rt.h.
 * A texture is an image and the way it is looked up. Shaders get its id in a parameter of type
 * 1i. Images are copied; a frame in flight keeps the images it was started with. */
#ifndef OPENRT_RT_TEXTURES_H
#define OPENRT_RT_TEXTURES_H

#include "openrt/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Gives n unused ids of textures. They become textures when they are first bound.
 * Errors:  RT_INVALID_VALUE  n negative, or textures NULL with n above 0
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtGenTextures(RTsizei n, RTuint *textures);

/* Deletes textures; 0 and unknown ids are ignored. The bound one is replaced by 0.
 * Errors:  RT_INVALID_VALUE  n negative, or textures NULL with n above 0
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtDeleteTextures(RTsizei n, const RTuint *textures);

/* Binds a texture of one or two dimensions: the calls about textures are about it. An unknown id
 * becomes a new texture with this number of dimensions. 0 is a texture of each that no shader can
 * look up. Legal in objects.
 * Errors:  RT_INVALID_ENUM       target is no texture target
 *          RT_INVALID_VALUE      id above 1048575
 *          RT_INVALID_OPERATION  target is neither RT_TEXTURE_1D nor RT_TEXTURE_2D: not part of this
 *                                release; the texture has another number of dimensions
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtBindTexture(RTenum target, RTuint texture);

/* Whether an id is that of a texture: it has been bound and not deleted since.
 * Threads: the context's. Since: 0.1 */
RTAPI RTboolean RTAPIENTRY rtIsTexture(RTuint texture);

/* Gives a level of the bound texture its image: any size up to RT_MAX_TEXTURE_SIZE (16384) a side
 * for level 0 and half of that for each further one, the first row at the bottom, read from
 * `pixels` as rtPixelStore says. NULL: an image of zeros.
 *   internalFormat  1 to 4; RT_ALPHA, RT_LUMINANCE, RT_LUMINANCE_ALPHA, RT_INTENSITY, RT_RGB,
 *                   RT_RGBA, their sized and compressed forms (kept uncompressed); RT_SRGB,
 *                   RT_SRGB8, RT_SRGB_ALPHA, RT_SRGB8_ALPHA8: colours, not alpha, in sRGB coding
 *   format          RT_RGB, RT_RGBA, RT_BGR, RT_BGRA, RT_LUMINANCE, RT_LUMINANCE_ALPHA, RT_RED,
 *                   RT_GREEN, RT_BLUE, RT_ALPHA
 *   type            whole numbers of 8, 16 and 32 bits, which stand for 0..1, signed ones for
 *                   -1..1 (negative texels become 0); all components in one number, as
 *                   RT_UNSIGNED_SHORT_5_6_5 and RT_UNSIGNED_INT_8_8_8_8_REV; RT_HALF_FLOAT and
 *                   RT_FLOAT (kept as given, so that environments may be brighter than 1)
 * Scales and biases of rtPixelTransfer are applied first, those of now also in a display list.
 * Texels are kept in the precision of `type`, in 16 bits if that has 32. An image with a side of 0
 * is none.
 *
 * Mipmaps are the levels after RT_TEXTURE_BASE_LEVEL, each with half the sides of the one before,
 * rounded down, to a single texel or RT_TEXTURE_MAX_LEVEL. They are given one by one, or made by
 * the library: if RT_GENERATE_MIPMAP is RT_TRUE when the base level gets its image, the levels
 * after it are dropped and made from it, in linear light, when the first look-up needs them. A
 * texture whose minification filter needs levels that are not there, or that have other sizes or
 * another internal format, is looked up in its base level by RT_TEXTURE_MAG_FILTER.
 *
 * The target RT_PROXY_TEXTURE_2D asks whether there could be such an image: pixels are not read, no
 * texture changes, and rtGetTexLevelParameter of that target says how the image's level would be,
 * or 0 for all if it is too large, or its border, format or type are not part of this release; none
 * of that is an error. There is one such state a context. The call is made at once where a display
 * list is compiled.
 * Errors:  RT_INVALID_ENUM       target, format or type is no such token
 *          RT_INVALID_VALUE      size, level, border or internalFormat out of range
 *          RT_INVALID_OPERATION  a target, border, format or type that OpenGL has and this release
 *                                has not; a type of fields that does not fit the format
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtTexImage2D(RTenum target, RTint level, RTint internalFormat, RTsizei width,
                                   RTsizei height, RTint border, RTenum format, RTenum type,
                                   const void *pixels);

/* Gives a level of the bound texture of one dimension its image: as rtTexImage2D does, of one row;
 * also for RT_PROXY_TEXTURE_1D.
 * Errors:  RT_INVALID_ENUM       target, format or type is no such token
 *          RT_INVALID_VALUE      size, level, border or internalFormat out of range
 *          RT_INVALID_OPERATION  a target, border, format or type that OpenGL has and this release
 *                                has not; a type of fields that does not fit the format
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtTexImage1D(RTenum target, RTint level, RTint internalFormat, RTsizei width,
                                   RTint border, RTenum format, RTenum type, const void *pixels);

/* Replaces a part of a level's image; it is converted to the precision that the image has. At the
 * base level, with RT_GENERATE_MIPMAP, the levels after it are made anew.
 * Errors:  RT_INVALID_ENUM       target, format or type is no such token
 *          RT_INVALID_VALUE      the part does not lie inside the image, a size is negative, pixels
 *                                is NULL
 *          RT_INVALID_OPERATION  the level has no image; a target, format or type that OpenGL has
 *                                and this release has not
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtTexSubImage2D(RTenum target, RTint level, RTint xoffset, RTint yoffset,
                                      RTsizei width, RTsizei height, RTenum format, RTenum type,
                                      const void *pixels);

/* Replaces a part of a level of the bound texture of one dimension: as rtTexSubImage2D does.
 * Errors:  RT_INVALID_ENUM       target, format or type is no such token
 *          RT_INVALID_VALUE      the part does not lie inside the image, a size is negative, pixels
 *                                is NULL
 *          RT_INVALID_OPERATION  the level has no image; a target, format or type that OpenGL has
 *                                and this release has not
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtTexSubImage1D(RTenum target, RTint level, RTint xoffset, RTsizei width,
                                      RTenum format, RTenum type, const void *pixels);

/* Priorities of textures, without effect: all that exist are in memory, and resident.
 * Errors:  RT_INVALID_VALUE  n negative, NULL with n above 0; rtAreTexturesResident: an unknown id
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtPrioritizeTextures(RTsizei n, const RTuint *textures,
                                           const RTclampf *priorities);
RTAPI RTboolean RTAPIENTRY rtAreTexturesResident(RTsizei n, const RTuint *textures,
                                                 RTboolean *residences);

/* How the bound texture is looked up:
 *   RT_TEXTURE_WRAP_S, _T       RT_REPEAT (start), RT_MIRRORED_REPEAT, RT_CLAMP_TO_EDGE,
 *                               RT_CLAMP_TO_BORDER (the border colour outside), RT_CLAMP (at the
 *                               border linear filters mix the edge with the border colour)
 *   RT_TEXTURE_MAG_FILTER       RT_NEAREST, RT_LINEAR (start)
 *   RT_TEXTURE_MIN_FILTER       RT_NEAREST, RT_LINEAR, RT_NEAREST_MIPMAP_NEAREST,
 *                               RT_LINEAR_MIPMAP_NEAREST, RT_NEAREST_MIPMAP_LINEAR (start),
 *                               RT_LINEAR_MIPMAP_LINEAR; which level, follows from how much of the
 *                               texture a sample covers: docs/textures.md has the formula
 *   RT_TEXTURE_BORDER_COLOR     four components, linear RGBA; start 0. Calls with arrays only
 *   RT_TEXTURE_MIN_LOD, _MAX_LOD  limits of the level of detail; start -1000, 1000
 *   RT_TEXTURE_LOD_BIAS         added to it, limited to 16 both ways; start 0
 *   RT_TEXTURE_BASE_LEVEL, _MAX_LEVEL  the levels that are used; start 0, 1000
 *   RT_GENERATE_MIPMAP          see rtTexImage2D; start RT_FALSE
 *   RT_TEXTURE_PRIORITY, _WRAP_R  without effect
 * Errors:  RT_INVALID_ENUM       target, pname or value is no such token; a colour in a call for
 *                                one value
 *          RT_INVALID_VALUE      a negative level, a number that is NaN, params NULL
 *          RT_INVALID_OPERATION  one that OpenGL has and this release has not
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtTexParameteri(RTenum target, RTenum pname, RTint param);
RTAPI void RTAPIENTRY rtTexParameterf(RTenum target, RTenum pname, RTfloat param);
RTAPI void RTAPIENTRY rtTexParameteriv(RTenum target, RTenum pname, const RTint *params);
RTAPI void RTAPIENTRY rtTexParameterfv(RTenum target, RTenum pname, const RTfloat *params);

/* How the bound texture is looked up: what rtTexParameteri and the like have set.
 * Errors:  RT_INVALID_ENUM       target or pname is no such token
 *          RT_INVALID_VALUE      params NULL
 *          RT_INVALID_OPERATION  one that OpenGL has and this release has not
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtGetTexParameteriv(RTenum target, RTenum pname, RTint *params);
RTAPI void RTAPIENTRY rtGetTexParameterfv(RTenum target, RTenum pname, RTfloat *params);

/* Facts of a level of the bound texture: RT_TEXTURE_WIDTH, _HEIGHT, _BORDER, _INTERNAL_FORMAT, and
 * the bits of its components: RT_TEXTURE_RED_SIZE, _GREEN_SIZE, _BLUE_SIZE, _ALPHA_SIZE,
 * _LUMINANCE_SIZE. Levels that the library makes have them too, levels without an image 0. Of
 * RT_PROXY_TEXTURE_1D and _2D: what rtTexImage said there; all other calls refuse these targets
 * with RT_INVALID_ENUM.
 * Errors:  RT_INVALID_ENUM       target or pname is no such token
 *          RT_INVALID_VALUE      level out of range, params NULL
 *          RT_INVALID_OPERATION  RT_TEXTURE_COMPRESSED_IMAGE_SIZE: nothing is compressed
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtGetTexLevelParameteriv(RTenum target, RTint level, RTenum pname,
                                               RTint *params);
RTAPI void RTAPIENTRY rtGetTexLevelParameterfv(RTenum target, RTint level, RTenum pname,
                                               RTfloat *params);

/* The image of a level of the bound texture; laid out as rtPixelStore of the kind RT_PACK_ says.
 * Nothing where the level has none.
 * Errors:  RT_INVALID_ENUM       target, format or type is no such token
 *          RT_INVALID_VALUE      level out of range, pixels NULL
 *          RT_INVALID_OPERATION  format and type do not fit, or are not of colours
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtGetTexImage(RTenum target, RTint level, RTenum format, RTenum type,
                                    void *pixels);

/* How images lie in the application's memory: RT_UNPACK_ALIGNMENT 1, 2, 4 (start) or 8;
 * RT_UNPACK_ROW_LENGTH, RT_UNPACK_SKIP_PIXELS, RT_UNPACK_SKIP_ROWS from 0 (start), in pixels;
 * RT_UNPACK_SWAP_BYTES 0 (start) or 1.
 * Errors:  RT_INVALID_ENUM       pname is no such token
 *          RT_INVALID_VALUE      param out of range
 *          RT_INVALID_OPERATION  a name that OpenGL has and this release has not
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtPixelStorei(RTenum pname, RTint param);
RTAPI void RTAPIENTRY rtPixelStoref(RTenum pname, RTfloat param);

#ifdef __cplusplus
}
#endif
#endif
