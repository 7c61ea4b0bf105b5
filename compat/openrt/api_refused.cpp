// SPDX-License-Identifier: MIT
// Written by compat/generate_calls.py; change the table, not this file.
#include "compat/openrt/guard.h"
#include "openrt/rt_gl.h"

using smart::compat::refused;

// State
RTAPI void RTAPIENTRY rtPushAttrib(RTbitfield) { refused("rtPushAttrib"); }
RTAPI void RTAPIENTRY rtPopAttrib(void) { refused("rtPopAttrib"); }
RTAPI void RTAPIENTRY rtPushClientAttrib(RTbitfield) { refused("rtPushClientAttrib"); }
RTAPI void RTAPIENTRY rtPopClientAttrib(void) { refused("rtPopClientAttrib"); }

// Begin, end and current values
RTAPI void RTAPIENTRY rtEdgeFlag(RTboolean) { refused("rtEdgeFlag"); }
RTAPI void RTAPIENTRY rtEdgeFlagv(const RTboolean *) { refused("rtEdgeFlagv"); }
RTAPI void RTAPIENTRY rtIndexd(RTdouble) { refused("rtIndexd"); }
RTAPI void RTAPIENTRY rtIndexf(RTfloat) { refused("rtIndexf"); }
RTAPI void RTAPIENTRY rtIndexi(RTint) { refused("rtIndexi"); }
RTAPI void RTAPIENTRY rtIndexs(RTshort) { refused("rtIndexs"); }
RTAPI void RTAPIENTRY rtIndexub(RTubyte) { refused("rtIndexub"); }
RTAPI void RTAPIENTRY rtIndexdv(const RTdouble *) { refused("rtIndexdv"); }
RTAPI void RTAPIENTRY rtIndexfv(const RTfloat *) { refused("rtIndexfv"); }
RTAPI void RTAPIENTRY rtIndexiv(const RTint *) { refused("rtIndexiv"); }
RTAPI void RTAPIENTRY rtIndexsv(const RTshort *) { refused("rtIndexsv"); }
RTAPI void RTAPIENTRY rtIndexubv(const RTubyte *) { refused("rtIndexubv"); }
RTAPI void RTAPIENTRY rtRectd(RTdouble, RTdouble, RTdouble, RTdouble) { refused("rtRectd"); }
RTAPI void RTAPIENTRY rtRectf(RTfloat, RTfloat, RTfloat, RTfloat) { refused("rtRectf"); }
RTAPI void RTAPIENTRY rtRecti(RTint, RTint, RTint, RTint) { refused("rtRecti"); }
RTAPI void RTAPIENTRY rtRects(RTshort, RTshort, RTshort, RTshort) { refused("rtRects"); }
RTAPI void RTAPIENTRY rtRectdv(const RTdouble *, const RTdouble *) { refused("rtRectdv"); }
RTAPI void RTAPIENTRY rtRectfv(const RTfloat *, const RTfloat *) { refused("rtRectfv"); }
RTAPI void RTAPIENTRY rtRectiv(const RTint *, const RTint *) { refused("rtRectiv"); }
RTAPI void RTAPIENTRY rtRectsv(const RTshort *, const RTshort *) { refused("rtRectsv"); }
RTAPI void RTAPIENTRY rtMultiTexCoord1d(RTenum, RTdouble) { refused("rtMultiTexCoord1d"); }
RTAPI void RTAPIENTRY rtMultiTexCoord1dv(RTenum,
    const RTdouble *) { refused("rtMultiTexCoord1dv"); }
RTAPI void RTAPIENTRY rtMultiTexCoord1f(RTenum, RTfloat) { refused("rtMultiTexCoord1f"); }
RTAPI void RTAPIENTRY rtMultiTexCoord1fv(RTenum, const RTfloat *) { refused("rtMultiTexCoord1fv"); }
RTAPI void RTAPIENTRY rtMultiTexCoord1i(RTenum, RTint) { refused("rtMultiTexCoord1i"); }
RTAPI void RTAPIENTRY rtMultiTexCoord1iv(RTenum, const RTint *) { refused("rtMultiTexCoord1iv"); }
RTAPI void RTAPIENTRY rtMultiTexCoord1s(RTenum, RTshort) { refused("rtMultiTexCoord1s"); }
RTAPI void RTAPIENTRY rtMultiTexCoord1sv(RTenum, const RTshort *) { refused("rtMultiTexCoord1sv"); }
RTAPI void RTAPIENTRY rtMultiTexCoord2d(RTenum, RTdouble,
    RTdouble) { refused("rtMultiTexCoord2d"); }
RTAPI void RTAPIENTRY rtMultiTexCoord2dv(RTenum,
    const RTdouble *) { refused("rtMultiTexCoord2dv"); }
