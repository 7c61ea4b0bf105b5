// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "compat/recorder/geometry_recording.h"
#include "compat/recorder/layers.h"
#include "libsmart/scene/scene.h"
#include "libsmart/shading/fixed_state.h"

namespace smart::compat {

/// A run of loose primitives as it was compiled last, for the case that it stays the same.
struct LooseRun {
    ModelPtr model;
    BuildQuality quality = BuildQuality::Fastest;
    uint64_t raysThen = 0; ///< Recorder::rays() when it was built
};

/// What the next frame of a scene consists of so far.
struct SceneRecording {
    std::vector<FinishedLayer> below; ///< bottom first
    // Of the layer under way:
    std::optional<LayerView> view;   ///< since its first primitive
    std::vector<BufferClear> clears; ///< before that
    InstanceList instances;
    /// Loose primitives since the last instance; their inherited attributes are those current at
    /// the first vertex.
    GeometryRecording loose;
    InheritedAttributes looseInherited;
    FixedStatePtr looseState; ///< of all of the run
    /// Runs by their order in the frame: those of this one, then those of the one before.
    std::vector<LooseRun> looseRuns;
    std::size_t looseCount = 0; ///< runs of this frame that are instances

    std::vector<std::shared_ptr<Shader>> lights;
    std::shared_ptr<Shader> camera, environment, renderingObject;

    uint64_t additions = 0;         ///< calls that added something
    uint64_t finishedAdditions = 0; ///< those that are in the last picture that left it open
};

} // namespace smart::compat
