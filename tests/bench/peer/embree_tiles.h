// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "tests/bench/peer/embree_frames.h"

namespace smart::bench {

/// A camera ray for each pixel; from what it meets one to each light in front of the surface, and a
/// reflected one where the instance's object reflects, with rays to the lights from there. In
/// packets of sixteen, flagged as coherent, by so many threads.
PeerRays traceFrame(RTCScene scene, const PeerFrame& frame, std::span<const uint8_t> reflecting,
                    unsigned threads);

} // namespace smart::bench
