// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace smart {

/// Sums over the tiles of finished frames.
struct RenderStatistics {
    uint64_t primaryRays = 0, shadowRays = 0, secondaryRays = 0, badPixels = 0;
};

} // namespace smart
