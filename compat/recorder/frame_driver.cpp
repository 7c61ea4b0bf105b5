// SPDX-License-Identifier: MIT
#include "compat/recorder/frame_driver.h"

#include <utility>

#include "compat/recorder/frame_table.h"
#include "libsmart/base/error.h"

namespace smart::compat {

namespace {

SceneStatistics statisticsOfLayers(const Frame& frame) {
    SceneStatistics sum = statistics(*frame.scene);
    for (const auto& layer : frame.below) {
        const SceneStatistics more = statistics(*layer->scene);
        sum.triangles += more.triangles;
        sum.instances += more.instances;
        sum.nodes += more.nodes;
        sum.leaves += more.leaves;
        sum.references += more.references;
        sum.bytes += more.bytes;
        sum.droppedTriangles += more.droppedTriangles;
        sum.droppedInstances += more.droppedInstances;
    }
    return sum;
}

} // namespace

FrameDriver::FrameDriver(Recorder& recorder, unsigned threads)
    : recorder_(recorder), renderer_(threads) {
    recorder_.setBuildThreads(renderer_.threads());
}

// Everything that may fail comes first; a listener may hear of the frame before this returns.
QueuedFramePtr FrameDriver::submit(uint32_t* id) {
    const std::shared_ptr<Frame> frame = recorder_.makeFrame();
    const SceneStatistics sceneStatistics = statisticsOfLayers(*frame);
    QueuedFramePtr queued = renderer_.prepare(frame, listener_);
    const uint32_t given = frameTable().add(*frame, queued);
    if (id && given == FrameTable::kNoId)
        throw Error(ErrorCode::OutOfMemory, "no frame id is left");
    if (id) *id = given;
    sceneStatistics_ = sceneStatistics;
    renderer_.submit(queued);
    return queued;
}

void FrameDriver::start() {
    recorder_.requireOutsideObject();
    if (inFlight_) throw Error(ErrorCode::InvalidOperation, "a frame is in flight already");
    inFlight_ = submit();
    recorder_.clearScene();
}

void FrameDriver::end() {
    recorder_.requireOutsideObject();
    if (!inFlight_) throw Error(ErrorCode::InvalidOperation, "no frame is in flight");
    const QueuedFramePtr frame = std::exchange(inFlight_, nullptr);
    frame->wait();
    waitedFor(*frame);
    if (const std::exception_ptr error = frame->takeError()) std::rethrow_exception(error);
}

void FrameDriver::render() {
    if (!inFlight_) start();
    end();
}

void FrameDriver::finish() {
    recorder_.requireOutsideObject();
    if (!recorder_.sceneHasNews() || !recorder_.frameSettings().target.memory) {
        renderer_.waitAll();
        if (inFlight_) waitedFor(*inFlight_);
        return;
    }
    const QueuedFramePtr frame = submit();
    recorder_.sceneIsFinished();
    renderer_.waitAll();
    waitedFor(*frame);
    if (const std::exception_ptr error = frame->takeError()) std::rethrow_exception(error);
}

uint32_t FrameDriver::queue() {
    recorder_.requireOutsideObject();
    uint32_t id = 0;
    submit(&id);
    recorder_.clearScene();
    return id;
}

void FrameDriver::setThreads(unsigned threads) {
    recorder_.requireOutsidePrimitive();
    renderer_.setThreads(threads);
    recorder_.setBuildThreads(renderer_.threads());
}

} // namespace smart::compat
