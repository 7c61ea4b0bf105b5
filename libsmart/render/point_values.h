// SPDX-License-Identifier: MIT
// The values of shaded points by the names that shaders give them: RTS_READS_...
#pragma once

#include <cstdint>

#include "openrt/rts_packet.h"

namespace smart {

/// Sets values of all lanes, or of the point, to 0.
void clearValues(RTSpacket& points, uint32_t values);
void clearValues(RTSstate& point, uint32_t values);

/// Copies values of a lane.
void copyValues(const RTSpacket& from, int lane, uint32_t values, RTSpacket& to);

} // namespace smart
