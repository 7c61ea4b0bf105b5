// SPDX-License-Identifier: MIT
// The frames of a recorded program until it has waited for them: when a picture stays as it is.
#pragma once

#include <cstdint>
#include <vector>

#include "compat/recorder/context.h"
#include "compat/stream/call_table.h"
#include "libsmart/render/frame.h"

namespace smart::compat {

class RecordedFrames {
public:
    /// After a call that starts frames or waits for them, in the context that is current:
    /// where the pictures lie that it has waited for and that no frame in flight is drawn over.
    /// `latestBefore`: what FrameDriver::latestFrame() was before the call.
    std::vector<PixelTarget> finishedBy(const CallSignature& call, const CallValue* arguments,
                                        uint32_t latestBefore);

private:
    struct InFlight {
        uint32_t id;
        ContextId context;
        bool isStarted; ///< by rtStartRendering or rtRender, and not queued
        PixelTarget target;
    };
    void add(const InFlight& frame);

    std::vector<InFlight> frames_; ///< of those that a context queued to one memory the latest
};

} // namespace smart::compat
