// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "libsmart/kernel/packet.h"

namespace smart {

/// Transparent surfaces that a shadow ray passes; what lies behind so many counts as dark.
inline constexpr int kMaxTransparentHits = 256;

/// The surfaces that a ray passes, each once: the test in float may find a triangle again just
/// behind where it was found, and at an edge it finds both triangles.
class Crossings {
public:
    /// Whether the hit is another surface than those before it.
    bool add(const Hit& hit) {
        for (int i = 0; i < count_; ++i)
            if (hit.triangle == recent_[i].triangle && samePath(hit, recent_[i])) return repeated();
        if (count_ > 0 && samePath(hit, recent_[newest_]) &&
            hit.t <= recent_[newest_].t * (1.0f + kSamePlace))
            return repeated();
        newest_ = (newest_ + 1) % kRecent;
        recent_[newest_] = hit;
        count_ = std::min(count_ + 1, kRecent);
        step_ = 0x1p-23f;
        return true;
    }
    /// Where to look for the next one.
    float beyond(const Hit& hit) const {
        constexpr float kInfinity = std::numeric_limits<float>::infinity();
        return std::max(std::nextafter(hit.t, kInfinity), hit.t * (1.0f + step_));
    }

private:
    static constexpr int kRecent = 4;
    static constexpr float kSamePlace = 0x1p-20f; ///< hits of one instance, as a share of t

    static bool samePath(const Hit& a, const Hit& b) {
        return a.levels == b.levels && std::equal(a.path, a.path + a.levels, b.path);
    }
    bool repeated() {
        step_ *= 2; // the float test's error is a few units in the last place, seldom more
        return false;
    }

    Hit recent_[kRecent];
    int count_ = 0, newest_ = kRecent - 1;
    float step_ = 0x1p-23f;
};

} // namespace smart
