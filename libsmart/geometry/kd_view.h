// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include "libsmart/accel/kd_tree.h"
#include "libsmart/kernel/view.h"

namespace smart {

/// The tree as kernels see it, over what lies in `bounds`; valid as long as the tree's vectors.
inline KdView makeKdView(const KdTree& tree, const Aabb& bounds) {
    KdView view{};
    view.nodes = tree.nodes.empty() ? nullptr : tree.nodes.data();
    view.prims = tree.prims.empty() ? nullptr : tree.prims.data();
    for (int k = 0; k < 3; ++k) {
        view.lo[k] = bounds.lo[k];
        view.hi[k] = bounds.hi[k];
        if (bounds.empty()) continue;
        view.maxAbs = std::max({view.maxAbs, std::fabs(bounds.lo[k]), std::fabs(bounds.hi[k])});
    }
    return view;
}

} // namespace smart
