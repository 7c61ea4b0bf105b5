// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec4.hpp>

namespace smart::compat {

/// What happens to colours between the application's memory and the library's (OpenGL's pixel
/// transfer): each is multiplied by the scale, and the bias is added.
struct PixelTransfer {
    glm::vec4 scale{1.0f}, bias{0.0f}; ///< red, green, blue, alpha

    bool operator==(const PixelTransfer&) const = default;
    glm::vec4 operator()(const glm::vec4& color) const { return color * scale + bias; }
};

} // namespace smart::compat
