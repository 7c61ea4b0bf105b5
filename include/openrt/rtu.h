/* SPDX-License-Identifier: MIT */
/* The counterpart of GLU 1.3, in libOpenRT: projections, cameras, quadrics, images, tessellation.
 * C99, usable from C++. Where nothing else is said a call does what its namesake of GLU does, with
 * the same vertices in the same order.
 *
 * Errors. Besides what GLU reports - a return value, or the RTU_ERROR callback of the object - a
 *   wrong call records an error in the context, as every rt call does, if the thread has one.
 *   Objects are not checked beyond NULL, which is RT_INVALID_VALUE. Objects belong to no context;
 *   one object is used by one thread at a time.
 * Threads. Calls that draw, set matrices or cameras: the context's. All others: any.
 */
#ifndef OPENRT_RTU_H
#define OPENRT_RTU_H

#include "openrt/rt_state.h"
#include "openrt/rtu_enums.h"
#include "openrt/types.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct RTUquadric RTUquadric;
typedef struct RTUtesselator RTUtesselator;
typedef struct RTUnurbs RTUnurbs;
typedef RTUquadric RTUquadricObj;
typedef RTUtesselator RTUtesselatorObj;
typedef RTUtesselator RTUtriangulatorObj;
typedef RTUnurbs RTUnurbsObj;
typedef void(RTAPIENTRY *RTUfuncptr)(void);

/* ---- Strings ---------------------------------------------------------------------------- */

/* The text of an error of rtGetError, of GLU or of tessellation; NULL for another number.
 * Errors:  None.
 * Since: 0.1 */
RTAPI const RTubyte *RTAPIENTRY rtuErrorString(RTenum error);

/* Text about these calls: RTU_VERSION: "1.3"; RTU_EXTENSIONS: "". NULL for another name.
 * Since: 0.1 */
RTAPI const RTubyte *RTAPIENTRY rtuGetString(RTenum name);

/* Whether extName is one of the words of extString; RT_FALSE where one is NULL. Since: 0.1 */
RTAPI RTboolean RTAPIENTRY rtuCheckExtension(const RTubyte *extName, const RTubyte *extString);

/* ---- Projections ------------------------------------------------------------------------ */

/* Multiply the current matrix by a camera as GLU does: less is refused than by rtPerspective and
 * rtLookAt.
 * rtuPerspective: any fovy, aspect, near and far, negative ones too; no effect where near = far,
 *   aspect = 0 or fovy is a multiple of 360 degrees.
 * rtuLookAt: a direction without length stays zero; eye = centre, or the up vector 0 or along the
 *   line of sight, give a matrix with rows of zeros.
 * Some of these matrices have no inverse. What is placed by such a model-view matrix is flat or not
 * seen. A projection without one (near or far 0, fovy 180) is an error of the frame (rtRender).
 * Errors:  RT_INVALID_VALUE  an argument, or the matrix, is not finite
 * Since: 0.1 */
RTAPI void RTAPIENTRY rtuPerspective(RTdouble fovy, RTdouble aspect, RTdouble zNear,
                                     RTdouble zFar);
RTAPI void RTAPIENTRY rtuLookAt(RTdouble eyeX, RTdouble eyeY, RTdouble eyeZ, RTdouble centerX,
                                RTdouble centerY, RTdouble centerZ, RTdouble upX, RTdouble upY,
                                RTdouble upZ);

/* Multiplies the current matrix by a projection of the plane: rtOrtho with near -1 and far 1.
 * Errors:  RT_INVALID_VALUE  left = right, bottom = top; an argument that is not finite
 * Since: 0.1 */
RTAPI void RTAPIENTRY rtuOrtho2D(RTdouble left, RTdouble right, RTdouble bottom, RTdouble top);

/* Multiplies the current matrix so that a small rectangle fills the viewport: that of delX by delY
 * pixels about (x, y), and the viewport {x, y, width, height}. delX or delY not above 0: no effect,
 * as in GLU.
 * Errors:  RT_INVALID_VALUE  viewport NULL
 * Since: 0.1 */
RTAPI void RTAPIENTRY rtuPickMatrix(RTdouble x, RTdouble y, RTdouble delX, RTdouble delY,
                                    const RTint *viewport);

/* From object to window coordinates, and back. Depth is 0 to 1, or near to far in rtuUnProject4,
 * where clipW is the clip coordinate w of the point. RT_FALSE, and the results are left as they
 * were: a matrix without an inverse, w = 0, or a pointer NULL.
 * Errors:  RT_INVALID_VALUE  a pointer NULL
 * Since: 0.1 */
