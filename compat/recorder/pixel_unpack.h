// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "libsmart/shading/texture.h"

namespace smart::compat {

/// How images lie in the application's memory (OpenGL's unpack state).
struct PixelStore {
    uint32_t alignment = 4;
    uint32_t rowLength = 0; ///< pixels between rows; 0: the image's width
    uint32_t skipPixels = 0, skipRows = 0;
    bool swapBytes = false;
    bool lsbFirst = false; ///< of bitmaps: the lowest bit of a byte is its first
};

enum class PixelOrder : uint8_t {
    Luminance, LuminanceAlpha, Rgb, Rgba, Bgr, Bgra, Red, Green, Blue, Alpha
};

/// An image of the application's, as rtTexImage2D and rtTexSubImage2D name it.
struct ImageSource {
    const void* pixels; ///< nullptr: an image of zeros
    uint32_t width, height;
    PixelOrder order;
    TexelType type;
};

/// Tightly packed texels of 1 to 4 channels (as TextureImage has them), which stand for what
/// `format` says. Alpha that the source lacks is 1, colours that it lacks are 0; luminance and
/// intensity of colours are their red, as in OpenGL.
std::vector<std::byte> unpackImage(const ImageSource& source, const PixelStore& store,
                                   uint32_t channels,
                                   TexelFormat format = TexelFormat::ByChannels);

/// Rows from the bottom, each of whole bytes with the highest bit first.
std::vector<std::byte> unpackBitmap(const void* bits, uint32_t width, uint32_t height,
                                    const PixelStore& store);

} // namespace smart::compat
