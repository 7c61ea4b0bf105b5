// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

namespace samples {

/// Checks that the header of a PLY file is well formed and announces no more than the file holds:
/// assimp loops over, and follows, whatever stands there. Throws LoadError.
void checkPlyHeader(std::span<const uint8_t> bytes);

} // namespace samples
