// SPDX-License-Identifier: MIT
#include "compat/recorder/picture.h"

#include <cstring>

namespace smart::compat {

glm::vec4 Picture::colorAt(uint32_t x, uint32_t y) const {
    const std::size_t size = bytesPerPixel(target.format);
    const std::size_t stride = target.stride != 0 ? target.stride : target.width * size;
    const auto* at = static_cast<const unsigned char*>(target.memory) + y * stride + x * size;
    const auto bytes = [&](int r, int g, int b, int a) {
        return glm::vec4(at[r], at[g], at[b], a < 0 ? 255.0f : float(at[a])) / 255.0f;
    };
    const auto floats = [&](int r, int g, int b, int a) {
        float values[4] = {0.0f, 0.0f, 0.0f, 1.0f};
        std::memcpy(values, at, size);
        return glm::vec4(values[r], values[g], values[b], a < 0 ? 1.0f : values[a]);
    };
    switch (target.format) {
    case PixelFormat::Bgr32f: return floats(2, 1, 0, -1);
    case PixelFormat::Rgb32f: return floats(0, 1, 2, -1);
    case PixelFormat::Rgba32f: return floats(0, 1, 2, 3);
    case PixelFormat::Rgb8: return bytes(0, 1, 2, -1);
    case PixelFormat::Rgba8: return bytes(0, 1, 2, 3);
    case PixelFormat::Bgra8: return bytes(2, 1, 0, 3);
    }
    return glm::vec4(0.0f);
}

} // namespace smart::compat
