// SPDX-License-Identifier: MIT
// Rays that suit no packet: tracing them together must not cost more than tracing them one by one.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "libsmart/kernel/kernels.h"
#include "tests/bench/measurement.h"

namespace smart::bench {

/// One way to trace the rays of a case.
struct CaseResult {
    std::string form;
    double nanoseconds = 0;  ///< a ray, the median
    double ofSingle = 0;     ///< of the time of single rays, the median over the repeats
    bool asked = true;       ///< false: a yardstick itself
    std::size_t wrong = 0;
};

struct CaseSeries {
    std::string name;
    Query query;
    std::size_t rays = 0;
    std::vector<CaseResult> results;
};

/// May cost so much more than single rays.
inline constexpr double kCaseLimit = 1.1;

/// All cases, size x size rays each. Kernels are compared with the kernel for single rays, the public query with the
/// public query of one ray a call.
std::vector<CaseSeries> measureCases(Precision precision, uint32_t size, unsigned repeats,
                                     const Progress& progress);

nlohmann::json jsonOf(const std::vector<CaseSeries>& cases);
void print(std::ostream& out, const std::vector<CaseSeries>& cases);

} // namespace smart::bench
