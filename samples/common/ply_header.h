// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

namespace samples {

/// Compares what the header of a PLY file announces with the size of the file, so that nobody
/// loops over, or makes room for, elements that are not there. Throws LoadError.
void checkPlyHeader(std::span<const uint8_t> bytes);

} // namespace samples
