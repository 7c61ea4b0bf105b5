// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec4.hpp>
#include <vector>

namespace smart {

/// Texture units of fixed function; OpenGL 1.5 wants two at least. What the first one has stands
/// by itself everywhere, for few programs use another; the others count from 0 again there.
inline constexpr std::size_t kTextureUnits = 4, kMoreUnits = kTextureUnits - 1;

/// A vertex's texture coordinates for the units after the first.
struct MoreTexCoords : std::array<glm::vec4, kMoreUnits> {
    MoreTexCoords() { fill({0.0f, 0.0f, 0.0f, 1.0f}); }
};

/// The texture coordinates of one unit, of vertices first..
struct UnitTexCoords {
    uint32_t first = 0xFFFFFFFFu;
    std::vector<glm::vec4> values;
    bool operator==(const UnitTexCoords&) const = default;
};

} // namespace smart
