// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "libsmart/accel/wide_tree.h"
#include "libsmart/kernel/view.h"

namespace smart {

/// What tiles of rays walk in a model: a box tree of wide nodes over its triangles, and the
/// triangles once more in the order of the leaves.
class TileTrees {
public:
    TileTrees() = default;
    /// Triangles whose box is empty are left out. Throws std::bad_alloc.
    TileTrees(const std::vector<Triangle>& triangles, const std::vector<Aabb>& boxes);
    TileTrees(TileTrees&&) = default;
    TileTrees& operator=(TileTrees&&) = default;

    std::size_t bytes() const;
    /// Points `view` at them; valid as long as they live and stay put.
    void show(ModelView& view) const;

private:
    WideTree triangles_;
    std::vector<float> blocks_; ///< see WideView
};

} // namespace smart
