// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/mat4x3.hpp>
#include <glm/vec3.hpp>

#include "libsmart/kernel/packet.h"
#include "libsmart/scene/scene.h"

namespace smart {

/// The way from the scene down to the triangle of a hit, resolved from HitPacket::path.
struct HitChain {
    const InstanceView* instances[kMaxLevels];
    uint32_t levels;
    const Model* model;     ///< innermost
    uint32_t triangle;      ///< number in it
    glm::dmat4x3 toWorld;   ///< product of the chain's matrices

    /// (v1-v0) x (v2-v0) of the triangle's world-space vertices, in double.
    glm::dvec3 worldNormal() const;
    glm::dvec3 worldVertex(int corner) const;
};

/// Precondition: hit.triangle != kNoHit, and the hit came from this scene.
HitChain resolve(const Scene& scene, const uint32_t* path, uint32_t levels, uint32_t triangle);

} // namespace smart
