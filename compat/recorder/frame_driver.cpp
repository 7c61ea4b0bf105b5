// SPDX-License-Identifier: MIT
#include "compat/recorder/frame_driver.h"

#include <atomic>
#include <string>
#include <utility>

#include "libsmart/base/error.h"

namespace smart::compat {

namespace {

uint64_t nextFrameId() {
    static std::atomic<uint64_t> last{0};
    return ++last;
}

} // namespace

FrameDriver::FrameDriver(Recorder& recorder, unsigned threads)
    : recorder_(recorder), renderer_(threads) {
    recorder_.setBuildThreads(renderer_.threads());
}

void FrameDriver::submit(const std::shared_ptr<const Frame>& frame) {
    renderer_.submit(frame);
    lastScene_ = frame->scene;
}

void FrameDriver::waitFor(uint64_t frame) {
    const auto count = [&] {
        const RenderStatistics now = renderer_.statistics();
        frameStatistics_.primaryRays = now.primaryRays - before_.primaryRays;
        frameStatistics_.shadowRays = now.shadowRays - before_.shadowRays;
        frameStatistics_.secondaryRays = now.secondaryRays - before_.secondaryRays;
        frameStatistics_.badPixels = now.badPixels - before_.badPixels;
        before_ = now;
    };
    try {
        renderer_.wait(frame);
    } catch (...) {
        count();
        throw;
    }
    count();
    if (const uint64_t bad = frameStatistics_.badPixels; bad > 0)
        throw Error(ErrorCode::InvalidOperation,
                    "the picture is complete, but " + std::to_string(bad) +
                        (bad == 1 ? " pixel is" : " pixels are") +
                        " black: a shader failed there, or its colour was not finite");
}

void FrameDriver::start() {
    recorder_.requireOutsideObject();
    if (inFlight_) throw Error(ErrorCode::InvalidOperation, "a frame is in flight already");
    const std::shared_ptr<const Frame> frame = recorder_.makeFrame(nextFrameId());
    submit(frame);
    recorder_.clearScene();
    finishedAdditions_ = 0;
    inFlight_ = frame->id;
    inFlightDone_ = false;
}

void FrameDriver::end() {
    recorder_.requireOutsideObject();
    if (!inFlight_) throw Error(ErrorCode::InvalidOperation, "no frame is in flight");
    const uint64_t frame = *std::exchange(inFlight_, std::nullopt);
    if (!inFlightDone_) waitFor(frame);
    if (inFlightFailure_) std::rethrow_exception(std::exchange(inFlightFailure_, nullptr));
}

void FrameDriver::render() {
    if (!inFlight_) start();
    end();
}

void FrameDriver::finish() {
    recorder_.requireOutsideObject();
    if (inFlight_ && !inFlightDone_) {
        try {
            waitFor(*inFlight_);
        } catch (...) {
            inFlightFailure_ = std::current_exception();
        }
        inFlightDone_ = true;
    }
    const uint64_t additions = recorder_.sceneAdditions();
    if (additions == finishedAdditions_ || !recorder_.frameSettings().target.memory) return;
    const std::shared_ptr<const Frame> frame = recorder_.makeFrame(nextFrameId());
    submit(frame);
    finishedAdditions_ = additions;
    waitFor(frame->id);
}

float FrameDriver::progress() const {
    return inFlight_ && !inFlightDone_ ? renderer_.progress(*inFlight_) : 1.0f;
}

void FrameDriver::setThreads(unsigned threads) {
    recorder_.requireOutsidePrimitive();
    renderer_.setThreads(threads);
    recorder_.setBuildThreads(renderer_.threads());
}

const SceneStatistics& FrameDriver::sceneStatistics() {
    if (lastScene_) {
        lastSceneStatistics_ = statistics(*lastScene_);
        lastScene_.reset();
    }
    return lastSceneStatistics_;
}

} // namespace smart::compat
