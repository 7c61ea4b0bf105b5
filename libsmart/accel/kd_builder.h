// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "libsmart/accel/kd_tree.h"

namespace smart {

/// What the builder needs to know of its primitives, and no more. Called from several threads.
class KdPrimitives {
public:
    virtual uint32_t count() const = 0;
    /// Box of a primitive; an empty box leaves the primitive out of the tree.
    virtual Aabb bounds(uint32_t prim) const = 0;
    /// Box of the part of the primitive inside `cell`, rounded outward; empty if they are disjoint.
    virtual Aabb clipped(uint32_t prim, const Aabb& cell) const {
        return intersection(bounds(prim), cell);
    }

protected:
    ~KdPrimitives() = default;
};

/// Costs are relative to each other: the expected cost of a leaf is
/// intersectionCost * count, of a split traversalCost + the children's by surface area.
struct KdBuildOptions {
    float traversalCost = 1.0f;
    float intersectionCost = 0.5f;
    float emptyFactor = 0.9f; ///< cost multiplier of a split that cuts off empty space, (0, 1]
    unsigned threads = 1;     ///< how many threads may build, the caller's included
};

struct KdBuildStats {
    uint64_t events = 0; ///< candidate events swept, all nodes together
    uint32_t depth = 0;  ///< of the deepest leaf, root = 0
};

/// Builds the tree that minimises the surface area heuristic greedily, in O(N log N):
/// Wald, Havran, "On building fast kd-trees for ray tracing, and on doing that in O(N log N)",
/// IEEE Symposium on Interactive Ray Tracing 2006, section 4.3 (sorted events are kept sorted
/// through every split) with perfect splits by clipping (section 5.1) and planar events.
/// The tree does not depend on the number of threads. A primitive is found in every leaf whose
/// cell's inside it meets; one that only touches a split plane may be on one side alone, where
/// traversal finds it because it pads split distances. No more than 8 references a primitive,
/// about 4 where geometry that no plane separates would make more. Rethrows what the primitives
/// throw on any thread; throws Error for more than 2^30 primitives, nodes or references.
KdTree buildKdTree(const KdPrimitives& primitives, const KdBuildOptions& options = {},
                   KdBuildStats* stats = nullptr);

} // namespace smart
