// SPDX-License-Identifier: MIT
// What is left of an object's tree after many updates: rays through it against rays through one
// that was made for the same positions.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <ostream>

#include "tests/bench/dynamic.h"

namespace smart::bench {

/// Seconds, the least of several.
struct DecayStep {
    unsigned number = 0;
    double updated = 0; ///< camera rays through the object that was updated so often
    double fresh = 0;   ///< the same through one that was defined with these positions
};

struct DecaySeries {
    std::string motion;
    std::vector<DecayStep> steps;
    double update = 0, longest = 0; ///< of the updates, in seconds: the median, and the longest
};

struct DecayReport {
    std::vector<DecaySeries> series;
    nlohmann::json json() const;
};
std::ostream& operator<<(std::ostream& out, const DecayReport& report);

/// Updates a sheet so many times for each of several motions.
DecayReport measureDecay(const DynamicOptions& options, unsigned updates,
                         const DynamicProgress& progress);

} // namespace smart::bench
