/* SPDX-License-Identifier: MIT */
/* Rays from the application. Part of openrt/rt.h.
 *
 * The ray calls run on the calling thread alone, on any thread, with any context or none, and
 * leave its floating-point state as found. Culling, transparency and clip planes do not act here.
 *
 * A ray needs no normalised direction: distances are in units of its length. [tnear, tfar] is
 * closed; infinite limits are legal; tnear below 0 counts as 0. NaN limits, tnear above tfar, an
 * origin or direction that is not finite, or a zero direction: a miss.
 * Of hits at equal distance the lowest (instance, primitive) wins; in nested objects level by
 * level. */
#ifndef OPENRT_RT_QUERY_H
#define OPENRT_RT_QUERY_H

#include "openrt/types.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct RTray {
    float origin[3];
    float tnear;
    float direction[3];
    float tfar;
} RTray;

/* A miss: t = tfar, the ids RT_INVALID, the rest 0. */
typedef struct RThit {
    float t;
    float u, v;       /* weights of the second and third vertex */
    RTuint primitive; /* number of the triangle in its object, from 0, in the order given: a quad
                         is two, a dropped triangle keeps its number */
    RTuint object;    /* id; 0 for loose geometry. Of nested objects the innermost */
    RTuint instance;  /* number of the scene's instance in order of submission, from 0, loose runs
                         included. Of nested objects the outermost */
    float normal[3];  /* (v1 - v0) x (v2 - v0) of the vertices in the scene's space */
    RTuint flags;     /* RT_HIT_BACK where dot(direction, normal) > 0 */
} RThit;

/* Rays as separate arrays. tnear, tfar NULL: 0 and infinity. */
typedef struct RTraystream {
    const float *ox, *oy, *oz, *dx, *dy, *dz, *tnear, *tfar;
    RTbitfield flags; /* 0 or RT_COMMON_ORIGIN: ox, oy, oz hold one value for all rays */
} RTraystream;

/* Hits as separate arrays. NULL: not wanted. */
typedef struct RThitstream {
    float *t, *u, *v;
    RTuint *primitive, *object, *instance;
    float *nx, *ny, *nz;
} RThitstream;

/* Compiles the scene under way for rtIntersect and rtOccluded: what it consists of so far. Returns
 * a handle, RT_INVALID if memory ran out; the scene stays open. Handles count from 1, are unique in
 * the process and never used again. Legal in objects; the open object is not part of the scene.
 * Threads: the context's. Since: 0.1 */
RTAPI RTuint RTAPIENTRY rtCompileScene(void);

/* Frees a compiled scene; calls on it that run at the time end undisturbed.
 * Errors:  RT_INVALID_VALUE  unknown handle
 * Threads: any; no context needed. Since: 0.1 */
RTAPI void RTAPIENTRY rtReleaseScene(RTuint handle);

/* The nearest hits of rays: hits[i] belongs to rays[i]. coherence: RT_COHERENT if runs of 16, 64,
 * 256 consecutive rays are neighbours, as in tiles or in Morton order, else RT_INCOHERENT; it
 * changes the speed only. An error is recorded in the calling thread's context, if it has one.
 * Errors:  RT_INVALID_VALUE  unknown handle; count negative; with count above 0 a pointer NULL that
 *                            has to be given, unknown flags of rays
 *          RT_INVALID_ENUM   another coherence
 * Threads: any; no context needed. Since: 0.1 */
RTAPI void RTAPIENTRY rtIntersect(RTuint handle, const RTray *rays, RThit *hits, RTsizei count,
                                  RTenum coherence);
RTAPI void RTAPIENTRY rtIntersectStream(RTuint handle, const RTraystream *rays,
                                        RThitstream *hits, RTsizei count, RTenum coherence);

/* Whether anything lies in a ray's range: blocked[i] = 1 or 0. coherence: see rtIntersect. An error
 * is recorded in the calling thread's context, if it has one.
 * Errors:  RT_INVALID_VALUE  unknown handle; count negative; with count above 0 a pointer NULL that
 *                            has to be given, unknown flags of rays
 *          RT_INVALID_ENUM   another coherence
 * Threads: any; no context needed. Since: 0.1 */
RTAPI void RTAPIENTRY rtOccluded(RTuint handle, const RTray *rays, RTubyte *blocked, RTsizei count,
                                 RTenum coherence);
RTAPI void RTAPIENTRY rtOccludedStream(RTuint handle, const RTraystream *rays, RTubyte *blocked,
                                       RTsizei count, RTenum coherence);

#ifdef __cplusplus
}
#endif
#endif
