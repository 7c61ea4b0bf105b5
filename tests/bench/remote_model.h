// SPDX-License-Identifier: MIT
// How fast a frame is that many machines render together, computed from what one costs.
#pragma once

#include <cstdint>

namespace smart::bench {

struct RemoteCosts {
    double tileSeconds = 0;       ///< of one thread, tracing
    double masterSeconds = 0; ///< for a tile of another rank, by the thread that serves them
    double answerBytes = 0;       ///< of a tile on the wire
    double latencySeconds = 0;    ///< one way
    double lineBytesPerSecond = 0; ///< of rank 0; 0: no limit
    double tilesAhead = 3;         ///< a thread
};

struct RemotePrediction {
    double frameSeconds = 0;  ///< of a frame by itself
    double framesPerSecond = 0; ///< with frames in the queue
    const char* limit = "";   ///< what sets the latter
    double efficiency = 0;    ///< of framesPerSecond, against as many threads without a network
};

/// ranks: with rank 0; each has so many threads that trace. All tiles cost the same.
RemotePrediction predict(const RemoteCosts& costs, uint64_t tiles, unsigned ranks,
                         unsigned threads);

} // namespace smart::bench
