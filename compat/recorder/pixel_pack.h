// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec4.hpp>

#include "compat/recorder/picture.h"
#include "compat/recorder/pixel_unpack.h"

namespace smart::compat {

enum class PackOrder : uint8_t {
    Red, Green, Blue, Alpha, Luminance, LuminanceAlpha, Rgb, Rgba, Bgr, Bgra, Depth
};
enum class PackType : uint8_t {
    Byte, UnsignedByte, Short, UnsignedShort, Int, UnsignedInt, Float,
    Fields ///< all components in one number
};

/// The fields of a number that holds a pixel, the highest first; reversed: the first component lies
/// in the lowest.
struct PackFields {
    uint8_t bytes = 0, count = 0;
    uint8_t bits[4] = {};
    bool reversed = false;
};

/// How pixels are stored in the application's memory.
struct PackFormat {
    PackOrder order = PackOrder::Rgba;
    PackType type = PackType::UnsignedByte;
    PackFields fields; ///< PackType::Fields only
};

/// A rectangle of the picture; it may reach beyond.
struct ReadArea {
    int32_t x = 0, y = 0;
    uint32_t width = 0, height = 0;
};

/// Stores the pixels of an area as OpenGL does (OpenGL 1.5, section 4.3.2), after scale and bias of
/// the colours; what lies outside the picture stays as it is. Precondition for depth: the picture
/// has it.
void packPixels(const Picture& picture, const ReadArea& area, const PackFormat& format,
                const PixelStore& store, const glm::vec4& scale, const glm::vec4& bias, void* to);

} // namespace smart::compat
