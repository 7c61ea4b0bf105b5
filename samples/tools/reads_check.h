// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "openrt/rts.h"

namespace samples {

/// The values of a point, as RTS_READS_ names them, that `shade` of a surface class depends on
/// without its `reads` saying so. Each is set to 0 in turn, as in a frame, and the radiances are
/// compared; questions are answered as in checkPackets. Empty for a class without `reads`.
std::vector<std::string> undeclaredReads(const RTshaderclass& shaderClass);

} // namespace samples
