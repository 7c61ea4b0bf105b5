/* SPDX-License-Identifier: MIT */
/* Vertex arrays, buffer objects, rectangles, as OpenGL has them. Part of openrt/rt.h.
 * Arrays are read by the calls that draw them, and not later: an application may change or free
 * them as soon as such a call returns. So are they where a display list is compiled. What is drawn
 * is what rtBegin, the attributes and vertices of each element, and rtEnd would draw. */
#ifndef OPENRT_RT_ARRAYS_H
#define OPENRT_RT_ARRAYS_H

#include "openrt/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Where a vertex array lies: `size` components of a type for each element, elements `stride` bytes
 * apart (0: without a gap). With a buffer bound to RT_ARRAY_BUFFER the pointer is an offset into
 * it. Integer colours and normals are scaled as by rtColor and rtNormal. The index array is kept
 * and never read: there are no colour indices. Nothing of this is kept in display lists.
 * Errors:  RT_INVALID_VALUE  a size that the array can not have; a negative stride
 *          RT_INVALID_ENUM   a type that the array can not have
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtVertexPointer(RTint size, RTenum type, RTsizei stride, const void *ptr);
RTAPI void RTAPIENTRY rtNormalPointer(RTenum type, RTsizei stride, const void *ptr);
RTAPI void RTAPIENTRY rtColorPointer(RTint size, RTenum type, RTsizei stride, const void *ptr);
RTAPI void RTAPIENTRY rtSecondaryColorPointer(RTint size, RTenum type, RTsizei stride,
                                              const void *pointer);
RTAPI void RTAPIENTRY rtTexCoordPointer(RTint size, RTenum type, RTsizei stride, const void *ptr);
RTAPI void RTAPIENTRY rtFogCoordPointer(RTenum type, RTsizei stride, const void *pointer);
RTAPI void RTAPIENTRY rtEdgeFlagPointer(RTsizei stride, const void *ptr);
RTAPI void RTAPIENTRY rtIndexPointer(RTenum type, RTsizei stride, const void *ptr);

