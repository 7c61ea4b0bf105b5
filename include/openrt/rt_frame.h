/* SPDX-License-Identifier: MIT */
/* Frame buffers, what a frame consists of, rendering. Part of openrt/rt.h. */
#ifndef OPENRT_RT_FRAME_H
#define OPENRT_RT_FRAME_H

#include "openrt/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The application's memory for frames started from now on; row 0 at the bottom. It must live
 * until these frames are done. Formats: RT_BGR_32 (three floats: blue, green, red), RT_RGB_8,
 * RT_RGBA_8, RT_BGRA_8, RT_RGB_32F, RT_RGBA_32F. Values for 8 bits are clamped to 0..1, times
 * 255, rounded; floats are not clamped. A frame keeps the memory it was started with.
 * Not in an object.
 * Errors:  RT_INVALID_ENUM   unknown format
 *          RT_INVALID_VALUE  fb NULL, width or height 0, or more bytes than memory has
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtSetFrameBuffer(RTubyte *fb, RTuint width, RTuint height, RTuint format);

/* Bytes from one row of the frame buffer to the next; 0 (start): rows follow each other. It must
 * hold a row, and be a multiple of 4 for formats of floats, when a frame is started.
 * Not in an object.
 * Errors:  RT_INVALID_VALUE  negative
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtFrameBufferStride(RTsizei bytes);

/* Memory for another value of each pixel: of the frame buffer's size, packed, row 0 at the bottom.
 * It lasts like the frame buffer; memory NULL switches off. Not in an object.
 *   what                                        format           a miss
 *   RT_DEPTH     window depth                   RT_FLOAT         1
 *   RT_DISTANCE  along the ray                  RT_FLOAT         infinity
 *   RT_NORMAL    shading normal, length 1       RT_RGB_32F       0
 *   RT_OBJECT_ID, RT_INSTANCE_ID,
 *   RT_PRIMITIVE_ID  as in RThit                RT_UNSIGNED_INT  RT_INVALID
 * They belong to the ray through the pixel's first sample.
 * Errors:  RT_INVALID_ENUM       unknown `what`, or not its format
 *          RT_INVALID_OPERATION  RT_ALBEDO: not part of this release
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtSetAuxBuffer(RTenum what, void *memory, RTuint format);

/* How many samples a pixel gets: 1 (start: the pixel's centre) to 4096; and the seed of sample
 * positions and random numbers, 0 at the start. Both depend on pixel, sample and seed only. Read
 * when a frame is started.
 * Errors:  RT_INVALID_VALUE  n out of range
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtSamples(RTuint n);
RTAPI void RTAPIENTRY rtSeed(RTuint seed);

/* How deep shaders may trace rays: one of depth n (camera rays: 0) spawns none; 0 to 256, 8 at the
 * start. And the share of a pixel, 0 to 1, below which a ray is not traced, 1/512 at the start.
 * Read when a frame is started.
 * Errors:  RT_INVALID_VALUE  out of range
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtRecursionLimit(RTuint n);
RTAPI void RTAPIENTRY rtWeightCutoff(RTfloat weight);

/* Adds a light shader to this frame. Fast: without the check for one given twice. Not in an
 * object.
 * Errors:  RT_INVALID_VALUE      unknown shader
 *          RT_INVALID_OPERATION  not a light shader, or given already
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtUseLight(RTuint shader);
RTAPI void RTAPIENTRY rtUseLightFast(RTuint shader);

/* The frame's camera shader, environment shader and rendering object; each once a frame. Without:
 * the projection matrix, the clear colour, the default (samples of a pixel averaged). With a
 * camera shader the space that the model-view matrix maps to is the world. Not in an object.
 * Errors:  RT_INVALID_VALUE      unknown shader
 *          RT_INVALID_OPERATION  not of this kind, or the frame has one already
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtUseCamera(RTuint shader);
RTAPI void RTAPIENTRY rtUseEnvironmentShader(RTuint shader);
RTAPI void RTAPIENTRY rtUseRenderingObject(RTuint shader);

/* Freezes the bound scene as a frame and starts to render it. Returns at once, unless the queue of
 * frames is full (rtFrameDepth); the scene is empty then. Not in an object.
 * Errors:  RT_INVALID_OPERATION  no frame buffer; a stride that holds no row; a frame started by
 *                                this call is in flight; a projection matrix without an inverse
 *                                and no camera shader
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtStartRendering(void);

/* Waits for the frame that rtStartRendering started. Not in an object.
 * Errors:  RT_INVALID_OPERATION  none in flight; or the picture is complete but for pixels
 *                                (RT_STAT_BAD_PIXELS) in which a shader failed: they are black
 *          what else went wrong while it was rendered (each is recorded once, here or by
 *            rtWaitFrame)
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtEndRendering(void);

/* Renders the bound scene as a frame and waits for it: rtStartRendering unless a frame is in
 * flight, then rtEndRendering. With one in flight it only waits, and what was described since stays
 * for the next frame. Not in an object.
 * Errors:  RT_INVALID_OPERATION  no frame buffer; a stride that holds no row; a projection matrix
 *                                without an inverse and no camera shader; pixels in which a
 *                                shader failed, as by rtEndRendering
 *          what else went wrong while it was rendered
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtRender(void);

/* Renders what the bound scene was given so far and leaves it open; unless nothing was added to it
 * since the last time or there is no frame buffer. Waits for this and for all other frames of the
 * context. Not in an object.
 * Errors:  RT_INVALID_OPERATION  a stride that holds no row; a projection matrix without an inverse
 *                                and no camera shader; pixels in which a shader failed, as by
 *                                rtEndRendering
 *          what else went wrong while the frames were rendered
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtFinish(void);

/* Has no effect, as nothing is pending that could be shown: single-buffered windows of rtut show
 * a frame at the end of the display callback.
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtFlush(void);

#ifdef __cplusplus
}
#endif
#endif
