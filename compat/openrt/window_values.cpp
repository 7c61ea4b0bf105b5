// SPDX-License-Identifier: MIT
#include "compat/openrt/window_values.h"

#include "openrt/rt.h"

namespace smart::compat {

namespace {

std::optional<StateValue> storeValue(const PixelStore& unpack, const PixelStore& pack,
                                     RTenum name) {
    const auto number = [](double n) { return StateValue::number(n); };
    switch (name) {
    case RT_UNPACK_ALIGNMENT: return number(unpack.alignment);
    case RT_UNPACK_ROW_LENGTH: return number(unpack.rowLength);
    case RT_UNPACK_SKIP_PIXELS: return number(unpack.skipPixels);
    case RT_UNPACK_SKIP_ROWS: return number(unpack.skipRows);
    case RT_UNPACK_SWAP_BYTES: return number(unpack.swapBytes);
    case RT_UNPACK_LSB_FIRST: return number(unpack.lsbFirst);
    case RT_PACK_ALIGNMENT: return number(pack.alignment);
    case RT_PACK_ROW_LENGTH: return number(pack.rowLength);
    case RT_PACK_SKIP_PIXELS: return number(pack.skipPixels);
    case RT_PACK_SKIP_ROWS: return number(pack.skipRows);
    case RT_PACK_SWAP_BYTES: return number(pack.swapBytes);
    case RT_PACK_LSB_FIRST: return number(pack.lsbFirst);
    default: return std::nullopt;
    }
}

} // namespace

std::optional<StateValue> windowValue(Recorder& recorder, RTenum name) {
    const FrameSettings& settings = recorder.frameSettings();
    const PixelTarget& target = settings.target;
    switch (name) {
    case RT_SCISSOR_BOX: {
        const Viewport box =
            settings.scissor.value_or(Viewport{0, 0, target.width, target.height});
        return StateValue::list(
            {double(box.x), double(box.y), double(box.width), double(box.height)});
    }
    case RT_DEPTH_RANGE: {
        StateValue range = StateValue::list({settings.depthNear, settings.depthFar});
        range.normalised = true;
        return range;
    }
    case RT_DEPTH_CLEAR_VALUE: {
        StateValue depth = StateValue::number(settings.clearDepth);
        depth.normalised = true;
        return depth;
    }
    case RT_DRAW_BUFFER:
        return StateValue::number(settings.drawsColor
                                      ? settings.drawBuffer ? settings.drawBuffer : RT_BACK
                                      : RT_NONE);
    case RT_READ_BUFFER:
        return StateValue::number(settings.readBuffer ? settings.readBuffer : RT_BACK);
    default: return storeValue(recorder.pixelStore(), recorder.packStore(), name);
    }
}

} // namespace smart::compat
