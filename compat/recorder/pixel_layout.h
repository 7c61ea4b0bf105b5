// SPDX-License-Identifier: MIT
// How pixels lie in the application's memory.
#pragma once

#include <cstddef>
#include <cstdint>

#include "libsmart/shading/texture_image.h"

namespace smart::compat {

enum class PixelOrder : uint8_t {
    Luminance, LuminanceAlpha, Rgb, Rgba, Bgr, Bgra, Red, Green, Blue, Alpha, Depth
};
enum class PixelType : uint8_t {
    Byte, UnsignedByte, Short, UnsignedShort, Int, UnsignedInt, Half, Float,
    Fields ///< all components in one number
};

/// The fields of a number that holds a pixel, the highest first; reversed: the first component lies
/// in the lowest.
struct PixelFields {
    uint8_t bytes = 0, count = 0;
    uint8_t bits[4] = {};
    bool reversed = false;

    uint8_t bitsOf(uint32_t component) const {
        return bits[reversed ? count - 1 - component : component];
    }
    /// From the lowest bit of the number.
    uint32_t shiftOf(uint32_t component) const;
};

struct PixelLayout {
    PixelOrder order = PixelOrder::Rgba;
    PixelType type = PixelType::UnsignedByte;
    PixelFields fields = {}; ///< PixelType::Fields only

    uint32_t components() const;
    /// Whether its numbers are whole and may be negative.
    bool isSigned() const {
        return type == PixelType::Byte || type == PixelType::Short || type == PixelType::Int;
    }
    /// Of what the machine's order of bytes, and alignment, apply to.
    std::size_t elementBytes() const;
    std::size_t pixelBytes() const;
};

/// OpenGL's pack or unpack state.
struct PixelStore {
    uint32_t alignment = 4;
    uint32_t rowLength = 0; ///< pixels between rows; 0: the image's width
    uint32_t skipPixels = 0, skipRows = 0;
    bool swapBytes = false;
    bool lsbFirst = false; ///< of bitmaps: the lowest bit of a byte is its first
};

/// Where the rows of an image begin.
struct PixelRows {
    std::size_t offset, stride; ///< bytes to the first pixel, from row to row
};
PixelRows rowsOf(const PixelLayout& layout, uint32_t width, const PixelStore& store);

/// Texels that hold the values of such pixels between 0 and 1, those of 10 bits and more in 16 bits.
TexelType texelTypeFor(const PixelLayout& layout);
/// Of texels of red, green, blue and alpha.
PixelLayout rgbaLayoutOf(TexelType type);

} // namespace smart::compat
