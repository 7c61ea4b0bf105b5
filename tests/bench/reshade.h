// SPDX-License-Identifier: MIT
// What instances of one model with other shaders cost, in memory and in building time.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <vector>

#include "libsmart/kernel/view.h"

namespace smart::bench {

struct ReshadeReport {
    std::size_t triangles = 0;
    uint32_t instances = 0;
    std::size_t modelBytes = 0;     ///< triangles, tree, shading data
    double instanceBytes = 0;       ///< of one more reshaded instance, as the library counts
    double instanceAllocated = 0;   ///< the same as malloc counts; 0 where it does not tell
    double millisecondsPerFrame = 0; ///< building the tree over the instances
};

/// Measures a model of two shaders, and a scene of so many instances each with a set of its own.
ReshadeReport measureReshading(const std::vector<Triangle>& triangles, uint32_t instances,
                               unsigned threads);

std::ostream& operator<<(std::ostream&, const ReshadeReport&);

} // namespace smart::bench
