/* SPDX-License-Identifier: MIT */
/* Written by compat/generate_calls.py; change the table, not this file. */
/* The functions of OpenGL 1.5 which this release declares and does not carry out. Each
 * records RT_INVALID_OPERATION with a text that names it, changes nothing and returns 0,
 * NULL or RT_FALSE. The others are in openrt/rt.h. */
#ifndef OPENRT_RT_GL_H
#define OPENRT_RT_GL_H

#include "openrt/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* State */
RTAPI void RTAPIENTRY rtPushAttrib(RTbitfield mask);
RTAPI void RTAPIENTRY rtPopAttrib(void);
RTAPI void RTAPIENTRY rtPushClientAttrib(RTbitfield mask);
RTAPI void RTAPIENTRY rtPopClientAttrib(void);

/* Begin, end and current values */
RTAPI void RTAPIENTRY rtEdgeFlag(RTboolean flag);
RTAPI void RTAPIENTRY rtEdgeFlagv(const RTboolean *flag);
RTAPI void RTAPIENTRY rtIndexd(RTdouble c);
RTAPI void RTAPIENTRY rtIndexf(RTfloat c);
RTAPI void RTAPIENTRY rtIndexi(RTint c);
RTAPI void RTAPIENTRY rtIndexs(RTshort c);
RTAPI void RTAPIENTRY rtIndexub(RTubyte c);
RTAPI void RTAPIENTRY rtIndexdv(const RTdouble *c);
RTAPI void RTAPIENTRY rtIndexfv(const RTfloat *c);
RTAPI void RTAPIENTRY rtIndexiv(const RTint *c);
RTAPI void RTAPIENTRY rtIndexsv(const RTshort *c);
RTAPI void RTAPIENTRY rtIndexubv(const RTubyte *c);
RTAPI void RTAPIENTRY rtRectd(RTdouble x1, RTdouble y1, RTdouble x2, RTdouble y2);
RTAPI void RTAPIENTRY rtRectf(RTfloat x1, RTfloat y1, RTfloat x2, RTfloat y2);
RTAPI void RTAPIENTRY rtRecti(RTint x1, RTint y1, RTint x2, RTint y2);
RTAPI void RTAPIENTRY rtRects(RTshort x1, RTshort y1, RTshort x2, RTshort y2);
RTAPI void RTAPIENTRY rtRectdv(const RTdouble *v1, const RTdouble *v2);
RTAPI void RTAPIENTRY rtRectfv(const RTfloat *v1, const RTfloat *v2);
RTAPI void RTAPIENTRY rtRectiv(const RTint *v1, const RTint *v2);
RTAPI void RTAPIENTRY rtRectsv(const RTshort *v1, const RTshort *v2);
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

/* Matrices */
RTAPI void RTAPIENTRY rtDepthRange(RTclampd near_val, RTclampd far_val);