/* Which vertex arrays are read: RT_VERTEX_ARRAY, RT_NORMAL_ARRAY, RT_COLOR_ARRAY,
 * RT_TEXTURE_COORD_ARRAY, RT_SECONDARY_COLOR_ARRAY, RT_FOG_COORD_ARRAY, RT_EDGE_FLAG_ARRAY,
 * RT_INDEX_ARRAY. rtInterleavedArrays sets and enables the arrays of a format (RT_V2F to
 * RT_T4F_C4F_N3F_V4F) and disables the others.
 * Errors:  RT_INVALID_ENUM   another array, another format
 *          RT_INVALID_VALUE  a negative stride
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtEnableClientState(RTenum cap);
RTAPI void RTAPIENTRY rtDisableClientState(RTenum cap);
RTAPI void RTAPIENTRY rtInterleavedArrays(RTenum format, RTsizei stride, const void *pointer);

/* The texture unit, RT_TEXTURE0 to RT_TEXTURE3, whose array of coordinates calls mean.
 * Errors:  RT_INVALID_ENUM  another unit
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtClientActiveTexture(RTenum texture);

/* The pointer of a vertex array: RT_VERTEX_ARRAY_POINTER and the like.
 * Errors:  RT_INVALID_ENUM   another name
 *          RT_INVALID_VALUE  params NULL
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtGetPointerv(RTenum pname, void **params);

/* Gives the attributes of element i of the enabled arrays, and its vertex: last, and if there is a
 * vertex array. Legal between rtBegin and rtEnd.
 * Errors:  RT_INVALID_VALUE      i negative
 *          RT_INVALID_OPERATION  an enabled array has no memory, its buffer is mapped or too short
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtArrayElement(RTint i);

/* Draw primitives of elements first to first + count - 1, or of those that indices name. Current
 * values are afterwards what they were before. The multiple forms draw one after the other, or
 * nothing where one of them is wrong. Of a drawing in which memory runs out (RT_OUT_OF_MEMORY) the
 * vertices that there was memory for are drawn.
 * Errors:  RT_INVALID_ENUM       unknown mode; indices are RT_UNSIGNED_BYTE, _SHORT or _INT
 *          RT_INVALID_VALUE      a negative first, count or drawcount; end < start
 *          RT_INVALID_OPERATION  an enabled array or the indices have no memory, their buffer is
 *                                mapped or too short
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtDrawArrays(RTenum mode, RTint first, RTsizei count);
RTAPI void RTAPIENTRY rtDrawElements(RTenum mode, RTsizei count, RTenum type, const void *indices);
RTAPI void RTAPIENTRY rtDrawRangeElements(RTenum mode, RTuint start, RTuint end, RTsizei count,
                                          RTenum type, const void *indices);
RTAPI void RTAPIENTRY rtMultiDrawArrays(RTenum mode, const RTint *first, const RTsizei *count,
                                        RTsizei drawcount);
RTAPI void RTAPIENTRY rtMultiDrawElements(RTenum mode, const RTsizei *count, RTenum type,
                                          const void *const *indices, RTsizei drawcount);

/* A polygon of the corners (x1, y1), (x2, y1), (x2, y2), (x1, y2) in the plane z = 0.
 * Errors:  RT_INVALID_VALUE  v1 or v2 NULL
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtRects(RTshort x1, RTshort y1, RTshort x2, RTshort y2);
RTAPI void RTAPIENTRY rtRecti(RTint x1, RTint y1, RTint x2, RTint y2);
RTAPI void RTAPIENTRY rtRectf(RTfloat x1, RTfloat y1, RTfloat x2, RTfloat y2);
RTAPI void RTAPIENTRY rtRectd(RTdouble x1, RTdouble y1, RTdouble x2, RTdouble y2);
RTAPI void RTAPIENTRY rtRectsv(const RTshort *v1, const RTshort *v2);
RTAPI void RTAPIENTRY rtRectiv(const RTint *v1, const RTint *v2);
RTAPI void RTAPIENTRY rtRectfv(const RTfloat *v1, const RTfloat *v2);
RTAPI void RTAPIENTRY rtRectdv(const RTdouble *v1, const RTdouble *v2);

/* Names of buffers, and which one RT_ARRAY_BUFFER or RT_ELEMENT_ARRAY_BUFFER means; 0: the
 * application's memory. Binding a name that does not exist makes a buffer. A buffer that is
 * deleted is bound nowhere any more; unknown names are ignored.
 * Errors:  RT_INVALID_VALUE  n negative, buffers NULL
 *          RT_INVALID_ENUM   another target
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtGenBuffers(RTsizei n, RTuint *buffers);
RTAPI void RTAPIENTRY rtDeleteBuffers(RTsizei n, const RTuint *buffers);
RTAPI RTboolean RTAPIENTRY rtIsBuffer(RTuint buffer);
RTAPI void RTAPIENTRY rtBindBuffer(RTenum target, RTuint buffer);

/* The bytes of the bound buffer: all of them anew (data NULL: zeros), or a part. `usage` is kept
 * to be asked for and has no other meaning.
 * Errors:  RT_INVALID_ENUM       another target or usage
 *          RT_INVALID_VALUE      a part outside of the buffer, a negative size, data NULL
 *          RT_INVALID_OPERATION  no buffer is bound; a part of a mapped buffer
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtBufferData(RTenum target, RTsizeiptr size, const void *data, RTenum usage);
RTAPI void RTAPIENTRY rtBufferSubData(RTenum target, RTintptr offset, RTsizeiptr size,
                                      const void *data);
RTAPI void RTAPIENTRY rtGetBufferSubData(RTenum target, RTintptr offset, RTsizeiptr size,
                                         void *data);

/* The bytes of the bound buffer for the application, until rtUnmapBuffer; a mapped buffer can not
 * be drawn from.
 * Errors:  RT_INVALID_ENUM       another target or access
 *          RT_INVALID_OPERATION  no buffer is bound; mapped already; not mapped
 * Threads: the context's. Since: 0.1 */
RTAPI void *RTAPIENTRY rtMapBuffer(RTenum target, RTenum access);
RTAPI RTboolean RTAPIENTRY rtUnmapBuffer(RTenum target);

/* Facts of the bound buffer: RT_BUFFER_SIZE, RT_BUFFER_USAGE, RT_BUFFER_ACCESS, RT_BUFFER_MAPPED;
 * RT_BUFFER_MAP_POINTER.
 * Errors:  RT_INVALID_ENUM       another target or name
 *          RT_INVALID_OPERATION  no buffer is bound
 *          RT_INVALID_VALUE      params NULL
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtGetBufferParameteriv(RTenum target, RTenum pname, RTint *params);
RTAPI void RTAPIENTRY rtGetBufferPointerv(RTenum target, RTenum pname, void **params);

#ifdef __cplusplus
}
#endif

#endif
