// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

namespace samples {

/// What openrt-render reports about a scene and its frames.
struct RenderStatistics {
    std::string scene, output, isa, precision;
    uint32_t width = 0, height = 0, samples = 1;
    int64_t triangles = 0, instances = 0, nodes = 0, leaves = 0, references = 0, bytes = 0;
    int64_t droppedTriangles = 0, droppedInstances = 0, badPixels = 0;
    int64_t primaryRays = 0, shadowRays = 0, secondaryRays = 0; ///< of one frame
    double loadSeconds = 0, buildSeconds = 0;
    std::vector<double> frameSeconds;

    /// Asks the current context for everything that it counts.
    void query();
    /// The fastest frame's, which other programs disturbed least.
    double bestFrameSeconds() const;
    double raysPerSecond() const;

    void printText(std::ostream& out) const;
    void printJson(std::ostream& out) const;
};

} // namespace samples