/* Raster position */
RTAPI void RTAPIENTRY rtRasterPos2d(RTdouble x, RTdouble y);
RTAPI void RTAPIENTRY rtRasterPos2f(RTfloat x, RTfloat y);
RTAPI void RTAPIENTRY rtRasterPos2i(RTint x, RTint y);
RTAPI void RTAPIENTRY rtRasterPos2s(RTshort x, RTshort y);
RTAPI void RTAPIENTRY rtRasterPos3d(RTdouble x, RTdouble y, RTdouble z);
RTAPI void RTAPIENTRY rtRasterPos3f(RTfloat x, RTfloat y, RTfloat z);
RTAPI void RTAPIENTRY rtRasterPos3i(RTint x, RTint y, RTint z);
RTAPI void RTAPIENTRY rtRasterPos3s(RTshort x, RTshort y, RTshort z);
RTAPI void RTAPIENTRY rtRasterPos4d(RTdouble x, RTdouble y, RTdouble z, RTdouble w);
RTAPI void RTAPIENTRY rtRasterPos4f(RTfloat x, RTfloat y, RTfloat z, RTfloat w);
RTAPI void RTAPIENTRY rtRasterPos4i(RTint x, RTint y, RTint z, RTint w);
RTAPI void RTAPIENTRY rtRasterPos4s(RTshort x, RTshort y, RTshort z, RTshort w);
RTAPI void RTAPIENTRY rtRasterPos2dv(const RTdouble *v);
RTAPI void RTAPIENTRY rtRasterPos2fv(const RTfloat *v);
RTAPI void RTAPIENTRY rtRasterPos2iv(const RTint *v);
RTAPI void RTAPIENTRY rtRasterPos2sv(const RTshort *v);
RTAPI void RTAPIENTRY rtRasterPos3dv(const RTdouble *v);
RTAPI void RTAPIENTRY rtRasterPos3fv(const RTfloat *v);
RTAPI void RTAPIENTRY rtRasterPos3iv(const RTint *v);
RTAPI void RTAPIENTRY rtRasterPos3sv(const RTshort *v);
RTAPI void RTAPIENTRY rtRasterPos4dv(const RTdouble *v);
RTAPI void RTAPIENTRY rtRasterPos4fv(const RTfloat *v);
RTAPI void RTAPIENTRY rtRasterPos4iv(const RTint *v);
RTAPI void RTAPIENTRY rtRasterPos4sv(const RTshort *v);
RTAPI void RTAPIENTRY rtWindowPos2d(RTdouble x, RTdouble y);
RTAPI void RTAPIENTRY rtWindowPos2dv(const RTdouble *v);
RTAPI void RTAPIENTRY rtWindowPos2f(RTfloat x, RTfloat y);
RTAPI void RTAPIENTRY rtWindowPos2fv(const RTfloat *v);
RTAPI void RTAPIENTRY rtWindowPos2i(RTint x, RTint y);
RTAPI void RTAPIENTRY rtWindowPos2iv(const RTint *v);
RTAPI void RTAPIENTRY rtWindowPos2s(RTshort x, RTshort y);
RTAPI void RTAPIENTRY rtWindowPos2sv(const RTshort *v);
RTAPI void RTAPIENTRY rtWindowPos3d(RTdouble x, RTdouble y, RTdouble z);
RTAPI void RTAPIENTRY rtWindowPos3dv(const RTdouble *v);
RTAPI void RTAPIENTRY rtWindowPos3f(RTfloat x, RTfloat y, RTfloat z);
RTAPI void RTAPIENTRY rtWindowPos3fv(const RTfloat *v);
RTAPI void RTAPIENTRY rtWindowPos3i(RTint x, RTint y, RTint z);
RTAPI void RTAPIENTRY rtWindowPos3iv(const RTint *v);
RTAPI void RTAPIENTRY rtWindowPos3s(RTshort x, RTshort y, RTshort z);
RTAPI void RTAPIENTRY rtWindowPos3sv(const RTshort *v);

/* Vertex arrays */
RTAPI void RTAPIENTRY rtEnableClientState(RTenum cap);
RTAPI void RTAPIENTRY rtDisableClientState(RTenum cap);
RTAPI void RTAPIENTRY rtVertexPointer(RTint size, RTenum type, RTsizei stride, const void *ptr);
RTAPI void RTAPIENTRY rtNormalPointer(RTenum type, RTsizei stride, const void *ptr);
RTAPI void RTAPIENTRY rtColorPointer(RTint size, RTenum type, RTsizei stride, const void *ptr);
RTAPI void RTAPIENTRY rtIndexPointer(RTenum type, RTsizei stride, const void *ptr);
RTAPI void RTAPIENTRY rtTexCoordPointer(RTint size, RTenum type, RTsizei stride, const void *ptr);
RTAPI void RTAPIENTRY rtEdgeFlagPointer(RTsizei stride, const void *ptr);
RTAPI void RTAPIENTRY rtGetPointerv(RTenum pname, void **params);
RTAPI void RTAPIENTRY rtArrayElement(RTint i);
RTAPI void RTAPIENTRY rtDrawArrays(RTenum mode, RTint first, RTsizei count);
RTAPI void RTAPIENTRY rtDrawElements(RTenum mode, RTsizei count, RTenum type, const void *indices);
RTAPI void RTAPIENTRY rtInterleavedArrays(RTenum format, RTsizei stride, const void *pointer);
RTAPI void RTAPIENTRY rtDrawRangeElements(RTenum mode, RTuint start, RTuint end, RTsizei count,
                                          RTenum type, const void *indices);
