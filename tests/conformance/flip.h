// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "tests/conformance/picture.h"

namespace conformance {

// The FLIP error of each pixel, 0 to 1: what an observer at 67 pixels a degree sees when two
// pictures of one size alternate.
// P. Andersson, J. Nilsson, T. Akenine-Moeller, M. Oskarsson, K. Astroem, M. Fairchild: "FLIP: A
// Difference Evaluator for Alternating Images", High-Performance Graphics 2020.
std::vector<float> flipErrors(const Picture& reference, const Picture& test);

float meanOf(const std::vector<float>& errors);

} // namespace conformance
