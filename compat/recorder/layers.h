// SPDX-License-Identifier: MIT
#pragma once

#include <glm/mat4x4.hpp>
#include <optional>
#include <vector>

#include "libsmart/render/frame.h"

namespace smart::compat {

/// How primitives are seen, as far as a layer has it to itself: other primitives belong to another
/// layer.
struct LayerView {
    glm::dmat4 projection{1.0};
    std::optional<Viewport> viewport; ///< empty: the frame buffer
    std::optional<Viewport> scissor;  ///< empty: the test is off
    float depthNear = 0.0f, depthFar = 1.0f;
    bool drawsColor = true;

    bool operator==(const LayerView&) const = default;
};

/// A layer that nothing is added to any more.
struct FinishedLayer {
    LayerView view;
    InstanceList instances;
    std::vector<BufferClear> clears; ///< before its primitives
};

/// Whether a clear, of the whole picture, writes all that another one does.
bool coversAll(const BufferClear& clear, const BufferClear& other);
/// Whether clears of the whole picture leave nothing of what was there before.
bool forgetEverything(const std::vector<BufferClear>& clears);

/// Whether all state blocks of a layer take the last of equal depths (RT_LEQUAL).
bool takesLastOfEqual(const InstanceList& instances);

/// Makes the lowest layer's clears of the whole picture part of what the picture starts from.
void startFrom(std::vector<BufferClear>& clears, const PixelTarget& target, Frame& frame);

} // namespace smart::compat
