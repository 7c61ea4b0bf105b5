// SPDX-License-Identifier: MIT
// Speeds count only where the answers are right: engines are compared ray by ray, and where they
// differ the triangles are asked (truth.h).
#pragma once

#include <span>

#include "tests/bench/engine.h"
#include "tests/bench/truth.h"

namespace smart::bench {

struct Mistakes {
    std::size_t wrong = 0;
    std::size_t ties = 0; ///< right for a ray near the ray only: edges and silhouettes
};

/// found[e] are the answers of engine e. Rays on which all agree are judged now and then.
std::vector<Mistakes> judgeClosest(const Truth& truth, const RaySet& rays,
                                   std::span<const std::vector<Found>> found);

/// blocked[e] are the answers of engine e.
std::vector<Mistakes> judgeAny(const Truth& truth, const RaySet& rays,
                               std::span<const std::vector<uint32_t>> blocked);

/// With this share of wrong answers our speed means nothing.
inline constexpr double kWrongLimit = 1e-6;

} // namespace smart::bench
