/* SPDX-License-Identifier: MIT */
/* A shader class in C: squares of two colours over the texture coordinates, lit without shadows.
 * The colour of the light squares can be set for each vertex too, and multiplies then. */
#include <math.h>
#include <stddef.h>

#include "openrt/rts_plugin.h"
#include "sample_shaders.h"

typedef struct Checker {
    float light[3], dark[3];
    float squares; /* along a unit of texture coordinate */
} Checker;

typedef struct CheckerVertex {
    float tint[3];
} CheckerVertex;

static int construct(void *shader, void *triangleBlock, void *vertexBlock) {
    const Checker defaults = {{0.9f, 0.9f, 0.9f}, {0.1f, 0.1f, 0.1f}, 8.0f};
    const CheckerVertex vertexDefaults = {{1.0f, 1.0f, 1.0f}};
    (void)triangleBlock;
    *(Checker *)shader = defaults;
    *(CheckerVertex *)vertexBlock = vertexDefaults;
    return 0;
}

static int shade(const void *shader, RTSstate *state) {
    const Checker *checker = (const Checker *)shader;
    const float *tint = ((const CheckerVertex *)state->vertexParam)->tint;
    const float *coordinate = rtsTexCoord(state);
    const float *normal = rtsShadingNormal(state);
    const float cell = floorf(coordinate[0] * checker->squares) +
                       floorf(coordinate[1] * checker->squares);
    const float *color = fmodf(fabsf(cell), 2.0f) < 0.5f ? checker->light : checker->dark;
    const float side = rtsFrontFace(state) ? 1.0f : -1.0f;
    float sum[3] = {0.0f, 0.0f, 0.0f};
    RTuint i;
    int k;
    for (i = 0; i < rtsLightCount(state); ++i) {
        RTSlightsample light;
        float cosine;
        if (!rtsIlluminate(state, i, &light)) continue;
        cosine = side * (normal[0] * light.direction[0] + normal[1] * light.direction[1] +
                         normal[2] * light.direction[2]);
        if (cosine <= 0.0f) continue;
        for (k = 0; k < 3; ++k) sum[k] += color[k] * tint[k] * cosine * light.radiance[k];
    }
    rtsResultColor(state, sum[0], sum[1], sum[2]);
    return 0;
}

static const RTSparameter parameters[] = {
    {"light", RTS_PER_SHADER, RTS_FLOAT3, offsetof(Checker, light), sizeof(float[3])},
    {"dark", RTS_PER_SHADER, RTS_FLOAT3, offsetof(Checker, dark), sizeof(float[3])},
    {"squares", RTS_PER_SHADER, RTS_FLOAT1, offsetof(Checker, squares), sizeof(float)},
    {"tint", RTS_PER_VERTEX, RTS_FLOAT3, offsetof(CheckerVertex, tint), sizeof(float[3])}};

static const RTshaderclass checker = {
    .structSize = sizeof(RTshaderclass),
    .interfaceVersion = RTS_INTERFACE_VERSION,
    .kind = RT_SURFACE_SHADER,
    .name = "Checker",
    .shaderSize = sizeof(Checker),
    .vertexSize = sizeof(CheckerVertex),
    .alignment = sizeof(float),
    .parameters = parameters,
    .parameterCount = sizeof parameters / sizeof parameters[0],
    .construct = construct,
    .shade = shade};

RTS_PLUGIN(checker);

const RTshaderclass *checkerClass(void) { return &checker; }