RTAPI RTint RTAPIENTRY rtuProject(RTdouble objX, RTdouble objY, RTdouble objZ,
                                  const RTdouble *model, const RTdouble *proj, const RTint *view,
                                  RTdouble *winX, RTdouble *winY, RTdouble *winZ);
RTAPI RTint RTAPIENTRY rtuUnProject(RTdouble winX, RTdouble winY, RTdouble winZ,
                                    const RTdouble *model, const RTdouble *proj, const RTint *view,
                                    RTdouble *objX, RTdouble *objY, RTdouble *objZ);
RTAPI RTint RTAPIENTRY rtuUnProject4(RTdouble winX, RTdouble winY, RTdouble winZ, RTdouble clipW,
                                     const RTdouble *model, const RTdouble *proj,
                                     const RTint *view, RTdouble nearVal, RTdouble farVal,
                                     RTdouble *objX, RTdouble *objY, RTdouble *objZ,
                                     RTdouble *objW);

/* The camera ray through the window position (winX, winY): origin on the near plane, direction of
 * length 1, both arrays of three, for rtIntersect: it takes the place of OpenGL's selection. With
 * the model-view matrix it is a ray in object coordinates, with the identity one in eye space.
 * RT_FALSE on error.
 * Errors:  RT_INVALID_VALUE  a product of matrices without an inverse, a pointer NULL
 * Since: 0.1 */
RTAPI RTint RTAPIENTRY rtuPickRay(RTdouble winX, RTdouble winY, const RTdouble *model,
                                  const RTdouble *proj, const RTint *view, RTfloat *origin,
                                  RTfloat *direction);

/* ---- Cameras of projection systems and head-mounted displays ------------------------------ */

/* Set the camera of this frame; as rtUseCamera does with a Matrix camera. The projection
 * matrix is ignored then, and eye space is the world. Not in an object.
 * FromMatrices: the rays lead through the corners of the [-1,1] cube, mapped to the world by the
 *   inverse of projection * modelview.
 * FromWall: the eye and three corners of a screen in world space. The frustum reaches from a
 *   hundredth of the eye's distance from the screen's plane to infinity.
 * FromFov: pose, a column-major matrix, places the eye in the world (it looks along its -z);
 *   left, right, up, down: the angles of the frustum's sides in radians, left and down negative,
 *   as OpenXR gives them.
 * Errors:  RT_INVALID_VALUE      a pointer NULL, a number not finite, matrices without an inverse,
 *                                the eye in the plane of the screen, a screen without area, an
 *                                angle of 90 degrees or more, left >= right, down >= up
 *          RT_INVALID_OPERATION  the frame has a camera already
 * Since: 0.1 */
RTAPI void RTAPIENTRY rtuCameraFromMatrices(const RTdouble projection[16],
                                            const RTdouble modelview[16]);
RTAPI void RTAPIENTRY rtuCameraFromWall(const RTdouble lowerLeft[3], const RTdouble lowerRight[3],
                                        const RTdouble upperLeft[3], const RTdouble eye[3]);
RTAPI void RTAPIENTRY rtuCameraFromFov(const RTdouble pose[16], RTdouble left, RTdouble right,
                                       RTdouble up, RTdouble down);

/* ---- Quadrics --------------------------------------------------------------------------- */

/* Make and delete a quadric. Start: RTU_FILL, RTU_SMOOTH normals, RTU_OUTSIDE, no texture
 * coordinates. NULL if memory ran out. Deleting NULL is ignored.
 * Errors:  None.
 * Since: 0.1 */
RTAPI RTUquadric *RTAPIENTRY rtuNewQuadric(void);
RTAPI void RTAPIENTRY rtuDeleteQuadric(RTUquadric *quad);

/* How a quadric is drawn. draw: RTU_FILL, RTU_LINE, RTU_SILHOUETTE, RTU_POINT. normal: RTU_SMOOTH,
 * RTU_FLAT, RTU_NONE. orientation: RTU_OUTSIDE, RTU_INSIDE. which: RTU_ERROR, cb takes an RTenum;
 * cb may be NULL.
 * Errors:  RT_INVALID_ENUM   another value (RTU_ERROR: RTU_INVALID_ENUM)
 *          RT_INVALID_VALUE  quad NULL
 * Since: 0.1 */
