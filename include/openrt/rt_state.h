/* SPDX-License-Identifier: MIT */
/* Matrices, current values, enables, queries of state. Part of openrt/rt.h. */
#ifndef OPENRT_RT_STATE_H
#define OPENRT_RT_STATE_H

#include "openrt/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The stack that the matrix calls act on: RT_MODELVIEW (start), RT_PROJECTION or RT_TEXTURE. Each
 * holds 32 matrices. Vertices and instances are placed by the model-view matrix. Without a camera
 * shader the eye is at the origin, looking along -z, and the projection matrix is the camera.
 * Matrices are kept in double. All matrix calls are legal in objects.
 * Errors:  RT_INVALID_ENUM  another mode
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtMatrixMode(RTenum mode);

/* Saves the current matrix, or restores the one saved last.
 * Errors:  RT_STACK_OVERFLOW   32 matrices are on the stack
 *          RT_STACK_UNDERFLOW  nothing saved; in an object, nothing saved since rtNewObject
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtPushMatrix(void);
RTAPI void RTAPIENTRY rtPopMatrix(void);

/* Replaces the current matrix, or multiplies it from the right by m. Transpose: m is row-major.
 * Errors:  RT_INVALID_VALUE  m NULL
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtLoadIdentity(void);
RTAPI void RTAPIENTRY rtLoadMatrixf(const RTfloat *m);
RTAPI void RTAPIENTRY rtLoadMatrixd(const RTdouble *m);
RTAPI void RTAPIENTRY rtMultMatrixf(const RTfloat *m);
RTAPI void RTAPIENTRY rtMultMatrixd(const RTdouble *m);
RTAPI void RTAPIENTRY rtLoadTransposeMatrixf(const RTfloat *m);
RTAPI void RTAPIENTRY rtLoadTransposeMatrixd(const RTdouble *m);
RTAPI void RTAPIENTRY rtMultTransposeMatrixf(const RTfloat *m);
RTAPI void RTAPIENTRY rtMultTransposeMatrixd(const RTdouble *m);

/* Multiply the current matrix by a rotation, a scaling or a translation. The rotation is by `angle`
 * degrees about (x, y, z), anticlockwise for a viewer whom the axis points at; a zero axis gives
 * none.
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtRotatef(RTfloat angle, RTfloat x, RTfloat y, RTfloat z);
RTAPI void RTAPIENTRY rtRotated(RTdouble angle, RTdouble x, RTdouble y, RTdouble z);
RTAPI void RTAPIENTRY rtScalef(RTfloat x, RTfloat y, RTfloat z);
RTAPI void RTAPIENTRY rtScaled(RTdouble x, RTdouble y, RTdouble z);
RTAPI void RTAPIENTRY rtTranslatef(RTfloat x, RTfloat y, RTfloat z);
RTAPI void RTAPIENTRY rtTranslated(RTdouble x, RTdouble y, RTdouble z);

/* Multiply the current matrix by a projection: OpenGL's glFrustum and glOrtho, GLU's
 * gluPerspective (fovy, the whole vertical angle, between 0 and 180 degrees) and gluLookAt.
 * Errors:  RT_INVALID_VALUE  OpenGL's: left = right, bottom = top, near = far; rtFrustum and
 *                            rtPerspective: near or far not above 0; an argument that is not
 *                            finite; fovy or aspect out of range; rtLookAt: eye = centre, or the
 *                            up vector along the line of sight
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtFrustum(RTdouble left, RTdouble right, RTdouble bottom, RTdouble top,
                                RTdouble zNear, RTdouble zFar);
RTAPI void RTAPIENTRY rtOrtho(RTdouble left, RTdouble right, RTdouble bottom, RTdouble top,
                              RTdouble zNear, RTdouble zFar);
RTAPI void RTAPIENTRY rtPerspective(RTdouble fovy, RTdouble aspect, RTdouble zNear, RTdouble zFar);
RTAPI void RTAPIENTRY rtLookAt(RTdouble eyeX, RTdouble eyeY, RTdouble eyeZ, RTdouble centerX,
                               RTdouble centerY, RTdouble centerZ, RTdouble upX, RTdouble upY,
                               RTdouble upZ);

/* The current normal; (0, 0, 1) at the start. Goes through the inverse transpose of the model-view
 * matrix at each vertex; need not have length 1. Integers as in OpenGL: the type's range is mapped
 * to -1..1. With two components z is 0; a fourth is ignored. Where no normal was ever given,
 * programmable surfaces see the geometric normal. Legal everywhere.
 * Errors:  RT_INVALID_VALUE  v NULL
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtNormal2s(RTshort x, RTshort y);
RTAPI void RTAPIENTRY rtNormal2i(RTint x, RTint y);
RTAPI void RTAPIENTRY rtNormal2f(RTfloat x, RTfloat y);
RTAPI void RTAPIENTRY rtNormal2d(RTdouble x, RTdouble y);
RTAPI void RTAPIENTRY rtNormal2sv(const RTshort *v);
RTAPI void RTAPIENTRY rtNormal2iv(const RTint *v);
RTAPI void RTAPIENTRY rtNormal2fv(const RTfloat *v);
RTAPI void RTAPIENTRY rtNormal2dv(const RTdouble *v);
RTAPI void RTAPIENTRY rtNormal3b(RTbyte x, RTbyte y, RTbyte z);
RTAPI void RTAPIENTRY rtNormal3s(RTshort x, RTshort y, RTshort z);
RTAPI void RTAPIENTRY rtNormal3i(RTint x, RTint y, RTint z);
RTAPI void RTAPIENTRY rtNormal3f(RTfloat x, RTfloat y, RTfloat z);
RTAPI void RTAPIENTRY rtNormal3d(RTdouble x, RTdouble y, RTdouble z);
RTAPI void RTAPIENTRY rtNormal3bv(const RTbyte *v);
RTAPI void RTAPIENTRY rtNormal3sv(const RTshort *v);
RTAPI void RTAPIENTRY rtNormal3iv(const RTint *v);
RTAPI void RTAPIENTRY rtNormal3fv(const RTfloat *v);
RTAPI void RTAPIENTRY rtNormal3dv(const RTdouble *v);
RTAPI void RTAPIENTRY rtNormal4s(RTshort x, RTshort y, RTshort z, RTshort w);
RTAPI void RTAPIENTRY rtNormal4i(RTint x, RTint y, RTint z, RTint w);
RTAPI void RTAPIENTRY rtNormal4f(RTfloat x, RTfloat y, RTfloat z, RTfloat w);
RTAPI void RTAPIENTRY rtNormal4d(RTdouble x, RTdouble y, RTdouble z, RTdouble w);
RTAPI void RTAPIENTRY rtNormal4sv(const RTshort *v);
RTAPI void RTAPIENTRY rtNormal4iv(const RTint *v);
RTAPI void RTAPIENTRY rtNormal4fv(const RTfloat *v);
RTAPI void RTAPIENTRY rtNormal4dv(const RTdouble *v);

/* The current texture coordinate; (0, 0, 0, 1) at the start and where not given. Legal everywhere.
 * Errors:  RT_INVALID_VALUE  v NULL
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtTexCoord1s(RTshort s);
RTAPI void RTAPIENTRY rtTexCoord1i(RTint s);
RTAPI void RTAPIENTRY rtTexCoord1f(RTfloat s);
RTAPI void RTAPIENTRY rtTexCoord1d(RTdouble s);
RTAPI void RTAPIENTRY rtTexCoord1sv(const RTshort *v);
RTAPI void RTAPIENTRY rtTexCoord1iv(const RTint *v);
RTAPI void RTAPIENTRY rtTexCoord1fv(const RTfloat *v);
RTAPI void RTAPIENTRY rtTexCoord1dv(const RTdouble *v);
RTAPI void RTAPIENTRY rtTexCoord2s(RTshort s, RTshort t);
RTAPI void RTAPIENTRY rtTexCoord2i(RTint s, RTint t);
RTAPI void RTAPIENTRY rtTexCoord2f(RTfloat s, RTfloat t);
RTAPI void RTAPIENTRY rtTexCoord2d(RTdouble s, RTdouble t);
RTAPI void RTAPIENTRY rtTexCoord2sv(const RTshort *v);
RTAPI void RTAPIENTRY rtTexCoord2iv(const RTint *v);
RTAPI void RTAPIENTRY rtTexCoord2fv(const RTfloat *v);
RTAPI void RTAPIENTRY rtTexCoord2dv(const RTdouble *v);
RTAPI void RTAPIENTRY rtTexCoord3s(RTshort s, RTshort t, RTshort r);
RTAPI void RTAPIENTRY rtTexCoord3i(RTint s, RTint t, RTint r);
RTAPI void RTAPIENTRY rtTexCoord3f(RTfloat s, RTfloat t, RTfloat r);
RTAPI void RTAPIENTRY rtTexCoord3d(RTdouble s, RTdouble t, RTdouble r);
RTAPI void RTAPIENTRY rtTexCoord3sv(const RTshort *v);
RTAPI void RTAPIENTRY rtTexCoord3iv(const RTint *v);
RTAPI void RTAPIENTRY rtTexCoord3fv(const RTfloat *v);
RTAPI void RTAPIENTRY rtTexCoord3dv(const RTdouble *v);
RTAPI void RTAPIENTRY rtTexCoord4s(RTshort s, RTshort t, RTshort r, RTshort q);
RTAPI void RTAPIENTRY rtTexCoord4i(RTint s, RTint t, RTint r, RTint q);
RTAPI void RTAPIENTRY rtTexCoord4f(RTfloat s, RTfloat t, RTfloat r, RTfloat q);
RTAPI void RTAPIENTRY rtTexCoord4d(RTdouble s, RTdouble t, RTdouble r, RTdouble q);
RTAPI void RTAPIENTRY rtTexCoord4sv(const RTshort *v);
RTAPI void RTAPIENTRY rtTexCoord4iv(const RTint *v);
RTAPI void RTAPIENTRY rtTexCoord4fv(const RTfloat *v);
RTAPI void RTAPIENTRY rtTexCoord4dv(const RTdouble *v);

/* The current colour; opaque white at the start; alpha is 1 where not given. Integers as in
 * OpenGL: unsigned ranges are mapped to 0..1, signed ones to -1..1. Not clamped. Legal everywhere.
 * Errors:  RT_INVALID_VALUE  v NULL
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtColor3b(RTbyte red, RTbyte green, RTbyte blue);
RTAPI void RTAPIENTRY rtColor3s(RTshort red, RTshort green, RTshort blue);
RTAPI void RTAPIENTRY rtColor3i(RTint red, RTint green, RTint blue);
RTAPI void RTAPIENTRY rtColor3f(RTfloat red, RTfloat green, RTfloat blue);
RTAPI void RTAPIENTRY rtColor3d(RTdouble red, RTdouble green, RTdouble blue);
RTAPI void RTAPIENTRY rtColor3ub(RTubyte red, RTubyte green, RTubyte blue);
RTAPI void RTAPIENTRY rtColor3us(RTushort red, RTushort green, RTushort blue);
RTAPI void RTAPIENTRY rtColor3ui(RTuint red, RTuint green, RTuint blue);
RTAPI void RTAPIENTRY rtColor3bv(const RTbyte *v);
RTAPI void RTAPIENTRY rtColor3sv(const RTshort *v);
RTAPI void RTAPIENTRY rtColor3iv(const RTint *v);
RTAPI void RTAPIENTRY rtColor3fv(const RTfloat *v);
RTAPI void RTAPIENTRY rtColor3dv(const RTdouble *v);
RTAPI void RTAPIENTRY rtColor3ubv(const RTubyte *v);
RTAPI void RTAPIENTRY rtColor3usv(const RTushort *v);
RTAPI void RTAPIENTRY rtColor3uiv(const RTuint *v);
RTAPI void RTAPIENTRY rtColor4b(RTbyte red, RTbyte green, RTbyte blue, RTbyte alpha);
RTAPI void RTAPIENTRY rtColor4s(RTshort red, RTshort green, RTshort blue, RTshort alpha);
RTAPI void RTAPIENTRY rtColor4i(RTint red, RTint green, RTint blue, RTint alpha);
RTAPI void RTAPIENTRY rtColor4f(RTfloat red, RTfloat green, RTfloat blue, RTfloat alpha);
RTAPI void RTAPIENTRY rtColor4d(RTdouble red, RTdouble green, RTdouble blue, RTdouble alpha);
RTAPI void RTAPIENTRY rtColor4ub(RTubyte red, RTubyte green, RTubyte blue, RTubyte alpha);
RTAPI void RTAPIENTRY rtColor4us(RTushort red, RTushort green, RTushort blue, RTushort alpha);
RTAPI void RTAPIENTRY rtColor4ui(RTuint red, RTuint green, RTuint blue, RTuint alpha);
RTAPI void RTAPIENTRY rtColor4bv(const RTbyte *v);
RTAPI void RTAPIENTRY rtColor4sv(const RTshort *v);
RTAPI void RTAPIENTRY rtColor4iv(const RTint *v);
RTAPI void RTAPIENTRY rtColor4fv(const RTfloat *v);
RTAPI void RTAPIENTRY rtColor4dv(const RTdouble *v);
RTAPI void RTAPIENTRY rtColor4ubv(const RTubyte *v);
RTAPI void RTAPIENTRY rtColor4usv(const RTushort *v);
RTAPI void RTAPIENTRY rtColor4uiv(const RTuint *v);

/* The part of the frame buffer that the camera fills; in pixels from the lower left corner. The
 * rest gets the clear colour. Without it, the whole. Width and height are clamped to
 * RT_MAX_VIEWPORT_DIMS. Not in an object.
 * Errors:  RT_INVALID_VALUE  negative width or height
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtViewport(RTint x, RTint y, RTsizei width, RTsizei height);

/* What rays that meet nothing see without an environment shader; clamped to 0..1, not a number
 * counts as 0; transparent black at the start. Not in an object.
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtClearColor(RTclampf red, RTclampf green, RTclampf blue, RTclampf alpha);

/* Switches of state; off at the start but for RT_DITHER, which has no effect, and RT_DEPTH_TEST:
 * that is on until a program enables or disables it or clears a buffer; from then on it is as in
 * OpenGL, where it is off until it is enabled, and what is given last covers what was given before.
 *   OpenGL's             those of fixed function; see rt_fixed.h
 *   RT_SHADOWS           lights of fixed function cast shadows
 *   RT_REFLECTIONS       fixed-function surfaces reflect by their material's RT_REFLECTION
 *   RT_FRAMEBUFFER_SRGB  frame buffers of 8 bits are stored sRGB-encoded
 *   RT_MULTISAMPLE       four samples a pixel where rtSamples asks for one
 * rtEnable and rtDisable: not in an object.
 * Errors:  RT_INVALID_ENUM       no switch of this interface
 *          RT_INVALID_OPERATION  rtEnable, the first time: RT_STENCIL_TEST, evaluators,
 *                                RT_TEXTURE_3D, RT_TEXTURE_CUBE_MAP, sample coverage and the
 *                                imaging subset, which there are not
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtEnable(RTenum cap);
RTAPI void RTAPIENTRY rtDisable(RTenum cap);
RTAPI RTboolean RTAPIENTRY rtIsEnabled(RTenum cap);

/* Values of state; converted as in OpenGL: colours, normals and depths become integers by mapping
 * -1..1 to the whole range, other numbers by rounding, and booleans by comparison with 0; integers
 * out of range are clamped. All values and switches of OpenGL 1.5 whose calls this library has, as
 * many as there; its own, and how many values the most common ones have:
 *   16  RT_MODELVIEW_MATRIX, RT_PROJECTION_MATRIX, RT_TEXTURE_MATRIX and RT_TRANSPOSE_..._MATRIX
 *   4   RT_CURRENT_COLOR, RT_CURRENT_TEXTURE_COORDS, RT_COLOR_CLEAR_VALUE, RT_VIEWPORT
 *   3   RT_CURRENT_NORMAL
 *   2   RT_MAX_VIEWPORT_DIMS
 *   1   RT_MATRIX_MODE, RT_MODELVIEW_STACK_DEPTH, RT_PROJECTION_STACK_DEPTH,
 *       RT_TEXTURE_STACK_DEPTH, RT_MAX_MODELVIEW_STACK_DEPTH, RT_MAX_PROJECTION_STACK_DEPTH,
 *       RT_MAX_TEXTURE_STACK_DEPTH, RT_MAX_OBJECT_DEPTH, RT_MAX_TEXTURE_SIZE,
 *       RT_TEXTURE_BINDING_2D, RT_SHADER_BINDING, RT_SHADER_CLASS_BINDING, RT_OBJECT_INDEX,
 *       RT_UNPACK_ALIGNMENT, RT_UNPACK_ROW_LENGTH, RT_UNPACK_SKIP_PIXELS, RT_UNPACK_SKIP_ROWS,
 *       RT_UNPACK_SWAP_BYTES, RT_SAMPLES, RT_PRECISION_HINT, RT_BUILD_QUALITY, RT_LAZY_BUILD,
 *       RT_FRAMEBUFFER_SRGB, RT_MULTISAMPLE,
 *       RT_FRAME_DEPTH, RT_SCENE_BINDING,
 *       RT_FRAME_PROGRESS (of the frame of rtStartRendering, 0 to 1; 1 when there is none),
 *       RT_STAT_TRIANGLES, _INSTANCES, _NODES, _LEAVES, _REFERENCES, _DROPPED_TRIANGLES,
 *       _DROPPED_INSTANCES (of the scene of the last frame started), _BYTES, _PEAK_BYTES,
 *       _MODELS_BUILT, _BUILD_MICROSECONDS (of this context), _RAYS, _PRIMARY_RAYS, _SHADOW_RAYS,
 *       _SECONDARY_RAYS, _BAD_PIXELS, _BUSY_MICROSECONDS, _IDLE_MICROSECONDS (of the last frame
 *       waited for)
 * Errors:  RT_INVALID_ENUM       no such value
 *          RT_INVALID_OPERATION  a value of OpenGL's that is not part of this release
 *          RT_INVALID_VALUE      params NULL
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtGetBooleanv(RTenum pname, RTboolean *params);
RTAPI void RTAPIENTRY rtGetIntegerv(RTenum pname, RTint *params);
RTAPI void RTAPIENTRY rtGetInteger64v(RTenum pname, RTint64 *params);
RTAPI void RTAPIENTRY rtGetFloatv(RTenum pname, RTfloat *params);
RTAPI void RTAPIENTRY rtGetDoublev(RTenum pname, RTdouble *params);

#ifdef __cplusplus
}
#endif
#endif
