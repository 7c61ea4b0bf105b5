// SPDX-License-Identifier: MIT
// What the precise mode asks where floats can not tell.
#pragma once

#include "libsmart/kernel/exact_meeting.h"

namespace smart {

enum class Order : uint32_t {
    Nothing, ///< not met, not in the ray's range, or behind the best
    Nearer,  ///< in range, and nearer than the best or the first
    Equal,   ///< exactly as near as the best
};

struct Ruling {
    Order order;
    float low, high; ///< unless Nothing: the distance lies between them
    uint32_t exact;  ///< not 0: exact arithmetic was needed
};

/// Compares where the ray meets the candidate with the ray's limits and with the best triangle so
/// far, whose distance is known to lie in [bestLow, bestHigh]; best.triangle = kNoHit: none yet.
void arbitrate(const ModelView& scene, const WorldRay& ray, const TriangleName& candidate,
               const TriangleName& best, float bestLow, float bestHigh, Ruling& ruling);

/// t, u and v of a triangle that the ray meets, as the nearest floats; returns not 0 where exact
/// arithmetic was needed.
uint32_t placeHit(const ModelView& scene, const WorldRay& ray, const TriangleName& name, float& t,
                  float& u, float& v);

} // namespace smart
