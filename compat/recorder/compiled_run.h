// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "compat/recorder/shader_catalog.h"
#include "libsmart/geometry/model.h"

namespace smart::compat {

/// Primitives of a display list as an object, with the shader that they were compiled for.
struct CompiledRun {
    ModelPtr model;
    uint32_t shader = 0; ///< Shader::index()
    /// Of the parameters that triangles and vertices latched; 0: the shader has none of the kind.
    uint64_t triangleStamp = 0, vertexStamp = 0;

    CompiledRun(ModelPtr compiled, const BoundShader& bound)
        : model(std::move(compiled)), shader(bound.shader->index()),
          triangleStamp(stampOf(bound.triangleBlock, bound.triangleStamp)),
          vertexStamp(stampOf(bound.vertexBlock, bound.vertexStamp)) {}

    /// Whether it may be placed while `bound` is bound: as it is, or, where neither shader has
    /// parameters that geometry latches, with `bound` in the other's place.
    bool fits(const BoundShader& bound) const {
        if (stampOf(bound.triangleBlock, bound.triangleStamp) != triangleStamp ||
            stampOf(bound.vertexBlock, bound.vertexStamp) != vertexStamp)
            return false;
        return shader == bound.shader->index() || (triangleStamp == 0 && vertexStamp == 0);
    }

private:
    static uint64_t stampOf(const std::vector<std::byte>& block, uint64_t stamp) {
        return block.empty() ? 0 : stamp;
    }
};

} // namespace smart::compat
