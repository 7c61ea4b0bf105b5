// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/vec4.hpp>

#include "libsmart/shading/fixed_state.h"

namespace smart::compat {

enum class HintMode : uint8_t { DontCare, Fastest, Nicest };
enum class StencilOperation : uint8_t {
    Keep, Zero, Replace, Increment, Decrement, Invert, IncrementWrap, DecrementWrap
};

struct IdleHints {
    HintMode perspectiveCorrection = HintMode::DontCare, pointSmooth = HintMode::DontCare,
             lineSmooth = HintMode::DontCare, polygonSmooth = HintMode::DontCare,
             fog = HintMode::DontCare, generateMipmap = HintMode::DontCare,
             textureCompression = HintMode::DontCare;
};

struct IdleStencil {
    CompareFunction function = CompareFunction::Always;
    uint32_t valueMask = 0xFFFFFFFFu, writeMask = 0xFFFFFFFFu;
    StencilOperation fail = StencilOperation::Keep, depthFail = StencilOperation::Keep,
                     depthPass = StencilOperation::Keep;
    int32_t clear = 0;
};

/// State of OpenGL's that can be set and asked for, and that no picture depends on: hints, the
/// stencil buffer, which nothing here tests, and what belongs to refused parts.
struct IdleState {
    IdleHints hints;
    IdleStencil stencil;
    bool dither = true, indexLogicOp = false;
    glm::vec4 accumClear{0.0f};
    float sampleCoverage = 1.0f;
    bool sampleCoverageInvert = false;
};

} // namespace smart::compat
