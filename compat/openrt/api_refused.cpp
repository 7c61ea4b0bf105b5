// SPDX-License-Identifier: MIT
// Written by compat/generate_calls.py; change the table, not this file.
#include "compat/openrt/guard.h"
#include "openrt/rt_gl.h"

using smart::compat::refused;
using smart::compat::refusedInPrimitive;

// Begin, end and current values
RTAPI void RTAPIENTRY rtIndexd(RTdouble) { refusedInPrimitive("rtIndexd"); }
RTAPI void RTAPIENTRY rtIndexf(RTfloat) { refusedInPrimitive("rtIndexf"); }
RTAPI void RTAPIENTRY rtIndexi(RTint) { refusedInPrimitive("rtIndexi"); }
RTAPI void RTAPIENTRY rtIndexs(RTshort) { refusedInPrimitive("rtIndexs"); }
RTAPI void RTAPIENTRY rtIndexub(RTubyte) { refusedInPrimitive("rtIndexub"); }
RTAPI void RTAPIENTRY rtIndexdv(const RTdouble *) { refusedInPrimitive("rtIndexdv"); }
RTAPI void RTAPIENTRY rtIndexfv(const RTfloat *) { refusedInPrimitive("rtIndexfv"); }
RTAPI void RTAPIENTRY rtIndexiv(const RTint *) { refusedInPrimitive("rtIndexiv"); }
RTAPI void RTAPIENTRY rtIndexsv(const RTshort *) { refusedInPrimitive("rtIndexsv"); }
RTAPI void RTAPIENTRY rtIndexubv(const RTubyte *) { refusedInPrimitive("rtIndexubv"); }

// Queries
RTAPI void RTAPIENTRY rtGenQueries(RTsizei, RTuint *) { refused("rtGenQueries"); }
RTAPI void RTAPIENTRY rtDeleteQueries(RTsizei, const RTuint *) { refused("rtDeleteQueries"); }
RTAPI RTboolean RTAPIENTRY rtIsQuery(RTuint) { refused("rtIsQuery"); return RT_FALSE; }
RTAPI void RTAPIENTRY rtBeginQuery(RTenum, RTuint) { refused("rtBeginQuery"); }
RTAPI void RTAPIENTRY rtEndQuery(RTenum) { refused("rtEndQuery"); }
RTAPI void RTAPIENTRY rtGetQueryiv(RTenum, RTenum, RTint *) { refused("rtGetQueryiv"); }
RTAPI void RTAPIENTRY rtGetQueryObjectiv(RTuint, RTenum, RTint *) { refused("rtGetQueryObjectiv"); }
RTAPI void RTAPIENTRY rtGetQueryObjectuiv(RTuint, RTenum,
    RTuint *) { refused("rtGetQueryObjectuiv"); }

// Frame buffer
RTAPI void RTAPIENTRY rtClearIndex(RTfloat) { refused("rtClearIndex"); }
RTAPI void RTAPIENTRY rtIndexMask(RTuint) { refused("rtIndexMask"); }
RTAPI void RTAPIENTRY rtAccum(RTenum, RTfloat) { refused("rtAccum"); }

// Textures
RTAPI void RTAPIENTRY rtTexImage3D(RTenum, RTint, RTint, RTsizei, RTsizei, RTsizei, RTint, RTenum,
    RTenum, const void *) { refused("rtTexImage3D"); }
RTAPI void RTAPIENTRY rtTexSubImage3D(RTenum, RTint, RTint, RTint, RTint, RTsizei, RTsizei, RTsizei,
    RTenum, RTenum, const void *) { refused("rtTexSubImage3D"); }
RTAPI void RTAPIENTRY rtCopyTexSubImage3D(RTenum, RTint, RTint, RTint, RTint, RTint, RTint, RTsizei,
    RTsizei) { refused("rtCopyTexSubImage3D"); }
RTAPI void RTAPIENTRY rtCompressedTexImage1D(RTenum, RTint, RTenum, RTsizei, RTint, RTsizei,
    const void *) { refused("rtCompressedTexImage1D"); }
