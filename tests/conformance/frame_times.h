// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "tests/conformance/conformance_case.h"

namespace conformance {

// Milliseconds of a frame: as they pass, and of all threads together, which says more where other
// programs run.
struct Milliseconds {
    double passed = 1e30, worked = 1e30;
};

struct FrameTime {
    std::string name; // of the port, and what it was given
    Milliseconds openGl, openRt;
};

// Each port whose name begins with the prefix, 512x512, two threads on both sides; of the
// isosurface 50 thousand, 500 thousand and 5 million triangles too. What ten more frames take after
// the first three: shaders are compiled then, trees are built. Runs of both alternate; the least of
// three counts. A line is printed for each as it is measured.
std::vector<FrameTime> measureFrameTimes(const Settings& settings, const std::string& prefix);

} // namespace conformance