RTAPI void RTAPIENTRY rtMultiTexCoord2f(RTenum, RTfloat, RTfloat) { refused("rtMultiTexCoord2f"); }
RTAPI void RTAPIENTRY rtMultiTexCoord2fv(RTenum, const RTfloat *) { refused("rtMultiTexCoord2fv"); }
RTAPI void RTAPIENTRY rtMultiTexCoord2i(RTenum, RTint, RTint) { refused("rtMultiTexCoord2i"); }
RTAPI void RTAPIENTRY rtMultiTexCoord2iv(RTenum, const RTint *) { refused("rtMultiTexCoord2iv"); }
RTAPI void RTAPIENTRY rtMultiTexCoord2s(RTenum, RTshort, RTshort) { refused("rtMultiTexCoord2s"); }
RTAPI void RTAPIENTRY rtMultiTexCoord2sv(RTenum, const RTshort *) { refused("rtMultiTexCoord2sv"); }
RTAPI void RTAPIENTRY rtMultiTexCoord3d(RTenum, RTdouble, RTdouble,
    RTdouble) { refused("rtMultiTexCoord3d"); }
RTAPI void RTAPIENTRY rtMultiTexCoord3dv(RTenum,
    const RTdouble *) { refused("rtMultiTexCoord3dv"); }
RTAPI void RTAPIENTRY rtMultiTexCoord3f(RTenum, RTfloat, RTfloat,
    RTfloat) { refused("rtMultiTexCoord3f"); }
RTAPI void RTAPIENTRY rtMultiTexCoord3fv(RTenum, const RTfloat *) { refused("rtMultiTexCoord3fv"); }
RTAPI void RTAPIENTRY rtMultiTexCoord3i(RTenum, RTint, RTint,
    RTint) { refused("rtMultiTexCoord3i"); }
RTAPI void RTAPIENTRY rtMultiTexCoord3iv(RTenum, const RTint *) { refused("rtMultiTexCoord3iv"); }
RTAPI void RTAPIENTRY rtMultiTexCoord3s(RTenum, RTshort, RTshort,
    RTshort) { refused("rtMultiTexCoord3s"); }
RTAPI void RTAPIENTRY rtMultiTexCoord3sv(RTenum, const RTshort *) { refused("rtMultiTexCoord3sv"); }
RTAPI void RTAPIENTRY rtMultiTexCoord4d(RTenum, RTdouble, RTdouble, RTdouble,
    RTdouble) { refused("rtMultiTexCoord4d"); }
RTAPI void RTAPIENTRY rtMultiTexCoord4dv(RTenum,
    const RTdouble *) { refused("rtMultiTexCoord4dv"); }
RTAPI void RTAPIENTRY rtMultiTexCoord4f(RTenum, RTfloat, RTfloat, RTfloat,
    RTfloat) { refused("rtMultiTexCoord4f"); }
RTAPI void RTAPIENTRY rtMultiTexCoord4fv(RTenum, const RTfloat *) { refused("rtMultiTexCoord4fv"); }
RTAPI void RTAPIENTRY rtMultiTexCoord4i(RTenum, RTint, RTint, RTint,
    RTint) { refused("rtMultiTexCoord4i"); }
RTAPI void RTAPIENTRY rtMultiTexCoord4iv(RTenum, const RTint *) { refused("rtMultiTexCoord4iv"); }
RTAPI void RTAPIENTRY rtMultiTexCoord4s(RTenum, RTshort, RTshort, RTshort,
    RTshort) { refused("rtMultiTexCoord4s"); }
RTAPI void RTAPIENTRY rtMultiTexCoord4sv(RTenum, const RTshort *) { refused("rtMultiTexCoord4sv"); }
RTAPI void RTAPIENTRY rtFogCoordf(RTfloat) { refused("rtFogCoordf"); }
RTAPI void RTAPIENTRY rtFogCoordfv(const RTfloat *) { refused("rtFogCoordfv"); }
RTAPI void RTAPIENTRY rtFogCoordd(RTdouble) { refused("rtFogCoordd"); }
RTAPI void RTAPIENTRY rtFogCoorddv(const RTdouble *) { refused("rtFogCoorddv"); }
RTAPI void RTAPIENTRY rtSecondaryColor3b(RTbyte, RTbyte, RTbyte) { refused("rtSecondaryColor3b"); }
RTAPI void RTAPIENTRY rtSecondaryColor3bv(const RTbyte *) { refused("rtSecondaryColor3bv"); }
RTAPI void RTAPIENTRY rtSecondaryColor3d(RTdouble, RTdouble,
    RTdouble) { refused("rtSecondaryColor3d"); }
RTAPI void RTAPIENTRY rtSecondaryColor3dv(const RTdouble *) { refused("rtSecondaryColor3dv"); }
RTAPI void RTAPIENTRY rtSecondaryColor3f(RTfloat, RTfloat,
    RTfloat) { refused("rtSecondaryColor3f"); }
