// SPDX-License-Identifier: MIT
// The application's function that hears of frames, and what may not be called from it.
#pragma once

#include "libsmart/render/queued_frame.h"
#include "openrt/types.h"

namespace smart::compat {

using FrameFunction = void(RTAPIENTRY*)(RTuint, RTenum, RTint, RTint, RTsizei, RTsizei, void*);

/// Calls a function of the application for what it hears.
class FrameCallback final : public FrameListener {
public:
    FrameCallback(FrameFunction function, void* user) : function_(function), user_(user) {}
    void tileDone(QueuedFrame& frame, const Tile& tile) noexcept override;
    void ended(QueuedFrame& frame, FrameStatus status) noexcept override;

private:
    void call(QueuedFrame& frame, RTenum event, const Tile& part) const noexcept;

    FrameFunction function_;
    void* user_;
};

/// Whether a frame's callback runs on this thread.
bool isInFrameCallback() noexcept;
/// The same; the frame then keeps it as its error that
/// `function` was called there.
bool refusedInCallback(const char* function) noexcept;
/// Whether this is a thread that renders, which can have no context nor wait for its own end, or
/// one of a process that may not use the library (whyUnusable).
bool refusedHere(const char* function) noexcept;

} // namespace smart::compat
