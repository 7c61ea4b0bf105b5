// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace smart {

/// Sums over the finished tiles of a frame, or of several.
struct RenderStatistics {
    uint64_t primaryRays = 0, shadowRays = 0, secondaryRays = 0, badPixels = 0;
    /// Of all workers: rendering tiles and writing them; and from the end of one tile to the start
    /// of the next, counted for the frame of the latter.
    uint64_t busyNanoseconds = 0, idleNanoseconds = 0;

    RenderStatistics& operator+=(const RenderStatistics& other) {
        primaryRays += other.primaryRays;
        shadowRays += other.shadowRays;
        secondaryRays += other.secondaryRays;
        badPixels += other.badPixels;
        busyNanoseconds += other.busyNanoseconds;
        idleNanoseconds += other.idleNanoseconds;
        return *this;
    }
};

} // namespace smart
