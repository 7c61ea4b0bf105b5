// SPDX-License-Identifier: MIT
#include <exception>
#include <memory>
#include <string>

#include "compat/openrt/frame_callback.h"
#include "compat/openrt/guard.h"
#include "compat/openrt/tokens.h"
#include "compat/recorder/frame_table.h"
#include "libsmart/render/worker.h"
#include "openrt/rt_queue.h"

using namespace smart;
using namespace smart::compat;

namespace {

/// Legal with any context or none, on any thread; in a context not between begin and end.
template <class Result, class Body>
Result anywhere(Result failure, const char* function, Body&& body) noexcept {
    if (whyUnusable()) return failure;
    try {
        if (Context* context = currentContext()) context->recorder().requireOutsidePrimitive();
        return body();
    } catch (...) {
        report(function);
    }
    return failure;
}

KnownFrame knownFrame(RTuint id) {
    const std::optional<KnownFrame> known = frameTable().find(id);
    if (!known) throwError(ErrorCode::InvalidValue, "no frame has the id " + std::to_string(id));
    return *known;
}

/// Records in the thread's context, if it has one, what went wrong with a frame that has ended.
void fetchFrom(QueuedFrame& frame, const char* function) {
    Context* const context = currentContext();
    if (!context) return;
    context->frames().waitedFor(frame);
    try {
        if (const std::exception_ptr error = frame.takeError()) std::rethrow_exception(error);
    } catch (...) {
        report(function);
    }
}

} // namespace

RTAPI RTuint RTAPIENTRY rtGenScene(void) {
    return guardedOr<RTuint>(RT_INVALID, __func__,
                             [](Context& c) { return c.recorder().newScene(); });
}
RTAPI void RTAPIENTRY rtBindScene(RTuint scene) {
    guarded(__func__, [&](Context& c) { c.recorder().bindScene(scene); });
}
RTAPI void RTAPIENTRY rtDeleteScene(RTuint scene) {
    guarded(__func__, [&](Context& c) { c.recorder().removeScene(scene); });
}

RTAPI RTuint RTAPIENTRY rtQueueFrame(void) {
    return guardedOr<RTuint>(RT_INVALID, __func__, [](Context& c) { return c.frames().queue(); });
}

RTAPI RTuint RTAPIENTRY rtQueueView(void) {
    return guardedOr<RTuint>(RT_INVALID, __func__,
                             [](Context& c) { return c.frames().queueView(); });
}

RTAPI void RTAPIENTRY rtFrameDepth(RTuint n) {
    guarded(__func__, [&](Context& c) {
        c.recorder().requireOutsidePrimitive();
        if (n == 0) throwError(ErrorCode::InvalidValue, "the queue holds one frame at least");
        c.frames().setDepth(n);
    });
}

RTAPI void RTAPIENTRY rtSetFrameCallback(FrameFunction cb, void* user) {
    guarded(__func__, [&](Context& c) {
        c.recorder().requireOutsidePrimitive();
        c.frames().setListener(cb ? std::make_shared<FrameCallback>(cb, user) : nullptr);
    });
}

RTAPI RTboolean RTAPIENTRY rtWaitFrame(RTuint frame) {
    return anywhere<RTboolean>(RT_FALSE, __func__, [&]() -> RTboolean {
        const KnownFrame known = knownFrame(frame);
        if (!known.frame && known.status == FrameStatus::Failed)
            throwError(ErrorCode::InvalidOperation,
                       "the frame failed; why is known of the newest frames only");
        FrameStatus status = known.status;
        if (known.frame && !onWorkerThread()) {
            status = known.frame->wait();
            fetchFrom(*known.frame, "rtWaitFrame");
        }
        return status == FrameStatus::Done ? RT_TRUE : RT_FALSE;
    });
}

RTAPI RTenum RTAPIENTRY rtFrameStatus(RTuint frame) {
    return anywhere<RTenum>(RT_INVALID, __func__,
                            [&] { return tokenOf(knownFrame(frame).status); });
}

RTAPI RTfloat RTAPIENTRY rtFrameProgress(RTuint frame) {
    return anywhere<RTfloat>(0.0f, __func__, [&] {
        const KnownFrame known = knownFrame(frame);
        return known.frame ? known.frame->progress() : 1.0f;
    });
}

RTAPI void RTAPIENTRY rtCancelFrame(RTuint frame) {
    anywhere(0, __func__, [&] {
        const KnownFrame known = knownFrame(frame);
        if (known.frame) known.frame->cancel();
        return 0;
    });
}