RTAPI void RTAPIENTRY rtSecondaryColor3fv(const RTfloat *) { refused("rtSecondaryColor3fv"); }
RTAPI void RTAPIENTRY rtSecondaryColor3i(RTint, RTint, RTint) { refused("rtSecondaryColor3i"); }
RTAPI void RTAPIENTRY rtSecondaryColor3iv(const RTint *) { refused("rtSecondaryColor3iv"); }
RTAPI void RTAPIENTRY rtSecondaryColor3s(RTshort, RTshort,
    RTshort) { refused("rtSecondaryColor3s"); }
RTAPI void RTAPIENTRY rtSecondaryColor3sv(const RTshort *) { refused("rtSecondaryColor3sv"); }
RTAPI void RTAPIENTRY rtSecondaryColor3ub(RTubyte, RTubyte,
    RTubyte) { refused("rtSecondaryColor3ub"); }
RTAPI void RTAPIENTRY rtSecondaryColor3ubv(const RTubyte *) { refused("rtSecondaryColor3ubv"); }
RTAPI void RTAPIENTRY rtSecondaryColor3ui(RTuint, RTuint,
    RTuint) { refused("rtSecondaryColor3ui"); }
RTAPI void RTAPIENTRY rtSecondaryColor3uiv(const RTuint *) { refused("rtSecondaryColor3uiv"); }
RTAPI void RTAPIENTRY rtSecondaryColor3us(RTushort, RTushort,
    RTushort) { refused("rtSecondaryColor3us"); }
RTAPI void RTAPIENTRY rtSecondaryColor3usv(const RTushort *) { refused("rtSecondaryColor3usv"); }

// Matrices
RTAPI void RTAPIENTRY rtDepthRange(RTclampd, RTclampd) { refused("rtDepthRange"); }

// Raster position
RTAPI void RTAPIENTRY rtRasterPos2d(RTdouble, RTdouble) { refused("rtRasterPos2d"); }
RTAPI void RTAPIENTRY rtRasterPos2f(RTfloat, RTfloat) { refused("rtRasterPos2f"); }
RTAPI void RTAPIENTRY rtRasterPos2i(RTint, RTint) { refused("rtRasterPos2i"); }
RTAPI void RTAPIENTRY rtRasterPos2s(RTshort, RTshort) { refused("rtRasterPos2s"); }
RTAPI void RTAPIENTRY rtRasterPos3d(RTdouble, RTdouble, RTdouble) { refused("rtRasterPos3d"); }
RTAPI void RTAPIENTRY rtRasterPos3f(RTfloat, RTfloat, RTfloat) { refused("rtRasterPos3f"); }
RTAPI void RTAPIENTRY rtRasterPos3i(RTint, RTint, RTint) { refused("rtRasterPos3i"); }
RTAPI void RTAPIENTRY rtRasterPos3s(RTshort, RTshort, RTshort) { refused("rtRasterPos3s"); }
RTAPI void RTAPIENTRY rtRasterPos4d(RTdouble, RTdouble, RTdouble,
    RTdouble) { refused("rtRasterPos4d"); }
RTAPI void RTAPIENTRY rtRasterPos4f(RTfloat, RTfloat, RTfloat,
    RTfloat) { refused("rtRasterPos4f"); }
RTAPI void RTAPIENTRY rtRasterPos4i(RTint, RTint, RTint, RTint) { refused("rtRasterPos4i"); }
RTAPI void RTAPIENTRY rtRasterPos4s(RTshort, RTshort, RTshort,
    RTshort) { refused("rtRasterPos4s"); }
