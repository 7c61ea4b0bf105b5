// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "samples/common/image_file.h"

namespace samples {

/// Checks what OpenEXR takes on trust in a file's header: that it announces no more than fits into
/// the budget and a bounded part of memory, and than the file can hold. Files of several parts,
/// deep pixels and cube maps are refused. Throws LoadError.
void checkExrHeader(std::span<const uint8_t> bytes, PixelBudget& budget);

} // namespace samples
