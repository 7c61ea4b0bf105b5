/* SPDX-License-Identifier: MIT */
/* Toon, a surface shader in C: the light in a few flat steps, and a dark line where the surface
 * turns away from the viewer. */
#include <math.h>
#include <stddef.h>

#include "openrt/rts_plugin.h"

typedef struct Toon {
    float color[3];
    RTint steps;   /* of brightness */
    float outline; /* cosine below which the line begins; 0: no line */
} Toon;

static const RTSparameter parameters[] = {
    {"color", RTS_PER_SHADER, RTS_FLOAT3, offsetof(Toon, color), sizeof(float[3])},
    {"steps", RTS_PER_SHADER, RTS_INT1, offsetof(Toon, steps), sizeof(RTint)},
    {"outline", RTS_PER_SHADER, RTS_FLOAT1, offsetof(Toon, outline), sizeof(float)}};

static int construct(void *shader, void *triangleBlock, void *vertexBlock) {
    const Toon defaults = {{0.9f, 0.5f, 0.2f}, 3, 0.25f};
    (void)triangleBlock; /* this class has parameters per shader only */
    (void)vertexBlock;
    *(Toon *)shader = defaults;
    return 0;
}

static float dot(const float a[3], const float b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static int shade(const void *shader, RTSstate *state) {
    const Toon *toon = (const Toon *)shader;
    const float *normal = rtsShadingNormal(state);
    const float facing = dot(normal, rtsRayDirection(state));
    const float side = facing < 0.0f ? 1.0f : -1.0f; /* normals may point away from the ray */
    float brightness = 0.0f;
    RTuint i;

    if (fabsf(facing) < toon->outline) {
        rtsResultColor(state, 0.0f, 0.0f, 0.0f);
        return 0;
    }
    for (i = 0; i < rtsLightCount(state); ++i) {
        RTSlightsample light;
        float cosine, open[3];
        if (!rtsIlluminate(state, i, &light)) continue;
        cosine = side * dot(normal, light.direction);
        if (cosine <= 0.0f) continue;
        rtsShadow(state, rtsHitPosition(state), light.direction, light.distance, open);
        brightness += cosine * open[1] * light.radiance[1];
    }
    /* One step more than the light reaches, so that the shade is not black. */
    brightness = (floorf(fminf(brightness, 0.999f) * (float)toon->steps) + 1.0f) /
                 ((float)toon->steps + 1.0f);
    rtsResultColor(state, toon->color[0] * brightness, toon->color[1] * brightness,
                   toon->color[2] * brightness);
    return 0;
}

static const RTshaderclass toonClass = {
    .structSize = sizeof(RTshaderclass),
    .interfaceVersion = RTS_INTERFACE_VERSION,
    .kind = RT_SURFACE_SHADER,
    .name = "Toon",
    .shaderSize = sizeof(Toon),
    .alignment = sizeof(float),
    .parameters = parameters,
    .parameterCount = sizeof parameters / sizeof parameters[0],
    .construct = construct,
    .shade = shade};

RTS_PLUGIN(toonClass);