RTAPI void RTAPIENTRY rtRasterPos2dv(const RTdouble *) { refused("rtRasterPos2dv"); }
RTAPI void RTAPIENTRY rtRasterPos2fv(const RTfloat *) { refused("rtRasterPos2fv"); }
RTAPI void RTAPIENTRY rtRasterPos2iv(const RTint *) { refused("rtRasterPos2iv"); }
RTAPI void RTAPIENTRY rtRasterPos2sv(const RTshort *) { refused("rtRasterPos2sv"); }
RTAPI void RTAPIENTRY rtRasterPos3dv(const RTdouble *) { refused("rtRasterPos3dv"); }
RTAPI void RTAPIENTRY rtRasterPos3fv(const RTfloat *) { refused("rtRasterPos3fv"); }
RTAPI void RTAPIENTRY rtRasterPos3iv(const RTint *) { refused("rtRasterPos3iv"); }
RTAPI void RTAPIENTRY rtRasterPos3sv(const RTshort *) { refused("rtRasterPos3sv"); }
RTAPI void RTAPIENTRY rtRasterPos4dv(const RTdouble *) { refused("rtRasterPos4dv"); }
RTAPI void RTAPIENTRY rtRasterPos4fv(const RTfloat *) { refused("rtRasterPos4fv"); }
RTAPI void RTAPIENTRY rtRasterPos4iv(const RTint *) { refused("rtRasterPos4iv"); }
RTAPI void RTAPIENTRY rtRasterPos4sv(const RTshort *) { refused("rtRasterPos4sv"); }
RTAPI void RTAPIENTRY rtWindowPos2d(RTdouble, RTdouble) { refused("rtWindowPos2d"); }
RTAPI void RTAPIENTRY rtWindowPos2dv(const RTdouble *) { refused("rtWindowPos2dv"); }
RTAPI void RTAPIENTRY rtWindowPos2f(RTfloat, RTfloat) { refused("rtWindowPos2f"); }
RTAPI void RTAPIENTRY rtWindowPos2fv(const RTfloat *) { refused("rtWindowPos2fv"); }
RTAPI void RTAPIENTRY rtWindowPos2i(RTint, RTint) { refused("rtWindowPos2i"); }
RTAPI void RTAPIENTRY rtWindowPos2iv(const RTint *) { refused("rtWindowPos2iv"); }
RTAPI void RTAPIENTRY rtWindowPos2s(RTshort, RTshort) { refused("rtWindowPos2s"); }
RTAPI void RTAPIENTRY rtWindowPos2sv(const RTshort *) { refused("rtWindowPos2sv"); }
RTAPI void RTAPIENTRY rtWindowPos3d(RTdouble, RTdouble, RTdouble) { refused("rtWindowPos3d"); }
RTAPI void RTAPIENTRY rtWindowPos3dv(const RTdouble *) { refused("rtWindowPos3dv"); }
RTAPI void RTAPIENTRY rtWindowPos3f(RTfloat, RTfloat, RTfloat) { refused("rtWindowPos3f"); }
RTAPI void RTAPIENTRY rtWindowPos3fv(const RTfloat *) { refused("rtWindowPos3fv"); }
RTAPI void RTAPIENTRY rtWindowPos3i(RTint, RTint, RTint) { refused("rtWindowPos3i"); }
RTAPI void RTAPIENTRY rtWindowPos3iv(const RTint *) { refused("rtWindowPos3iv"); }
RTAPI void RTAPIENTRY rtWindowPos3s(RTshort, RTshort, RTshort) { refused("rtWindowPos3s"); }
RTAPI void RTAPIENTRY rtWindowPos3sv(const RTshort *) { refused("rtWindowPos3sv"); }

// Vertex arrays
RTAPI void RTAPIENTRY rtEnableClientState(RTenum) { refused("rtEnableClientState"); }
RTAPI void RTAPIENTRY rtDisableClientState(RTenum) { refused("rtDisableClientState"); }
RTAPI void RTAPIENTRY rtVertexPointer(RTint, RTenum, RTsizei,
    const void *) { refused("rtVertexPointer"); }
RTAPI void RTAPIENTRY rtNormalPointer(RTenum, RTsizei, const void *) { refused("rtNormalPointer"); }
RTAPI void RTAPIENTRY rtColorPointer(RTint, RTenum, RTsizei,
    const void *) { refused("rtColorPointer"); }
RTAPI void RTAPIENTRY rtIndexPointer(RTenum, RTsizei, const void *) { refused("rtIndexPointer"); }
RTAPI void RTAPIENTRY rtTexCoordPointer(RTint, RTenum, RTsizei,
    const void *) { refused("rtTexCoordPointer"); }
RTAPI void RTAPIENTRY rtEdgeFlagPointer(RTsizei, const void *) { refused("rtEdgeFlagPointer"); }
RTAPI void RTAPIENTRY rtGetPointerv(RTenum, void **) { refused("rtGetPointerv"); }
RTAPI void RTAPIENTRY rtArrayElement(RTint) { refused("rtArrayElement"); }
RTAPI void RTAPIENTRY rtDrawArrays(RTenum, RTint, RTsizei) { refused("rtDrawArrays"); }
RTAPI void RTAPIENTRY rtDrawElements(RTenum, RTsizei, RTenum,
    const void *) { refused("rtDrawElements"); }
RTAPI void RTAPIENTRY rtInterleavedArrays(RTenum, RTsizei,
    const void *) { refused("rtInterleavedArrays"); }
RTAPI void RTAPIENTRY rtDrawRangeElements(RTenum, RTuint, RTuint, RTsizei, RTenum,
    const void *) { refused("rtDrawRangeElements"); }
RTAPI void RTAPIENTRY rtClientActiveTexture(RTenum) { refused("rtClientActiveTexture"); }
RTAPI void RTAPIENTRY rtMultiDrawArrays(RTenum, const RTint *, const RTsizei *,
    RTsizei) { refused("rtMultiDrawArrays"); }
RTAPI void RTAPIENTRY rtMultiDrawElements(RTenum, const RTsizei *, RTenum, const void *const *,
    RTsizei) { refused("rtMultiDrawElements"); }
RTAPI void RTAPIENTRY rtFogCoordPointer(RTenum, RTsizei,
    const void *) { refused("rtFogCoordPointer"); }
