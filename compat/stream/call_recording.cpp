// SPDX-License-Identifier: MIT
#include "compat/stream/call_recording.h"

#include <cstdio>
#include <exception>
#include <limits>
#include <mutex>

#include "compat/openrt/frame_callback.h"
#include "compat/openrt/guard.h"
#include "compat/openrt/tokens.h"
#include "compat/recorder/context.h"
#include "compat/stream/call_capture.h"
#include "compat/stream/call_player.h"
#include "compat/stream/call_sink.h"
#include "compat/stream/record_format.h"
#include "compat/stream/recorded_frames.h"
#include "compat/stream/trace_file.h"
#include "libsmart/base/immortal.h"
#include "libsmart/render/worker.h"
#include "openrt/version.h"

namespace smart::compat {

namespace {

enum State { kOff, kOn, kUnknown };

/// All that recordings have, under one lock, which makes one order of the calls of all threads.
struct Recording {
    std::mutex mutex;
    CallSink* sink = nullptr;
    RecordWriter writer;
    uint32_t threads = 0;
    RecordedFrames frames;
};

Recording& recording() {
    static Immortal<Recording> instance;
    return instance.get();
}

thread_local int threadNumber = -1;
thread_local uint8_t level = 0; ///< of calls that callbacks make during calls

uint16_t numberOfThread(Recording& r) {
    if (threadNumber < 0) {
        if (r.threads > std::numeric_limits<uint16_t>::max())
            throw StreamError("the program has more threads than a recording can number");
        threadNumber = int(r.threads++);
    }
    return uint16_t(threadNumber);
}

void writeStart(RecordWriter& writer) {
    const std::span<const CallSignature> table = callTable();
    writer.begin(RecordKind::Start, 0, 0, 0);
    writer.putBytes(kStreamMagic, sizeof kStreamMagic);
    writer.put(kByteOrder);
    writer.put(kStreamVersion);
    writer.put(uint8_t(sizeof(void*)));
    writer.putText(OPENRT_VERSION_STRING);
    writer.put(uint16_t(table.size()));
    for (const CallSignature& call : table) writer.put(call.fingerprint);
}

void stop(Recording& r, const char* why) noexcept {
    std::fprintf(stderr, "openrt: the recording of calls ends: %s\n", why);
    r.sink = nullptr;
    recordingState = kOff;
}

/// Runs body with the sink, under the lock. A failure ends the recording and nothing else.
template <class Body>
void withSink(Body&& body) noexcept {
    Recording& r = recording();
    const std::lock_guard lock(r.mutex);
    if (!r.sink) return;
    try {
        body(r, *r.sink);
    } catch (const std::exception& error) {
        stop(r, error.what());
    } catch (...) {
        stop(r, "unknown exception");
    }
}

void resolveEnvironment() noexcept {
    static std::once_flag once;
    std::call_once(once, [] {
        if (recordingState != kUnknown) return;
        CallSink* const file = traceFileFromEnvironment();
        if (file)
            setCallSink(file);
        else
            recordingState = kOff;
    });
}

/// Threads of the library, which call what frame callbacks may, do so at no time that a player
/// could repeat; and what a child of fork calls has no effect.
bool isRecorded() noexcept {
    return !onWorkerThread() && !isInFrameCallback() && !whyUnusable();
}

RTenum tokenOf(PixelFormat format) {
    constexpr RTenum kTokens[] = {RT_BGR_32, RT_RGB_8,   RT_RGBA_8,
                                  RT_BGRA_8, RT_RGB_32F, RT_RGBA_32F};
    return kTokens[std::size_t(format)];
}

uint32_t contextNumber() noexcept {
    return uint32_t(currentContextId());
}

} // namespace

std::atomic<int> recordingState{kUnknown};

void setCallSink(CallSink* sink) noexcept {
    Recording& r = recording();
    {
        const std::lock_guard lock(r.mutex);
        r.sink = sink;
        recordingState = sink ? kOn : kOff;
    }
    withSink([](Recording& now, CallSink& to) {
        writeStart(now.writer);
        to.record(now.writer.end());
    });
}

void abandonCallSink() noexcept {
    recordingState = kOff;
}

CallRecording::CallRecording(uint16_t number, const CallValue* arguments) noexcept
    : call_(callTable()[number]), arguments_(arguments) {
    resolveEnvironment();
    if (recordingState != kOn || !isRecorded()) return;
    isActive_ = true;
    level_ = level++;
    errorsBefore_ = errorsRaised().count;
    withSink([&](Recording& r, CallSink& sink) {
        Context* const context = currentContext();
        r.writer.begin(RecordKind::Call, level_, numberOfThread(r), contextNumber());
        r.writer.put(number);
        captureArguments(r.writer, call_, arguments, context);
        sink.record(r.writer.end());
        if (call_.kind == CallKind::Frame || call_.kind == CallKind::Read) sink.flush();
    });
    if (Context* const context = currentContext())
        latestBefore_ = context->frames().latestFrame();
}

CallRecording::~CallRecording() {
    if (isActive_) level = level_;
}

void CallRecording::end(CallValue result) noexcept {
    if (!isActive_) return;
    const bool told = errorsRaised().count != errorsBefore_ ||
                      call_.resultMeaning != Meaning::Plain || call_.comparesResult ||
                      call_.yield != Yield::Nothing;
    if (told) recordOutcome(result);
    if (call_.kind == CallKind::Frame || call_.kind == CallKind::Read) recordPictures();
}

uint64_t CallRecording::hashOfPixels() const {
    Context* const context = currentContext();
    if (!context || call_.yield != Yield::Pixels) return 0;
    const auto named = [&](const char* name) {
        return argumentNamed(call_, name, arguments_).value_or(0);
    };
    const PixelTarget& picture = context->frames().latestTarget();
    const auto* const to = static_cast<const std::byte*>(arguments_[6].as<void*>());
    const ImageRows rows = rowsOfReadPixels(call_, arguments_, imageStoresOf(context));
    const bool isInside = named("x") >= 0 && named("y") >= 0 &&
                          named("x") + named("width") <= int64_t(picture.width) &&
                          named("y") + named("height") <= int64_t(picture.height);
    if (!to || !isInside || rows.rows == 0) return 0; // pixels outside stay what they were
    return hashOfRows(to + rows.offset, std::size_t(rows.rowBytes), std::size_t(rows.stride),
                      rows.rows);
}

void CallRecording::recordOutcome(CallValue result) const {
    withSink([&](Recording& r, CallSink& sink) {
        const RaisedErrors& errors = errorsRaised();
        const bool failed = errors.count != errorsBefore_;
        r.writer.begin(RecordKind::Outcome, level_, numberOfThread(r), contextNumber());
        r.writer.put(call_.number);
        r.writer.put(failed ? errorToken(errors.since(errorsBefore_)) : RTenum(RT_NO_ERROR));
        r.writer.put(result);
        r.writer.put(failed ? 0 : hashOfPixels());
        const auto n = arguments_[0].as<RTsizei>();
        const bool hasNames =
            call_.yield == Yield::Names && !failed && n > 0 && currentContext();
        r.writer.put(hasNames ? uint32_t(n) : 0u);
        if (hasNames) r.writer.putBytes(arguments_[1].as<const RTuint*>(), std::size_t(n) * 4);
        sink.record(r.writer.end());
    });
}

void CallRecording::recordPictures() const {
    withSink([&](Recording& r, CallSink& sink) {
        if (!sink.wantsPictures()) return;
        for (const PixelTarget& target : r.frames.finishedBy(call_, arguments_, latestBefore_)) {
            const std::size_t rowBytes = std::size_t(target.width) * bytesPerPixel(target.format);
            const std::size_t stride = target.stride ? target.stride : rowBytes;
            r.writer.begin(RecordKind::Picture, level_, numberOfThread(r), contextNumber());
            r.writer.put(keyOfFrameBuffer(target.memory));
            r.writer.put(target.width);
            r.writer.put(target.height);
            r.writer.put(tokenOf(target.format));
            r.writer.put(uint64_t(stride));
            r.writer.put(hashOfRows(static_cast<const std::byte*>(target.memory), rowBytes, stride,
                                    target.height));
            sink.record(r.writer.end());
        }
    });
}

} // namespace smart::compat
