// SPDX-License-Identifier: MIT
// One lane's vectors in packets of points.
#pragma once

#include "openrt/rts_packet.h"

namespace smart {

inline void setLane(RTSvectors& to, int lane, const float (&from)[3]) {
    to.x.lane[lane] = from[0];
    to.y.lane[lane] = from[1];
    to.z.lane[lane] = from[2];
}
template <int N>
void setLane(RTSfloats (&to)[N], int lane, const float (&from)[N]) {
    for (int k = 0; k < N; ++k) to[k].lane[lane] = from[k];
}
inline void getLane(const RTSvectors& from, int lane, float (&to)[3]) {
    to[0] = from.x.lane[lane];
    to[1] = from.y.lane[lane];
    to[2] = from.z.lane[lane];
}
template <int N>
void getLane(const RTSfloats (&from)[N], int lane, float (&to)[N]) {
    for (int k = 0; k < N; ++k) to[k] = from[k].lane[lane];
}

} // namespace smart
