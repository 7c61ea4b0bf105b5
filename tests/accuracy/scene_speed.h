// SPDX-License-Identifier: MIT
// How fast each mode is on a scene, all engines in turn over the same rays.
#pragma once

#include <string>
#include <vector>

#include "tests/bench/measurement.h"

namespace smart::test {

struct SceneSpeed {
    std::string scene;
    std::size_t triangles = 0;
    std::vector<bench::Series> series;
    /// Of the precise mode's primary rays; 0 where the library does not count.
    uint64_t triangleTests = 0, doubleTests = 0, exactTests = 0;
};

struct SpeedOptions {
    std::string scene; ///< a .tri file, or generated:N
    bench::View view;
    uint32_t size = 512; ///< width and height in pixels
    unsigned threads = 1, repeat = 5;
    bool embree = true;
};

SceneSpeed measureScene(const SpeedOptions& options);

} // namespace smart::test
