// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "libsmart/accel/kd_node.h"
#include "libsmart/base/aabb.h"

namespace smart {

/// A finished kd-tree over numbered primitives: triangles of a model or instances of a scene.
/// Root = nodes[0]; nodes is empty when there is no primitive.
struct KdTree {
    Aabb bounds;
    std::vector<KdNode> nodes;
    std::vector<uint32_t> prims; ///< primitive numbers, leaf by leaf

    std::size_t bytes() const {
        return nodes.capacity() * sizeof(KdNode) + prims.capacity() * sizeof(uint32_t);
    }
};

} // namespace smart
