// SPDX-License-Identifier: MIT
// What the queue of frames makes of the processors, and how soon it lets go of a frame.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <ostream>

#include "tests/bench/dynamic.h"

namespace smart::bench {

struct QueueFigures {
    unsigned frames = 0, depth = 0, threads = 0;
    double wall = 0;       ///< seconds from the first rtQueueFrame to the end of the last frame
    double busy = 0;       ///< of the library's threads, by its own counts
    double idle = 0;
    double processor = 0;  ///< of the same threads, by the system: running
    double ready = 0;      ///< and ready to run, while others had the processors
    double tile = 0;       ///< mean time of a tile
    double longestTile = 0;
    double cancel = 0;     ///< median time from rtCancelFrame to the end of the frame
    double longestCancel = 0;

    nlohmann::json json() const;
};
std::ostream& operator<<(std::ostream& out, const QueueFigures& figures);

/// Lit frames of the scene, `frames` of them; then as many cancelled ones as `options.repeat`.
QueueFigures measureQueue(const DynamicScene& scene, const DynamicOptions& options,
                          unsigned frames);

} // namespace smart::bench
