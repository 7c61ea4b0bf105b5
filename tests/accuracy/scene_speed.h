// SPDX-License-Identifier: MIT
// How fast each mode is on a scene, all engines in turn over the same rays.
#pragma once

#include <string>
#include <vector>

#include "tests/bench/measurement.h"

namespace smart::test {

/// One engine and kind of rays, traced by one thread. Time is what the thread spent computing, so
/// that other programs on the machine disturb little; the best repeat counts.
struct EngineSpeed {
    std::string engine;
    bench::Kind kind;
    std::vector<double> nanosecondsPerRay; ///< one for each repeat
    bench::Mistakes mistakes;

    double best() const;
};

struct SceneSpeed {
    std::string scene;
    std::size_t triangles = 0, primaryRays = 0, shadowRays = 0;
    std::vector<EngineSpeed> engines;
    uint64_t triangleTests = 0, doubleTests = 0, exactTests = 0; ///< precise mode, primary rays
};

struct SpeedOptions {
    std::string scene; ///< a .tri file, or generated:N
    bench::View view;
    uint32_t size = 512; ///< width and height in pixels
    unsigned buildThreads = 1, repeat = 5;
    bool embree = true;
};

SceneSpeed measureScene(const SpeedOptions& options);

} // namespace smart::test
