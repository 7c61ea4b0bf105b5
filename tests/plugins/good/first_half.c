/* SPDX-License-Identifier: MIT */
/* Two classes in C; second_half.cpp adds one in C++ to the same library. */
#include <openrt/rts_plugin.h>

static int construct(void *shader, void *triangleBlock, void *vertexBlock) {
    (void)triangleBlock;
    (void)vertexBlock;
    *(float *)shader = 0.5f;
    return 0;
}
static int shadeRed(const void *shader, RTSstate *state) {
    rtsResultColor(state, *(const float *)shader, 0, 0);
    return 0;
}
static int shadeGreen(const void *shader, RTSstate *state) {
    rtsResultColor(state, 0, *(const float *)shader, 0);
    return 0;
}

static const RTshaderclass red = {.structSize = sizeof(RTshaderclass),
                                  .interfaceVersion = RTS_INTERFACE_VERSION,
                                  .kind = RT_SURFACE_SHADER,
                                  .name = "Red",
                                  .shaderSize = sizeof(float),
                                  .alignment = sizeof(float),
                                  .construct = construct,
                                  .shade = shadeRed};
static const RTshaderclass green = {.structSize = sizeof(RTshaderclass),
                                    .interfaceVersion = RTS_INTERFACE_VERSION,
                                    .kind = RT_SURFACE_SHADER,
                                    .name = "Green",
                                    .shaderSize = sizeof(float),
                                    .alignment = sizeof(float),
                                    .construct = construct,
                                    .shade = shadeGreen};

RTS_PLUGIN(red);
RTS_PLUGIN(green);
