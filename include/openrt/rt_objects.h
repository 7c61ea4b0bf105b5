/* SPDX-License-Identifier: MIT */
/* Primitives, objects and instances. Part of openrt/rt.h.
 * An object is geometry with its attributes and shaders, compiled once. An instance places it in
 * this frame. Primitives outside objects are loose geometry: each longest run of them between
 * instances is an implicit instance with object id 0, in its place in the order of submission. */
#ifndef OPENRT_RT_OBJECTS_H
#define OPENRT_RT_OBJECTS_H

#include "openrt/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Starts and ends primitives. With vertices v0, v1, ... the triangles are
 *   RT_TRIANGLES       (0,1,2) (3,4,5) ...
 *   RT_TRIANGLE_STRIP  (0,1,2) (2,1,3) (2,3,4) ...: every other one turned
 *   RT_TRIANGLE_FAN    (0,1,2) (0,2,3) ...
 *   RT_QUADS           (0,1,2) (0,2,3), (4,5,6) (4,6,7) ...
 *   RT_QUAD_STRIP      (0,1,3) (0,3,2), (2,3,5) (2,5,4) ...
 *   RT_POLYGON         (0,1,2) (0,2,3) ...
 * and draws in pixels of the window, for camera rays alone, as OpenGL does:
 *   RT_POINTS          each, rtPointSize large
 *   RT_LINES           (0,1) (2,3) ...
 *   RT_LINE_STRIP      (0,1) (1,2) ...
 *   RT_LINE_LOOP       as a strip, and from the last to 0
 * rtLineWidth wide. Points and lines have fixed function's colour whatever shader is bound, and no
 * shadow, reflection or rtIntersect meets them. They need the projection matrix: with a camera
 * shader they are not seen. Incomplete primitives are dropped.
 * Errors:  RT_INVALID_OPERATION  rtBegin inside rtBegin, rtEnd without
 *          RT_INVALID_ENUM       unknown mode
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtBegin(RTenum mode);
RTAPI void RTAPIENTRY rtEnd(void);

/* A vertex, at the model-view matrix times (x, y, z, w), divided by w; z = 0 and w = 1 if not
 * given. It takes the current normal, texture coordinate, colour and per-vertex parameters. A
 * result that is not finite drops the triangles of the vertex; they are counted and keep their
 * numbers.
 * Errors:  RT_INVALID_OPERATION  not between rtBegin and rtEnd, or the bound shader is no surface
 *          RT_INVALID_VALUE      v NULL
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtVertex2s(RTshort x, RTshort y);
RTAPI void RTAPIENTRY rtVertex2i(RTint x, RTint y);
RTAPI void RTAPIENTRY rtVertex2f(RTfloat x, RTfloat y);
RTAPI void RTAPIENTRY rtVertex2d(RTdouble x, RTdouble y);
RTAPI void RTAPIENTRY rtVertex2sv(const RTshort *v);
RTAPI void RTAPIENTRY rtVertex2iv(const RTint *v);
RTAPI void RTAPIENTRY rtVertex2fv(const RTfloat *v);
RTAPI void RTAPIENTRY rtVertex2dv(const RTdouble *v);
RTAPI void RTAPIENTRY rtVertex3s(RTshort x, RTshort y, RTshort z);
RTAPI void RTAPIENTRY rtVertex3i(RTint x, RTint y, RTint z);
RTAPI void RTAPIENTRY rtVertex3f(RTfloat x, RTfloat y, RTfloat z);
RTAPI void RTAPIENTRY rtVertex3d(RTdouble x, RTdouble y, RTdouble z);
RTAPI void RTAPIENTRY rtVertex3sv(const RTshort *v);
RTAPI void RTAPIENTRY rtVertex3iv(const RTint *v);
RTAPI void RTAPIENTRY rtVertex3fv(const RTfloat *v);
RTAPI void RTAPIENTRY rtVertex3dv(const RTdouble *v);
RTAPI void RTAPIENTRY rtVertex4s(RTshort x, RTshort y, RTshort z, RTshort w);
RTAPI void RTAPIENTRY rtVertex4i(RTint x, RTint y, RTint z, RTint w);
RTAPI void RTAPIENTRY rtVertex4f(RTfloat x, RTfloat y, RTfloat z, RTfloat w);
RTAPI void RTAPIENTRY rtVertex4d(RTdouble x, RTdouble y, RTdouble z, RTdouble w);
RTAPI void RTAPIENTRY rtVertex4sv(const RTshort *v);
RTAPI void RTAPIENTRY rtVertex4iv(const RTint *v);
RTAPI void RTAPIENTRY rtVertex4fv(const RTfloat *v);
RTAPI void RTAPIENTRY rtVertex4dv(const RTdouble *v);

/* Starts a new object and returns its id; RT_INVALID on error. Until rtEndObject, geometry goes
 * into the object, whose coordinates are its own: the matrix mode is RT_MODELVIEW, the matrix the
 * identity. Matrices, matrix mode and current attributes are restored by rtEndObject. Colours,
 * normals and texture coordinates that the object does not set come from the current values when
 * it is instantiated. RT_DEFINE_AND_INSTANTIATE adds an instance at the end, with the matrix in
 * force now. Not in an object.
 * Errors:  RT_INVALID_ENUM       mode is neither RT_DEFINE nor RT_DEFINE_AND_INSTANTIATE
 *          RT_INVALID_OPERATION  in an object, or while a display list is compiled
 * Threads: the context's. Since: 0.1 */
RTAPI RTuint RTAPIENTRY rtNewObject(RTenum mode);

