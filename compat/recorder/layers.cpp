// SPDX-License-Identifier: MIT
#include "compat/recorder/layers.h"

#include <algorithm>

namespace smart::compat {

namespace {

bool isWhole(const BufferClear& clear, const PixelTarget& target) {
    if (!clear.scissor) return true;
    const Viewport& box = *clear.scissor;
    return box.contains(0, 0) && box.contains(target.width - 1, target.height - 1);
}

} // namespace

bool coversAll(const BufferClear& clear, const BufferClear& other) {
    if (clear.scissor && clear.scissor != other.scissor) return false;
    for (int k = 0; k < 4; ++k)
        if (other.colorMask[k] && !clear.colorMask[k]) return false;
    return clear.depth || !other.depth;
}

bool forgetEverything(const std::vector<BufferClear>& clears) {
    bool color[4] = {}, depth = false;
    for (const BufferClear& clear : clears) {
        if (clear.scissor) continue;
        for (int k = 0; k < 4; ++k) color[k] |= clear.colorMask[k];
        depth |= clear.depth.has_value();
    }
    return depth && std::all_of(std::begin(color), std::end(color), [](bool c) { return c; });
}

bool takesLastOfEqual(const InstanceList& instances) {
    return !instances.empty() &&
           std::ranges::all_of(instances.traits(), [](const InstanceList::Traits& traits) {
               return traits->state &&
                      traits->state->ops.depthFunction == CompareFunction::LessEqual;
           });
}

void startFrom(std::vector<BufferClear>& clears, const PixelTarget& target, Frame& frame) {
    auto clear = clears.begin();
    for (; clear != clears.end() && isWhole(*clear, target); ++clear) {
        for (int k = 0; k < 4; ++k)
            if (clear->colorMask[k]) frame.clearColor[k] = clear->color[k];
        if (clear->depth) frame.clearDepth = *clear->depth;
    }
    clears.erase(clears.begin(), clear);
}

} // namespace smart::compat