RTAPI void RTAPIENTRY rtClientActiveTexture(RTenum texture);
RTAPI void RTAPIENTRY rtMultiDrawArrays(RTenum mode, const RTint *first, const RTsizei *count,
                                        RTsizei drawcount);
RTAPI void RTAPIENTRY rtMultiDrawElements(RTenum mode, const RTsizei *count, RTenum type,
                                          const void *const *indices, RTsizei drawcount);
RTAPI void RTAPIENTRY rtFogCoordPointer(RTenum type, RTsizei stride, const void *pointer);
RTAPI void RTAPIENTRY rtSecondaryColorPointer(RTint size, RTenum type, RTsizei stride,
                                              const void *pointer);

/* Buffer objects */
RTAPI void RTAPIENTRY rtBindBuffer(RTenum target, RTuint buffer);
RTAPI void RTAPIENTRY rtDeleteBuffers(RTsizei n, const RTuint *buffers);
RTAPI void RTAPIENTRY rtGenBuffers(RTsizei n, RTuint *buffers);
RTAPI RTboolean RTAPIENTRY rtIsBuffer(RTuint buffer);
RTAPI void RTAPIENTRY rtBufferData(RTenum target, RTsizeiptr size, const void *data, RTenum usage);
RTAPI void RTAPIENTRY rtBufferSubData(RTenum target, RTintptr offset, RTsizeiptr size,
                                      const void *data);
RTAPI void RTAPIENTRY rtGetBufferSubData(RTenum target, RTintptr offset, RTsizeiptr size,
                                         void *data);
RTAPI void *RTAPIENTRY rtMapBuffer(RTenum target, RTenum access);
RTAPI RTboolean RTAPIENTRY rtUnmapBuffer(RTenum target);
RTAPI void RTAPIENTRY rtGetBufferParameteriv(RTenum target, RTenum pname, RTint *params);
RTAPI void RTAPIENTRY rtGetBufferPointerv(RTenum target, RTenum pname, void **params);

/* Queries */
RTAPI void RTAPIENTRY rtGenQueries(RTsizei n, RTuint *ids);
RTAPI void RTAPIENTRY rtDeleteQueries(RTsizei n, const RTuint *ids);
RTAPI RTboolean RTAPIENTRY rtIsQuery(RTuint id);
RTAPI void RTAPIENTRY rtBeginQuery(RTenum target, RTuint id);
RTAPI void RTAPIENTRY rtEndQuery(RTenum target);
RTAPI void RTAPIENTRY rtGetQueryiv(RTenum target, RTenum pname, RTint *params);
RTAPI void RTAPIENTRY rtGetQueryObjectiv(RTuint id, RTenum pname, RTint *params);
RTAPI void RTAPIENTRY rtGetQueryObjectuiv(RTuint id, RTenum pname, RTuint *params);

/* Lighting and materials */
RTAPI void RTAPIENTRY rtShadeModel(RTenum mode);
RTAPI void RTAPIENTRY rtLightf(RTenum light, RTenum pname, RTfloat param);
RTAPI void RTAPIENTRY rtLighti(RTenum light, RTenum pname, RTint param);
RTAPI void RTAPIENTRY rtLightfv(RTenum light, RTenum pname, const RTfloat *params);
RTAPI void RTAPIENTRY rtLightiv(RTenum light, RTenum pname, const RTint *params);
RTAPI void RTAPIENTRY rtGetLightfv(RTenum light, RTenum pname, RTfloat *params);
RTAPI void RTAPIENTRY rtGetLightiv(RTenum light, RTenum pname, RTint *params);
RTAPI void RTAPIENTRY rtLightModelf(RTenum pname, RTfloat param);
RTAPI void RTAPIENTRY rtLightModeli(RTenum pname, RTint param);
RTAPI void RTAPIENTRY rtLightModelfv(RTenum pname, const RTfloat *params);
RTAPI void RTAPIENTRY rtLightModeliv(RTenum pname, const RTint *params);
RTAPI void RTAPIENTRY rtMaterialf(RTenum face, RTenum pname, RTfloat param);
RTAPI void RTAPIENTRY rtMateriali(RTenum face, RTenum pname, RTint param);
RTAPI void RTAPIENTRY rtMaterialfv(RTenum face, RTenum pname, const RTfloat *params);
RTAPI void RTAPIENTRY rtMaterialiv(RTenum face, RTenum pname, const RTint *params);
RTAPI void RTAPIENTRY rtGetMaterialfv(RTenum face, RTenum pname, RTfloat *params);
RTAPI void RTAPIENTRY rtGetMaterialiv(RTenum face, RTenum pname, RTint *params);
RTAPI void RTAPIENTRY rtColorMaterial(RTenum face, RTenum mode);

