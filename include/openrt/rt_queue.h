/* SPDX-License-Identifier: MIT */
/* Several scenes, and the queue of frames. Part of openrt/rt.h.
 *
 *     RTuint frames[2];
 *     rtFrameDepth(3);                               // three frames in flight, then wait
 *     for (i = 0; ; ++i) {
 *         if (i >= 2) { rtWaitFrame(frames[i % 2]);  show(pixels[i % 2]); }
 *         rtSetFrameBuffer(pixels[i % 2], width, height, RT_RGBA_8);
 *         describe(i);                               // while the frame before is rendered
 *         frames[i % 2] = rtQueueFrame();
 *     }
 *
 * Frames in flight. A frame keeps everything as it was when it was queued: geometry, shaders and
 * their parameters, textures, matrices, settings, callback, and where its pixels go. Whatever the
 * application changes, replaces or removes afterwards belongs to later frames; only the memory of
 * the frame buffer and of auxiliary buffers is the application's, and has to live, and be left
 * alone, until the frame has ended. A frame that writes to memory of a frame queued before it is
 * started when that has ended; to keep all cores busy give frames in flight memory of their own.
 * rtThreads, rtInit, rtExit and rtDestroyContext wait for the frames queued; cancel them first
 * where that takes too long.
 *
 * Order. Frames of a context end in the order in which they were queued. One that is cancelled
 * ends at once. Frames of different contexts are independent of each other.
 *
 * Frame ids count from 1, are unique in the process, and are never used again. rtWaitFrame,
 * rtFrameStatus, rtFrameProgress and rtCancelFrame take the id of any frame of any context, on any
 * thread, with a context or without; errors are recorded if the thread has one. An id stays known
 * after the frame's and the context's end, until rtExit. A frame that has ended holds no memory
 * but for a small record, of the newest 256 frames; the scene of a context's last frame stays for
 * rtQueueView if a camera in use took it.
 */
#ifndef OPENRT_RT_QUEUE_H
#define OPENRT_RT_QUEUE_H

#include "openrt/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Makes a new, empty scene. A scene is what a frame consists of: instances, loose geometry, lights,
 * camera, environment and rendering object; scene 0 always exists. Everything else - matrices,
 * current values, objects, shaders, parameters, hints, settings, the frame buffer - belongs to the
 * context and is the same for all its scenes. Not in an object.
 * Threads: the context's. Since: 0.1 */
RTAPI RTuint RTAPIENTRY rtGenScene(void);

/* Binds a scene: rtInstantiateObject, rtUse... and loose geometry fill it from now on, and
 * rtQueueFrame, rtStartRendering, rtRender, rtFinish and rtCompileScene take it; 0 at the start.
 * What the scene bound before was given stays in it. Not in an object.
 * Errors:  RT_INVALID_VALUE  unknown scene
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtBindScene(RTuint scene);

/* Forgets a scene and what it was given; 0 is ignored. If it is bound, scene 0 is bound instead.
 * Frames queued and scenes compiled from it are not touched. Not in an object.
 * Errors:  RT_INVALID_VALUE  unknown scene
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtDeleteScene(RTuint scene);

/* Freezes the bound scene as a frame, queues it and returns the frame's id; the scene is empty
 * then. Returns at once unless as many frames as rtFrameDepth allows have not ended: then it waits
 * until one of them has. Any number of frames may be queued this way beside the one that
 * rtStartRendering starts. Not in an object.
 * Errors:  RT_INVALID_OPERATION  no frame buffer; a stride that holds no row; a projection matrix
 *                                without an inverse and no camera shader
 *          RT_OUT_OF_MEMORY      also when 2^32 - 2 frames have been rendered by the process
 * Threads: the context's. Since: 0.1 */
RTAPI RTuint RTAPIENTRY rtQueueFrame(void);

/* Queues the scene of the last frame once more, seen by another camera. It is that of the frame
 * that this context queued or started last, as it was frozen then, seen by the camera that the
 * bound scene uses now (rtUseCamera, rtuCameraFromWall ...), in the frame buffer, viewport and
 * scissor of now; returns the frame's id. Uses the camera up; all else that the bound scene was
 * given waits for its next frame. All walls of a room and both eyes show the same moment this way,
 * and its trees are built once. The first view, too, has to be taken by a camera of its own: a
 * frame seen by the projection matrix is not kept. Not in an object.
 * Errors:  RT_INVALID_OPERATION  no camera is in use; no frame before, or one without a camera; no
 *                                frame buffer, or a stride that holds no row
 * Threads: the context's. Since: 0.1 */