RTAPI void RTAPIENTRY rtCompressedTexImage2D(RTenum, RTint, RTenum, RTsizei, RTsizei, RTint,
    RTsizei, const void *) { refused("rtCompressedTexImage2D"); }
RTAPI void RTAPIENTRY rtCompressedTexImage3D(RTenum, RTint, RTenum, RTsizei, RTsizei, RTsizei,
    RTint, RTsizei, const void *) { refused("rtCompressedTexImage3D"); }
RTAPI void RTAPIENTRY rtCompressedTexSubImage1D(RTenum, RTint, RTint, RTsizei, RTenum, RTsizei,
    const void *) { refused("rtCompressedTexSubImage1D"); }
RTAPI void RTAPIENTRY rtCompressedTexSubImage2D(RTenum, RTint, RTint, RTint, RTsizei, RTsizei,
    RTenum, RTsizei, const void *) { refused("rtCompressedTexSubImage2D"); }
RTAPI void RTAPIENTRY rtCompressedTexSubImage3D(RTenum, RTint, RTint, RTint, RTint, RTsizei,
    RTsizei, RTsizei, RTenum, RTsizei, const void *) { refused("rtCompressedTexSubImage3D"); }
RTAPI void RTAPIENTRY rtGetCompressedTexImage(RTenum, RTint,
    void *) { refused("rtGetCompressedTexImage"); }

// Pixels
RTAPI void RTAPIENTRY rtPixelMapfv(RTenum, RTsizei, const RTfloat *) { refused("rtPixelMapfv"); }
RTAPI void RTAPIENTRY rtPixelMapuiv(RTenum, RTsizei, const RTuint *) { refused("rtPixelMapuiv"); }
RTAPI void RTAPIENTRY rtPixelMapusv(RTenum, RTsizei, const RTushort *) { refused("rtPixelMapusv"); }
RTAPI void RTAPIENTRY rtGetPixelMapfv(RTenum, RTfloat *) { refused("rtGetPixelMapfv"); }
RTAPI void RTAPIENTRY rtGetPixelMapuiv(RTenum, RTuint *) { refused("rtGetPixelMapuiv"); }
RTAPI void RTAPIENTRY rtGetPixelMapusv(RTenum, RTushort *) { refused("rtGetPixelMapusv"); }

// Evaluators
RTAPI void RTAPIENTRY rtMap1d(RTenum, RTdouble, RTdouble, RTint, RTint,
    const RTdouble *) { refused("rtMap1d"); }
RTAPI void RTAPIENTRY rtMap1f(RTenum, RTfloat, RTfloat, RTint, RTint,
    const RTfloat *) { refused("rtMap1f"); }
RTAPI void RTAPIENTRY rtMap2d(RTenum, RTdouble, RTdouble, RTint, RTint, RTdouble, RTdouble, RTint,
    RTint, const RTdouble *) { refused("rtMap2d"); }
RTAPI void RTAPIENTRY rtMap2f(RTenum, RTfloat, RTfloat, RTint, RTint, RTfloat, RTfloat, RTint,
    RTint, const RTfloat *) { refused("rtMap2f"); }
