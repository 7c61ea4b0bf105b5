// SPDX-License-Identifier: MIT
// Which triangles meet at an edge or a vertex, and what that means for a ray that passes there.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "libsmart/kernel/view.h"

namespace smart::test {

/// A place where a ray's line meets a closed triangle.
struct Touch {
    uint32_t triangle = 0;
    int facing = 0;     ///< sign of direction . normal, never 0
    uint32_t zeros = 0; ///< bit k: the weight of vertex k is 0; 0 = interior
};

class MeshTopology {
public:
    /// Corners of the triangles added from here on are shared among themselves only.
    void startMesh() { numbers_.clear(); }
    /// Numbers count from 0. Triangles that nothing can hit are neighbours of none.
    void add(const Triangle& triangle, bool canBeHit);

    /// Triangles that share a corner with this one, itself included.
    std::vector<uint32_t> neighbours(uint32_t triangle) const;

    /// Whether one of the touches, all at the same distance along one ray, is a hit that no
    /// rounding excuses: in the interior of a triangle, or at an edge (vertex) whose two (all)
    /// triangles are touched and face the same way.
    bool isMust(std::span<const Touch> layer) const;

private:
    bool surrounds(const Touch& touch, std::span<const Touch> layer) const;

    std::map<std::array<float, 3>, uint32_t> numbers_; ///< of the corners of the mesh at hand
    std::vector<std::array<uint32_t, 3>> vertices_;    ///< numbers of equal corners are equal
    std::vector<std::vector<uint32_t>> around_;        ///< triangles at each vertex
};

} // namespace smart::test
