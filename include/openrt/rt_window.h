/* SPDX-License-Identifier: MIT */
/* The buffers of the window as OpenGL has them: clearing, scissor, depth range, reading what was
 * drawn so far. Part of openrt/rt.h.
 *
 * A frame is drawn in layers. A layer ends where the projection matrix, viewport, scissor, depth
 * range or draw buffer of the next primitive differ from those of its first one, or where rtClear
 * comes between. Layers are merged pixel by pixel in order, by window depth; rays that shaders send
 * on see their own layer only. A frame that is not cleared starts from the clear colour, and depth
 * 1. */
#ifndef OPENRT_RT_WINDOW_H
#define OPENRT_RT_WINDOW_H

#include "openrt/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Clears buffers inside the scissor: RT_COLOR_BUFFER_BIT to the clear colour where the colour mask
 * allows, RT_DEPTH_BUFFER_BIT to the clear depth if the depth mask does. RT_STENCIL_BUFFER_BIT and
 * RT_ACCUM_BUFFER_BIT are accepted. What clears of colour and depth leave nothing of is forgotten.
 * From the first rtClear on RT_DEPTH_TEST is off unless it was ever set: see rt_state.h. Not in an
 * object.
 * Errors:  RT_INVALID_VALUE  other bits
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtClear(RTbitfield mask);

/* The depth that rtClear clears to: 0 to 1, clamped; 1 at the start. Not in an object.
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtClearDepth(RTclampd depth);

/* The rectangle that RT_SCISSOR_TEST leaves to be drawn, in pixels from the lower left corner; at
 * the start the frame buffer. Not in an object.
 * Errors:  RT_INVALID_VALUE  a negative size
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtScissor(RTint x, RTint y, RTsizei width, RTsizei height);

/* The depth in the window of the near and the far plane; clamped to 0 to 1; 0 and 1 at the start.
 * Not in an object.
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtDepthRange(RTclampd near_val, RTclampd far_val);

/* The buffer to draw to and to read from: there is one, whatever its name: RT_FRONT, RT_BACK,
 * RT_LEFT, RT_FRONT_LEFT, RT_BACK_LEFT, for drawing RT_FRONT_AND_BACK too. RT_NONE: nothing is
 * drawn but depths. Not in an object.
 * Errors:  RT_INVALID_ENUM       unknown name
 *          RT_INVALID_OPERATION  a buffer for the right eye, or an auxiliary one
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtDrawBuffer(RTenum mode);
RTAPI void RTAPIENTRY rtReadBuffer(RTenum mode);

/* Reads a rectangle of the picture back, in pixels from the lower left corner. Renders what the
 * bound scene was given so far, unless nothing was added since the last time, and stores the
 * rectangle; pixels outside of the frame buffer stay as they are in `pixels`. The scene stays open.
 * After rtRender, with nothing new, it is that picture.
 *
 * Without rtSetFrameBuffer the picture is kept in memory of the library's, as large as the viewport
 * needs it, in 8 bits a channel. Formats: RT_RED, RT_GREEN, RT_BLUE, RT_ALPHA, RT_RGB, RT_RGBA,
 * RT_BGR, RT_BGRA, RT_LUMINANCE (the sum of red, green and blue), RT_LUMINANCE_ALPHA,
 * RT_DEPTH_COMPONENT. Types: all of OpenGL's numbers. RT_FLOAT is not clamped. Rows lie as the
 * RT_PACK_... values of rtPixelStore say; scales and biases of rtPixelTransfer apply to colours.
 * Not in an object.
 * Errors:  RT_INVALID_ENUM       unknown format or type
 *          RT_INVALID_VALUE      a negative size; pixels NULL
 *          RT_INVALID_OPERATION  RT_COLOR_INDEX and RT_STENCIL_INDEX; a type of fields that does
 *                                not fit the format; no frame buffer and no viewport; depth of a
 *                                frame that has ended before depth was ever asked for
 *          what went wrong while it was rendered
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtReadPixels(RTint x, RTint y, RTsizei width, RTsizei height, RTenum format,
                                   RTenum type, void *pixels);

/* Makes an image of a texture, or a part of one, from the picture so far: as rtTexImage2D and
 * rtTexSubImage2D do, in 8 bits a channel, 0 outside of the frame buffer. Not in an object.
 * Errors:  RT_INVALID_ENUM       target is no such token; a number as internal format
 *          RT_INVALID_VALUE      size, level, border or internal format out of range; the part does
 *                                not lie inside the image
 *          RT_INVALID_OPERATION  a target, border or format that OpenGL has and this release has
 *                                not; the level has no image; no frame buffer and no viewport
 *          what went wrong while the picture was rendered
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtCopyTexImage1D(RTenum target, RTint level, RTenum internalformat, RTint x,
                                       RTint y, RTsizei width, RTint border);
RTAPI void RTAPIENTRY rtCopyTexImage2D(RTenum target, RTint level, RTenum internalformat, RTint x,
                                       RTint y, RTsizei width, RTsizei height, RTint border);
RTAPI void RTAPIENTRY rtCopyTexSubImage1D(RTenum target, RTint level, RTint xoffset, RTint x,
                                          RTint y, RTsizei width);
RTAPI void RTAPIENTRY rtCopyTexSubImage2D(RTenum target, RTint level, RTint xoffset,
                                          RTint yoffset, RTint x, RTint y, RTsizei width,
                                          RTsizei height);

/* Draws a rectangle of the picture so far at the raster position; as rtDrawPixels does. Not in an
 * object.
 * Errors:  RT_INVALID_ENUM       unknown type
 *          RT_INVALID_VALUE      a negative size
 *          RT_INVALID_OPERATION  RT_DEPTH and RT_STENCIL
 *          what went wrong while it was rendered
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtCopyPixels(RTint x, RTint y, RTsizei width, RTsizei height, RTenum type);

#ifdef __cplusplus
}
#endif
#endif
