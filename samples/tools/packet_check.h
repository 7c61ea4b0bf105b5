// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "openrt/rts.h"

namespace samples {

/// What comparing the two forms of a shader class says.
struct PacketVerdict {
    uint32_t points = 0;    ///< compared
    uint32_t different = 0; ///< of which the two forms disagree
    std::string example;    ///< the first of those, in words
};

/// Shades points with a class's `shade`, one by one, and with its `shadePacket`, up to sixteen at
/// once, and compares the bits. What the shader asks is answered without a scene: each answer
/// depends on every bit of the question and on nothing else. The points look in all directions
/// at surfaces of both orientations; packets are full and partly filled; parameters are the class's
/// defaults and others near them.
PacketVerdict checkPackets(const RTshaderclass& shaderClass);

} // namespace samples