/* Ends the object begun by rtNewObject or rtReplaceObject and compiles it; from here on it never
 * changes. If memory runs out the object stays open, as it was.
 * Errors:  RT_INVALID_OPERATION  no object is open
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtEndObject(void);

/* Defines the geometry of an existing id anew, as rtNewObject(RT_DEFINE) does. Until rtEndObject
 * has succeeded the old one stands; frames in flight, instances already given and objects that
 * nest the old one keep it. Not in an object.
 * Errors:  RT_INVALID_VALUE      unknown object
 *          RT_INVALID_OPERATION  in an object, or while a display list is compiled
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtReplaceObject(RTuint object);

/* New positions for vertices of an object: three floats each, for first to first + count - 1 in the
 * order in which rtVertex gave them; the triangles stay the same ones, with their numbers, normals
 * and other attributes. Positions are in the object's coordinates: matrices that were in force in
 * the object do not act on them. A position that is not finite drops the triangles of the vertex,
 * and triangles without area are dropped, both until a later update makes them whole. The memory
 * may be used again at once. count 0 does nothing.
 * The object is made anew beside the old one, which frames in flight, instances already given and
 * objects that nest it keep; what does not change, such as attributes, is shared with it. Time is
 * proportional to the whole object, whatever the count: update a mesh in one call. If memory runs
 * out the object stays as it was. Not in an object.
 * Errors:  RT_INVALID_VALUE  unknown object; count negative; vertices that the object does not
 *                            have; xyz NULL with count above 0
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtUpdateObject(RTuint object, RTuint first, RTsizei count,
                                     const RTfloat *xyz);

/* Forgets the id of an object; frames in flight, this frame's instances and other objects that use
 * the object keep it. Not in an object.
 * Errors:  RT_INVALID_VALUE  unknown object
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtRemoveObject(RTuint object);

/* An instance of an object at the model-view matrix: for this frame, or, in an object, as a part
 * of that object, as it is compiled now. A matrix without an inverse gives an instance that is
 * never hit, is counted, and keeps its number.
 * Errors:  RT_INVALID_VALUE      unknown object
 *          RT_INVALID_OPERATION  the object under definition; a matrix whose last row is not a
 *                                multiple of (0, 0, 0, 1)
 *          RT_STACK_OVERFLOW     objects nest deeper than RT_MAX_OBJECT_DEPTH
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtInstantiateObject(RTuint object);

/* An instance with another shader: as by rtInstantiateObject, with `shader` in the place of every
 * shader of the object; nothing is copied.
 * Errors:  RT_INVALID_VALUE      unknown object or shader
 *          RT_INVALID_OPERATION  not a surface shader; the object under definition; a matrix whose
 *                                last row is not a multiple of (0, 0, 0, 1)
 *          RT_STACK_OVERFLOW     objects nest deeper than RT_MAX_OBJECT_DEPTH
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtInstantiateObjectShader(RTuint object, RTuint shader);

/* An instance with other shaders: as by rtInstantiateObject, with shaders[i] in the place of the
 * i-th shader of the object in order of first use (rtGetObjectiv, RT_OBJECT_SHADERS), in the
 * objects nested in it too. 0 keeps the object's own.
 * Errors:  RT_INVALID_VALUE      unknown object or shader; n negative or above the number of the
 *                                object's shaders; shaders NULL with n above 0
 *          RT_INVALID_OPERATION  not a surface shader; the object under definition; a matrix whose
 *                                last row is not a multiple of (0, 0, 0, 1)
 *          RT_STACK_OVERFLOW     objects nest deeper than RT_MAX_OBJECT_DEPTH
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtInstantiateObjectShaders(RTuint object, RTsizei n, const RTuint *shaders);

/* How objects are built; state, read by rtEndObject. Legal in objects.
 *   RT_BUILD_QUALITY  RT_NICEST, RT_DONT_CARE (start), RT_FASTEST, RT_KD_TREE
 *   RT_LAZY_BUILD     RT_TRUE, RT_FALSE (start)
 * An object has one tree. RT_NICEST builds a tree of boxes by the surface area heuristic, in which
 * triangles are cut where that pays (Stich and others, 2009). RT_DONT_CARE builds one over bins and
 * cuts nothing (Wald, 2007); an object that is defined again, or updated, gets what pays: the fast
 * tree, unless the frames started since its last build had more than some eight rays a triangle.
 * RT_FASTEST builds a tree of boxes along a space-filling curve in linear time. RT_KD_TREE builds
 * the kd-tree that the surface area heuristic finds best, exactly (Wald and Havran, 2006): something
 * to compare with, for it takes longest to build and rays take longer in it. Hits do not depend on
 * any of this. After rtUpdateObject the old tree of boxes is fitted to the new positions (Lauterbach
 * and others, 2006) until rays would take half as long again as in a new one, which cuts nothing; a
 * kd-tree is built anew. Primitives outside objects get the fast tree, a better one once they stay.
 * RT_LAZY_BUILD builds when the first ray reaches an instance of the object: objects that no ray
 * reaches have no tree. Threads that come meanwhile wait. If memory runs out then, the frame fails
 * with RT_OUT_OF_MEMORY; the next frame tries again.
 * Errors:  RT_INVALID_ENUM  unknown hint, or value not one of the hint's
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtObjectHint(RTenum hint, RTenum value);

/* Facts of an object:
 *   RT_OBJECT_SHADER_COUNT  how many shaders it uses, those of nested objects included
 *   RT_OBJECT_SHADERS       their ids in order of first use
 * Errors:  RT_INVALID_VALUE  unknown object, params NULL
 *          RT_INVALID_ENUM   another name
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtGetObjectiv(RTuint object, RTenum pname, RTint *params);

#ifdef __cplusplus
}
#endif
#endif
