// SPDX-License-Identifier: MIT
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "libsmart/scene/hit_chain.h"
#include "libsmart/shading/fixed_function.h"

namespace smart {

/// One way from the scene down to a model, whatever the triangle there. The outermost instance has
/// to have a state block.
struct FixedWay {
    explicit FixedWay(const HitChain& way);

    HitChain chain;
    glm::dmat3 normals; ///< takes normals to eye space
    double normalScale; ///< rescaleFactor()
};

/// What arrives of each of the kFixedLights.
struct FixedArrival {
    uint32_t hidden = 0;               ///< bit i: nothing of light i
    const glm::vec3* shares = nullptr; ///< of all, where one's is neither nothing nor all

    /// Takes light i's share; those of all are in `memory` in the end.
    void add(int i, const glm::vec3* memory) {
        if (memory[i] == glm::vec3(0.0f))
            hidden |= 1u << i;
        else if (memory[i] != glm::vec3(1.0f))
            shares = memory;
    }
};

/// The vertex stage for a triangle that was hit, with the state block of its outermost instance,
/// which it must have. Each side is lit when first asked for.
class FixedTriangle {
public:
    FixedTriangle() = default;
    FixedTriangle(const HitChain& chain, const FixedViewer& viewer) {
        set(FixedWay(chain), chain.triangle, viewer);
    }
    void set(const FixedWay& way, uint32_t triangle, const FixedViewer& viewer);

    const FixedState& state() const { return *state_; }
    const FixedViewer& viewer() const { return viewer_; }

    const glm::dvec3& position(int corner) const { return vertices_[corner].position; }
    /// The lit vertices.
    const LitVertex (&corners(bool back))[3];
    /// LitVertex::lightsIn of a point.
    uint32_t lightsAt(const glm::dvec3& weights, bool back);
    /// Whether these are the same in all points.
    bool litAtVertices() const { return state_->lighting.shadeModel != ShadeModel::Phong; }

    /// Whether the primary colour, found at the vertices, is all that the state makes use of.
    bool onlyPrimary() const {
        return litAtVertices() && !state_->isTextured() && !state_->fog.enabled &&
               !state_->lighting.hasSecondary();
    }
    glm::vec4 primaryAt(const glm::dvec3& weights, bool back, uint32_t hidden);
    /// What a point with these weights has, as the state's shade model says.
    LitVertex at(const glm::dvec3& weights, bool back, const FixedArrival& arrival = {});

private:
    static constexpr int kProvoking = 3; ///< number of that vertex, where it is no corner
    /// The lit vertices, where all lights that are not hidden are seen.
    struct Lit {
        bool known = false;
        uint32_t hidden = 0;
        LitVertex corners[3], flat;
    };

    const Lit& lit(bool back, uint32_t hidden);
    void light(Lit& to, bool back, const glm::vec3* visibility) const;
    FixedVertex vertexAt(const glm::dvec3& weights, FixedMaterials& memory) const;
    LitVertex lit(const FixedVertex& vertex, bool back, const glm::vec3* visibility) const;
    /// What the state makes use of; the rest is left as it is.
    LitVertex interpolated(const LitVertex (&corners)[3], const glm::dvec3& weights) const;

    const FixedState* state_ = nullptr;
    FixedViewer viewer_;
    FixedVertex vertices_[4];
    int provoking_ = 2;
    Lit seen_[2]; ///< by side, with nothing hidden
    Lit shadowed_; ///< neighbouring points mostly see the same lights
    bool shadowedBack_ = false;
};

} // namespace smart
