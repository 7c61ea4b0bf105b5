// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "libsmart/accel/wide_tree.h"
#include "libsmart/kernel/view.h"

namespace smart {

class BuildCrew;

/// A box tree of wide nodes over triangles, and the triangles once more in the order of its leaves:
/// what rays walk in a model, unless it has a kd-tree.
class TriangleTree {
public:
    TriangleTree() = default;
    /// Triangles whose box is empty are left out. Throws std::bad_alloc, and Error for more than
    /// 2^27 of them. The tree does not depend on the number of threads.
    TriangleTree(std::span<const Triangle> triangles, std::span<const Aabb> boxes,
                 WideQuality quality, unsigned threads);

    /// The same tree over triangles that have moved, each within the boxes anew, for a fraction of
    /// what a new one costs. Nothing where other boxes are empty than were at the build: that needs
    /// a new tree. This one stays as it is. Throws std::bad_alloc.
    std::optional<TriangleTree> refitted(std::span<const Triangle> moved,
                                         std::span<const Aabb> boxes, unsigned threads) const;
    /// How much more a ray is expected to cost than it did when the tree was built, after which its
    /// triangles moved: Lauterbach and others, "RT-DEFORM", 2006. Rays that meet the bounds count.
    float decay() const { return builtCost_ > 0 ? cost_ / builtCost_ : 1.0f; }
    /// From here on a new tree pays: rays take noticeably longer, while a build costs what two or
    /// three refits do.
    static constexpr float kDecayed = 1.5f;

    bool empty() const { return nodes_.empty(); }
    const Aabb& bounds() const { return bounds_; }
    float cost() const { return cost_; } ///< expected, of a ray that meets the bounds: see WideCosts
    std::span<const WideNode> nodes() const { return nodes_; }
    const float* blocks() const { return blocks_.get(); } ///< see WideView
    std::size_t entries() const { return entries_; } ///< triangles in leaves, cut ones repeatedly
    std::size_t bytes() const;

private:
    std::vector<WideNode> nodes_;
    std::unique_ptr<float[]> blocks_;
    std::size_t entries_ = 0;
    uint32_t primitives_ = 0; ///< different triangles
    Aabb bounds_;
    float cost_ = 0, builtCost_ = 0;
};

} // namespace smart
