// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "compat/recorder/pixel_layout.h"
#include "compat/recorder/pixel_transfer.h"
#include "libsmart/shading/texture.h"

namespace smart::compat {

/// An image of the application's, as rtTexImage2D and rtTexSubImage2D name it.
struct ImageSource {
    const void* pixels; ///< nullptr: an image of zeros
    uint32_t width, height;
    PixelLayout layout;
};

/// Tightly packed texels of 1 to 4 channels (as TextureImage has them), which stand for what
/// `format` says. Alpha that the source lacks is 1, colours that it lacks are 0; luminance and
/// intensity of colours are their red, as in OpenGL. Signed numbers stand for -1 to 1 (OpenGL 1.5,
/// table 2.9); what `type` can not hold is limited to what it can.
std::vector<std::byte> unpackImage(const ImageSource& source, const PixelStore& store,
                                   uint32_t channels, TexelType type,
                                   TexelFormat format = TexelFormat::ByChannels,
                                   const PixelTransfer& transfer = {});

/// Rows from the bottom, each of whole bytes with the highest bit first.
std::vector<std::byte> unpackBitmap(const void* bits, uint32_t width, uint32_t height,
                                    const PixelStore& store);

} // namespace smart::compat
