/* SPDX-License-Identifier: MIT */
/* OpenGL's fixed-function state: lights, materials, fog, texture environment, what becomes of
 * fragments, stacks of attributes. Part of openrt/rt.h.
 *
 * The calls mean what they mean in OpenGL 1.5, errors included; what is said here is what OpenGL
 * leaves open, or where this library differs. All of it but materials and current values is
 * latched as one block: by rtBegin for loose geometry, by the instantiation for objects. None of
 * it is legal in objects, but for materials and current values, which are legal everywhere.
 * Tokens are those of OpenGL. Errors that all of these calls have:
 *          RT_INVALID_ENUM       a token that OpenGL does not know there; a call with one value
 *                                for what takes several
 *          RT_INVALID_VALUE      a number out of OpenGL's range, or not a number; NULL. What
 *                                vertices latch, but for materials, may be not a number
 *          RT_INVALID_OPERATION  between rtBegin and rtEnd, or in an object
 * Without any of them geometry shows the colours of its vertices, and the nearest surface. */
#ifndef OPENRT_RT_FIXED_H
#define OPENRT_RT_FIXED_H

#include "openrt/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Where the lighting equation is evaluated: RT_SMOOTH (start): at the vertices, whose colours are
 * interpolated; RT_FLAT: at the provoking vertex; RT_PHONG, ours: at every point that is seen.
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtShadeModel(RTenum mode);

