// SPDX-License-Identifier: MIT
// H9: rays that leave the surface which a ray has hit.
#pragma once

#include "tests/accuracy/case_run.h"

namespace smart::test {

struct SecondaryResult {
    std::string scene, engine;
    int mode = -1;
    std::size_t rays = 0;  ///< of each side
    std::size_t acne = 0;  ///< outward: met what is not there, or its own surface
    std::size_t leaks = 0; ///< inward: met nothing, or not the surface that comes next
};

/// One case for each scene of H9: closed spheres and pairs of concentric ones, moved and scaled.
std::vector<SecondaryResult> runSecondary(const std::vector<EngineKind>& kinds, std::size_t rays,
                                          unsigned threads, uint64_t seed);

} // namespace smart::test
