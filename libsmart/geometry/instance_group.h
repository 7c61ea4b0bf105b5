// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "libsmart/accel/wide_tree.h"
#include "libsmart/geometry/instance_list.h"
#include "libsmart/kernel/view.h"

namespace smart {

/// How long a group is expected to last: which builder makes its tree.
enum class GroupLife { Lasting, OneFrame };

/// Instances with the tree over them; what a scene is, and what an object that nests others adds
/// to its triangles. An instance whose matrix is singular or not finite, or whose model is empty,
/// keeps its number but is never hit.
class InstanceGroup {
public:
    InstanceGroup() = default;
    /// Throws std::bad_alloc. threads: how many may build the tree.
    InstanceGroup(InstanceList instances, unsigned threads, GroupLife life = GroupLife::Lasting);

    std::span<const InstanceView> instances() const { return list_.views(); }
    /// What instances have in common, each once.
    std::span<const InstanceList::Traits> traits() const { return list_.traits(); }
    const WideTree& tree() const { return tree_; }
    uint32_t dropped() const { return dropped_; } ///< singular or not finite
    Aabb bounds() const { return bounds_; }
    std::size_t bytes() const { return list_.bytes() + tree_.bytes(); }
    /// Points `view`'s children at this group; valid as long as the group lives, also once it has
    /// been moved.
    void show(ModelView& view) const;

private:
    InstanceList list_;
    WideTree tree_; ///< empty for fewer than two instances
    Aabb bounds_;
    uint32_t dropped_ = 0;
};

} // namespace smart
