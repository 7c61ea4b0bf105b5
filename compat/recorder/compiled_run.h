// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "compat/recorder/fixed_state_recorder.h"
#include "compat/recorder/shader_catalog.h"
#include "libsmart/geometry/model.h"

namespace smart::compat {

/// Primitives of a display list as an object, with the shader that they were compiled for and the
/// materials, of which they may set a part.
struct CompiledRun {
    ModelPtr model;
    uint32_t shader = 0; ///< Shader::index()
    /// Of the parameters that triangles and vertices latched; 0: the shader has none of the kind.
    uint64_t triangleStamp = 0, vertexStamp = 0;
    std::shared_ptr<const FixedMaterials> materials; ///< current before; nullptr: the initial ones

    CompiledRun(ModelPtr compiled, const BoundShader& bound,
                std::shared_ptr<const FixedMaterials> before)
        : model(std::move(compiled)), shader(bound.shader->index()),
          triangleStamp(stampOf(bound.triangleBlock, bound.triangleStamp)),
          vertexStamp(stampOf(bound.vertexBlock, bound.vertexStamp)),
          materials(std::move(before)) {}

    /// Whether it may be placed while `bound` is bound and `now` are the materials: as it is, or,
    /// where neither shader has parameters that geometry latches, with `bound` in the other's
    /// place.
    bool fits(const BoundShader& bound, const std::shared_ptr<const FixedMaterials>& now) const {
        if (!model->shading.materials.empty() && !same(materials, now)) return false;
        if (stampOf(bound.triangleBlock, bound.triangleStamp) != triangleStamp ||
            stampOf(bound.vertexBlock, bound.vertexStamp) != vertexStamp)
            return false;
        return shader == bound.shader->index() || (triangleStamp == 0 && vertexStamp == 0);
    }

private:
    static bool same(const std::shared_ptr<const FixedMaterials>& a,
                     const std::shared_ptr<const FixedMaterials>& b) {
        return a == b || *(a ? a : initialMaterials()) == *(b ? b : initialMaterials());
    }
    static uint64_t stampOf(const std::vector<std::byte>& block, uint64_t stamp) {
        return block.empty() ? 0 : stamp;
    }
};

} // namespace smart::compat