/* Fog */
RTAPI void RTAPIENTRY rtFogf(RTenum pname, RTfloat param);
RTAPI void RTAPIENTRY rtFogi(RTenum pname, RTint param);
RTAPI void RTAPIENTRY rtFogfv(RTenum pname, const RTfloat *params);
RTAPI void RTAPIENTRY rtFogiv(RTenum pname, const RTint *params);

/* Rasterisation and fragments */
RTAPI void RTAPIENTRY rtAlphaFunc(RTenum func, RTclampf ref);
RTAPI void RTAPIENTRY rtBlendFunc(RTenum sfactor, RTenum dfactor);
RTAPI void RTAPIENTRY rtLogicOp(RTenum opcode);
RTAPI void RTAPIENTRY rtCullFace(RTenum mode);
RTAPI void RTAPIENTRY rtFrontFace(RTenum mode);
RTAPI void RTAPIENTRY rtPointSize(RTfloat size);
RTAPI void RTAPIENTRY rtLineWidth(RTfloat width);
RTAPI void RTAPIENTRY rtLineStipple(RTint factor, RTushort pattern);
RTAPI void RTAPIENTRY rtPolygonMode(RTenum face, RTenum mode);
RTAPI void RTAPIENTRY rtPolygonOffset(RTfloat factor, RTfloat units);
RTAPI void RTAPIENTRY rtPolygonStipple(const RTubyte *mask);
RTAPI void RTAPIENTRY rtGetPolygonStipple(RTubyte *mask);
RTAPI void RTAPIENTRY rtScissor(RTint x, RTint y, RTsizei width, RTsizei height);
RTAPI void RTAPIENTRY rtClipPlane(RTenum plane, const RTdouble *equation);
RTAPI void RTAPIENTRY rtGetClipPlane(RTenum plane, RTdouble *equation);
RTAPI void RTAPIENTRY rtDepthFunc(RTenum func);
RTAPI void RTAPIENTRY rtStencilFunc(RTenum func, RTint ref, RTuint mask);
RTAPI void RTAPIENTRY rtStencilOp(RTenum fail, RTenum zfail, RTenum zpass);
RTAPI void RTAPIENTRY rtBlendEquation(RTenum mode);
RTAPI void RTAPIENTRY rtBlendColor(RTfloat red, RTfloat green, RTfloat blue, RTfloat alpha);
RTAPI void RTAPIENTRY rtSampleCoverage(RTfloat value, RTboolean invert);
RTAPI void RTAPIENTRY rtBlendFuncSeparate(RTenum sfactorRGB, RTenum dfactorRGB, RTenum sfactorAlpha,
                                          RTenum dfactorAlpha);
RTAPI void RTAPIENTRY rtPointParameterf(RTenum pname, RTfloat param);
RTAPI void RTAPIENTRY rtPointParameterfv(RTenum pname, const RTfloat *params);
RTAPI void RTAPIENTRY rtPointParameteri(RTenum pname, RTint param);
RTAPI void RTAPIENTRY rtPointParameteriv(RTenum pname, const RTint *params);

