/* SPDX-License-Identifier: MIT */
/* Display lists, as OpenGL has them. Part of openrt/rt.h.
 * A list is a recording of calls, with every effect that they have on the state. Calls that
 * OpenGL carries out at once while a list is compiled are so here: what makes or deletes names,
 * queries, pixel storage, vertex array pointers, rtFinish and the like, and of our own calls those
 * that define objects and render frames. All others are kept: placing objects and binding shaders
 * too. What a call's pointers point to is copied then; its errors show when the list is called.
 * Each longest run of primitives, colours, normals, texture coordinates and materials is compiled
 * once, at its first use, and placed as an object is, with the matrix, state, shader and current
 * values of that moment. Where it can not be placed (between rtBegin and rtEnd, in an object,
 * under a matrix without an inverse or with a projection in it, where polygons are drawn as points
 * or lines) its calls are made one by one. */
#ifndef OPENRT_RT_LISTS_H
#define OPENRT_RT_LISTS_H

#include "openrt/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Makes `range` empty lists with consecutive names and returns the first; 0 where there is no such
 * room, or `range` is 0. rtDeleteLists forgets lists and empties their names; names without a list
 * are ignored. A list under way in a call stays until the call returns.
 * Errors:  RT_INVALID_VALUE  a negative range
 * Threads: the context's. Since: 0.1 */
RTAPI RTuint RTAPIENTRY rtGenLists(RTsizei range);
RTAPI void RTAPIENTRY rtDeleteLists(RTuint list, RTsizei range);
RTAPI RTboolean RTAPIENTRY rtIsList(RTuint list);

/* Starts a list under a name, which need not come from rtGenLists, and ends it. Until rtEndList
 * the calls are kept (RT_COMPILE), or kept and made (RT_COMPILE_AND_EXECUTE). A list of that name
 * stays until then. Not in an object, and rtNewObject is not legal while a list is compiled.
 * Errors:  RT_INVALID_VALUE      list 0
 *          RT_INVALID_ENUM       another mode
 *          RT_INVALID_OPERATION  rtNewList while a list is compiled, rtEndList while none is
 *          RT_OUT_OF_MEMORY      by rtEndList: the calls did not fit; the name keeps what it had
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtNewList(RTuint list, RTenum mode);
RTAPI void RTAPIENTRY rtEndList(void);

/* Calls a list, or n of them with names base + lists[i]; legal between rtBegin and rtEnd. Unknown
 * names are ignored, and so are calls more than 64 levels deep. `type` is RT_BYTE to RT_FLOAT, or
 * RT_2_BYTES, RT_3_BYTES or RT_4_BYTES, the highest byte first. The base is 0 at the start.
 * Errors:  RT_INVALID_VALUE      n negative, lists NULL
 *          RT_INVALID_ENUM       another type
 *          RT_INVALID_OPERATION  lists that call each other more than a million times
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtCallList(RTuint list);
RTAPI void RTAPIENTRY rtCallLists(RTsizei n, RTenum type, const void *lists);
RTAPI void RTAPIENTRY rtListBase(RTuint base);

#ifdef __cplusplus
}
#endif

#endif
