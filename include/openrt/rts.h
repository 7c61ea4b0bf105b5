/* SPDX-License-Identifier: MIT */
/* OpenRTS in C: what a shader is, what it may ask, and the descriptor that makes a class known.
 *
 * A shader never links against the library: everything it asks goes through the function table
 * of the RTSstate that it is given. Structures that the library makes, and those that say their
 * size, only ever grow at their end; the others stay: shaders built against older headers work.
 *
 * Spaces and units: positions and directions are in the space that instance matrices map to
 * (eye space with the projection matrix as camera, world space with a camera shader). Radiance
 * is linear RGB. Directions handed to a shader have length 1; those it hands back need not.
 */
#ifndef OPENRT_RTS_H
#define OPENRT_RTS_H

#include <math.h>

#include "openrt/types.h"

#ifdef __cplusplus
extern "C" {
#endif

#define RTS_INTERFACE_VERSION 1u

typedef struct RTSstate RTSstate;
struct RTSpacket; /* rts_packet.h */

/* Bits of RTSstate::flags; rays inherit them. */
#define RTS_INDIRECT 1u /* the shader adds light from one random direction: see rtsIndirect */
#define RTS_STOPPED 2u  /* the point traces no further rays: see rtsStopRayRecursion */

/* A sample of a light as seen from a point. */
typedef struct RTSlightsample {
    float direction[3]; /* from the point to the light, length 1 */
    float distance;     /* to the light; may be infinite */
    float radiance[3];  /* arriving at the point if nothing is between */
} RTSlightsample;

/* What a traced ray met, without shading. */
typedef struct RTShitinfo {
    float distance; /* infinite: nothing was met */
    float position[3];
    float normal[3]; /* geometric, length 1 */
    RTuint object, instance, primitive;
} RTShitinfo;

/* A ray from a camera shader. The direction need not be normalised; limits are in its units. */
typedef struct RTScameraray {
    float origin[3];
    float direction[3];
    float tnear, tfar;
    RTSstate *state; /* at no surface: pixel, sample and random numbers; set by the library */
} RTScameraray;

/* The function table. Functions that trace return 0 where the recursion limit or the weight
 * cut-off stopped them (the result is black then), 1 otherwise. */
typedef struct RTSfunctions {
    RTuint structSize;
    /* Radiance along a ray; weight (0..1) is its share of the pixel (the state's weight times the
     * factor that the shader will apply), for the cut-off. A ray that starts at the shaded point
     * never meets the surface it leaves because of rounding. */
    int (*trace)(RTSstate *state, const float origin[3], const float direction[3], float weight,
                 float radiance[3]);
    int (*traceHit)(RTSstate *state, const float origin[3], const float direction[3],
                    RTShitinfo *hit);
    /* What is left, per channel, of light that travels `distance` along the ray: 1 nothing in
     * between, 0 opaque, otherwise the product of the transparencies. */
    int (*shadow)(RTSstate *state, const float origin[3], const float direction[3], float distance,
                  float attenuation[3]);
    /* A light that is split into n samples counts as n lights of 1/n of its radiance. */
    RTuint (*lightCount)(const RTSstate *state);
    /* Light i at the shaded point; 0: it contributes nothing there. */
    int (*illuminate)(RTSstate *state, RTuint light, RTSlightsample *sample);
    /* Texture by id at (s, t): RGBA, linear. An unknown texture is opaque white. */
    void (*texture)(RTSstate *state, RTuint texture, float s, float t, float rgba[4]);
    /* Radiance of the environment in a direction. */
    void (*environment)(RTSstate *state, const float direction[3], float radiance[3]);
    /* Next number of the pixel's random stream, in [0, 1). */
    float (*random)(RTSstate *state);
} RTSfunctions;

/* The point being shaded. Shaders read it, and write `result` only. */
struct RTSstate {
    const RTSfunctions *functions;
    void *tracer; /* the library's own */

    float rayOrigin[3];
    float rayDirection[3]; /* length 1 */
    float rayDistance;     /* from the ray's origin; infinite in an environment shader */

    float position[3];
    float geometricNormal[3]; /* length 1; the side from which the vertices turn anticlockwise */
    float shadingNormal[3];   /* interpolated; length 1 */
    float rawNormal[3];       /* interpolated, as long as interpolation left it */
    float barycentric[3];     /* weights of the first, second and third vertex */
    float texCoord[4];
    float color[4]; /* interpolated current colour, RGBA */

    RTuint frontFace; /* 1: the ray came from the geometric normal's side */
    RTuint object, instance, primitive;
    RTuint depth; /* 0 for camera rays */
    float weight; /* share of the pixel, 1 for camera rays */

    /* Blocks of the per-triangle and of the interpolated per-vertex parameters; NULL if the class
     * has none. */
    const void *triangleParam;
    const void *vertexParam;

    RTuint pixel[2];
    RTuint sample;

    float result[4]; /* radiance and alpha; black and 1 at the start */
    RTuint resultSet;

    RTuint flags;          /* RTS_INDIRECT, RTS_STOPPED */
    /* Width, across the ray, of what the sample stands for; in an environment shader the angle. */
    float footprint;
    float texCoordDensity; /* texture coordinates per unit of length on the triangle; 0: none */
};

/* A pixel, for rendering objects. */
typedef struct RTSpixel {
    RTuint structSize;
    RTSstate *state;
    RTuint x, y;    /* from the lower left corner */
    RTuint samples; /* what rtSamples asks for */
    /* Radiance and alpha through the point (x, y) of the pixel's square, (0.5, 0.5) its centre. */
    void (*trace)(struct RTSpixel *pixel, float x, float y, float rgba[4]);
    /* Position of the i-th of n samples in the pixel's square. */
    void (*samplePosition)(struct RTSpixel *pixel, RTuint i, RTuint n, float xy[2]);
    /* As trace, with RTSstate::flags for the camera ray and those that it gives rise to. */
    void (*traceWith)(struct RTSpixel *pixel, float x, float y, RTuint flags, float rgba[4]);
    /* What the camera ray through the point meets, not yet shaded: a state from which further rays
     * start as in a surface shader, valid until the next call through this pixel. NULL: nothing. */
    RTSstate *(*visit)(struct RTSpixel *pixel, float x, float y);
} RTSpixel;

/* Parameters ------------------------------------------------------------------------------- */

typedef enum RTSscope { RTS_PER_SHADER = 0, RTS_PER_TRIANGLE = 1, RTS_PER_VERTEX = 2 } RTSscope;

typedef enum RTStype {
    RTS_INT1 = 1, RTS_INT2, RTS_INT3, /* rtParameter1i, 2i, 3i; also texture ids. RTS_INT1 of size
                                         1 is a bool: any number but 0 is stored as 1 */
    RTS_FLOAT1, RTS_FLOAT2, RTS_FLOAT3, RTS_FLOAT4, RTS_FLOAT16, /* rtParameter1f ... 16fv */
    RTS_RAW,   /* rtParameterRaw: `size` bytes */
    RTS_STRING /* rtParameterString: a const char * that lives as long as the shader object;
                  per shader only */
} RTStype;

typedef struct RTSparameter {
    const char *name;
    RTSscope scope;
    RTStype type;
    RTuint offset; /* into the block of its scope */
    RTuint size;   /* bytes; checked against the type */
} RTSparameter;

/* The class descriptor ---------------------------------------------------------------------- */

/* What a surface shader reads of the point: bits of RTshaderclass::reads. */
#define RTS_READS_RAY 0x1u            /* rayOrigin, rayDirection, rayDistance */
#define RTS_READS_POSITION 0x2u       /* position */
#define RTS_READS_NORMAL 0x4u         /* geometricNormal, frontFace */
#define RTS_READS_SHADING_NORMAL 0x8u /* shadingNormal */
#define RTS_READS_RAW_NORMAL 0x10u    /* rawNormal */
#define RTS_READS_BARYCENTRIC 0x20u   /* barycentric */
#define RTS_READS_TEXCOORD 0x40u      /* texCoord */
#define RTS_READS_COLOR 0x80u         /* color */
#define RTS_READS_IDS 0x100u          /* object, instance, primitive */
#define RTS_READS_PIXEL 0x200u        /* pixel, sample */
#define RTS_READS_FOOTPRINT 0x400u    /* footprint, texCoordDensity */
#define RTS_READS_EVERYTHING 0xFFFFFFFFu
/* The functions of the table read as well: illuminate and environment the position, these the
 * values named. */
#define RTS_READS_TRACE 0x7u      /* trace, traceHit, shadow: ray, position, normal */
#define RTS_READS_TEXTURE 0x405u  /* texture, for its level of detail: ray, normal, footprint */

/* Functions return 0 for success unless said otherwise; any other value is a fault of the shader:
 * its pixel is black and counted. They must not throw, and run on many threads at once. */
typedef struct RTshaderclass {
    RTuint structSize;       /* sizeof(RTshaderclass) */
    RTuint interfaceVersion; /* RTS_INTERFACE_VERSION */
    RTenum kind;             /* RT_SURFACE_SHADER, RT_ENV_SHADER, RT_LIGHT_SHADER, ... */
    const char *name;

    /* Bytes of the three parameter blocks; the vertex block consists of floats, as it is
     * interpolated, at most 256 of them. */
    RTuint shaderSize, triangleSize, vertexSize;
    RTuint alignment; /* of the shader block, at most 64; the other two blocks get 16 */
    const RTSparameter *parameters;
    RTuint parameterCount;

    /* Fills blocks with defaults; NULL pointers for blocks of size 0. */
    int (*construct)(void *shader, void *triangleBlock, void *vertexBlock);
    /* Ends the per-shader block; may be NULL. The other two blocks are plain data. */
    void (*destroy)(void *shader);

    int (*shade)(const void *shader, RTSstate *state);                /* surface, environment */
    int (*transparency)(const void *shader, RTSstate *, float rgb[3]); /* surface; may be NULL */
    /* light: 1 it contributes, 0 it does not, negative a fault */
    int (*illuminate)(const void *shader, const float position[3], RTSlightsample *sample);
    int (*cameraRay)(const void *shader, float x, float y, RTScameraray *ray); /* camera */
    int (*renderPixel)(const void *shader, RTSpixel *pixel, float rgba[4]); /* rendering object */

    /* All that follow may be NULL. */
    /* shade for up to sixteen points at once: surface, environment */
    int (*shadePacket)(const void *shader, struct RTSpacket *packet);
    /* surface: 1 promises that transparency answers black everywhere; asked once a frame */
    int (*opaque)(const void *shader);
    /* light: into how many samples it wants to be split (1 at least); asked once a frame */
    RTuint (*lightSamples)(const void *shader);
    /* light, in the place of illuminate: sample i of n, from random numbers of the state; the
     * light that the n samples carry together is the mean of their radiances */
    int (*illuminateSample)(const void *shader, RTSstate *state, RTuint i, RTuint n,
                            RTSlightsample *sample);
    /* surface: what shade and shadePacket read of the point, RTS_READS_...; NULL: everything. Asked
     * once the parameters are set, before the shader is used. What is not named is not computed:
     * it is 0 for both functions, as a point and in the lanes of a packet. Lights that are asked
     * for samples see the point as well: in frames with illuminateSample all values are there. */
    RTuint (*reads)(const void *shader);
} RTshaderclass;

/* The calls of a C shader ------------------------------------------------------------------- */

static inline int rtsTraceRay(RTSstate *s, const float origin[3], const float direction[3],
                              float weight, float radiance[3]) {
    return s->functions->trace(s, origin, direction, weight, radiance);
}
static inline int rtsTraceHit(RTSstate *s, const float origin[3], const float direction[3],
                              RTShitinfo *hit) {
    return s->functions->traceHit(s, origin, direction, hit);
}
static inline int rtsShadow(RTSstate *s, const float origin[3], const float direction[3],
                            float distance, float attenuation[3]) {
    return s->functions->shadow(s, origin, direction, distance, attenuation);
}
static inline RTuint rtsLightCount(const RTSstate *s) { return s->functions->lightCount(s); }
static inline int rtsIlluminate(RTSstate *s, RTuint light, RTSlightsample *sample) {
    return s->functions->illuminate(s, light, sample);
}
static inline void rtsTexture(RTSstate *s, RTuint texture, float u, float v, float rgba[4]) {
    s->functions->texture(s, texture, u, v, rgba);
}
static inline const float *rtsHitPosition(const RTSstate *s) { return s->position; }
static inline const float *rtsShadingNormal(const RTSstate *s) { return s->shadingNormal; }
static inline const float *rtsFlatNormal(const RTSstate *s) { return s->geometricNormal; }
static inline const float *rtsTexCoord(const RTSstate *s) { return s->texCoord; }
static inline const float *rtsShadingColor(const RTSstate *s) { return s->color; }
static inline const float *rtsRayDirection(const RTSstate *s) { return s->rayDirection; }
static inline const float *rtsRayOrigin(const RTSstate *s) { return s->rayOrigin; }
static inline const float *rtsBarycentricCoords(const RTSstate *s) { return s->barycentric; }
static inline RTuint rtsFrontFace(const RTSstate *s) { return s->frontFace; }
/* Mirror direction of the incoming ray at the shading normal. */
static inline void rtsReflectedDirection(const RTSstate *s, float direction[3]) {
    const float *d = s->rayDirection, *n = s->shadingNormal;
    const float c = 2.0f * (d[0] * n[0] + d[1] * n[1] + d[2] * n[2]);
    direction[0] = d[0] - c * n[0];
    direction[1] = d[1] - c * n[1];
    direction[2] = d[2] - c * n[2];
}
/* Direction of the incoming ray beyond a surface between two media, by Snell's law; eta is the
 * index of refraction on the ray's side divided by that behind. 0: total reflection, and no
 * direction. */
static inline int rtsRefractedDirection(const RTSstate *s, float eta, float direction[3]) {
    const float *d = s->rayDirection, *n = s->shadingNormal;
    float cosine = d[0] * n[0] + d[1] * n[1] + d[2] * n[2];
    const float side = cosine > 0.0f ? -1.0f : 1.0f; /* of the normal that faces the ray */
    float squared, along;
    cosine *= -side;
    squared = 1.0f - eta * eta * (1.0f - cosine * cosine);
    if (!(squared >= 0.0f)) return 0;
    along = side * (eta * cosine - sqrtf(squared));
    direction[0] = eta * d[0] + along * n[0];
    direction[1] = eta * d[1] + along * n[1];
    direction[2] = eta * d[2] + along * n[2];
    return 1;
}
/* Whether the shader should add light from the surroundings: one ray in a random direction,
 * weighted by how much of what comes from there it reflects. Asked for by path tracing. */
static inline int rtsIndirect(const RTSstate *s) { return (s->flags & RTS_INDIRECT) != 0; }
/* Rays that this point asks for from now on are not traced: black, and 0 as the answer. */
static inline void rtsStopRayRecursion(RTSstate *s) { s->flags |= RTS_STOPPED; }
static inline float rtsRandom(RTSstate *s) { return s->functions->random(s); }
static inline void rtsEnvironment(RTSstate *s, const float direction[3], float radiance[3]) {
    s->functions->environment(s, direction, radiance);
}
static inline void rtsResultColor(RTSstate *s, float r, float g, float b) {
    s->result[0] = r;
    s->result[1] = g;
    s->result[2] = b;
    s->resultSet = 1;
}

#ifdef __cplusplus
}
#endif
#endif