RTAPI void RTAPIENTRY rtuQuadricDrawStyle(RTUquadric *quad, RTenum draw);
RTAPI void RTAPIENTRY rtuQuadricNormals(RTUquadric *quad, RTenum normal);
RTAPI void RTAPIENTRY rtuQuadricOrientation(RTUquadric *quad, RTenum orientation);
RTAPI void RTAPIENTRY rtuQuadricTexture(RTUquadric *quad, RTboolean texture);
RTAPI void RTAPIENTRY rtuQuadricCallback(RTUquadric *quad, RTenum which, RTUfuncptr cb);

/* Draw a quadric with rtBegin and rtEnd: a sphere about the origin, poles on the z axis; the side
 * of a cylinder or cone from z = 0 to height; a disk in z = 0; the part of a disk from angle
 * `start` (degrees, from +y, clockwise) over `sweep`. As in GLU, more than 239 slices, or stacks of
 * a sphere, are drawn as 239; flat normals of points and of the lines along a cylinder are the
 * smooth ones; RTU_INSIDE turns the normals of a cone in x and y only.
 * Errors:  RT_INVALID_VALUE  (RTU_ERROR: RTU_INVALID_VALUE) nothing is drawn: quad NULL; slices
 *                            below 2; stacks or loops below 1 or above 65,536; a measure negative
 *                            or not finite; outer 0, inner > outer; a cylinder without height whose
 *                            radii are equal
 * Since: 0.1 */
RTAPI void RTAPIENTRY rtuSphere(RTUquadric *quad, RTdouble radius, RTint slices, RTint stacks);
RTAPI void RTAPIENTRY rtuCylinder(RTUquadric *quad, RTdouble base, RTdouble top, RTdouble height,
                                  RTint slices, RTint stacks);
RTAPI void RTAPIENTRY rtuDisk(RTUquadric *quad, RTdouble inner, RTdouble outer, RTint slices,
                              RTint loops);
RTAPI void RTAPIENTRY rtuPartialDisk(RTUquadric *quad, RTdouble inner, RTdouble outer,
                                     RTint slices, RTint loops, RTdouble start, RTdouble sweep);

/* ---- Images ----------------------------------------------------------------------------- */

/* Scales an image with GLU's box filter; reading as rtTexImage2D does (RT_UNPACK_...) and writing
 * as rtReadPixels does (RT_PACK_...); without a context, or between rtBegin and rtEnd, these have
 * the values of the start. Formats: RT_COLOR_INDEX, RT_STENCIL_INDEX,
 * RT_DEPTH_COMPONENT, RT_RED, RT_GREEN, RT_BLUE, RT_ALPHA, RT_LUMINANCE, RT_LUMINANCE_ALPHA,
 * RT_RGB, RT_BGR, RT_RGBA, RT_BGRA; types: RT_UNSIGNED_BYTE, RT_BYTE, RT_UNSIGNED_SHORT, RT_SHORT,
 * RT_UNSIGNED_INT, RT_INT, RT_FLOAT. 0 on success, else an RTU_ error number.
 * Errors:  RT_INVALID_VALUE  (RTU_INVALID_VALUE) a negative size, a pointer NULL
 *          RT_INVALID_ENUM   (RTU_INVALID_ENUM) format or type; GLU's RT_BITMAP and the packed
 *                            types of OpenGL 1.2 are not part of this release
 *          RT_OUT_OF_MEMORY  (RTU_OUT_OF_MEMORY)
 * Since: 0.1 */
RTAPI RTint RTAPIENTRY rtuScaleImage(RTenum format, RTsizei wIn, RTsizei hIn, RTenum typeIn,
                                     const void *dataIn, RTsizei wOut, RTsizei hOut,
                                     RTenum typeOut, void *dataOut);

/* Scale an image to powers of two and make its mipmaps: it is halved down to one pixel, and every
 * level given to rtTexImage1D, rtTexImage2D or rtTexImage3D. Levels: only base to max, where the
 * image given is level `level`. Results, formats and types are those of rtuScaleImage.
 * Errors:  RT_INVALID_VALUE  (RTU_INVALID_VALUE) a size below 1, data NULL, base to max no range of
 *                            levels that holds `level`
 *          RT_INVALID_ENUM   (RTU_INVALID_ENUM) format or type, as of rtuScaleImage
 *          RT_OUT_OF_MEMORY  (RTU_OUT_OF_MEMORY)
 *          those of rtTexImage1D, rtTexImage2D and rtTexImage3D
 * Since: 0.1 */
RTAPI RTint RTAPIENTRY rtuBuild1DMipmaps(RTenum target, RTint internalFormat, RTsizei width,
                                         RTenum format, RTenum type, const void *data);
RTAPI RTint RTAPIENTRY rtuBuild2DMipmaps(RTenum target, RTint internalFormat, RTsizei width,
                                         RTsizei height, RTenum format, RTenum type,
                                         const void *data);