/* Frame buffer */
RTAPI void RTAPIENTRY rtClearIndex(RTfloat c);
RTAPI void RTAPIENTRY rtClear(RTbitfield mask);
RTAPI void RTAPIENTRY rtIndexMask(RTuint mask);
RTAPI void RTAPIENTRY rtColorMask(RTboolean red, RTboolean green, RTboolean blue, RTboolean alpha);
RTAPI void RTAPIENTRY rtDrawBuffer(RTenum mode);
RTAPI void RTAPIENTRY rtReadBuffer(RTenum mode);
RTAPI void RTAPIENTRY rtClearDepth(RTclampd depth);
RTAPI void RTAPIENTRY rtDepthMask(RTboolean flag);
RTAPI void RTAPIENTRY rtClearAccum(RTfloat red, RTfloat green, RTfloat blue, RTfloat alpha);
RTAPI void RTAPIENTRY rtAccum(RTenum op, RTfloat value);
RTAPI void RTAPIENTRY rtStencilMask(RTuint mask);
RTAPI void RTAPIENTRY rtClearStencil(RTint s);

/* Textures */
RTAPI void RTAPIENTRY rtTexGend(RTenum coord, RTenum pname, RTdouble param);
RTAPI void RTAPIENTRY rtTexGenf(RTenum coord, RTenum pname, RTfloat param);
RTAPI void RTAPIENTRY rtTexGeni(RTenum coord, RTenum pname, RTint param);
RTAPI void RTAPIENTRY rtTexGendv(RTenum coord, RTenum pname, const RTdouble *params);
RTAPI void RTAPIENTRY rtTexGenfv(RTenum coord, RTenum pname, const RTfloat *params);
RTAPI void RTAPIENTRY rtTexGeniv(RTenum coord, RTenum pname, const RTint *params);
RTAPI void RTAPIENTRY rtGetTexGendv(RTenum coord, RTenum pname, RTdouble *params);
RTAPI void RTAPIENTRY rtGetTexGenfv(RTenum coord, RTenum pname, RTfloat *params);
RTAPI void RTAPIENTRY rtGetTexGeniv(RTenum coord, RTenum pname, RTint *params);
RTAPI void RTAPIENTRY rtTexEnvf(RTenum target, RTenum pname, RTfloat param);
RTAPI void RTAPIENTRY rtTexEnvi(RTenum target, RTenum pname, RTint param);
RTAPI void RTAPIENTRY rtTexEnvfv(RTenum target, RTenum pname, const RTfloat *params);
RTAPI void RTAPIENTRY rtTexEnviv(RTenum target, RTenum pname, const RTint *params);
RTAPI void RTAPIENTRY rtGetTexEnvfv(RTenum target, RTenum pname, RTfloat *params);
RTAPI void RTAPIENTRY rtGetTexEnviv(RTenum target, RTenum pname, RTint *params);
RTAPI void RTAPIENTRY rtTexImage1D(RTenum target, RTint level, RTint internalFormat, RTsizei width,
                                   RTint border, RTenum format, RTenum type, const void *pixels);
RTAPI void RTAPIENTRY rtGetTexImage(RTenum target, RTint level, RTenum format, RTenum type,
                                    void *pixels);
RTAPI void RTAPIENTRY rtPrioritizeTextures(RTsizei n, const RTuint *textures,
                                           const RTclampf *priorities);
RTAPI RTboolean RTAPIENTRY rtAreTexturesResident(RTsizei n, const RTuint *textures,
                                                 RTboolean *residences);
RTAPI void RTAPIENTRY rtTexSubImage1D(RTenum target, RTint level, RTint xoffset, RTsizei width,
                                      RTenum format, RTenum type, const void *pixels);
RTAPI void RTAPIENTRY rtCopyTexImage1D(RTenum target, RTint level, RTenum internalformat, RTint x,
                                       RTint y, RTsizei width, RTint border);
RTAPI void RTAPIENTRY rtCopyTexImage2D(RTenum target, RTint level, RTenum internalformat, RTint x,
                                       RTint y, RTsizei width, RTsizei height, RTint border);
RTAPI void RTAPIENTRY rtCopyTexSubImage1D(RTenum target, RTint level, RTint xoffset, RTint x,
                                          RTint y, RTsizei width);
RTAPI void RTAPIENTRY rtCopyTexSubImage2D(RTenum target, RTint level, RTint xoffset, RTint yoffset,
                                          RTint x, RTint y, RTsizei width, RTsizei height);
