// SPDX-License-Identifier: MIT
// Rays from the application. Runs on the calling thread alone and leaves its floating-point
// environment as found.
#pragma once

#include <cstddef>
#include <cstdint>

#include "libsmart/scene/scene.h"

namespace smart {

inline constexpr uint32_t kNoId = 0xFFFFFFFFu;

/// Input rays, structure of arrays. tNear and tFar may be nullptr: 0 and infinity.
/// commonOrigin: org[k] points to one value for all rays.
struct RayStream {
    const float* org[3];
    const float* dir[3];
    const float* tNear;
    const float* tFar;
    bool commonOrigin;
    std::ptrdiff_t stride = 1; ///< in floats, between one ray's value and the next's
};

/// Outputs; nullptr = not wanted. A miss: t = tFar, ids kNoId, the rest 0.
struct HitStream {
    float *t, *u, *v;
    uint32_t *primitive, *object, *instance;
    float* normal[3]; ///< (v1-v0) x (v2-v0) of the world-space vertices
    uint32_t* flags;  ///< 1 where dot(direction, normal) > 0
    std::ptrdiff_t stride = 1; ///< in 4-byte words
};

enum class Coherence { Coherent, Incoherent };

/// Rays that reach a lazy model build its tree. What keeps them from that, such as a lack of
/// memory, is thrown at the end; rays went through the model then.
void intersect(const Scene&, const RayStream&, const HitStream&, std::size_t count, Coherence);
/// blocked[i] = 1 or 0
void occluded(const Scene&, const RayStream&, uint8_t* blocked, std::size_t count, Coherence);

} // namespace smart