RTAPI void RTAPIENTRY rtGetMapdv(RTenum, RTenum, RTdouble *) { refused("rtGetMapdv"); }
RTAPI void RTAPIENTRY rtGetMapfv(RTenum, RTenum, RTfloat *) { refused("rtGetMapfv"); }
RTAPI void RTAPIENTRY rtGetMapiv(RTenum, RTenum, RTint *) { refused("rtGetMapiv"); }
RTAPI void RTAPIENTRY rtEvalCoord1d(RTdouble) { refusedInPrimitive("rtEvalCoord1d"); }
RTAPI void RTAPIENTRY rtEvalCoord1f(RTfloat) { refusedInPrimitive("rtEvalCoord1f"); }
RTAPI void RTAPIENTRY rtEvalCoord1dv(const RTdouble *) { refusedInPrimitive("rtEvalCoord1dv"); }
RTAPI void RTAPIENTRY rtEvalCoord1fv(const RTfloat *) { refusedInPrimitive("rtEvalCoord1fv"); }
RTAPI void RTAPIENTRY rtEvalCoord2d(RTdouble, RTdouble) { refusedInPrimitive("rtEvalCoord2d"); }
RTAPI void RTAPIENTRY rtEvalCoord2f(RTfloat, RTfloat) { refusedInPrimitive("rtEvalCoord2f"); }
RTAPI void RTAPIENTRY rtEvalCoord2dv(const RTdouble *) { refusedInPrimitive("rtEvalCoord2dv"); }
RTAPI void RTAPIENTRY rtEvalCoord2fv(const RTfloat *) { refusedInPrimitive("rtEvalCoord2fv"); }
RTAPI void RTAPIENTRY rtMapGrid1d(RTint, RTdouble, RTdouble) { refused("rtMapGrid1d"); }
RTAPI void RTAPIENTRY rtMapGrid1f(RTint, RTfloat, RTfloat) { refused("rtMapGrid1f"); }
RTAPI void RTAPIENTRY rtMapGrid2d(RTint, RTdouble, RTdouble, RTint, RTdouble,
    RTdouble) { refused("rtMapGrid2d"); }
RTAPI void RTAPIENTRY rtMapGrid2f(RTint, RTfloat, RTfloat, RTint, RTfloat,
    RTfloat) { refused("rtMapGrid2f"); }
RTAPI void RTAPIENTRY rtEvalPoint1(RTint) { refusedInPrimitive("rtEvalPoint1"); }
RTAPI void RTAPIENTRY rtEvalPoint2(RTint, RTint) { refusedInPrimitive("rtEvalPoint2"); }
RTAPI void RTAPIENTRY rtEvalMesh1(RTenum, RTint, RTint) { refused("rtEvalMesh1"); }
RTAPI void RTAPIENTRY rtEvalMesh2(RTenum, RTint, RTint, RTint, RTint) { refused("rtEvalMesh2"); }

// Selection and feedback
RTAPI void RTAPIENTRY rtFeedbackBuffer(RTsizei, RTenum, RTfloat *) { refused("rtFeedbackBuffer"); }
RTAPI void RTAPIENTRY rtSelectBuffer(RTsizei, RTuint *) { refused("rtSelectBuffer"); }

// Imaging subset
RTAPI void RTAPIENTRY rtColorTable(RTenum, RTenum, RTsizei, RTenum, RTenum,
    const void *) { refused("rtColorTable"); }
RTAPI void RTAPIENTRY rtColorSubTable(RTenum, RTsizei, RTsizei, RTenum, RTenum,
    const void *) { refused("rtColorSubTable"); }
RTAPI void RTAPIENTRY rtColorTableParameteriv(RTenum, RTenum,
    const RTint *) { refused("rtColorTableParameteriv"); }
RTAPI void RTAPIENTRY rtColorTableParameterfv(RTenum, RTenum,
    const RTfloat *) { refused("rtColorTableParameterfv"); }
RTAPI void RTAPIENTRY rtCopyColorSubTable(RTenum, RTsizei, RTint, RTint,
    RTsizei) { refused("rtCopyColorSubTable"); }
RTAPI void RTAPIENTRY rtCopyColorTable(RTenum, RTenum, RTint, RTint,
    RTsizei) { refused("rtCopyColorTable"); }
RTAPI void RTAPIENTRY rtGetColorTable(RTenum, RTenum, RTenum,
    void *) { refused("rtGetColorTable"); }
RTAPI void RTAPIENTRY rtGetColorTableParameterfv(RTenum, RTenum,
    RTfloat *) { refused("rtGetColorTableParameterfv"); }
RTAPI void RTAPIENTRY rtGetColorTableParameteriv(RTenum, RTenum,
    RTint *) { refused("rtGetColorTableParameteriv"); }