RTAPI RTuint RTAPIENTRY rtQueueView(void);

/* How many frames of this context may be in flight; those of rtStartRendering included. 2 at the
 * start. A smaller number than there are now lets these go on.
 * Errors:  RT_INVALID_VALUE  n is 0
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtFrameDepth(RTuint n);

/* Waits until the frame has ended: its memory is no longer written to, and its callback is not
 * called any more. RT_TRUE if it is RT_DONE. Waiting again is legal and returns at once. In a
 * frame callback it does not wait: RT_TRUE only if the frame is RT_DONE already.
 * What went wrong while the frame was rendered is recorded, code and text, in the calling
 * thread's context, by the first rtWaitFrame or rtEndRendering for that frame on a thread that
 * has one.
 * Errors:  RT_INVALID_VALUE  unknown frame (returns RT_FALSE)
 *          what went wrong with the frame
 * Threads: any; no context needed. Since: 0.1 */
RTAPI RTboolean RTAPIENTRY rtWaitFrame(RTuint frame);

/* How far a frame is. RT_QUEUED: none of its tiles was started. RT_RENDERING: some were; also when
 * all are done and an earlier frame is not. RT_DONE: every pixel is in the frame buffer.
 * RT_CANCELLED: some pixels never will be. RT_FAILED: the library could not render it, see
 * rtWaitFrame. The last three stay.
 * Errors:  RT_INVALID_VALUE  unknown frame (returns RT_INVALID)
 * Threads: any; no context needed. Since: 0.1 */
RTAPI RTenum RTAPIENTRY rtFrameStatus(RTuint frame);

/* The share of the frame's tiles that are done or dropped: 0 to 1; never falls, and is 1 for every
 * frame that has ended, however it did.
 * Errors:  RT_INVALID_VALUE  unknown frame (returns 0)
 * Threads: any; no context needed. Since: 0.1 */
RTAPI RTfloat RTAPIENTRY rtFrameProgress(RTuint frame);

/* Drops the tiles of the frame that no thread has begun, and returns at once; the frame ends when
 * those under way are done, without waiting for earlier frames. Its pixels so far stay. A frame
 * that has ended, or all of whose tiles have been begun, is not changed: it becomes RT_DONE.
 * rtEndRendering returns for a cancelled frame as for any other.
 * Errors:  RT_INVALID_VALUE  unknown frame
 * Threads: any; no context needed. Since: 0.1 */
RTAPI void RTAPIENTRY rtCancelFrame(RTuint frame);

/* A function to be called while frames are rendered: those started from now on by any call of this
 * context; NULL: none (start).
 *   RT_FRAME_PROGRESS                  the pixels of the rectangle (x, y, w, h) are in the frame
 *                                      buffer; y counts from the bottom
 *   RT_DONE, RT_CANCELLED, RT_FAILED   the frame has ended so; (0, 0, w, h) is the whole picture.
 *                                      The last call for a frame, and the next frame's comes after
 *                                      it unless that is cancelled. Until it returns no later frame
 *                                      writes to this frame's memory, and rtWaitFrame waits.
 * It runs on threads of the library, for different rectangles on several at once, and must return
 * soon: it holds up the rendering. It may call rtWaitFrame (which does not wait there),
 * rtFrameStatus, rtFrameProgress and rtCancelFrame. Any other call of the library does nothing
 * there; the first is RT_INVALID_OPERATION, kept for rtWaitFrame or rtEndRendering of the frame,
 * which is done all the same. So is an exception that leaves cb. `user` is passed on; it has to
 * live until the frames started with it have ended. A frame without an id, after the last of
 * them, is RT_INVALID.
 * Errors:  None but those that every call can record.
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtSetFrameCallback(void(RTAPIENTRY *cb)(RTuint frame, RTenum event, RTint x,
                                                              RTint y, RTsizei w, RTsizei h,
                                                              void *user),
                                         void *user);

#ifdef __cplusplus
}
#endif
#endif
