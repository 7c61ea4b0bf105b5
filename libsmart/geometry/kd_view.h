// SPDX-License-Identifier: MIT
#pragma once

#include "libsmart/accel/kd_tree.h"
#include "libsmart/geometry/box_view.h"

namespace smart {

/// The tree as kernels see it, over what lies in `bounds`; valid as long as the tree's vectors.
inline KdView makeKdView(const KdTree& tree, const Aabb& bounds) {
    KdView view{};
    static_cast<BoxView&>(view) = makeBoxView(bounds);
    view.nodes = tree.nodes.empty() ? nullptr : tree.nodes.data();
    view.prims = tree.prims.empty() ? nullptr : tree.prims.data();
    return view;
}

} // namespace smart
