// SPDX-License-Identifier: MIT
// Frames with one light, shaded in every way that the library has, beside the time that their rays
// take alone.
#pragma once

#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

#include "tests/bench/measurement.h"

namespace smart::bench {

/// One way to make a frame, or a part of one.
struct FrameCost {
    std::string way;
    double seconds = 0; ///< the least measured: processor time of one thread, by the clock of more
    bool same = true;   ///< the pixels are those of the first way that makes a picture
};

/// Frames of one surface class.
struct FrameSeries {
    std::string surface;
    unsigned threads = 1;
    std::size_t pixels = 0;     ///< each has one camera ray
    std::size_t shadowRays = 0; ///< of a frame
    /// The camera rays, and the shadow rays where there are any, made beforehand and traced by the
    /// kernels as tiles, with nothing else done.
    double aloneSeconds = 0;
    std::size_t aloneShadowRays = 0;
    double cameraSeconds = 0; ///< camera rays made and traced
    std::vector<FrameCost> ways;
};

struct FrameReport {
    std::vector<FrameSeries> series;

    bool allSame() const;
};
std::ostream& operator<<(std::ostream& out, const FrameReport& report);

/// All ways in turn, `repeats` times over, for several surface classes, with one thread and with
/// `threads`. `only`: those whose name begins so.
FrameReport measureFrames(const std::vector<Triangle>& triangles, const View& view,
                          const std::string& only, uint32_t size, unsigned threads,
                          unsigned repeats, const Progress& progress);

} // namespace smart::bench
