// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <ostream>

#include "tests/bench/measurement.h"

namespace smart::bench {

struct BuildResult {
    std::string engine;
    unsigned threads;
    BuildReport report;
};

/// What one run measured, as text and as JSON.
struct Report {
    std::string scene;
    std::size_t triangles = 0;
    std::vector<BuildResult> builds;
    std::vector<Series> series;

    bool anyRefused() const;
    nlohmann::json json() const;
};
std::ostream& operator<<(std::ostream& out, const Report& report);

} // namespace smart::bench
