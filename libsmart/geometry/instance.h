// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/mat4x3.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <utility>
#include <vector>

#include "libsmart/kernel/view.h"

namespace smart {

struct Model;
struct FixedMaterials;
struct FixedState;
struct MoreTexCoords;

/// Reshading: which shader stands in for which, by shader index. Immutable and shared.
struct ShaderReplacement {
    bool all = false;      ///< every shader is replaced by `allBy`
    uint32_t allBy = 0;
    std::vector<std::pair<uint32_t, uint32_t>> pairs; ///< (replaced, by), when not `all`
    std::vector<std::shared_ptr<const void>> keepAlive;

    uint32_t operator()(uint32_t shader) const {
        if (all) return allBy;
        for (const auto& [replaced, by] : pairs)
            if (replaced == shader) return by;
        return shader;
    }
    std::size_t bytes() const;
};

/// Attributes of vertices for which their object set none; fixed at instantiation. Inside an
/// object a part that the object had not set either comes from the instance above (`from...`
/// is false then).
struct InheritedAttributes {
    glm::vec4 color{1.0f};
    glm::vec3 normal{0.0f, 0.0f, 1.0f};
    glm::vec4 texCoord{0.0f, 0.0f, 0.0f, 1.0f};
    std::shared_ptr<const FixedMaterials> materials; ///< nullptr: OpenGL's initial ones
    glm::vec3 secondaryColor{0.0f};
    float fogCoordinate = 0.0f;
    std::shared_ptr<const MoreTexCoords> moreTexCoords; ///< nullptr: OpenGL's initial ones
    bool ownColor = true, ownNormal = true, ownTexCoord = true, ownMaterials = true;
    bool ownSecondaryColor = true, ownFogCoordinate = true;
    uint8_t ownMoreTexCoords = 0xFF; ///< a bit for each unit
};

/// What an instance has beside its matrix and its object's id. Instances with the same share it.
struct InstanceTraits {
    std::shared_ptr<const Model> model;
    InheritedAttributes inherited;
    std::shared_ptr<const ShaderReplacement> replacement; ///< nullptr: none
    /// What fixed function makes of it, in the scene's instances; nullptr: the vertices' colour,
    /// the nearest hit.
    std::shared_ptr<const FixedState> state;

    /// To the bit; of what is pointed to, whether it is the same.
    bool sameAs(const InstanceTraits& other) const;
    std::size_t hash() const;
};

/// A model placed in its parent's space (another model's, or the scene's).
struct Instance : InstanceTraits {
    glm::dmat4x3 toParent{1.0}; ///< column-major; last column the translation
    uint32_t objectId = 0;
};

/// The matrix of an instance as it was given.
inline glm::dmat4x3 toParent(const InstanceView& instance) {
    glm::dmat4x3 matrix;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row) matrix[column][row] = instance.toParent[column][row];
    return matrix;
}

/// All of an instance as it was given.
Instance asGiven(const InstanceView& instance);

} // namespace smart
