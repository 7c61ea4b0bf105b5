// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "libsmart/kernel/packet.h"
#include "libsmart/scene/hit_chain.h"
#include "libsmart/shading/shader_object.h"

namespace smart {

/// Index of the shader that a hit's triangle has: its own, as the instances of the chain replace
/// it, from the innermost outward.
uint32_t effectiveShader(const HitChain& chain);

/// Fills what a state says of the ray and of the point it met: position, normals, weights,
/// texture coordinate, colour, side and ids. In double, rounded to float once, with no function
/// whose bits depend on the machine. `instance`: number in the scene. t, u, v: the hit's.
/// Attributes that the model does not have come from the innermost instance that does have them;
/// normals that it does not have are the geometric one.
void fillSurfacePoint(const HitChain& chain, uint32_t instance, const Ray& ray, float t, float u,
                      float v, RTSstate& state);

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
