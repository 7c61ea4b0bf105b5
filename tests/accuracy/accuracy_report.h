// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <ostream>

#include "tests/accuracy/case_run.h"
#include "tests/accuracy/scene_speed.h"
#include "tests/accuracy/secondary.h"

namespace smart::test {

/// What one run of openrt-accuracy found.
struct AccuracyReport {
    std::string isa, embree; ///< embree: its version, empty without
    unsigned threads = 1;
    std::size_t rays = 0;
    std::vector<CaseResult> cases;
    std::vector<SecondaryResult> secondary;
    std::vector<SceneSpeed> speeds;

    nlohmann::json json() const;
    /// Rates a million rays, one line a case and engine.
    void printTable(std::ostream& out) const;
    /// The promises that our modes broke; empty if none.
    std::string brokenPromises() const;
};

} // namespace smart::test
