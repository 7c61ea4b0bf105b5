// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>

#include "compat/recorder/geometry_recording.h"
#include "libsmart/base/memory_counter.h"
#include "libsmart/scene/scene.h"

namespace smart::compat {

/// Builds the models and scenes of one context, and counts what they take.
class ModelCompiler {
public:
    ModelPtr compile(GeometryRecording& recording, BuildQuality quality, bool lazy);
    /// As updateModel().
    ModelPtr update(const Model& old, uint32_t first, uint32_t count, const float* positions,
                    BuildQuality quality, bool lazy);
    /// lastOfEqual: as Scene has it.
    ScenePtr makeScene(InstanceList instances, Precision precision,
                       bool lastOfEqual = false);

    void setThreads(unsigned threads) { threads_ = threads; }
    uint64_t modelsBuilt() const { return modelsBuilt_; }
    double buildSeconds() const { return buildSeconds_; } ///< models and top levels
    const MemoryCounter& memory() const { return *memory_; }

private:
    template <class Build>
    ModelPtr counted(Build&& build, BuildQuality quality, bool lazy);

    std::shared_ptr<MemoryCounter> memory_ = std::make_shared<MemoryCounter>();
    unsigned threads_ = 1;
    uint64_t modelsBuilt_ = 0;
    double buildSeconds_ = 0;
};

} // namespace smart::compat
