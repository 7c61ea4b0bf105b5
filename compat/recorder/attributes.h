// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>

#include "libsmart/geometry/texture_units.h"
#include "libsmart/shading/fixed_state.h"

namespace smart::compat {

/// OpenGL's current values, which vertices latch.
struct Attributes {
    glm::vec4 color{1.0f};
    glm::vec3 normal{0.0f, 0.0f, 1.0f};
    glm::vec4 texCoord{0.0f, 0.0f, 0.0f, 1.0f};
    std::shared_ptr<const FixedMaterials> materials; ///< nullptr: OpenGL's initial ones
    glm::vec4 secondaryColor{0.0f, 0.0f, 0.0f, 1.0f};
    float fogCoordinate = 0.0f;
    MoreTexCoords moreTexCoords;
    bool moreTexCoordsGiven = false; ///< no: they are OpenGL's initial ones
    bool edgeFlag = true;

    const glm::vec4& texCoordOf(std::size_t unit) const {
        return unit == 0 ? texCoord : moreTexCoords[unit - 1];
    }
};

/// Which of them geometry sets on its own; the others come from its instance.
struct AttributesGiven {
    bool color = false, normal = false, texCoord = false, materials = false;
    bool secondaryColor = false, fogCoordinate = false;
    uint8_t moreTexCoords = 0; ///< a bit for each texture unit after the first
};

} // namespace smart::compat