RTAPI void RTAPIENTRY rtTexImage3D(RTenum target, RTint level, RTint internalformat, RTsizei width,
                                   RTsizei height, RTsizei depth, RTint border, RTenum format,
                                   RTenum type, const void *pixels);
RTAPI void RTAPIENTRY rtTexSubImage3D(RTenum target, RTint level, RTint xoffset, RTint yoffset,
                                      RTint zoffset, RTsizei width, RTsizei height, RTsizei depth,
                                      RTenum format, RTenum type, const void *pixels);
RTAPI void RTAPIENTRY rtCopyTexSubImage3D(RTenum target, RTint level, RTint xoffset, RTint yoffset,
                                          RTint zoffset, RTint x, RTint y, RTsizei width,
                                          RTsizei height);
RTAPI void RTAPIENTRY rtActiveTexture(RTenum texture);
RTAPI void RTAPIENTRY rtCompressedTexImage1D(RTenum target, RTint level, RTenum internalformat,
                                             RTsizei width, RTint border, RTsizei imageSize,
                                             const void *data);
RTAPI void RTAPIENTRY rtCompressedTexImage2D(RTenum target, RTint level, RTenum internalformat,
                                             RTsizei width, RTsizei height, RTint border,
                                             RTsizei imageSize, const void *data);
RTAPI void RTAPIENTRY rtCompressedTexImage3D(RTenum target, RTint level, RTenum internalformat,
                                             RTsizei width, RTsizei height, RTsizei depth,
                                             RTint border, RTsizei imageSize, const void *data);
RTAPI void RTAPIENTRY rtCompressedTexSubImage1D(RTenum target, RTint level, RTint xoffset,
                                                RTsizei width, RTenum format, RTsizei imageSize,
                                                const void *data);
RTAPI void RTAPIENTRY rtCompressedTexSubImage2D(RTenum target, RTint level, RTint xoffset,
                                                RTint yoffset, RTsizei width, RTsizei height,
                                                RTenum format, RTsizei imageSize, const void *data);
RTAPI void RTAPIENTRY rtCompressedTexSubImage3D(RTenum target, RTint level, RTint xoffset,
                                                RTint yoffset, RTint zoffset, RTsizei width,
                                                RTsizei height, RTsizei depth, RTenum format,
                                                RTsizei imageSize, const void *data);
RTAPI void RTAPIENTRY rtGetCompressedTexImage(RTenum target, RTint level, void *img);

/* Pixels */
RTAPI void RTAPIENTRY rtPixelZoom(RTfloat xfactor, RTfloat yfactor);
RTAPI void RTAPIENTRY rtPixelTransferf(RTenum pname, RTfloat param);
RTAPI void RTAPIENTRY rtPixelTransferi(RTenum pname, RTint param);
RTAPI void RTAPIENTRY rtPixelMapfv(RTenum map, RTsizei mapsize, const RTfloat *values);
RTAPI void RTAPIENTRY rtPixelMapuiv(RTenum map, RTsizei mapsize, const RTuint *values);
RTAPI void RTAPIENTRY rtPixelMapusv(RTenum map, RTsizei mapsize, const RTushort *values);
RTAPI void RTAPIENTRY rtGetPixelMapfv(RTenum map, RTfloat *values);
RTAPI void RTAPIENTRY rtGetPixelMapuiv(RTenum map, RTuint *values);
RTAPI void RTAPIENTRY rtGetPixelMapusv(RTenum map, RTushort *values);
RTAPI void RTAPIENTRY rtBitmap(RTsizei width, RTsizei height, RTfloat xorig, RTfloat yorig,
                               RTfloat xmove, RTfloat ymove, const RTubyte *bitmap);
RTAPI void RTAPIENTRY rtReadPixels(RTint x, RTint y, RTsizei width, RTsizei height, RTenum format,
                                   RTenum type, void *pixels);
RTAPI void RTAPIENTRY rtDrawPixels(RTsizei width, RTsizei height, RTenum format, RTenum type,
                                   const void *pixels);
RTAPI void RTAPIENTRY rtCopyPixels(RTint x, RTint y, RTsizei width, RTsizei height, RTenum type);

