// SPDX-License-Identifier: MIT
// What the precise mode must say about a set of rays: what exact arithmetic finds, touches
// included, the lowest number among equal distances, and t, u and v as the nearest floats.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <string>

#include "tests/libsmart/kernel/engine_check.h"

namespace smart::test {

/// How many hits differ from the exact ones, and in what.
struct Differences {
    std::size_t hits = 0, existence = 0, triangle = 0, rounding = 0;
    std::size_t all() const { return existence + triangle + rounding; }
};

inline std::ostream& operator<<(std::ostream& out, const Differences& d) {
    return out << d.hits << " hits; wrong: " << d.existence << " hit or miss, " << d.triangle
               << " triangles, " << d.rounding << " roundings";
}

inline bool isNearestFloat(float value, const mpq_class& exact) {
    if (std::isinf(value)) {
        return abs(exact) >= mpq_class(std::ldexp(1.0, 128) - std::ldexp(1.0, 103));
    }
    const mpq_class error = abs(mpq_class(value) - exact);
    for (const float other : {std::nextafter(value, INFINITY), std::nextafter(value, -INFINITY)}) {
        if (!std::isinf(other) && abs(mpq_class(other) - exact) < error) return false;
    }
    return true;
}

inline void compare(const TracedScene& scene, const ExactAnswer& truth, const Hit& hit,
                    Differences& differences) {
    const std::vector<ExactCrossing>& first = truth.touches.empty() ? truth.nearest : truth.touches;
    if (first.empty() != (hit.triangle == kNoHit)) {
        ++differences.existence;
        return;
    }
    if (first.empty()) return;
    ++differences.hits;
    const ExactCrossing* lowest = &first[0];
    for (const ExactCrossing& crossing : first) {
        if (crossing.t == first[0].t && crossing.triangle < lowest->triangle) lowest = &crossing;
    }
    if (scene.claim(hit).triangle != lowest->triangle) {
        ++differences.triangle;
        return;
    }
    differences.rounding += !isNearestFloat(hit.t, lowest->t) ||
                            !isNearestFloat(hit.u, lowest->u) || !isNearestFloat(hit.v, lowest->v);
}

inline Differences compareAll(const TracedScene& scene, std::span<const Ray> rays,
                              std::span<const Hit> hits) {
    Differences differences;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        compare(scene, scene.reference().nearest(rays[i]), hits[i], differences);
    }
    return differences;
}

inline Differences checkPrecise(const TracedScene& scene, std::span<const Ray> rays,
                                const std::string& name) {
    SCOPED_TRACE(name);
    const Differences differences =
        compareAll(scene, rays, traceAllWays(scene, rays, Precision::Precise));
    EXPECT_EQ(differences.all(), 0u) << differences;
    std::cout << "    " << name << ": " << differences << '\n';
    return differences;
}

} // namespace smart::test
