// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "libsmart/kernel/packet.h"
#include "libsmart/scene/hit_chain.h"
#include "libsmart/shading/shader_object.h"

namespace smart {

/// Index of the shader that a hit's triangle has: its own, as the instances of the chain replace
/// it, from the innermost outward.
uint32_t effectiveShader(const HitChain& chain);

/// Weights of the corners at a hit. u and v were rounded each by itself: together they may exceed 1
/// by a little, and name a point beside the triangle, which need not be inside a closed body any
/// more.
inline glm::dvec3 cornerWeights(float u, float v) {
    const double sum = double(u) + double(v);
    if (sum > 1.0) return {0.0, u / sum, v / sum};
    return {1.0 - sum, u, v};
}

/// What the hits of one triangle, met in one way, have in common. Made for the first of them, whose
/// chain has to live as long.
class SurfaceTriangle {
public:
    explicit SurfaceTriangle(const HitChain& chain);

    const HitChain& chain() const { return *chain_; }
    /// Corner in the world.
    const glm::dvec3& corner(int i) const { return corners_[i]; }
    /// As long as twice the triangle's area.
    const glm::dvec3& areaNormal() const { return areaNormal_; }
    /// Length 1; nullptr: underflow took it.
    const glm::dvec3* normal() const { return hasNormal_ ? &normal_ : nullptr; }
    /// A normal of the model's in its own space to the world: times the inverse transpose.
    glm::dvec3 toWorld(const glm::dvec3& normal);

private:
    const HitChain* chain_;
    glm::dvec3 corners_[3], areaNormal_, normal_;
    glm::dmat3 cofactors_;
    double shrink_ = 0; ///< 1 / determinant
    bool hasNormal_, hasCofactors_ = false;
};

/// Fills what a state says of the ray and of the point it met: position, normals, weights,
/// texture coordinate, colour, side and ids. In double, rounded to float once, with no function
/// whose bits depend on the machine. `instance`: number in the scene. t, u, v: the hit's.
/// Attributes that the model does not have come from the innermost instance that does have them;
/// normals that it does not have are the geometric one.
void fillSurfacePoint(SurfaceTriangle& triangle, uint32_t instance, const Ray& ray, float t,
                      float u, float v, RTSstate& state);
inline void fillSurfacePoint(const HitChain& chain, uint32_t instance, const Ray& ray, float t,
                             float u, float v, RTSstate& state) {
    SurfaceTriangle triangle(chain);
    fillSurfacePoint(triangle, instance, ray, t, u, v, state);
}

/// Memory for an interpolated per-vertex block.
struct VertexScratch {
    alignas(kBlockAlignment) std::byte bytes[kMaxVertexBlock];
};

/// Points the state to the parameter blocks that `shader` sees at the hit; state.barycentric is
/// set already. Where the triangle was given parameters of another class, or none, the class's
/// defaults serve. `scratch` lives as long as the state is used.
void fillParameterBlocks(const HitChain& chain, const ShaderTable& table,
                         const ShaderObject& shader, VertexScratch& scratch, RTSstate& state);

} // namespace smart
