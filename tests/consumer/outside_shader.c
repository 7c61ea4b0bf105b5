/* SPDX-License-Identifier: MIT */
/* A shader library of an outside project, in C. */
#include <math.h>
#include <openrt/rts_plugin.h>

static int construct(void *shader, void *triangleBlock, void *vertexBlock) {
    (void)shader;
    (void)triangleBlock;
    (void)vertexBlock;
    return 0;
}

static int shade(const void *shader, RTSstate *state) {
    (void)shader;
    rtsResultColor(state, 1.0f, floorf(0.5f + rtsBarycentricCoords(state)[0] * 0.25f), 0.5f);
    return 0;
}

static const RTshaderclass orchid = {.structSize = sizeof(RTshaderclass),
                                     .interfaceVersion = RTS_INTERFACE_VERSION,
                                     .kind = RT_SURFACE_SHADER,
                                     .name = "Orchid",
                                     .alignment = 1,
                                     .construct = construct,
                                     .shade = shade};

RTS_PLUGIN(orchid);
