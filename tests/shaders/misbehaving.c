/* SPDX-License-Identifier: MIT */
#include "tests/shaders/misbehaving.h"

#include <string.h>

#include "openrt/rts_packet.h"
#include "openrt/rts_plugin.h"

static int construct(void *shader, void *triangleBlock, void *vertexBlock) {
    (void)shader, (void)triangleBlock, (void)vertexBlock;
    return 0;
}

static int returnFault(const void *shader, RTSstate *state) {
    (void)shader;
    rtsResultColor(state, 1.0f, 1.0f, 1.0f);
    return 7;
}

static int returnFaultInPacket(const void *shader, struct RTSpacket *packet) {
    (void)shader;
    packet->resultSet = packet->active;
    return -7;
}

static int divideByZero(const void *shader, RTSstate *state) {
    const float zero = rtsRayDirection(state)[0] * 0.0f;
    (void)shader;
    rtsResultColor(state, 1.0f / zero, zero / zero, 0.0f);
    return 0;
}

#define SURFACE(identifier, itsName)                                                          \
    static const RTshaderclass identifier = {.structSize = sizeof(RTshaderclass),             \
                                             .interfaceVersion = RTS_INTERFACE_VERSION,       \
                                             .kind = RT_SURFACE_SHADER,                       \
                                             .name = itsName,                                 \
                                             .alignment = 1,                                  \
                                             .construct = construct,

SURFACE(faulty, "ReturnsFault").shade = returnFault};
SURFACE(faultyPacket, "ReturnsFaultInPacket").shade = returnFault,
    .shadePacket = returnFaultInPacket};
SURFACE(dividing, "DividesByZero").shade = divideByZero};

RTS_PLUGIN(faulty);
RTS_PLUGIN(faultyPacket);
RTS_PLUGIN(dividing);

const RTshaderclass *misbehavingClass(const char *name) {
    const RTshaderclass *const all[] = {&faulty, &faultyPacket, &dividing};
    for (unsigned i = 0; i < sizeof all / sizeof all[0]; ++i)
        if (strcmp(all[i]->name, name) == 0) return all[i];
    return NULL;
}