/* Evaluators */
RTAPI void RTAPIENTRY rtMap1d(RTenum target, RTdouble u1, RTdouble u2, RTint stride, RTint order,
                              const RTdouble *points);
RTAPI void RTAPIENTRY rtMap1f(RTenum target, RTfloat u1, RTfloat u2, RTint stride, RTint order,
                              const RTfloat *points);
RTAPI void RTAPIENTRY rtMap2d(RTenum target, RTdouble u1, RTdouble u2, RTint ustride, RTint uorder,
                              RTdouble v1, RTdouble v2, RTint vstride, RTint vorder,
                              const RTdouble *points);
RTAPI void RTAPIENTRY rtMap2f(RTenum target, RTfloat u1, RTfloat u2, RTint ustride, RTint uorder,
                              RTfloat v1, RTfloat v2, RTint vstride, RTint vorder,
                              const RTfloat *points);
RTAPI void RTAPIENTRY rtGetMapdv(RTenum target, RTenum query, RTdouble *v);
RTAPI void RTAPIENTRY rtGetMapfv(RTenum target, RTenum query, RTfloat *v);
RTAPI void RTAPIENTRY rtGetMapiv(RTenum target, RTenum query, RTint *v);
RTAPI void RTAPIENTRY rtEvalCoord1d(RTdouble u);
RTAPI void RTAPIENTRY rtEvalCoord1f(RTfloat u);
RTAPI void RTAPIENTRY rtEvalCoord1dv(const RTdouble *u);
RTAPI void RTAPIENTRY rtEvalCoord1fv(const RTfloat *u);
RTAPI void RTAPIENTRY rtEvalCoord2d(RTdouble u, RTdouble v);
RTAPI void RTAPIENTRY rtEvalCoord2f(RTfloat u, RTfloat v);
RTAPI void RTAPIENTRY rtEvalCoord2dv(const RTdouble *u);
RTAPI void RTAPIENTRY rtEvalCoord2fv(const RTfloat *u);
RTAPI void RTAPIENTRY rtMapGrid1d(RTint un, RTdouble u1, RTdouble u2);
RTAPI void RTAPIENTRY rtMapGrid1f(RTint un, RTfloat u1, RTfloat u2);
RTAPI void RTAPIENTRY rtMapGrid2d(RTint un, RTdouble u1, RTdouble u2, RTint vn, RTdouble v1,
                                  RTdouble v2);
RTAPI void RTAPIENTRY rtMapGrid2f(RTint un, RTfloat u1, RTfloat u2, RTint vn, RTfloat v1,
                                  RTfloat v2);
RTAPI void RTAPIENTRY rtEvalPoint1(RTint i);
RTAPI void RTAPIENTRY rtEvalPoint2(RTint i, RTint j);
RTAPI void RTAPIENTRY rtEvalMesh1(RTenum mode, RTint i1, RTint i2);
RTAPI void RTAPIENTRY rtEvalMesh2(RTenum mode, RTint i1, RTint i2, RTint j1, RTint j2);

/* Selection and feedback */
RTAPI RTint RTAPIENTRY rtRenderMode(RTenum mode);
RTAPI void RTAPIENTRY rtFeedbackBuffer(RTsizei size, RTenum type, RTfloat *buffer);
RTAPI void RTAPIENTRY rtPassThrough(RTfloat token);
RTAPI void RTAPIENTRY rtSelectBuffer(RTsizei size, RTuint *buffer);
RTAPI void RTAPIENTRY rtInitNames(void);
RTAPI void RTAPIENTRY rtLoadName(RTuint name);
RTAPI void RTAPIENTRY rtPushName(RTuint name);
RTAPI void RTAPIENTRY rtPopName(void);

/* Imaging subset */
RTAPI void RTAPIENTRY rtColorTable(RTenum target, RTenum internalformat, RTsizei width,
                                   RTenum format, RTenum type, const void *table);
RTAPI void RTAPIENTRY rtColorSubTable(RTenum target, RTsizei start, RTsizei count, RTenum format,
                                      RTenum type, const void *data);
