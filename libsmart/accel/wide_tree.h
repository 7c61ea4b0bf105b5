// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "libsmart/accel/wide_node.h"
#include "libsmart/base/aabb.h"

namespace smart {

/// A bounding volume hierarchy of wide nodes over numbered primitives. Root = nodes[0]; nodes is
/// empty when there is no primitive. Each primitive is in one leaf, in several where it was cut.
/// Nodes stand before those below them, and those below one are neighbours.
struct WideTree {
    Aabb bounds;
    uint32_t primitives = 0; ///< different ones
    float cost = 0;          ///< expected cost of a ray that meets `bounds`, in the unit of WideCosts
    std::vector<WideNode> nodes;
    std::vector<uint32_t> prims; ///< primitive numbers, leaf by leaf

    std::size_t bytes() const {
        return nodes.capacity() * sizeof(WideNode) + prims.capacity() * sizeof(uint32_t);
    }
};

/// Which of the builders below makes a tree, in the order of their build times.
enum class WideQuality { Fast, Binned, Spatial };

/// What rays spend, in clock cycles, once they meet a box.
struct WideCosts {
    float child = 30.0f; ///< the box against the rays one by one
    float node = 70.0f;  ///< sixteen boxes against a tile or a ray
    float leaf = 170.0f; ///< sixteen triangles against them
    float primitive = 12.0f;
};
inline constexpr WideCosts kTriangleCosts{};
/// Entering an instance is expensive: leaves hold one.
inline constexpr WideCosts kInstanceCosts{30.0f, 70.0f, 0.0f, 600.0f};

/// Builds a binary tree by the surface area heuristic over 32 bins an axis (Wald, "On fast
/// construction of SAH-based bounding volume hierarchies", 2007). Which of its subtrees become wide
/// nodes, and which leaves, is found by dynamic programming over the slots of wide nodes, so that
/// the expected cost is least (as Ylitie, Karras, Laine, "Efficient incoherent ray traversal on
/// GPUs through compressed wide BVHs", 2017). An empty box leaves a primitive out. The tree does not
/// depend on `threads`, the number of threads that may build, the caller's included. Throws
/// std::bad_alloc, and Error for more than 2^27 primitives.
WideTree buildWideTree(std::span<const Aabb> boxes, unsigned threads = 1,
                       const WideCosts& costs = kTriangleCosts);

/// The same with spatial splits: triangles are cut in two where that is cheaper (Stich, Friedrich,
/// Dietrich, "Spatial splits in bounding volume hierarchies", 2009), by which no more than a
/// quarter of the references are added. A box in the tree encloses the part of each triangle that
/// it is there for; that of the whole triangle may be larger. vertices: nine floats a box.
WideTree buildWideTreeSpatial(std::span<const Aabb> boxes, const float* vertices,
                              unsigned threads = 1, const WideCosts& costs = kTriangleCosts);

/// The same kind of tree in a time that grows linearly with the number of boxes, for geometry that
/// is made anew for every frame.
WideTree buildWideTreeFast(std::span<const Aabb> boxes, unsigned threads = 1,
                           const WideCosts& costs = kTriangleCosts);

} // namespace smart
