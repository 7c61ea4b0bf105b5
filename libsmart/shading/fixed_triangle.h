// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>

#include "libsmart/scene/hit_chain.h"
#include "libsmart/shading/fixed_function.h"

namespace smart {

/// The vertex stage for a triangle that was hit, with the state block of its outermost instance,
/// which it must have. Each side is lit when first asked for.
class FixedTriangle {
public:
    FixedTriangle() = default;
    FixedTriangle(const HitChain& chain, const FixedViewer& viewer);

    const FixedState& state() const { return *state_; }
    const FixedViewer& viewer() const { return viewer_; }

    const glm::dvec3& position(int corner) const { return vertices_[corner].position; }
    /// The lit vertices.
    const LitVertex (&corners(bool back))[3];
    /// What a point with these weights has, as the state's shade model says. visibility: see
    /// litVertex.
    LitVertex at(const glm::dvec3& weights, bool back, const glm::vec3* visibility = nullptr);

private:
    static constexpr int kProvoking = 3; ///< number of that vertex, where it is no corner

    void light(bool back);
    FixedVertex vertexAt(const glm::dvec3& weights, FixedMaterials& memory) const;
    LitVertex lit(const FixedVertex& vertex, bool back, const glm::vec3* visibility) const;
    /// What the state makes use of; the rest is left as it is.
    LitVertex interpolated(const LitVertex (&corners)[3], const glm::dvec3& weights) const;

    const FixedState* state_ = nullptr;
    FixedViewer viewer_;
    FixedVertex vertices_[4];
    int provoking_ = 2;
    bool isLit_[2] = {};
    LitVertex lit_[2][3], flat_[2];
};

} // namespace smart
