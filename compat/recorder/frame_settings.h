// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/vec4.hpp>
#include <optional>

#include "libsmart/geometry/model_build_options.h"
#include "libsmart/render/frame.h"

namespace smart::compat {

/// What the application sets once and frames read when they are started.
struct FrameSettings {
    PixelTarget target; ///< memory nullptr: none set
    std::optional<Viewport> viewport;
    std::optional<Viewport> scissor; ///< empty: the frame buffer, until the first rtScissor
    bool scissorTest = false;
    double depthNear = 0.0, depthFar = 1.0;
    glm::vec4 clearColor{0.0f};
    double clearDepth = 1.0;
    bool drawsColor = true;     ///< false: the draw buffer is none
    uint32_t drawBuffer = 0, readBuffer = 0; ///< as the application named them; 0: the back buffer
    uint32_t samples = 1;
    bool multisample = false; ///< four samples instead of one
    uint32_t seed = 0;
    uint32_t recursionLimit = 8;
    float weightCutoff = 1.0f / 512.0f;
    Precision precision = Precision::Watertight;
};

/// Hints for the compilation of objects.
struct BuildHints {
    BuildQuality quality = BuildQuality::DontCare;
    bool lazy = false;
};

} // namespace smart::compat
