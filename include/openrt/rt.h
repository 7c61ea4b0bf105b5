/* SPDX-License-Identifier: MIT */
/* Ray tracing in the manner of OpenGL. C99, usable from C++. This header and those it includes are
 * the reference manual: each call says what it does, its errors, its threads and its release.
 *
 *   rt_core.h      start and end, contexts, errors, settings of the library
 *   rt_state.h     matrices, current values, enables, queries of state
 *   rt_fixed.h     fixed function: lights, materials, fog, blending, attribute stacks
 *   rt_objects.h   primitives, objects, instances
 *   rt_lists.h     display lists
 *   rt_arrays.h    vertex arrays, buffer objects, rectangles
 *   rt_shaders.h   shader classes, shaders, their parameters
 *   rt_textures.h  images for shaders
 *   rt_pixels.h    raster position, bitmaps, rectangles of pixels
 *   rt_window.h    clearing, scissor, depth range, reading pixels back
 *   rt_frame.h     frame buffers, what a frame consists of, rendering
 *   rt_queue.h     several scenes, frames in flight
 *   rt_query.h     rays from the application
 *   rt_gl.h        the functions of OpenGL 1.5 that this release declares and refuses
 *
 * A program in short:
 *
 *     rtInit(&argc, argv);
 *     rtSetFrameBuffer(pixels, width, height, RT_RGBA_8);
 *     rtMatrixMode(RT_PROJECTION);  rtPerspective(60, (double)width / height, 0.1, 100);
 *     rtMatrixMode(RT_MODELVIEW);   rtLookAt(0, 0, 5, 0, 0, 0, 0, 1, 0);
 *     RTuint object = rtNewObject(RT_DEFINE);
 *     rtBegin(RT_TRIANGLES);  rtVertex3f(...);  ...  rtEnd();
 *     rtEndObject();
 *     for (each frame) { rtInstantiateObject(object); rtRender(); }
 *     rtExit();
 *
 * Rules that hold for every call, so that the calls below do not repeat them:
 *
 * Errors. A wrong call has no effect but to record an error; ids it would have returned are
 *   RT_INVALID. The first error stays until rtGetError reads it. Without a current context every
 *   call does nothing and rtGetError returns RT_INVALID_OPERATION. Memory that runs out is
 *   RT_OUT_OF_MEMORY, and the call has no other effect.
 * Places. Between rtBegin and rtEnd only rtVertex, rtColor, rtSecondaryColor, rtFogCoord, rtNormal,
 *   rtTexCoord, rtMultiTexCoord, rtEdgeFlag, rtMaterial, rtParameter, rtArrayElement and rtCallList
 *   calls are legal, and what says so; any other records RT_INVALID_OPERATION there. "Not in an
 *   object" means that the call records it between rtNewObject and rtEndObject too.
 * Threads. "The context's" is the thread on which the context is current (rtMakeCurrent).
 *   Different contexts may be used by different threads at once.
 * Ids start at 1; 0 names a default. Ids of one context mean nothing in another.
 * Units. Angles: degrees. Places and sizes in the window: pixels, from the lower left. Lengths: the
 *   scene's own unit. Matrices are column-major: m[12], m[13], m[14] is the translation.
 * Frame rule. Instances, lights, camera, environment, rendering object and loose geometry are given
 *   anew for every frame. Objects, shaders, textures, the frame buffer and all other state last.
 */
#ifndef OPENRT_RT_H
#define OPENRT_RT_H

#include "openrt/enums.h"
#include "openrt/rt_arrays.h"
#include "openrt/rt_core.h"
#include "openrt/rt_fixed.h"
#include "openrt/rt_frame.h"
#include "openrt/rt_gl.h"
#include "openrt/rt_lists.h"
#include "openrt/rt_objects.h"
#include "openrt/rt_pixels.h"
#include "openrt/rt_query.h"
#include "openrt/rt_queue.h"
#include "openrt/rt_shaders.h"
#include "openrt/rt_state.h"
#include "openrt/rt_textures.h"
#include "openrt/rt_window.h"
#include "openrt/types.h"
#include "openrt/version.h"

#endif
