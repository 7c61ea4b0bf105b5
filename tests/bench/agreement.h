// SPDX-License-Identifier: MIT
// Speeds count only where the answers are right: engines are compared ray by ray, and where they
// differ the triangles that they name are asked.
#pragma once

#include <span>

#include "tests/bench/engine.h"

namespace smart::bench {

struct Mistakes {
    std::size_t wrong = 0; ///< contradicted by a triangle that the ray clearly crosses, or misses
    std::size_t edge = 0;  ///< differs where the ray passes within 2^-14 of a triangle's edge
};

/// found[e] are the answers of engine e.
std::vector<Mistakes> judgeClosest(const std::vector<Triangle>& triangles, const RaySet& rays,
                                   std::span<const std::vector<Found>> found);

/// blocked[e] are the answers of engine e; for rays in dispute the engines name the triangles.
std::vector<Mistakes> judgeAny(const std::vector<Triangle>& triangles, const RaySet& rays,
                               std::span<const EnginePtr> engines,
                               std::span<const std::vector<uint32_t>> blocked);

/// More wrong answers than this share of the rays, and our speed means nothing.
inline constexpr double kWrongLimit = 1e-6;

} // namespace smart::bench
