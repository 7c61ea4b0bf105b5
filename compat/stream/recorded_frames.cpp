// SPDX-License-Identifier: MIT
#include "compat/stream/recorded_frames.h"

#include <algorithm>
#include <optional>
#include <string_view>

#include "compat/recorder/frame_table.h"
#include "compat/stream/call_capture.h"

namespace smart::compat {

namespace {

/// Cancelled where no frame is known by the id any more.
FrameStatus statusOf(uint32_t frame) {
    const std::optional<KnownFrame> known = frameTable().find(frame);
    return known ? known->status : FrameStatus::Cancelled;
}

bool hasEnded(uint32_t frame) {
    const FrameStatus status = statusOf(frame);
    return status != FrameStatus::Queued && status != FrameStatus::Rendering;
}

} // namespace

/// Frames of a context end in order: what it queued to the same memory before is drawn over.
void RecordedFrames::add(const InFlight& frame) {
    std::erase_if(frames_, [&](const InFlight& f) {
        return !f.isStarted && f.context == frame.context && f.target.memory == frame.target.memory;
    });
    frames_.push_back(frame);
}

std::vector<PixelTarget> RecordedFrames::finishedBy(const CallSignature& call,
                                                    const CallValue* arguments,
                                                    uint32_t latestBefore) {
    std::erase_if(frames_, [](const InFlight& f) { return !isContext(f.context); });
    const std::string_view name = call.name;
    const ContextId context = currentContextId();
    FrameDriver* const driver = context ? &currentContext()->frames() : nullptr;
    if (driver && driver->latestFrame() != latestBefore &&
        isFrameBuffer(driver->latestTarget().memory))
        add({driver->latestFrame(), context, name == "rtStartRendering" || name == "rtRender",
             driver->latestTarget()});

    const auto isInFlight = [&](const InFlight& f) {
        if (name == "rtWaitFrame")
            return f.isStarted || f.id != arguments[0].as<RTuint>() || !hasEnded(f.id);
        if (f.context != context) return true;
        if (f.isStarted) return driver->hasStarted();
        return (name != "rtFinish" && call.kind != CallKind::Read) || !hasEnded(f.id);
    };
    const auto firstEnded = std::stable_partition(frames_.begin(), frames_.end(), isInFlight);
    const std::vector<InFlight> ended(firstEnded, frames_.end());
    frames_.erase(firstEnded, frames_.end());

    std::vector<PixelTarget> finished;
    for (const InFlight& frame : ended) {
        const bool isDrawnOver = std::any_of(frames_.begin(), frames_.end(), [&](const auto& f) {
            return f.target.memory == frame.target.memory;
        });
        if (!isDrawnOver && statusOf(frame.id) == FrameStatus::Done)
            finished.push_back(frame.target);
    }
    return finished;
}

} // namespace smart::compat
