/* SPDX-License-Identifier: MIT */
/* OpenRTS for packets: up to sixteen points of one shader at once, as a structure of arrays.
 * What is said in rts.h of one point holds here for each lane. A lane counts if its bit is set in
 * `active` and, in a call, in `lanes`; the memory of the others may be read but says nothing, and
 * what a call stores there is unspecified. A packet shader gives each lane what the class's
 * scalar form gives for that point alone.
 */
#ifndef OPENRT_RTS_PACKET_H
#define OPENRT_RTS_PACKET_H

#include "openrt/rts.h"

#ifdef __cplusplus
extern "C" {
#endif

#define RTS_PACKET_SIZE 16

typedef struct RTSfloats { float lane[RTS_PACKET_SIZE]; } RTSfloats;
typedef struct RTSids { RTuint lane[RTS_PACKET_SIZE]; } RTSids;
typedef struct RTSvectors { RTSfloats x, y, z; } RTSvectors;
typedef struct RTScolors { RTSfloats r, g, b; } RTScolors;

/* RTSlightsample of each lane. */
typedef struct RTSlightpacket {
    RTSvectors direction;
    RTSfloats distance;
    RTScolors radiance;
} RTSlightpacket;

/* RTShitinfo of each lane. */
typedef struct RTShitpacket {
    RTSfloats distance;
    RTSvectors position, normal;
    RTSids object, instance, primitive;
} RTShitpacket;

typedef struct RTSpacket RTSpacket;

/* As the functions of RTSfunctions. Those that trace return the lanes that were traced. */
typedef struct RTSpacketfunctions {
    RTuint structSize;
    RTuint (*trace)(RTSpacket *packet, RTuint lanes, const RTSvectors *origin,
                    const RTSvectors *direction, const RTSfloats *weight, RTScolors *radiance);
    RTuint (*traceHit)(RTSpacket *packet, RTuint lanes, const RTSvectors *origin,
                       const RTSvectors *direction, RTShitpacket *hits);
    RTuint (*shadow)(RTSpacket *packet, RTuint lanes, const RTSvectors *origin,
                     const RTSvectors *direction, const RTSfloats *distance,
                     RTScolors *attenuation);
    RTuint (*lightCount)(const RTSpacket *packet);
    /* Returns the lanes to which light i contributes. */
    RTuint (*illuminate)(RTSpacket *packet, RTuint lanes, RTuint light, RTSlightpacket *samples);
    void (*texture)(RTSpacket *packet, RTuint lanes, RTuint texture, const RTSfloats *s,
                    const RTSfloats *t, RTSfloats rgba[4]);
    void (*environment)(RTSpacket *packet, RTuint lanes, const RTSvectors *direction,
                        RTScolors *radiance);
    void (*random)(RTSpacket *packet, RTuint lanes, RTSfloats *numbers);
} RTSpacketfunctions;

/* The points being shaded. Shaders read them, and write `result` and `resultSet` only. */
struct RTSpacket {
    RTuint structSize;
    RTuint active;
    const RTSpacketfunctions *functions;
    void *tracer; /* the library's own */

    RTSvectors rayOrigin, rayDirection;
    RTSfloats rayDistance;
    RTSvectors position, geometricNormal, shadingNormal, rawNormal;
    RTSfloats barycentric[3], texCoord[4], color[4];
    RTuint frontFace; /* lanes */
    RTSids object, instance, primitive;
    RTuint depth; /* the same for all */
    RTuint flags; /* the same for all */
    RTSfloats weight;
    const void *triangleParam[RTS_PACKET_SIZE];
    const void *vertexParam[RTS_PACKET_SIZE];
    RTSids pixel[2], sample;
    RTSfloats footprint, texCoordDensity;

    RTSfloats result[4]; /* radiance and alpha; black and 1 at the start */
    RTuint resultSet;    /* lanes */
};

#ifdef __cplusplus
}
#endif
#endif
