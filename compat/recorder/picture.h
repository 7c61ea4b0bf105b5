// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/vec4.hpp>

#include "libsmart/render/framebuffer.h"

namespace smart::compat {

/// What was rendered, as memory of the application's or of the library's own.
struct Picture {
    PixelTarget target;
    const float* depth = nullptr; ///< window depth, packed; nullptr: not kept

    bool contains(int64_t x, int64_t y) const {
        return x >= 0 && y >= 0 && x < int64_t(target.width) && y < int64_t(target.height);
    }
    /// As stored. Alpha that the format lacks is 1.
    glm::vec4 colorAt(uint32_t x, uint32_t y) const;
    float depthAt(uint32_t x, uint32_t y) const {
        return depth[std::size_t(y) * target.width + x];
    }
};

} // namespace smart::compat