RTAPI void RTAPIENTRY rtSecondaryColorPointer(RTint, RTenum, RTsizei,
    const void *) { refused("rtSecondaryColorPointer"); }

// Buffer objects
RTAPI void RTAPIENTRY rtBindBuffer(RTenum, RTuint) { refused("rtBindBuffer"); }
RTAPI void RTAPIENTRY rtDeleteBuffers(RTsizei, const RTuint *) { refused("rtDeleteBuffers"); }
RTAPI void RTAPIENTRY rtGenBuffers(RTsizei, RTuint *) { refused("rtGenBuffers"); }
RTAPI RTboolean RTAPIENTRY rtIsBuffer(RTuint) { refused("rtIsBuffer"); return RT_FALSE; }
RTAPI void RTAPIENTRY rtBufferData(RTenum, RTsizeiptr, const void *,
    RTenum) { refused("rtBufferData"); }
RTAPI void RTAPIENTRY rtBufferSubData(RTenum, RTintptr, RTsizeiptr,
    const void *) { refused("rtBufferSubData"); }
RTAPI void RTAPIENTRY rtGetBufferSubData(RTenum, RTintptr, RTsizeiptr,
    void *) { refused("rtGetBufferSubData"); }
RTAPI void *RTAPIENTRY rtMapBuffer(RTenum, RTenum) { refused("rtMapBuffer"); return nullptr; }
RTAPI RTboolean RTAPIENTRY rtUnmapBuffer(RTenum) { refused("rtUnmapBuffer"); return RT_FALSE; }
RTAPI void RTAPIENTRY rtGetBufferParameteriv(RTenum, RTenum,
    RTint *) { refused("rtGetBufferParameteriv"); }
RTAPI void RTAPIENTRY rtGetBufferPointerv(RTenum, RTenum,
    void **) { refused("rtGetBufferPointerv"); }

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

// Lighting and materials
RTAPI void RTAPIENTRY rtShadeModel(RTenum) { refused("rtShadeModel"); }
RTAPI void RTAPIENTRY rtLightf(RTenum, RTenum, RTfloat) { refused("rtLightf"); }
RTAPI void RTAPIENTRY rtLighti(RTenum, RTenum, RTint) { refused("rtLighti"); }
RTAPI void RTAPIENTRY rtLightfv(RTenum, RTenum, const RTfloat *) { refused("rtLightfv"); }
RTAPI void RTAPIENTRY rtLightiv(RTenum, RTenum, const RTint *) { refused("rtLightiv"); }
RTAPI void RTAPIENTRY rtGetLightfv(RTenum, RTenum, RTfloat *) { refused("rtGetLightfv"); }
RTAPI void RTAPIENTRY rtGetLightiv(RTenum, RTenum, RTint *) { refused("rtGetLightiv"); }
RTAPI void RTAPIENTRY rtLightModelf(RTenum, RTfloat) { refused("rtLightModelf"); }
RTAPI void RTAPIENTRY rtLightModeli(RTenum, RTint) { refused("rtLightModeli"); }
RTAPI void RTAPIENTRY rtLightModelfv(RTenum, const RTfloat *) { refused("rtLightModelfv"); }
RTAPI void RTAPIENTRY rtLightModeliv(RTenum, const RTint *) { refused("rtLightModeliv"); }
RTAPI void RTAPIENTRY rtMaterialf(RTenum, RTenum, RTfloat) { refused("rtMaterialf"); }
RTAPI void RTAPIENTRY rtMateriali(RTenum, RTenum, RTint) { refused("rtMateriali"); }
RTAPI void RTAPIENTRY rtMaterialfv(RTenum, RTenum, const RTfloat *) { refused("rtMaterialfv"); }
RTAPI void RTAPIENTRY rtMaterialiv(RTenum, RTenum, const RTint *) { refused("rtMaterialiv"); }
RTAPI void RTAPIENTRY rtGetMaterialfv(RTenum, RTenum, RTfloat *) { refused("rtGetMaterialfv"); }
RTAPI void RTAPIENTRY rtGetMaterialiv(RTenum, RTenum, RTint *) { refused("rtGetMaterialiv"); }
RTAPI void RTAPIENTRY rtColorMaterial(RTenum, RTenum) { refused("rtColorMaterial"); }

// Fog
RTAPI void RTAPIENTRY rtFogf(RTenum, RTfloat) { refused("rtFogf"); }
RTAPI void RTAPIENTRY rtFogi(RTenum, RTint) { refused("rtFogi"); }
RTAPI void RTAPIENTRY rtFogfv(RTenum, const RTfloat *) { refused("rtFogfv"); }
RTAPI void RTAPIENTRY rtFogiv(RTenum, const RTint *) { refused("rtFogiv"); }

