// SPDX-License-Identifier: MIT
#include "compat/recorder/pixel_layout.h"

#include <algorithm>

namespace smart::compat {

uint32_t PixelFields::shiftOf(uint32_t component) const {
    const uint32_t field = reversed ? count - 1 - component : component;
    uint32_t shift = 0;
    for (uint32_t below = field + 1; below < count; ++below) shift += bits[below];
    return shift;
}

uint32_t PixelLayout::components() const {
    switch (order) {
    case PixelOrder::LuminanceAlpha: return 2;
    case PixelOrder::Rgb:
    case PixelOrder::Bgr: return 3;
    case PixelOrder::Rgba:
    case PixelOrder::Bgra: return 4;
    default: return 1;
    }
}

std::size_t PixelLayout::elementBytes() const {
    switch (type) {
    case PixelType::Byte:
    case PixelType::UnsignedByte: return 1;
    case PixelType::Short:
    case PixelType::UnsignedShort:
    case PixelType::Half: return 2;
    case PixelType::Fields: return fields.bytes;
    default: return 4;
    }
}

std::size_t PixelLayout::pixelBytes() const {
    return type == PixelType::Fields ? fields.bytes : components() * elementBytes();
}

PixelRows rowsOf(const PixelLayout& layout, uint32_t width, const PixelStore& store) {
    const std::size_t pixel = layout.pixelBytes();
    std::size_t stride = (store.rowLength != 0 ? store.rowLength : width) * pixel;
    if (layout.elementBytes() < store.alignment)
        stride = (stride + store.alignment - 1) / store.alignment * store.alignment;
    return {store.skipRows * stride + store.skipPixels * pixel, stride};
}

TexelType texelTypeFor(const PixelLayout& layout) {
    switch (layout.type) {
    case PixelType::Byte:
    case PixelType::UnsignedByte: return TexelType::Byte;
    case PixelType::Half: return TexelType::Half;
    case PixelType::Float: return TexelType::Float;
    case PixelType::Fields: {
        const uint8_t* const bits = layout.fields.bits;
        return *std::max_element(bits, bits + layout.fields.count) > 8 ? TexelType::Short
                                                                       : TexelType::Byte;
    }
    default: return TexelType::Short;
    }
}

PixelLayout rgbaLayoutOf(TexelType type) {
    switch (type) {
    case TexelType::Byte: return {PixelOrder::Rgba, PixelType::UnsignedByte};
    case TexelType::Short: return {PixelOrder::Rgba, PixelType::UnsignedShort};
    case TexelType::Half: return {PixelOrder::Rgba, PixelType::Half};
    case TexelType::Float: break;
    }
    return {PixelOrder::Rgba, PixelType::Float};
}

} // namespace smart::compat
