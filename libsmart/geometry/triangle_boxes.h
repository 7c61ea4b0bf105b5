// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "libsmart/base/aabb.h"
#include "libsmart/kernel/view.h"

namespace smart {

/// Box of each triangle; empty for those that are in no tree: not finite, or degenerate.
struct TriangleBoxes {
    /// threads: how many may look at the triangles. Throws std::bad_alloc.
    TriangleBoxes(const std::vector<Triangle>& triangles, unsigned threads);

    std::vector<Aabb> boxes;
    Aabb bounds;
    std::size_t dropped = 0; ///< how many are left out
};

} // namespace smart
