/* SPDX-License-Identifier: MIT */
/* Start and end, contexts, errors, settings of the library. Part of openrt/rt.h.
 *
 * Processes. A program may end in any way, at any time: by return, exit or a signal, on any
 *   thread, with frames in flight, with rtExit or without. The child of a fork may call exec or
 *   end, on any way too; whatever else it asks of the library has no effect, and rtGetError answers
 *   RT_INVALID_OPERATION. Floating-point state, signal mask and handlers, locale and thread
 *   affinity of the application are left as they are; signals are never delivered to the library's
 *   threads. Threads that had no frame for some seconds end, and are started again by the next one:
 *   a process whose main thread calls pthread_exit ends with the last of the others. */
#ifndef OPENRT_RT_CORE_H
#define OPENRT_RT_CORE_H

#include "openrt/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Makes a fresh default context and makes it current on the calling thread. A second call ends
 * the default context of the first. Both pointers may be NULL; otherwise the arguments below are
 * taken out of argv, and *argcp is lowered:
 *   --rt-threads N        threads that render, 0 = all cores (environment: OPENRT_THREADS)
 *   --rt-isa NAME         generic, sse4, avx2, avx512, neon (environment: OPENRT_ISA)
 *   --rt-precision NAME   fast, watertight or precise
 *   --rt-samples N        as rtSamples
 *   --rt-offscreen N      for rtut windows, as --rt-size WxH, --rt-output PATTERN and
 *                         --rt-depth PATTERN: see openrt/rtut.h
 * A bad value prints one line on stderr and is ignored. The environment variable OPENRT_LOG, a
 * file's name or `stderr`, gets a line for every error that any context records; OPENRT_TRACE names
 * a new file that gets all calls (openrt-trace); set-uid programs ignore all of these variables.
 * Errors:  None but those that every call can record.
 * Threads: any. Since: 0.1 */
RTAPI void RTAPIENTRY rtInit(int *argcp, char *argv[]);

/* Waits for the frames in flight and frees all contexts and compiled scenes of the process.
 * Legal at any time, also between rtBegin and rtEnd, twice, and without rtInit. A process that
 * never calls it ends cleanly too.
 * Threads: any, while no other thread is inside a call. Since: 0.1 */
RTAPI void RTAPIENTRY rtExit(void);

/* A new context, not current anywhere; NULL if memory ran out. Each context has its own state,
 * objects and worker threads; these are started by its first frame.
 * Threads: any; no context needed. Since: 0.1 */
RTAPI RTcontext RTAPIENTRY rtCreateContext(void);

/* Makes a context current on the calling thread; NULL: none is. RT_TRUE if it is now current.
 * An error is recorded in the context that stays current.
 * Errors:  RT_INVALID_VALUE      unknown context
 *          RT_INVALID_OPERATION  it is current on another thread
 * Threads: any; no context needed. Since: 0.1 */
RTAPI RTboolean RTAPIENTRY rtMakeCurrent(RTcontext context);

/* Waits for the context's frames and ends it; it is no longer current on this thread. One that is
 * current on another thread lives until it no longer is. NULL is ignored.
 * Errors:  RT_INVALID_VALUE  unknown context
 * Threads: any; no context needed. Since: 0.1 */
RTAPI void RTAPIENTRY rtDestroyContext(RTcontext context);

/* The context that is current on the calling thread, or NULL.
 * Threads: any; no context needed. Since: 0.1 */
RTAPI RTcontext RTAPIENTRY rtGetCurrentContext(void);

/* The first error recorded since the last call, which it clears; RT_NO_ERROR if there was none.
 * Errors:  RT_INVALID_OPERATION  between rtBegin and rtEnd (returns RT_NO_ERROR there)
 * Threads: the context's. Since: 0.1 */
RTAPI RTenum RTAPIENTRY rtGetError(void);

/* The text of the error that rtGetError would return; after it was read, of the one it returned
 * last. Never NULL; "" if there was none. English, one line, without the function's name. Valid
 * until the next call on this context. Legal everywhere.
 * Errors:  None.
 * Threads: the context's. Since: 0.1 */
RTAPI const char *RTAPIENTRY rtGetErrorText(void);

/* Calls cb for every error that this context records; those that rtGetError drops too, on the
 * thread and during the call that caused it. NULL: none (start). Errors recorded while cb runs
 * do not call it again. The strings live until cb returns.
 * Errors:  None but those that every call can record.
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtErrorCallback(void(RTAPIENTRY *cb)(RTenum code, const char *function,
                                                           const char *text, void *user),
                                      void *user);

/* Text about the library: RT_VERSION (that of OpenGL that its calls follow, and its own),
 * RT_VENDOR, RT_RENDERER, RT_EXTENSIONS (OpenGL's, with spaces between: those that became part of
 * it by 1.5 and work whole; gl.h has their names), RT_ISA (the instruction set that the kernels
 * use: generic, sse4, avx2, avx512 or neon), RT_ISA_NAMES (those that library and machine have,
 * best first, with spaces between), RT_SHADER_FOLDERS (where shader libraries are
 * looked for, with colons between). Lives as long as the library, RT_SHADER_FOLDERS until it is
 * asked for again on the thread; NULL on error.
 * Errors:  RT_INVALID_ENUM  another name
 * Threads: the context's. Since: 0.1 */
RTAPI const RTubyte *RTAPIENTRY rtGetString(RTenum name);

/* How many threads render and build for this context, 0 to 1024; 0 = all cores (start, unless
 * OPENRT_THREADS or --rt-threads says otherwise). Waits for frames in flight.
 * Errors:  RT_INVALID_VALUE  n above 1024
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtThreads(RTuint n);

/* How exact intersections are: rtHint(RT_PRECISION_HINT, mode); read when a frame is started or a
 * scene compiled. RT_FASTEST: edges between triangles may let rays through, rarely for more speed.
 * RT_DONT_CARE (start): watertight. RT_NICEST: precise, the nearest hit that exact arithmetic finds
 * for the numbers as given. OpenGL's own hints are kept without effect. Not in an object.
 * Errors:  RT_INVALID_ENUM  target or mode is no such token
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtHint(RTenum target, RTenum mode);

#ifdef __cplusplus
}
#endif
#endif