RTAPI RTint RTAPIENTRY rtuBuild3DMipmaps(RTenum target, RTint internalFormat, RTsizei width,
                                         RTsizei height, RTsizei depth, RTenum format, RTenum type,
                                         const void *data);
RTAPI RTint RTAPIENTRY rtuBuild1DMipmapLevels(RTenum target, RTint internalFormat, RTsizei width,
                                              RTenum format, RTenum type, RTint level, RTint base,
                                              RTint max, const void *data);
RTAPI RTint RTAPIENTRY rtuBuild2DMipmapLevels(RTenum target, RTint internalFormat, RTsizei width,
                                              RTsizei height, RTenum format, RTenum type,
                                              RTint level, RTint base, RTint max,
                                              const void *data);
RTAPI RTint RTAPIENTRY rtuBuild3DMipmapLevels(RTenum target, RTint internalFormat, RTsizei width,
                                              RTsizei height, RTsizei depth, RTenum format,
                                              RTenum type, RTint level, RTint base, RTint max,
                                              const void *data);

/* ---- Tessellation ----------------------------------------------------------------------- */

/* Make and delete a tessellator. It takes polygons of any number of contours, concave, with holes,
 * touching or crossing themselves. NULL if memory ran out; deleting NULL is ignored; deleting in a
 * callback is not allowed.
 * Errors:  RT_INVALID_OPERATION  rtuDeleteTess before a polygon has ended: besides the RTU_TESS_ERROR
 *                                callback; it is deleted
 * Since: 0.1 */
RTAPI RTUtesselator *RTAPIENTRY rtuNewTess(void);
RTAPI void RTAPIENTRY rtuDeleteTess(RTUtesselator *tess);

/* The callbacks of a tessellator: by `which`; with _DATA also the polygon's data, which then has
 * precedence:
 *   RTU_TESS_BEGIN      void (RTenum mode): RT_TRIANGLES, RT_TRIANGLE_FAN, RT_LINE_LOOP
 *   RTU_TESS_EDGE_FLAG  void (RTboolean flag): asks for RT_TRIANGLES alone
 *   RTU_TESS_VERTEX     void (void *vertexData)
 *   RTU_TESS_END        void (void)
 *   RTU_TESS_COMBINE    void (RTdouble coords[3], void *vertexData[4], RTfloat weight[4],
 *                       void **outData): a vertex where edges cross or vertices meet
 *   RTU_TESS_ERROR      void (RTenum error)
 * Errors:  RT_INVALID_ENUM   another `which`
 *          RT_INVALID_VALUE  tess NULL
 * Since: 0.1 */
RTAPI void RTAPIENTRY rtuTessCallback(RTUtesselator *tess, RTenum which, RTUfuncptr cb);

/* Properties of a tessellator: RTU_TESS_WINDING_RULE (RTU_TESS_WINDING_ODD at the start),
 * RTU_TESS_BOUNDARY_ONLY (RT_FALSE), RTU_TESS_TOLERANCE (0 to 1 times the polygon's size: vertices
 * that near become one; 0).
 * Errors:  RT_INVALID_ENUM   (RTU_INVALID_ENUM) another property
 *          RT_INVALID_VALUE  (RTU_INVALID_VALUE) another value; tess or data NULL
 * Since: 0.1 */
RTAPI void RTAPIENTRY rtuTessProperty(RTUtesselator *tess, RTenum which, RTdouble data);
RTAPI void RTAPIENTRY rtuGetTessProperty(RTUtesselator *tess, RTenum which, RTdouble *data);

/* The normal of the polygons of a tessellator: triangles are anticlockwise seen from its tip. (0,
 * 0, 0), the start: found from the vertices, so that the sum of the contours' areas is not
 * negative.
 * Errors:  RT_INVALID_VALUE  (RTU_INVALID_VALUE) a number that is not finite; tess NULL
 * Since: 0.1 */
RTAPI void RTAPIENTRY rtuTessNormal(RTUtesselator *tess, RTdouble valueX, RTdouble valueY,
                                    RTdouble valueZ);

