/* SPDX-License-Identifier: MIT */
/* The functions of OpenGL 1.5 which this release declares and does not carry out. Each
 * records RT_INVALID_OPERATION with a text that names it, changes nothing and returns 0,
 * NULL or RT_FALSE. The others are in openrt/rt.h.
 * Written by compat/generate_calls.py; change the table, not this file. */
#ifndef OPENRT_RT_GL_H
#define OPENRT_RT_GL_H

#include "openrt/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Begin, end and current values */
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

/* Queries */
RTAPI void RTAPIENTRY rtGenQueries(RTsizei n, RTuint *ids);
RTAPI void RTAPIENTRY rtDeleteQueries(RTsizei n, const RTuint *ids);
RTAPI RTboolean RTAPIENTRY rtIsQuery(RTuint id);
RTAPI void RTAPIENTRY rtBeginQuery(RTenum target, RTuint id);
RTAPI void RTAPIENTRY rtEndQuery(RTenum target);
RTAPI void RTAPIENTRY rtGetQueryiv(RTenum target, RTenum pname, RTint *params);
RTAPI void RTAPIENTRY rtGetQueryObjectiv(RTuint id, RTenum pname, RTint *params);
RTAPI void RTAPIENTRY rtGetQueryObjectuiv(RTuint id, RTenum pname, RTuint *params);

/* Frame buffer */
RTAPI void RTAPIENTRY rtClearIndex(RTfloat c);
RTAPI void RTAPIENTRY rtIndexMask(RTuint mask);
RTAPI void RTAPIENTRY rtAccum(RTenum op, RTfloat value);

/* Textures */
RTAPI void RTAPIENTRY rtTexImage3D(RTenum target, RTint level, RTint internalformat, RTsizei width,
                                   RTsizei height, RTsizei depth, RTint border, RTenum format,
                                   RTenum type, const void *pixels);
RTAPI void RTAPIENTRY rtTexSubImage3D(RTenum target, RTint level, RTint xoffset, RTint yoffset,
                                      RTint zoffset, RTsizei width, RTsizei height, RTsizei depth,
                                      RTenum format, RTenum type, const void *pixels);
RTAPI void RTAPIENTRY rtCopyTexSubImage3D(RTenum target, RTint level, RTint xoffset, RTint yoffset,
                                          RTint zoffset, RTint x, RTint y, RTsizei width,
                                          RTsizei height);
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
RTAPI void RTAPIENTRY rtPixelMapfv(RTenum map, RTsizei mapsize, const RTfloat *values);
RTAPI void RTAPIENTRY rtPixelMapuiv(RTenum map, RTsizei mapsize, const RTuint *values);
RTAPI void RTAPIENTRY rtPixelMapusv(RTenum map, RTsizei mapsize, const RTushort *values);
RTAPI void RTAPIENTRY rtGetPixelMapfv(RTenum map, RTfloat *values);
RTAPI void RTAPIENTRY rtGetPixelMapuiv(RTenum map, RTuint *values);
RTAPI void RTAPIENTRY rtGetPixelMapusv(RTenum map, RTushort *values);

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
RTAPI void RTAPIENTRY rtFeedbackBuffer(RTsizei size, RTenum type, RTfloat *buffer);
RTAPI void RTAPIENTRY rtSelectBuffer(RTsizei size, RTuint *buffer);

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
