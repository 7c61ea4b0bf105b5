// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>

#include "libsmart/base/memory_counter.h"

namespace smart {

/// Which trees a model gets.
enum class BuildQuality : uint8_t {
    Nicest,   ///< the exact kd-tree; a tree of wide nodes as well, when tiles of rays come
    DontCare, ///< a tree of wide nodes by the surface area heuristic
    Fastest   ///< a tree of wide nodes, in the least time
};

struct ModelBuildOptions {
    BuildQuality quality = BuildQuality::Nicest;
    bool lazy = false;    ///< trees are built when the first ray reaches the model
    unsigned threads = 1; ///< how many may build, the caller's included
    std::shared_ptr<MemoryCounter> memory{}; ///< of all that the model holds
};

} // namespace smart
