// SPDX-License-Identifier: MIT
#include "compat/openrt/frame_callback.h"

#include <algorithm>
#include <exception>
#include <limits>
#include <string>
#include <utility>

#include "compat/openrt/tokens.h"
#include "compat/recorder/context.h"
#include "libsmart/base/error.h"
#include "libsmart/base/fp_environment.h"
#include "libsmart/render/worker.h"

namespace smart::compat {

namespace {

thread_local QueuedFrame* frameOfCallback = nullptr;

RTsizei extent(uint32_t pixels) {
    return RTsizei(std::min(pixels, uint32_t(std::numeric_limits<RTsizei>::max())));
}

} // namespace

void FrameCallback::call(QueuedFrame& frame, RTenum event, const Tile& part) const noexcept {
    const FpEnvironment asFound; // whatever the application does to it
    frameOfCallback = &frame;
    try {
        function_(RTuint(frame.frame().id), event, RTint(part.x), RTint(part.y),
                  extent(part.width), extent(part.height), user_);
    } catch (...) {
        try {
            throw Error(ErrorCode::InvalidOperation, "an exception left the frame callback");
        } catch (...) {
            frame.keepError(std::current_exception());
        }
    }
    frameOfCallback = nullptr;
}

void FrameCallback::tileDone(QueuedFrame& frame, const Tile& tile) noexcept {
    call(frame, RT_FRAME_PROGRESS, tile);
}

void FrameCallback::ended(QueuedFrame& frame, FrameStatus status) noexcept {
    const PixelTarget& target = frame.frame().target;
    call(frame, tokenOf(status), {0, 0, target.width, target.height});
}

bool isInFrameCallback() noexcept { return frameOfCallback != nullptr; }

bool refusedInCallback(const char* function) noexcept {
    if (!frameOfCallback) return false;
    try {
        throw Error(ErrorCode::InvalidOperation,
                    std::string(function) + " was called by a frame callback, which may call "
                                            "rtWaitFrame, rtFrameStatus, rtFrameProgress and "
                                            "rtCancelFrame only");
    } catch (...) {
        frameOfCallback->keepError(std::current_exception());
    }
    return true;
}

bool refusedHere(const char* function) noexcept {
    return refusedInCallback(function) || onWorkerThread() || whyUnusable();
}

} // namespace smart::compat
