// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
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

    /// Whether tiles of rays (KernelTable::intersectTile, occludedTile) may be traced; `rays` of
    /// them are about to be. What tiles walk is made when so many have come that it pays: one for
    /// four triangles. Until then, and always in precise mode, packets are traced. Thread-safe.
    bool readyForTiles(uint64_t rays) const;
    /// Makes it at once.
    void prepareTiles() const;

    const InstanceGroup& group() const { return group_; }
    /// Once tiles may be traced, rays of any kind walk what they walk: ModelView::wideReady.
    const ModelView& view() const {
        return tilesReady_.load(std::memory_order_acquire) ? preparedView_ : view_;
    }
    Precision precision() const { return precision_; }
    double buildSeconds() const { return buildSeconds_; } ///< of the top level

private:
    /// Whether prepareTiles() has nothing to make.
    bool modelsAreReady() const;

    InstanceGroup group_;
    ModelView view_{};
    mutable ModelView preparedView_{}; ///< once tilesReady_
    mutable std::once_flag tilesOnce_, tilesPayOnce_;
    mutable std::atomic<bool> tilesReady_{false};
    mutable std::atomic<uint64_t> tileRays_{0};
    mutable uint64_t tilesPay_ = 0; ///< from so many rays on
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
