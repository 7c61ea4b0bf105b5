// SPDX-License-Identifier: MIT
#pragma once

#include "samples/common/environment_file.h"

namespace samples {

/// A picture in Radiance's format (.hdr), plain or run-length encoded, its first row at the top
/// and its first column at the left; throws LoadError.
Environment decodeRadiance(std::span<const uint8_t> bytes, PixelBudget& budget);

} // namespace samples
