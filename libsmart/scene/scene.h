// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "libsmart/geometry/instance_group.h"
#include "libsmart/geometry/model.h"
#include "libsmart/kernel/kernels.h"

namespace smart {

/// Everything that rays can meet in one frame: immutable, shared without locks.
class Scene {
public:
    /// Builds the top-level tree; for Precision::Fast also the records of every model reached.
    /// lastOfEqual: of hits at equal distance the last in order of submission counts.
    Scene(InstanceList instances, Precision precision, unsigned threads, bool lastOfEqual = false);
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;

    const InstanceGroup& group() const { return group_; }
    const ModelView& view() const { return view_; }
    Precision precision() const { return precision_; }
    double buildSeconds() const { return buildSeconds_; } ///< of the top level

private:
    InstanceGroup group_;
    ModelView view_{};
    Precision precision_;
    double buildSeconds_ = 0;
};

using ScenePtr = std::shared_ptr<const Scene>;

/// Sizes of all that a scene holds, each model counted once.
struct SceneStatistics {
    uint64_t triangles = 0;       ///< stored once each, whatever the number of instances
    uint64_t instances = 0;       ///< of the scene itself
    uint64_t nodes = 0, leaves = 0, references = 0; ///< of all trees, top level included
    uint64_t bytes = 0;
    uint64_t droppedTriangles = 0, droppedInstances = 0;
};
SceneStatistics statistics(const Scene&);

} // namespace smart
