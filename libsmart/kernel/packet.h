// SPDX-License-Identifier: MIT
// Rays and hits as plain memory: the same bytes whatever instruction set the reader was built for.
#pragma once

#include <cstdint>

namespace smart {

inline constexpr int kPacketSize = 16;  ///< 4x4 pixels; a multiple of every SIMD width
inline constexpr int kMaxLevels = 8;    ///< nesting of instances, the scene's own included
inline constexpr uint32_t kNoHit = 0xFFFFFFFFu;

/// Directions need not be normalised: t is in their units. A lane misses when its origin or
/// direction is not finite, its direction is zero, or its limits are NaN or out of order;
/// tNear below 0 counts as 0. [tNear, tFar] is closed and may be infinite.
struct alignas(64) RayPacket {
    float org[3][kPacketSize];
    float dir[3][kPacketSize];
    float tNear[kPacketSize], tFar[kPacketSize];
    uint32_t active; ///< bit i: lane i carries a ray
};

/// Nearest hit of each active lane; `triangle` is kNoHit, and the rest undefined, where there is
/// none. u, v are the weights of the second and third vertex.
/// path[0] numbers the instance in the scene, path[l] the child instance in the model reached
/// by path[0..l-1]; levels says how many entries hold.
struct alignas(64) HitPacket {
    float t[kPacketSize], u[kPacketSize], v[kPacketSize];
    uint32_t triangle[kPacketSize];
    uint32_t levels[kPacketSize];
    uint32_t path[kMaxLevels][kPacketSize];
};

struct Ray {
    float org[3];
    float dir[3];
    float tNear, tFar;
};

struct Hit {
    float t, u, v;
    uint32_t triangle;
    uint32_t levels;
    uint32_t path[kMaxLevels];
};

/// Memory of the caller for what the rays of a packet meet. `count` tells how much there was to be
/// stored: where it exceeds the capacity the rest is missing.
struct HitList {
    Hit* hits;
    uint32_t* lanes; ///< of each hit, the ray's
    uint32_t capacity, count;
};

/// What a traversal did; filled by the counting kernels only.
struct TraversalCounts {
    uint64_t nodes = 0;      ///< inner nodes visited, a packet counting as one visitor
    uint64_t leaves = 0;
    uint64_t triangles = 0;  ///< triangle tests, a packet counting as one
    uint64_t instances = 0;  ///< instances entered
    uint64_t doubles = 0;    ///< precise mode: tests of single rays that double had to repeat
    uint64_t exacts = 0;     ///< ... and exact arithmetic after it
};

} // namespace smart
