// SPDX-License-Identifier: MIT
// Frames with one light, shaded in every way that the library has.
#pragma once

#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

#include "tests/bench/measurement.h"

namespace smart::bench {

/// One way to shade frames of one surface class.
struct ShadingResult {
    std::string way;
    double seconds = 0; ///< of processor time, for a frame: the least measured
    bool same = true;   ///< the pixels are those of the first way
};

struct ShadingSeries {
    std::string surface;
    std::size_t hits = 0;       ///< of camera rays
    std::size_t shadowRays = 0; ///< of a frame
    double raySeconds = 0;      ///< the same for making and tracing the camera rays alone
    std::vector<ShadingResult> results;
};

struct ShadingReport {
    unsigned threads = 1;
    std::vector<ShadingSeries> series;

    bool allSame() const;
};
std::ostream& operator<<(std::ostream& out, const ShadingReport& report);

/// All ways in turn, `repeats` times over, for several surface classes.
ShadingReport measureFrames(const std::vector<Triangle>& triangles, const View& view,
                            uint32_t size, unsigned threads, unsigned repeats,
                            const Progress& progress);

} // namespace smart::bench
