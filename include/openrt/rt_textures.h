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

/* n unused texture ids. They become textures when they are first bound.
 * Errors:  RT_INVALID_VALUE  n negative, or textures NULL with n above 0
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtGenTextures(RTsizei n, RTuint *textures);

/* Deletes textures; 0 and unknown ids are ignored. The bound one is replaced by 0.
 * Errors:  RT_INVALID_VALUE  n negative, or textures NULL with n above 0
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtDeleteTextures(RTsizei n, const RTuint *textures);

/* The texture that the calls below are about; an unknown id becomes a new texture. 0 is a
 * texture that no shader can look up. Legal in objects.
 * Errors:  RT_INVALID_ENUM       target is no texture target
 *          RT_INVALID_VALUE      id above 1048575
 *          RT_INVALID_OPERATION  target is not RT_TEXTURE_2D: not part of this release
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtBindTexture(RTenum target, RTuint texture);

/* RT_TRUE if the id has been bound and not deleted since.
 * Threads: the context's. Since: 0.1 */
RTAPI RTboolean RTAPIENTRY rtIsTexture(RTuint texture);

/* Gives the bound texture its image: any size up to RT_MAX_TEXTURE_SIZE (16384) a side, the first
 * row at the bottom, read from `pixels` as rtPixelStore says. NULL: an image of zeros.
 *   internalFormat  1 to 4; RT_LUMINANCE, RT_LUMINANCE_ALPHA, RT_RGB, RT_RGBA and their sized
 *                   forms; RT_SRGB, RT_SRGB8, RT_SRGB_ALPHA, RT_SRGB8_ALPHA8 (bytes only)
 *   format          RT_RGB, RT_RGBA, RT_BGR, RT_BGRA, RT_LUMINANCE, RT_LUMINANCE_ALPHA
 *   type            RT_UNSIGNED_BYTE, RT_UNSIGNED_SHORT (0..1), RT_FLOAT (kept as given, so that
 *                   environments may be brighter than 1)
 * Texels are kept in the precision of `type`. An image with a side of 0 is none.
 * Errors:  RT_INVALID_ENUM       target, format or type is no such token
 *          RT_INVALID_VALUE      size, level, border or internalFormat out of range
 *          RT_INVALID_OPERATION  a target, level, border, format or type that OpenGL has and this
 *                                release has not; sRGB of other types than bytes
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtTexImage2D(RTenum target, RTint level, RTint internalFormat, RTsizei width,
                                   RTsizei height, RTint border, RTenum format, RTenum type,
                                   const void *pixels);

/* How the bound texture is looked up:
 *   RT_TEXTURE_WRAP_S, _T   RT_REPEAT (start), RT_CLAMP, RT_CLAMP_TO_EDGE, RT_MIRRORED_REPEAT
 *   RT_TEXTURE_MAG_FILTER   RT_NEAREST, RT_LINEAR (start)
 *   RT_TEXTURE_MIN_FILTER   OpenGL's six values; as there are no mipmaps, all look-ups follow
 *                           RT_TEXTURE_MAG_FILTER
 * RT_CLAMP clamps to the edge.
 * Errors:  RT_INVALID_ENUM       target, pname or value is no such token
 *          RT_INVALID_OPERATION  one that OpenGL has and this release has not
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtTexParameteri(RTenum target, RTenum pname, RTint param);
RTAPI void RTAPIENTRY rtTexParameterf(RTenum target, RTenum pname, RTfloat param);

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
