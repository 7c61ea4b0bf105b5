// SPDX-License-Identifier: MIT
#include "libsmart/render/image_raster.h"

#include <cstring>

#include "libsmart/base/half.h"

namespace smart {
namespace {

template <class T>
T componentAt(const std::vector<std::byte>& data, std::size_t number) {
    T value;
    std::memcpy(&value, data.data() + number * sizeof(T), sizeof(T));
    return value;
}

} // namespace

glm::vec4 ImagePixels::color(uint32_t x, uint32_t y) const {
    const std::size_t first = (std::size_t(y) * width + x) * 4;
    glm::vec4 result;
    for (int k = 0; k < 4; ++k) {
        const std::size_t number = first + std::size_t(k);
        switch (type) {
        case TexelType::Byte: result[k] = float(componentAt<uint8_t>(data, number)) / 255.0f; break;
        case TexelType::Short:
            result[k] = float(componentAt<uint16_t>(data, number)) / 65535.0f;
            break;
        case TexelType::Half: result[k] = halfToFloat(componentAt<uint16_t>(data, number)); break;
        case TexelType::Float: result[k] = componentAt<float>(data, number); break;
        }
    }
    return result;
}

} // namespace smart