/* Give a polygon to a tessellator: BeginPolygon { BeginContour { Vertex } EndContour } EndPolygon.
 * Callbacks come from EndPolygon (errors from any). A call that was left out is reported as GLU
 * does, and made up for. location: three coordinates, copied; data: what the vertex callback gets.
 * Coordinates beyond RTU_TESS_MAX_COORD are clamped and reported, NaN counts as 0. Vertices nearer
 * to each other than 2^-29 of the polygon's size count as one. A crossing without a combine
 * callback is RTU_TESS_NEED_COMBINE_CALLBACK: nothing is drawn.
 * Errors:  RT_INVALID_OPERATION  besides the RTU_TESS_ERROR callback: a call left out, a coordinate
 *                                clamped, no combine callback
 *          RT_INVALID_VALUE      tess or location NULL
 *          RT_OUT_OF_MEMORY      (RTU_OUT_OF_MEMORY) nothing is drawn
 * Since: 0.1 */
RTAPI void RTAPIENTRY rtuTessBeginPolygon(RTUtesselator *tess, void *data);
RTAPI void RTAPIENTRY rtuTessBeginContour(RTUtesselator *tess);
RTAPI void RTAPIENTRY rtuTessVertex(RTUtesselator *tess, const RTdouble *location, void *data);
RTAPI void RTAPIENTRY rtuTessEndContour(RTUtesselator *tess);
RTAPI void RTAPIENTRY rtuTessEndPolygon(RTUtesselator *tess);

/* Give a polygon to a tessellator, by the names of GLU 1.1: BeginPolygon opens a polygon and a
 * contour, NextContour ends one and opens another (its type is ignored), EndPolygon ends both.
 * Errors:  RT_INVALID_OPERATION  besides the RTU_TESS_ERROR callback: a call left out
 *          RT_INVALID_VALUE      tess NULL
 *          RT_OUT_OF_MEMORY      (RTU_OUT_OF_MEMORY) nothing is drawn
 * Since: 0.1 */
RTAPI void RTAPIENTRY rtuBeginPolygon(RTUtesselator *tess);
RTAPI void RTAPIENTRY rtuNextContour(RTUtesselator *tess, RTenum type);
RTAPI void RTAPIENTRY rtuEndPolygon(RTUtesselator *tess);

/* ---- NURBS ------------------------------------------------------------------------------ */

/* Curves and surfaces (NURBS), not part of this release: no effect; rtuNewNurbsRenderer returns
 * NULL.
 * Errors:  RT_INVALID_OPERATION  always, with a text that names the function
 * Since: 0.1 */
RTAPI RTUnurbs *RTAPIENTRY rtuNewNurbsRenderer(void);
RTAPI void RTAPIENTRY rtuDeleteNurbsRenderer(RTUnurbs *nurb);
RTAPI void RTAPIENTRY rtuBeginCurve(RTUnurbs *nurb);
RTAPI void RTAPIENTRY rtuEndCurve(RTUnurbs *nurb);
RTAPI void RTAPIENTRY rtuBeginSurface(RTUnurbs *nurb);
RTAPI void RTAPIENTRY rtuEndSurface(RTUnurbs *nurb);
RTAPI void RTAPIENTRY rtuBeginTrim(RTUnurbs *nurb);
RTAPI void RTAPIENTRY rtuEndTrim(RTUnurbs *nurb);
RTAPI void RTAPIENTRY rtuNurbsProperty(RTUnurbs *nurb, RTenum property, RTfloat value);
RTAPI void RTAPIENTRY rtuGetNurbsProperty(RTUnurbs *nurb, RTenum property, RTfloat *data);
RTAPI void RTAPIENTRY rtuNurbsCallback(RTUnurbs *nurb, RTenum which, RTUfuncptr cb);
RTAPI void RTAPIENTRY rtuNurbsCallbackData(RTUnurbs *nurb, void *userData);
RTAPI void RTAPIENTRY rtuNurbsCallbackDataEXT(RTUnurbs *nurb, void *userData);
RTAPI void RTAPIENTRY rtuLoadSamplingMatrices(RTUnurbs *nurb, const RTfloat *model,
                                              const RTfloat *perspective, const RTint *view);
RTAPI void RTAPIENTRY rtuNurbsCurve(RTUnurbs *nurb, RTint knotCount, RTfloat *knots, RTint stride,
                                    RTfloat *control, RTint order, RTenum type);
RTAPI void RTAPIENTRY rtuNurbsSurface(RTUnurbs *nurb, RTint sKnotCount, RTfloat *sKnots,
                                      RTint tKnotCount, RTfloat *tKnots, RTint sStride,
                                      RTint tStride, RTfloat *control, RTint sOrder, RTint tOrder,
                                      RTenum type);
RTAPI void RTAPIENTRY rtuPwlCurve(RTUnurbs *nurb, RTint count, RTfloat *data, RTint stride,
                                  RTenum type);

#ifdef __cplusplus
}
#endif
#endif