RTAPI void RTAPIENTRY rtHistogram(RTenum, RTsizei, RTenum, RTboolean) { refused("rtHistogram"); }
RTAPI void RTAPIENTRY rtResetHistogram(RTenum) { refused("rtResetHistogram"); }
RTAPI void RTAPIENTRY rtGetHistogram(RTenum, RTboolean, RTenum, RTenum,
    void *) { refused("rtGetHistogram"); }
RTAPI void RTAPIENTRY rtGetHistogramParameterfv(RTenum, RTenum,
    RTfloat *) { refused("rtGetHistogramParameterfv"); }
RTAPI void RTAPIENTRY rtGetHistogramParameteriv(RTenum, RTenum,
    RTint *) { refused("rtGetHistogramParameteriv"); }
RTAPI void RTAPIENTRY rtMinmax(RTenum, RTenum, RTboolean) { refused("rtMinmax"); }
RTAPI void RTAPIENTRY rtResetMinmax(RTenum) { refused("rtResetMinmax"); }
RTAPI void RTAPIENTRY rtGetMinmax(RTenum, RTboolean, RTenum, RTenum,
    void *) { refused("rtGetMinmax"); }
RTAPI void RTAPIENTRY rtGetMinmaxParameterfv(RTenum, RTenum,
    RTfloat *) { refused("rtGetMinmaxParameterfv"); }
RTAPI void RTAPIENTRY rtGetMinmaxParameteriv(RTenum, RTenum,
    RTint *) { refused("rtGetMinmaxParameteriv"); }
RTAPI void RTAPIENTRY rtConvolutionFilter1D(RTenum, RTenum, RTsizei, RTenum, RTenum,
    const void *) { refused("rtConvolutionFilter1D"); }
RTAPI void RTAPIENTRY rtConvolutionFilter2D(RTenum, RTenum, RTsizei, RTsizei, RTenum, RTenum,
    const void *) { refused("rtConvolutionFilter2D"); }
RTAPI void RTAPIENTRY rtConvolutionParameterf(RTenum, RTenum,
    RTfloat) { refused("rtConvolutionParameterf"); }
RTAPI void RTAPIENTRY rtConvolutionParameterfv(RTenum, RTenum,
    const RTfloat *) { refused("rtConvolutionParameterfv"); }
RTAPI void RTAPIENTRY rtConvolutionParameteri(RTenum, RTenum,
    RTint) { refused("rtConvolutionParameteri"); }
RTAPI void RTAPIENTRY rtConvolutionParameteriv(RTenum, RTenum,
    const RTint *) { refused("rtConvolutionParameteriv"); }
RTAPI void RTAPIENTRY rtCopyConvolutionFilter1D(RTenum, RTenum, RTint, RTint,
    RTsizei) { refused("rtCopyConvolutionFilter1D"); }
RTAPI void RTAPIENTRY rtCopyConvolutionFilter2D(RTenum, RTenum, RTint, RTint, RTsizei,
    RTsizei) { refused("rtCopyConvolutionFilter2D"); }
RTAPI void RTAPIENTRY rtGetConvolutionFilter(RTenum, RTenum, RTenum,
    void *) { refused("rtGetConvolutionFilter"); }
RTAPI void RTAPIENTRY rtGetConvolutionParameterfv(RTenum, RTenum,
    RTfloat *) { refused("rtGetConvolutionParameterfv"); }
RTAPI void RTAPIENTRY rtGetConvolutionParameteriv(RTenum, RTenum,
    RTint *) { refused("rtGetConvolutionParameteriv"); }
RTAPI void RTAPIENTRY rtSeparableFilter2D(RTenum, RTenum, RTsizei, RTsizei, RTenum, RTenum,
    const void *, const void *) { refused("rtSeparableFilter2D"); }
RTAPI void RTAPIENTRY rtGetSeparableFilter(RTenum, RTenum, RTenum, void *, void *,
    void *) { refused("rtGetSeparableFilter"); }