// Rasterisation and fragments
RTAPI void RTAPIENTRY rtAlphaFunc(RTenum, RTclampf) { refused("rtAlphaFunc"); }
RTAPI void RTAPIENTRY rtBlendFunc(RTenum, RTenum) { refused("rtBlendFunc"); }
RTAPI void RTAPIENTRY rtLogicOp(RTenum) { refused("rtLogicOp"); }
RTAPI void RTAPIENTRY rtCullFace(RTenum) { refused("rtCullFace"); }
RTAPI void RTAPIENTRY rtFrontFace(RTenum) { refused("rtFrontFace"); }
RTAPI void RTAPIENTRY rtPointSize(RTfloat) { refused("rtPointSize"); }
RTAPI void RTAPIENTRY rtLineWidth(RTfloat) { refused("rtLineWidth"); }
RTAPI void RTAPIENTRY rtLineStipple(RTint, RTushort) { refused("rtLineStipple"); }
RTAPI void RTAPIENTRY rtPolygonMode(RTenum, RTenum) { refused("rtPolygonMode"); }
RTAPI void RTAPIENTRY rtPolygonOffset(RTfloat, RTfloat) { refused("rtPolygonOffset"); }
RTAPI void RTAPIENTRY rtPolygonStipple(const RTubyte *) { refused("rtPolygonStipple"); }
RTAPI void RTAPIENTRY rtGetPolygonStipple(RTubyte *) { refused("rtGetPolygonStipple"); }
RTAPI void RTAPIENTRY rtScissor(RTint, RTint, RTsizei, RTsizei) { refused("rtScissor"); }
RTAPI void RTAPIENTRY rtClipPlane(RTenum, const RTdouble *) { refused("rtClipPlane"); }
RTAPI void RTAPIENTRY rtGetClipPlane(RTenum, RTdouble *) { refused("rtGetClipPlane"); }
RTAPI void RTAPIENTRY rtDepthFunc(RTenum) { refused("rtDepthFunc"); }
RTAPI void RTAPIENTRY rtStencilFunc(RTenum, RTint, RTuint) { refused("rtStencilFunc"); }
RTAPI void RTAPIENTRY rtStencilOp(RTenum, RTenum, RTenum) { refused("rtStencilOp"); }
RTAPI void RTAPIENTRY rtBlendEquation(RTenum) { refused("rtBlendEquation"); }
RTAPI void RTAPIENTRY rtBlendColor(RTfloat, RTfloat, RTfloat, RTfloat) { refused("rtBlendColor"); }
RTAPI void RTAPIENTRY rtSampleCoverage(RTfloat, RTboolean) { refused("rtSampleCoverage"); }
RTAPI void RTAPIENTRY rtBlendFuncSeparate(RTenum, RTenum, RTenum,
    RTenum) { refused("rtBlendFuncSeparate"); }
RTAPI void RTAPIENTRY rtPointParameterf(RTenum, RTfloat) { refused("rtPointParameterf"); }
RTAPI void RTAPIENTRY rtPointParameterfv(RTenum, const RTfloat *) { refused("rtPointParameterfv"); }
RTAPI void RTAPIENTRY rtPointParameteri(RTenum, RTint) { refused("rtPointParameteri"); }
RTAPI void RTAPIENTRY rtPointParameteriv(RTenum, const RTint *) { refused("rtPointParameteriv"); }

// Frame buffer
RTAPI void RTAPIENTRY rtClearIndex(RTfloat) { refused("rtClearIndex"); }
RTAPI void RTAPIENTRY rtClear(RTbitfield) { refused("rtClear"); }
RTAPI void RTAPIENTRY rtIndexMask(RTuint) { refused("rtIndexMask"); }
RTAPI void RTAPIENTRY rtColorMask(RTboolean, RTboolean, RTboolean,
    RTboolean) { refused("rtColorMask"); }
RTAPI void RTAPIENTRY rtDrawBuffer(RTenum) { refused("rtDrawBuffer"); }
RTAPI void RTAPIENTRY rtReadBuffer(RTenum) { refused("rtReadBuffer"); }
RTAPI void RTAPIENTRY rtClearDepth(RTclampd) { refused("rtClearDepth"); }
RTAPI void RTAPIENTRY rtDepthMask(RTboolean) { refused("rtDepthMask"); }
RTAPI void RTAPIENTRY rtClearAccum(RTfloat, RTfloat, RTfloat, RTfloat) { refused("rtClearAccum"); }
RTAPI void RTAPIENTRY rtAccum(RTenum, RTfloat) { refused("rtAccum"); }
RTAPI void RTAPIENTRY rtStencilMask(RTuint) { refused("rtStencilMask"); }
RTAPI void RTAPIENTRY rtClearStencil(RTint) { refused("rtClearStencil"); }

