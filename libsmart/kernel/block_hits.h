// SPDX-License-Identifier: MIT
#pragma once

#include "libsmart/kernel/triangle_block.h"

namespace smart::SMART_ISA {

/// What a policy says of one ray and the triangles of a block, side by side: bit i of a mask is
/// triangle i. A triangle in none of the masks is missed, or out of range.
struct BlockHits {
    uint32_t sure;    ///< hit at t, unless t is near that of the best hit
    uint32_t atStart; ///< met, perhaps behind the ray's start
    uint32_t unsure;  ///< left to the test of one triangle
    alignas(64) float t[kPacketSize];

    uint32_t any() const { return sure | atStart | unsure; }
};

} // namespace smart::SMART_ISA
