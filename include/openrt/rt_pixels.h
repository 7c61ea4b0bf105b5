/* SPDX-License-Identifier: MIT */
/* The raster position, bitmaps and rectangles of pixels, as OpenGL has them. Part of openrt/rt.h.
 * Like points and lines they are drawn in pixels of the window, in the order of submission among
 * everything else, tested for depth and blended; camera rays see them, no other ray does.
 * None of these calls is legal between rtBegin and rtEnd or in an object. */
#ifndef OPENRT_RT_PIXELS_H
#define OPENRT_RT_PIXELS_H

#include "openrt/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The raster position, where rectangles of pixels are drawn: transformed and lit as a vertex is,
 * with the current colour, normal and texture coordinates, and kept in the window, with the
 * viewport of now. It is invalid where the view volume or a clip plane cuts it away: nothing is
 * drawn then. It starts at (0, 0, 0), valid and white. As everything in the window it needs the
 * projection matrix: a camera shader does not move it.
 * Errors:  RT_INVALID_VALUE  v NULL
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtRasterPos2s(RTshort x, RTshort y);
RTAPI void RTAPIENTRY rtRasterPos2i(RTint x, RTint y);
RTAPI void RTAPIENTRY rtRasterPos2f(RTfloat x, RTfloat y);
RTAPI void RTAPIENTRY rtRasterPos2d(RTdouble x, RTdouble y);
RTAPI void RTAPIENTRY rtRasterPos3s(RTshort x, RTshort y, RTshort z);
RTAPI void RTAPIENTRY rtRasterPos3i(RTint x, RTint y, RTint z);
RTAPI void RTAPIENTRY rtRasterPos3f(RTfloat x, RTfloat y, RTfloat z);
RTAPI void RTAPIENTRY rtRasterPos3d(RTdouble x, RTdouble y, RTdouble z);
RTAPI void RTAPIENTRY rtRasterPos4s(RTshort x, RTshort y, RTshort z, RTshort w);
RTAPI void RTAPIENTRY rtRasterPos4i(RTint x, RTint y, RTint z, RTint w);
RTAPI void RTAPIENTRY rtRasterPos4f(RTfloat x, RTfloat y, RTfloat z, RTfloat w);
RTAPI void RTAPIENTRY rtRasterPos4d(RTdouble x, RTdouble y, RTdouble z, RTdouble w);
RTAPI void RTAPIENTRY rtRasterPos2sv(const RTshort *v);
RTAPI void RTAPIENTRY rtRasterPos2iv(const RTint *v);
RTAPI void RTAPIENTRY rtRasterPos2fv(const RTfloat *v);
RTAPI void RTAPIENTRY rtRasterPos2dv(const RTdouble *v);
RTAPI void RTAPIENTRY rtRasterPos3sv(const RTshort *v);
RTAPI void RTAPIENTRY rtRasterPos3iv(const RTint *v);
RTAPI void RTAPIENTRY rtRasterPos3fv(const RTfloat *v);
RTAPI void RTAPIENTRY rtRasterPos3dv(const RTdouble *v);
RTAPI void RTAPIENTRY rtRasterPos4sv(const RTshort *v);
RTAPI void RTAPIENTRY rtRasterPos4iv(const RTint *v);
RTAPI void RTAPIENTRY rtRasterPos4fv(const RTfloat *v);
RTAPI void RTAPIENTRY rtRasterPos4dv(const RTdouble *v);

/* The raster position in pixels from the window's lower left corner: always valid, z limited to 0
 * (the near end of the depth range) to 1, the current colour without lighting.
 * Errors:  RT_INVALID_VALUE  v NULL
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtWindowPos2s(RTshort x, RTshort y);
RTAPI void RTAPIENTRY rtWindowPos2i(RTint x, RTint y);
RTAPI void RTAPIENTRY rtWindowPos2f(RTfloat x, RTfloat y);
RTAPI void RTAPIENTRY rtWindowPos2d(RTdouble x, RTdouble y);
RTAPI void RTAPIENTRY rtWindowPos3s(RTshort x, RTshort y, RTshort z);
RTAPI void RTAPIENTRY rtWindowPos3i(RTint x, RTint y, RTint z);
RTAPI void RTAPIENTRY rtWindowPos3f(RTfloat x, RTfloat y, RTfloat z);
RTAPI void RTAPIENTRY rtWindowPos3d(RTdouble x, RTdouble y, RTdouble z);
RTAPI void RTAPIENTRY rtWindowPos2sv(const RTshort *v);
RTAPI void RTAPIENTRY rtWindowPos2iv(const RTint *v);
RTAPI void RTAPIENTRY rtWindowPos2fv(const RTfloat *v);
RTAPI void RTAPIENTRY rtWindowPos2dv(const RTdouble *v);
RTAPI void RTAPIENTRY rtWindowPos3sv(const RTshort *v);
RTAPI void RTAPIENTRY rtWindowPos3iv(const RTint *v);
RTAPI void RTAPIENTRY rtWindowPos3fv(const RTfloat *v);
RTAPI void RTAPIENTRY rtWindowPos3dv(const RTdouble *v);

/* Draws the bits of a bitmap that are 1 in the raster position's colour. (xorig, yorig) of the
 * bitmap is at the raster position, which moves by (xmove, ymove) then; all are in pixels. `bitmap`
 * NULL, or a bitmap of no size, moves it only. Rows lie as rtPixelStore says, from the bottom.
 * Errors:  RT_INVALID_VALUE  a negative size
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtBitmap(RTsizei width, RTsizei height, RTfloat xorig, RTfloat yorig,
                               RTfloat xmove, RTfloat ymove, const RTubyte *bitmap);

/* Draws a rectangle of colours at the raster position: its lower left corner is there, each pixel
 * as large as rtPixelZoom says, with the raster position's depth, fog and texture coordinates.
 * Formats and types are those of rtTexImage2D.
 * Errors:  RT_INVALID_VALUE      a negative size, pixels NULL
 *          RT_INVALID_ENUM       unknown format or type
 *          RT_INVALID_OPERATION  a format or type that this release has not: depths and stencil
 *                                values are not drawn; a type of fields that does not fit the
 *                                format
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtDrawPixels(RTsizei width, RTsizei height, RTenum format, RTenum type,
                                   const void *pixels);

/* Pixels of the window to one of rtDrawPixels; a negative number turns the picture over. Starts at 1.
 * Errors:  RT_INVALID_VALUE  not finite
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtPixelZoom(RTfloat xfactor, RTfloat yfactor);

/* Scales and biases of the colours of pixels: RT_RED_SCALE, RT_RED_BIAS and so on to RT_ALPHA_BIAS.
 * Colours that are drawn by rtDrawPixels, read by rtReadPixels or go into textures are multiplied
 * by the scale, and the bias is added. RT_MAP_COLOR, RT_MAP_STENCIL, RT_INDEX_SHIFT,
 * RT_INDEX_OFFSET, RT_DEPTH_SCALE and RT_DEPTH_BIAS have the values that they start with and no
 * others.
 * Errors:  RT_INVALID_ENUM       unknown name
 *          RT_INVALID_OPERATION  another value of one of the latter
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtPixelTransferf(RTenum pname, RTfloat param);
RTAPI void RTAPIENTRY rtPixelTransferi(RTenum pname, RTint param);

#ifdef __cplusplus
}
#endif

#endif