// Textures
RTAPI void RTAPIENTRY rtTexGend(RTenum, RTenum, RTdouble) { refused("rtTexGend"); }
RTAPI void RTAPIENTRY rtTexGenf(RTenum, RTenum, RTfloat) { refused("rtTexGenf"); }
RTAPI void RTAPIENTRY rtTexGeni(RTenum, RTenum, RTint) { refused("rtTexGeni"); }
RTAPI void RTAPIENTRY rtTexGendv(RTenum, RTenum, const RTdouble *) { refused("rtTexGendv"); }
RTAPI void RTAPIENTRY rtTexGenfv(RTenum, RTenum, const RTfloat *) { refused("rtTexGenfv"); }
RTAPI void RTAPIENTRY rtTexGeniv(RTenum, RTenum, const RTint *) { refused("rtTexGeniv"); }
RTAPI void RTAPIENTRY rtGetTexGendv(RTenum, RTenum, RTdouble *) { refused("rtGetTexGendv"); }
RTAPI void RTAPIENTRY rtGetTexGenfv(RTenum, RTenum, RTfloat *) { refused("rtGetTexGenfv"); }
RTAPI void RTAPIENTRY rtGetTexGeniv(RTenum, RTenum, RTint *) { refused("rtGetTexGeniv"); }
RTAPI void RTAPIENTRY rtTexEnvf(RTenum, RTenum, RTfloat) { refused("rtTexEnvf"); }
RTAPI void RTAPIENTRY rtTexEnvi(RTenum, RTenum, RTint) { refused("rtTexEnvi"); }
RTAPI void RTAPIENTRY rtTexEnvfv(RTenum, RTenum, const RTfloat *) { refused("rtTexEnvfv"); }
RTAPI void RTAPIENTRY rtTexEnviv(RTenum, RTenum, const RTint *) { refused("rtTexEnviv"); }
RTAPI void RTAPIENTRY rtGetTexEnvfv(RTenum, RTenum, RTfloat *) { refused("rtGetTexEnvfv"); }
RTAPI void RTAPIENTRY rtGetTexEnviv(RTenum, RTenum, RTint *) { refused("rtGetTexEnviv"); }
RTAPI void RTAPIENTRY rtTexImage1D(RTenum, RTint, RTint, RTsizei, RTint, RTenum, RTenum,
    const void *) { refused("rtTexImage1D"); }
RTAPI void RTAPIENTRY rtGetTexImage(RTenum, RTint, RTenum, RTenum,
    void *) { refused("rtGetTexImage"); }
RTAPI void RTAPIENTRY rtPrioritizeTextures(RTsizei, const RTuint *,
    const RTclampf *) { refused("rtPrioritizeTextures"); }
RTAPI RTboolean RTAPIENTRY rtAreTexturesResident(RTsizei, const RTuint *,
    RTboolean *) { refused("rtAreTexturesResident"); return RT_FALSE; }
RTAPI void RTAPIENTRY rtTexSubImage1D(RTenum, RTint, RTint, RTsizei, RTenum, RTenum,
    const void *) { refused("rtTexSubImage1D"); }
RTAPI void RTAPIENTRY rtCopyTexImage1D(RTenum, RTint, RTenum, RTint, RTint, RTsizei,
    RTint) { refused("rtCopyTexImage1D"); }
RTAPI void RTAPIENTRY rtCopyTexImage2D(RTenum, RTint, RTenum, RTint, RTint, RTsizei, RTsizei,
    RTint) { refused("rtCopyTexImage2D"); }
RTAPI void RTAPIENTRY rtCopyTexSubImage1D(RTenum, RTint, RTint, RTint, RTint,
    RTsizei) { refused("rtCopyTexSubImage1D"); }
RTAPI void RTAPIENTRY rtCopyTexSubImage2D(RTenum, RTint, RTint, RTint, RTint, RTint, RTsizei,
    RTsizei) { refused("rtCopyTexSubImage2D"); }
RTAPI void RTAPIENTRY rtTexImage3D(RTenum, RTint, RTint, RTsizei, RTsizei, RTsizei, RTint, RTenum,
    RTenum, const void *) { refused("rtTexImage3D"); }
RTAPI void RTAPIENTRY rtTexSubImage3D(RTenum, RTint, RTint, RTint, RTint, RTsizei, RTsizei, RTsizei,
    RTenum, RTenum, const void *) { refused("rtTexSubImage3D"); }
RTAPI void RTAPIENTRY rtCopyTexSubImage3D(RTenum, RTint, RTint, RTint, RTint, RTint, RTint, RTsizei,
    RTsizei) { refused("rtCopyTexSubImage3D"); }
