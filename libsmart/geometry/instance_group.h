// SPDX-License-Identifier: MIT
#pragma once

#include <glm/mat4x3.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "libsmart/accel/wide_tree.h"
#include "libsmart/kernel/view.h"

namespace smart {

struct Model;
struct FixedMaterials;
struct FixedState;

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
    bool ownColor = true, ownNormal = true, ownTexCoord = true, ownMaterials = true;
    bool ownSecondaryColor = true, ownFogCoordinate = true;
};

/// A model placed in its parent's space (another model's, or the scene's).
struct Instance {
    std::shared_ptr<const Model> model;
    glm::dmat4x3 toParent{1.0}; ///< column-major; last column the translation
    uint32_t objectId = 0;
    InheritedAttributes inherited;
    std::shared_ptr<const ShaderReplacement> replacement; ///< nullptr: none
    /// What fixed function makes of it, in the scene's instances; nullptr: the vertices' colour,
    /// the nearest hit.
    std::shared_ptr<const FixedState> state;
};

/// Instances with the tree over them; what a scene is, and what an object that nests others adds
/// to its triangles. An instance whose matrix is singular or not finite, or whose model is empty,
/// keeps its number but is never hit.
class InstanceGroup {
public:
    InstanceGroup() = default;
    /// Throws std::bad_alloc. threads: how many may build the tree.
    InstanceGroup(std::vector<Instance> instances, unsigned threads);
    InstanceGroup(InstanceGroup&&) = default; ///< views refer to matrices, which move along
    InstanceGroup& operator=(InstanceGroup&&) = default;

    const std::vector<Instance>& instances() const { return instances_; }
    const std::vector<InstanceView>& views() const { return views_; }
    const WideTree& tree() const { return tree_; }
    uint32_t dropped() const { return dropped_; } ///< singular or not finite
    Aabb bounds() const { return bounds_; }
    std::size_t bytes() const;
    /// Points `view`'s children at this group; valid as long as the group lives and stays put.
    void show(ModelView& view) const;

private:
    std::vector<Instance> instances_;
    std::vector<InstanceView> views_;
    WideTree tree_; ///< empty for fewer than two instances
    Aabb bounds_;
    uint32_t dropped_ = 0;
};

/// Inverse of an affine matrix in double; false where it is singular or not finite.
bool invertAffine(const glm::dmat4x3& matrix, glm::dmat4x3& inverse);

} // namespace smart
