// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "compat/recorder/picture.h"
#include "compat/recorder/pixel_layout.h"
#include "compat/recorder/pixel_transfer.h"

namespace smart::compat {

/// A rectangle of the picture; it may reach beyond.
struct ReadArea {
    int32_t x = 0, y = 0;
    uint32_t width = 0, height = 0;
};

/// Stores the pixels of an area as OpenGL does (OpenGL 1.5, section 4.3.2), after the transfer
/// of the colours; what lies outside the picture stays as it is. Precondition for depth: the picture
/// has it.
void packPixels(const Picture& picture, const ReadArea& area, const PixelLayout& layout,
                const PixelStore& store, const PixelTransfer& transfer, void* to);

} // namespace smart::compat
