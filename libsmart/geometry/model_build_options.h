// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>

#include "libsmart/base/memory_counter.h"

namespace smart {

/// Which tree a model gets over its triangles.
enum class BuildQuality : uint8_t {
    Nicest,   ///< a tree of wide nodes by the surface area heuristic, with spatial splits
    DontCare, ///< a tree of wide nodes by the surface area heuristic
    Fastest,  ///< a tree of wide nodes, in the least time
    KdTree    ///< the exact kd-tree by the surface area heuristic
};

struct ModelBuildOptions {
    BuildQuality quality = BuildQuality::Nicest;
    bool lazy = false;    ///< the tree is built when the first ray reaches the model
    unsigned threads = 1; ///< how many may build, the caller's included
    std::shared_ptr<MemoryCounter> memory{}; ///< of all that the model holds
};

} // namespace smart