RTAPI void RTAPIENTRY rtColorTableParameteriv(RTenum target, RTenum pname, const RTint *params);
RTAPI void RTAPIENTRY rtColorTableParameterfv(RTenum target, RTenum pname, const RTfloat *params);
RTAPI void RTAPIENTRY rtCopyColorSubTable(RTenum target, RTsizei start, RTint x, RTint y,
                                          RTsizei width);
RTAPI void RTAPIENTRY rtCopyColorTable(RTenum target, RTenum internalformat, RTint x, RTint y,
                                       RTsizei width);
RTAPI void RTAPIENTRY rtGetColorTable(RTenum target, RTenum format, RTenum type, void *table);
RTAPI void RTAPIENTRY rtGetColorTableParameterfv(RTenum target, RTenum pname, RTfloat *params);
RTAPI void RTAPIENTRY rtGetColorTableParameteriv(RTenum target, RTenum pname, RTint *params);
RTAPI void RTAPIENTRY rtHistogram(RTenum target, RTsizei width, RTenum internalformat,
                                  RTboolean sink);
RTAPI void RTAPIENTRY rtResetHistogram(RTenum target);
RTAPI void RTAPIENTRY rtGetHistogram(RTenum target, RTboolean reset, RTenum format, RTenum type,
                                     void *values);
RTAPI void RTAPIENTRY rtGetHistogramParameterfv(RTenum target, RTenum pname, RTfloat *params);
RTAPI void RTAPIENTRY rtGetHistogramParameteriv(RTenum target, RTenum pname, RTint *params);
RTAPI void RTAPIENTRY rtMinmax(RTenum target, RTenum internalformat, RTboolean sink);
RTAPI void RTAPIENTRY rtResetMinmax(RTenum target);
RTAPI void RTAPIENTRY rtGetMinmax(RTenum target, RTboolean reset, RTenum format, RTenum type,
                                  void *values);
RTAPI void RTAPIENTRY rtGetMinmaxParameterfv(RTenum target, RTenum pname, RTfloat *params);
RTAPI void RTAPIENTRY rtGetMinmaxParameteriv(RTenum target, RTenum pname, RTint *params);
RTAPI void RTAPIENTRY rtConvolutionFilter1D(RTenum target, RTenum internalformat, RTsizei width,
                                            RTenum format, RTenum type, const void *image);
RTAPI void RTAPIENTRY rtConvolutionFilter2D(RTenum target, RTenum internalformat, RTsizei width,
                                            RTsizei height, RTenum format, RTenum type,
                                            const void *image);
RTAPI void RTAPIENTRY rtConvolutionParameterf(RTenum target, RTenum pname, RTfloat params);
RTAPI void RTAPIENTRY rtConvolutionParameterfv(RTenum target, RTenum pname, const RTfloat *params);
RTAPI void RTAPIENTRY rtConvolutionParameteri(RTenum target, RTenum pname, RTint params);
RTAPI void RTAPIENTRY rtConvolutionParameteriv(RTenum target, RTenum pname, const RTint *params);
RTAPI void RTAPIENTRY rtCopyConvolutionFilter1D(RTenum target, RTenum internalformat, RTint x,
                                                RTint y, RTsizei width);
RTAPI void RTAPIENTRY rtCopyConvolutionFilter2D(RTenum target, RTenum internalformat, RTint x,
                                                RTint y, RTsizei width, RTsizei height);
RTAPI void RTAPIENTRY rtGetConvolutionFilter(RTenum target, RTenum format, RTenum type,
                                             void *image);
RTAPI void RTAPIENTRY rtGetConvolutionParameterfv(RTenum target, RTenum pname, RTfloat *params);
RTAPI void RTAPIENTRY rtGetConvolutionParameteriv(RTenum target, RTenum pname, RTint *params);
RTAPI void RTAPIENTRY rtSeparableFilter2D(RTenum target, RTenum internalformat, RTsizei width,
                                          RTsizei height, RTenum format, RTenum type,
                                          const void *row, const void *column);
RTAPI void RTAPIENTRY rtGetSeparableFilter(RTenum target, RTenum format, RTenum type, void *row,
                                           void *column, void *span);

#ifdef __cplusplus
}
#endif

#endif
