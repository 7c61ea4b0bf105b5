// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <ostream>

#include "libsmart/kernel/packet.h"
#include "tests/bench/limits.h"
#include "tests/bench/measurement.h"

namespace smart::bench {

/// What rays do in the tree that packets walk, as the counting kernels say.
struct RayCounts {
    Kind kind = Kind::Primary;
    std::size_t rays = 0, packets = 0;
    TraversalCounts alone, together; ///< one ray a packet, and sixteen
};

struct BuildResult {
    std::string engine;
    unsigned threads;
    BuildReport report;
};

/// What one run measured, as text and as JSON.
struct Report {
    std::string scene, isa, precision = "watertight";
    uint32_t size = 0; ///< of the picture
    std::size_t triangles = 0;
    std::vector<BuildResult> builds;
    std::vector<Series> series;
    std::vector<RayCounts> counts;
    Limits limits;

    bool anyRefused() const;
    nlohmann::json json() const;
};
std::ostream& operator<<(std::ostream& out, const Report& report);

} // namespace smart::bench