RTAPI void RTAPIENTRY rtActiveTexture(RTenum) { refused("rtActiveTexture"); }
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
RTAPI void RTAPIENTRY rtPixelZoom(RTfloat, RTfloat) { refused("rtPixelZoom"); }
RTAPI void RTAPIENTRY rtPixelTransferf(RTenum, RTfloat) { refused("rtPixelTransferf"); }
RTAPI void RTAPIENTRY rtPixelTransferi(RTenum, RTint) { refused("rtPixelTransferi"); }
RTAPI void RTAPIENTRY rtPixelMapfv(RTenum, RTsizei, const RTfloat *) { refused("rtPixelMapfv"); }
RTAPI void RTAPIENTRY rtPixelMapuiv(RTenum, RTsizei, const RTuint *) { refused("rtPixelMapuiv"); }
RTAPI void RTAPIENTRY rtPixelMapusv(RTenum, RTsizei, const RTushort *) { refused("rtPixelMapusv"); }
RTAPI void RTAPIENTRY rtGetPixelMapfv(RTenum, RTfloat *) { refused("rtGetPixelMapfv"); }
RTAPI void RTAPIENTRY rtGetPixelMapuiv(RTenum, RTuint *) { refused("rtGetPixelMapuiv"); }
RTAPI void RTAPIENTRY rtGetPixelMapusv(RTenum, RTushort *) { refused("rtGetPixelMapusv"); }
RTAPI void RTAPIENTRY rtBitmap(RTsizei, RTsizei, RTfloat, RTfloat, RTfloat, RTfloat,
    const RTubyte *) { refused("rtBitmap"); }
RTAPI void RTAPIENTRY rtReadPixels(RTint, RTint, RTsizei, RTsizei, RTenum, RTenum,
    void *) { refused("rtReadPixels"); }
RTAPI void RTAPIENTRY rtDrawPixels(RTsizei, RTsizei, RTenum, RTenum,
    const void *) { refused("rtDrawPixels"); }
RTAPI void RTAPIENTRY rtCopyPixels(RTint, RTint, RTsizei, RTsizei,
    RTenum) { refused("rtCopyPixels"); }

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
RTAPI void RTAPIENTRY rtEvalCoord1d(RTdouble) { refused("rtEvalCoord1d"); }
RTAPI void RTAPIENTRY rtEvalCoord1f(RTfloat) { refused("rtEvalCoord1f"); }
RTAPI void RTAPIENTRY rtEvalCoord1dv(const RTdouble *) { refused("rtEvalCoord1dv"); }
RTAPI void RTAPIENTRY rtEvalCoord1fv(const RTfloat *) { refused("rtEvalCoord1fv"); }
RTAPI void RTAPIENTRY rtEvalCoord2d(RTdouble, RTdouble) { refused("rtEvalCoord2d"); }
RTAPI void RTAPIENTRY rtEvalCoord2f(RTfloat, RTfloat) { refused("rtEvalCoord2f"); }
RTAPI void RTAPIENTRY rtEvalCoord2dv(const RTdouble *) { refused("rtEvalCoord2dv"); }
RTAPI void RTAPIENTRY rtEvalCoord2fv(const RTfloat *) { refused("rtEvalCoord2fv"); }
RTAPI void RTAPIENTRY rtMapGrid1d(RTint, RTdouble, RTdouble) { refused("rtMapGrid1d"); }
RTAPI void RTAPIENTRY rtMapGrid1f(RTint, RTfloat, RTfloat) { refused("rtMapGrid1f"); }
RTAPI void RTAPIENTRY rtMapGrid2d(RTint, RTdouble, RTdouble, RTint, RTdouble,
    RTdouble) { refused("rtMapGrid2d"); }
RTAPI void RTAPIENTRY rtMapGrid2f(RTint, RTfloat, RTfloat, RTint, RTfloat,
    RTfloat) { refused("rtMapGrid2f"); }
RTAPI void RTAPIENTRY rtEvalPoint1(RTint) { refused("rtEvalPoint1"); }
RTAPI void RTAPIENTRY rtEvalPoint2(RTint, RTint) { refused("rtEvalPoint2"); }
RTAPI void RTAPIENTRY rtEvalMesh1(RTenum, RTint, RTint) { refused("rtEvalMesh1"); }
RTAPI void RTAPIENTRY rtEvalMesh2(RTenum, RTint, RTint, RTint, RTint) { refused("rtEvalMesh2"); }

// Selection and feedback
RTAPI RTint RTAPIENTRY rtRenderMode(RTenum) { refused("rtRenderMode"); return 0; }
RTAPI void RTAPIENTRY rtFeedbackBuffer(RTsizei, RTenum, RTfloat *) { refused("rtFeedbackBuffer"); }
RTAPI void RTAPIENTRY rtPassThrough(RTfloat) { refused("rtPassThrough"); }
RTAPI void RTAPIENTRY rtSelectBuffer(RTsizei, RTuint *) { refused("rtSelectBuffer"); }
RTAPI void RTAPIENTRY rtInitNames(void) { refused("rtInitNames"); }
RTAPI void RTAPIENTRY rtLoadName(RTuint) { refused("rtLoadName"); }
RTAPI void RTAPIENTRY rtPushName(RTuint) { refused("rtPushName"); }
RTAPI void RTAPIENTRY rtPopName(void) { refused("rtPopName"); }

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