/* Properties of the lights RT_LIGHT0 to RT_LIGHT7; RT_SPOT_CUTOFF is in degrees. Positions and
 * directions go through the model-view matrix. Each light enabled when a frame starts is one of the
 * frame's lights too, which programmable surfaces see; with rtEnable(RT_SHADOWS) it casts shadows.
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtLightf(RTenum light, RTenum pname, RTfloat param);
RTAPI void RTAPIENTRY rtLighti(RTenum light, RTenum pname, RTint param);
RTAPI void RTAPIENTRY rtLightfv(RTenum light, RTenum pname, const RTfloat *params);
RTAPI void RTAPIENTRY rtLightiv(RTenum light, RTenum pname, const RTint *params);
RTAPI void RTAPIENTRY rtGetLightfv(RTenum light, RTenum pname, RTfloat *params);
RTAPI void RTAPIENTRY rtGetLightiv(RTenum light, RTenum pname, RTint *params);

/* What holds for all lights: RT_LIGHT_MODEL_AMBIENT, _LOCAL_VIEWER, _TWO_SIDE, _COLOR_CONTROL.
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtLightModelf(RTenum pname, RTfloat param);
RTAPI void RTAPIENTRY rtLightModeli(RTenum pname, RTint param);
RTAPI void RTAPIENTRY rtLightModelfv(RTenum pname, const RTfloat *params);
RTAPI void RTAPIENTRY rtLightModeliv(RTenum pname, const RTint *params);

/* The current materials, which vertices latch. RT_REFLECTION, ours, 0 at the start: the share, 0
 * to 1, of what is seen in the mirror direction, with rtEnable(RT_REFLECTIONS). Legal between
 * rtBegin and rtEnd and in objects; what an object does not set, its instances give.
 * Errors:  RT_INVALID_OPERATION  RT_COLOR_INDEXES
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtMaterialf(RTenum face, RTenum pname, RTfloat param);
RTAPI void RTAPIENTRY rtMateriali(RTenum face, RTenum pname, RTint param);
RTAPI void RTAPIENTRY rtMaterialfv(RTenum face, RTenum pname, const RTfloat *params);
RTAPI void RTAPIENTRY rtMaterialiv(RTenum face, RTenum pname, const RTint *params);
RTAPI void RTAPIENTRY rtGetMaterialfv(RTenum face, RTenum pname, RTfloat *params);
RTAPI void RTAPIENTRY rtGetMaterialiv(RTenum face, RTenum pname, RTint *params);

/* Which part of the material follows the vertices' colour; with rtEnable(RT_COLOR_MATERIAL).
 * Whether the vertices of an object follow is the business of its instances.
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtColorMaterial(RTenum face, RTenum mode);

/* The fog of a frame: by the depth in units of eye space, with a camera shader by the length of the
 * ray; or, where RT_FOG_COORDINATE_SOURCE says RT_FOG_COORDINATE, by the vertices' rtFogCoord.
 * Errors:  RT_INVALID_OPERATION  RT_FOG_INDEX
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtFogf(RTenum pname, RTfloat param);
RTAPI void RTAPIENTRY rtFogi(RTenum pname, RTint param);
RTAPI void RTAPIENTRY rtFogfv(RTenum pname, const RTfloat *params);
RTAPI void RTAPIENTRY rtFogiv(RTenum pname, const RTint *params);

/* The current coordinate of fog and the secondary colour, which vertices latch. That colour is
 * added after texturing where RT_COLOR_SUM is enabled and lighting is not.
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtFogCoordf(RTfloat coord);
RTAPI void RTAPIENTRY rtFogCoordfv(const RTfloat *coord);
RTAPI void RTAPIENTRY rtFogCoordd(RTdouble coord);
RTAPI void RTAPIENTRY rtFogCoorddv(const RTdouble *coord);
RTAPI void RTAPIENTRY rtSecondaryColor3b(RTbyte red, RTbyte green, RTbyte blue);
RTAPI void RTAPIENTRY rtSecondaryColor3bv(const RTbyte *v);
RTAPI void RTAPIENTRY rtSecondaryColor3d(RTdouble red, RTdouble green, RTdouble blue);
RTAPI void RTAPIENTRY rtSecondaryColor3dv(const RTdouble *v);
RTAPI void RTAPIENTRY rtSecondaryColor3f(RTfloat red, RTfloat green, RTfloat blue);
RTAPI void RTAPIENTRY rtSecondaryColor3fv(const RTfloat *v);
RTAPI void RTAPIENTRY rtSecondaryColor3i(RTint red, RTint green, RTint blue);
RTAPI void RTAPIENTRY rtSecondaryColor3iv(const RTint *v);
RTAPI void RTAPIENTRY rtSecondaryColor3s(RTshort red, RTshort green, RTshort blue);
RTAPI void RTAPIENTRY rtSecondaryColor3sv(const RTshort *v);
RTAPI void RTAPIENTRY rtSecondaryColor3ub(RTubyte red, RTubyte green, RTubyte blue);
RTAPI void RTAPIENTRY rtSecondaryColor3ubv(const RTubyte *v);
RTAPI void RTAPIENTRY rtSecondaryColor3ui(RTuint red, RTuint green, RTuint blue);
RTAPI void RTAPIENTRY rtSecondaryColor3uiv(const RTuint *v);
RTAPI void RTAPIENTRY rtSecondaryColor3us(RTushort red, RTushort green, RTushort blue);
RTAPI void RTAPIENTRY rtSecondaryColor3usv(const RTushort *v);

/* Whether the edges that start at vertices are drawn: where polygons are drawn as lines or points.
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtEdgeFlag(RTboolean flag);
RTAPI void RTAPIENTRY rtEdgeFlagv(const RTboolean *flag);

/* The active texture unit, and texture coordinates of each: RT_TEXTURE0 to RT_TEXTURE3. Calls about
 * bound textures, environments, generated coordinates and texture matrices mean the active unit;
 * the rtTexCoord calls mean RT_TEXTURE0. Shader classes see the coordinates of RT_TEXTURE0.
 * Errors:  RT_INVALID_ENUM  another unit
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtActiveTexture(RTenum texture);
RTAPI void RTAPIENTRY rtMultiTexCoord1d(RTenum target, RTdouble s);
RTAPI void RTAPIENTRY rtMultiTexCoord1dv(RTenum target, const RTdouble *v);
RTAPI void RTAPIENTRY rtMultiTexCoord1f(RTenum target, RTfloat s);
RTAPI void RTAPIENTRY rtMultiTexCoord1fv(RTenum target, const RTfloat *v);
RTAPI void RTAPIENTRY rtMultiTexCoord1i(RTenum target, RTint s);
RTAPI void RTAPIENTRY rtMultiTexCoord1iv(RTenum target, const RTint *v);
RTAPI void RTAPIENTRY rtMultiTexCoord1s(RTenum target, RTshort s);
RTAPI void RTAPIENTRY rtMultiTexCoord1sv(RTenum target, const RTshort *v);
RTAPI void RTAPIENTRY rtMultiTexCoord2d(RTenum target, RTdouble s, RTdouble t);
RTAPI void RTAPIENTRY rtMultiTexCoord2dv(RTenum target, const RTdouble *v);
RTAPI void RTAPIENTRY rtMultiTexCoord2f(RTenum target, RTfloat s, RTfloat t);
RTAPI void RTAPIENTRY rtMultiTexCoord2fv(RTenum target, const RTfloat *v);
RTAPI void RTAPIENTRY rtMultiTexCoord2i(RTenum target, RTint s, RTint t);
RTAPI void RTAPIENTRY rtMultiTexCoord2iv(RTenum target, const RTint *v);
RTAPI void RTAPIENTRY rtMultiTexCoord2s(RTenum target, RTshort s, RTshort t);
RTAPI void RTAPIENTRY rtMultiTexCoord2sv(RTenum target, const RTshort *v);
RTAPI void RTAPIENTRY rtMultiTexCoord3d(RTenum target, RTdouble s, RTdouble t, RTdouble r);
RTAPI void RTAPIENTRY rtMultiTexCoord3dv(RTenum target, const RTdouble *v);
RTAPI void RTAPIENTRY rtMultiTexCoord3f(RTenum target, RTfloat s, RTfloat t, RTfloat r);
RTAPI void RTAPIENTRY rtMultiTexCoord3fv(RTenum target, const RTfloat *v);
RTAPI void RTAPIENTRY rtMultiTexCoord3i(RTenum target, RTint s, RTint t, RTint r);
RTAPI void RTAPIENTRY rtMultiTexCoord3iv(RTenum target, const RTint *v);
RTAPI void RTAPIENTRY rtMultiTexCoord3s(RTenum target, RTshort s, RTshort t, RTshort r);
RTAPI void RTAPIENTRY rtMultiTexCoord3sv(RTenum target, const RTshort *v);
RTAPI void RTAPIENTRY rtMultiTexCoord4d(RTenum target, RTdouble s, RTdouble t, RTdouble r,
                                        RTdouble q);
RTAPI void RTAPIENTRY rtMultiTexCoord4dv(RTenum target, const RTdouble *v);
RTAPI void RTAPIENTRY rtMultiTexCoord4f(RTenum target, RTfloat s, RTfloat t, RTfloat r, RTfloat q);
RTAPI void RTAPIENTRY rtMultiTexCoord4fv(RTenum target, const RTfloat *v);
RTAPI void RTAPIENTRY rtMultiTexCoord4i(RTenum target, RTint s, RTint t, RTint r, RTint q);
RTAPI void RTAPIENTRY rtMultiTexCoord4iv(RTenum target, const RTint *v);
RTAPI void RTAPIENTRY rtMultiTexCoord4s(RTenum target, RTshort s, RTshort t, RTshort r, RTshort q);
RTAPI void RTAPIENTRY rtMultiTexCoord4sv(RTenum target, const RTshort *v);

/* How texels and colours become the fragment's colour. RT_TEXTURE_FILTER_CONTROL with
 * RT_TEXTURE_LOD_BIAS is the other target.
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtTexEnvf(RTenum target, RTenum pname, RTfloat param);
RTAPI void RTAPIENTRY rtTexEnvi(RTenum target, RTenum pname, RTint param);
RTAPI void RTAPIENTRY rtTexEnvfv(RTenum target, RTenum pname, const RTfloat *params);
RTAPI void RTAPIENTRY rtTexEnviv(RTenum target, RTenum pname, const RTint *params);
RTAPI void RTAPIENTRY rtGetTexEnvfv(RTenum target, RTenum pname, RTfloat *params);
RTAPI void RTAPIENTRY rtGetTexEnviv(RTenum target, RTenum pname, RTint *params);

/* Generated texture coordinates. Planes of RT_EYE_PLANE go through the inverse of the model-view
 * matrix of the call; those of RT_OBJECT_PLANE are of the coordinates of objects, or of the
 * vertices of loose geometry.
 * Errors:  RT_INVALID_OPERATION  RT_EYE_PLANE under a model-view matrix without an inverse
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtTexGend(RTenum coord, RTenum pname, RTdouble param);
RTAPI void RTAPIENTRY rtTexGenf(RTenum coord, RTenum pname, RTfloat param);
RTAPI void RTAPIENTRY rtTexGeni(RTenum coord, RTenum pname, RTint param);
RTAPI void RTAPIENTRY rtTexGendv(RTenum coord, RTenum pname, const RTdouble *params);
RTAPI void RTAPIENTRY rtTexGenfv(RTenum coord, RTenum pname, const RTfloat *params);
RTAPI void RTAPIENTRY rtTexGeniv(RTenum coord, RTenum pname, const RTint *params);
RTAPI void RTAPIENTRY rtGetTexGendv(RTenum coord, RTenum pname, RTdouble *params);
RTAPI void RTAPIENTRY rtGetTexGenfv(RTenum coord, RTenum pname, RTfloat *params);
RTAPI void RTAPIENTRY rtGetTexGeniv(RTenum coord, RTenum pname, RTint *params);

/* Clip planes, culling, and which side of a polygon is its front. They matter to camera rays only.
 * A plane goes through the inverse of the model-view matrix of the call.
 * Errors:  RT_INVALID_OPERATION  rtClipPlane under a model-view matrix without an inverse
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtClipPlane(RTenum plane, const RTdouble *equation);
RTAPI void RTAPIENTRY rtGetClipPlane(RTenum plane, RTdouble *equation);
RTAPI void RTAPIENTRY rtCullFace(RTenum mode);
RTAPI void RTAPIENTRY rtFrontFace(RTenum mode);

/* How polygons, lines and points, which camera rays alone see, cover pixels; sizes are in pixels.
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtPolygonMode(RTenum face, RTenum mode);
RTAPI void RTAPIENTRY rtPolygonOffset(RTfloat factor, RTfloat units);
RTAPI void RTAPIENTRY rtPolygonStipple(const RTubyte *mask);
RTAPI void RTAPIENTRY rtGetPolygonStipple(RTubyte *mask);
RTAPI void RTAPIENTRY rtLineWidth(RTfloat width);
RTAPI void RTAPIENTRY rtLineStipple(RTint factor, RTushort pattern);
RTAPI void RTAPIENTRY rtPointSize(RTfloat size);

/* How points get smaller with their distance from the eye: RT_POINT_DISTANCE_ATTENUATION, between
 * RT_POINT_SIZE_MIN and RT_POINT_SIZE_MAX. With several samples a pixel, points smaller than
 * RT_POINT_FADE_THRESHOLD_SIZE fade instead.
 * Errors:  RT_INVALID_VALUE  a size below 0
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtPointParameterf(RTenum pname, RTfloat param);
RTAPI void RTAPIENTRY rtPointParameteri(RTenum pname, RTint param);
RTAPI void RTAPIENTRY rtPointParameterfv(RTenum pname, const RTfloat *params);
RTAPI void RTAPIENTRY rtPointParameteriv(RTenum pname, const RTint *params);

/* What becomes of fragments, in the order of submission: tests, blending, masks. In a program that
 * neither clears a buffer nor enables or disables RT_DEPTH_TEST the depth test is on; from the
 * first rtClear on it is off until it is enabled, as in OpenGL.
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtAlphaFunc(RTenum func, RTclampf ref);
RTAPI void RTAPIENTRY rtBlendFunc(RTenum sfactor, RTenum dfactor);
RTAPI void RTAPIENTRY rtBlendFuncSeparate(RTenum sfactorRGB, RTenum dfactorRGB, RTenum sfactorAlpha,
                                          RTenum dfactorAlpha);
RTAPI void RTAPIENTRY rtBlendEquation(RTenum mode);
RTAPI void RTAPIENTRY rtBlendColor(RTfloat red, RTfloat green, RTfloat blue, RTfloat alpha);
RTAPI void RTAPIENTRY rtLogicOp(RTenum opcode);
RTAPI void RTAPIENTRY rtDepthFunc(RTenum func);
RTAPI void RTAPIENTRY rtDepthMask(RTboolean flag);
RTAPI void RTAPIENTRY rtColorMask(RTboolean red, RTboolean green, RTboolean blue, RTboolean alpha);

/* State of buffers that there are not: a stencil buffer (rtEnable refuses RT_STENCIL_TEST), an
 * accumulation buffer, sample coverage. It can be set and asked for.
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtStencilFunc(RTenum func, RTint ref, RTuint mask);
RTAPI void RTAPIENTRY rtStencilOp(RTenum fail, RTenum zfail, RTenum zpass);
RTAPI void RTAPIENTRY rtStencilMask(RTuint mask);
RTAPI void RTAPIENTRY rtClearStencil(RTint s);
RTAPI void RTAPIENTRY rtClearAccum(RTfloat red, RTfloat green, RTfloat blue, RTfloat alpha);
RTAPI void RTAPIENTRY rtSampleCoverage(RTfloat value, RTboolean invert);

/* Save groups of state and restore what was saved last; 16 deep each.
 * Errors:  RT_STACK_OVERFLOW   16 were saved
 *          RT_STACK_UNDERFLOW  nothing was saved
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtPushAttrib(RTbitfield mask);
RTAPI void RTAPIENTRY rtPopAttrib(void);
RTAPI void RTAPIENTRY rtPushClientAttrib(RTbitfield mask);
RTAPI void RTAPIENTRY rtPopClientAttrib(void);

/* Selection and feedback, which there are not: rtRenderMode(RT_RENDER) is legal and returns 0;
 * names have no effect, as in OpenGL outside of selection. To find what is under the mouse, see
 * rtuPickRay and rtIntersect.
 * Errors:  RT_INVALID_OPERATION  RT_SELECT, RT_FEEDBACK
 * Threads: the context's. Since: 0.1 */
RTAPI RTint RTAPIENTRY rtRenderMode(RTenum mode);
RTAPI void RTAPIENTRY rtInitNames(void);
RTAPI void RTAPIENTRY rtLoadName(RTuint name);
RTAPI void RTAPIENTRY rtPushName(RTuint name);
RTAPI void RTAPIENTRY rtPopName(void);
RTAPI void RTAPIENTRY rtPassThrough(RTfloat token);

#ifdef __cplusplus
}
#endif
#endif
