// SPDX-License-Identifier: MIT
// What OpenGL does with the fragments of a pixel (OpenGL 1.5, chapter 4), in order of submission.
#pragma once

#include <cstdint>
#include <glm/vec4.hpp>
#include <span>

#include "libsmart/shading/fixed_state.h"

namespace smart {

/// A hit, or a pixel primitive, as one pixel sees it.
struct Fragment {
    uint64_t order = 0;              ///< of submission in its layer
    const FixedState* state = nullptr; ///< nullptr: depth test RT_LESS, nothing else
    float depth = 1.0f;              ///< window depth, offset included
    glm::vec4 color{0.0f};           ///< textured and fogged, not clamped
    uint32_t source = 0;             ///< the maker's own: which hit it was
};

/// A pixel's place in the buffers.
struct PixelValue {
    glm::vec4 color{0.0f};
    float depth = 1.0f;
    /// Fragment::source of the one that wrote the depth last; kNoSource: none of this layer.
    uint32_t source = kNoSource;

    static constexpr uint32_t kNoSource = 0xFFFFFFFFu;
};

/// Sorts the fragments by their order and takes them through alpha test, depth test, blending,
/// logical operation and masks.
void replay(std::span<Fragment> fragments, PixelValue& pixel);

} // namespace smart
