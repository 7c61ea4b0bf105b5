// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "openrt/rts_packet.h"

namespace samples {

/// Stands in for the library while shaders are compared: the same question from a point and from
/// a lane gets the same answer, bit for bit, and other questions get others. So do points of which
/// the library would read other values for its answer: RTS_READS_TRACE, RTS_READS_TEXTURE.
struct AnsweringTracer {
    static constexpr int kLights = 3;

    uint32_t seed[RTS_PACKET_SIZE] = {};  ///< of the random numbers of each lane
    uint32_t drawn[RTS_PACKET_SIZE] = {}; ///< how many of them were asked for
};

/// Function tables whose `tracer` is an AnsweringTracer; a point is its lane 0.
const RTSfunctions& answeringFunctions();
const RTSpacketfunctions& answeringPacketFunctions();

} // namespace samples
