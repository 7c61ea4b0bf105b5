// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "tests/conformance/conformance_case.h"

namespace conformance {

struct FrameTime {
    std::string name;              // of the port, and what it was given
    double openGl = 0, openRt = 0; // milliseconds of a frame
    std::string renderer;          // OpenGL's
};

// Milliseconds of a frame of each port whose name begins with the prefix, 512x512, two threads on
// both sides, after the first frames; of the isosurface with 50 thousand, 500 thousand and 5
// million triangles too. A line is printed for each as it is measured.
std::vector<FrameTime> measureFrameTimes(const Settings& settings, const std::string& prefix);

} // namespace conformance
