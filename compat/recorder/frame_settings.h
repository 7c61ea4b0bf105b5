// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/vec4.hpp>
#include <optional>

#include "libsmart/render/frame.h"

namespace smart::compat {

/// What the application sets once and frames read when they are started.
struct FrameSettings {
    PixelTarget target; ///< memory nullptr: none set
    std::optional<Viewport> viewport;
    glm::vec4 clearColor{0.0f};
    uint32_t samples = 1;
    bool multisample = false; ///< four samples instead of one
    uint32_t seed = 0;
    uint32_t recursionLimit = 8;
    float weightCutoff = 1.0f / 512.0f;
    Precision precision = Precision::Watertight;
};

enum class BuildQuality : uint8_t { Nicest, DontCare, Fastest };

/// Hints for the compilation of objects.
struct BuildHints {
    BuildQuality quality = BuildQuality::DontCare;
    bool lazy = false;
};

} // namespace smart::compat
