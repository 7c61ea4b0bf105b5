// SPDX-License-Identifier: MIT
#include "compat/recorder/frame_driver.h"

#include <optional>
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

const PixelTarget& FrameDriver::applicationTarget() const {
    return recorder_.frameSettings().target;
}

QueuedFramePtr FrameDriver::submit(const PixelTarget& target, uint32_t* id) {
    return submit(recorder_.makeFrame(keepsDepth_ && target.memory ? withDepth(target) : target),
                  id);
}

void FrameDriver::waitedFor(const QueuedFrame& frame) {
    frameStatistics_ = frame.statistics();
    countRays();
}

void FrameDriver::countRays() {
    const RenderStatistics ended = renderer_.statistics();
    recorder_.setFrameRays(ended.shadowRays + ended.secondaryRays);
}

// Everything that may fail comes first; a listener may hear of the frame before this returns.
QueuedFramePtr FrameDriver::submit(const std::shared_ptr<Frame>& frame, uint32_t* id) {
    const PixelTarget& target = frame->target;
    if (ownPixels_ && target.memory == ownPixels_->data()) frame->keepAlive.push_back(ownPixels_);
    if (ownDepth_ && target.aux.depth == ownDepth_->data()) frame->keepAlive.push_back(ownDepth_);
    const SceneStatistics sceneStatistics = statisticsOfLayers(*frame);
    QueuedFramePtr queued = renderer_.prepare(frame, listener_);
    const uint32_t number = frameTable().add(*frame, queued);
    if (id && number == FrameTable::kNoId)
        throw Error(ErrorCode::OutOfMemory, "no frame id is left");
    if (id) *id = number;
    sceneStatistics_ = sceneStatistics;
    last_ = target;
    lastId_ = number;
    viewed_ = frame->camera ? frame : nullptr;
    renderer_.submit(queued);
    countRays();
    return queued;
}

void FrameDriver::start() {
    recorder_.requireOutsideObject();
    if (inFlight_) throw Error(ErrorCode::InvalidOperation, "a frame is in flight already");
    inFlight_ = submit(applicationTarget());
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
    if (!recorder_.sceneHasNews() || !applicationTarget().memory) {
        renderer_.waitAll();
        if (inFlight_) waitedFor(*inFlight_);
        return;
    }
    QueuedFramePtr frame;
    try {
        frame = submit(applicationTarget());
    } catch (...) {
        renderer_.waitAll(); // for the frames before, all the same
        throw;
    }
    recorder_.sceneIsFinished();
    renderer_.waitAll();
    waitedFor(*frame);
    if (const std::exception_ptr error = frame->takeError()) std::rethrow_exception(error);
}

PixelTarget FrameDriver::withDepth(PixelTarget target) {
    if (target.aux.depth) return target;
    const std::size_t pixels = std::size_t(target.width) * target.height;
    if (!ownDepth_ || ownDepth_->size() != pixels)
        ownDepth_ = std::make_shared<std::vector<float>>(pixels, 1.0f);
    target.aux.depth = ownDepth_->data();
    return target;
}

PixelTarget FrameDriver::ownTarget() {
    const std::optional<Viewport>& viewport = recorder_.frameSettings().viewport;
    const int64_t width = viewport ? int64_t(viewport->x) + viewport->width : 0;
    const int64_t height = viewport ? int64_t(viewport->y) + viewport->height : 0;
    if (width <= 0 || height <= 0)
        throw Error(ErrorCode::InvalidOperation,
                    "no frame buffer is set, and no viewport says how large one would be");
    const std::size_t pixels = std::size_t(width) * std::size_t(height);
    if (!ownPixels_ || ownPixels_->size() != pixels)
        ownPixels_ = std::make_shared<std::vector<uint32_t>>(pixels);
    PixelTarget target = applicationTarget();
    target.memory = ownPixels_->data();
    target.width = uint32_t(width);
    target.height = uint32_t(height);
    target.format = PixelFormat::Rgba8;
    target.stride = 0;
    return target;
}

Picture FrameDriver::finishedPicture(bool depth, PictureUse use) {
    recorder_.requireOutsideObject();
    const bool own = !applicationTarget().memory;
    PixelTarget target = own ? ownTarget() : applicationTarget();
    keepsDepth_ |= depth;
    if (keepsDepth_) target = withDepth(target);
    const bool shown = last_.memory == target.memory && last_.width == target.width &&
                       last_.height == target.height;
    const bool hasDepth = shown && last_.aux.depth == target.aux.depth && last_.aux.depth;
    const bool empty = recorder_.sceneIsEmpty();
    if (recorder_.sceneHasNews() || (!empty && (!shown || (depth && !hasDepth))) ||
        (own && !shown)) {
        const QueuedFramePtr frame = submit(target);
        recorder_.sceneIsFinished();
        renderer_.waitAll();
        waitedFor(*frame);
        if (const std::exception_ptr error = frame->takeError()) std::rethrow_exception(error);
    } else {
        renderer_.waitAll();
        if (depth && !hasDepth)
            throw Error(ErrorCode::InvalidOperation,
                        "the frame before has ended without its depth; those from now on keep it");
    }
    if (use == PictureUse::Scene) renderer_.sharePicture(target);
    return {target, target.aux.depth};
}

uint32_t FrameDriver::queueView() {
    if (!viewed_)
        throw Error(ErrorCode::InvalidOperation, "there is no frame before that a camera took");
    uint32_t id = 0;
    submit(recorder_.makeView(*viewed_, applicationTarget()), &id);
    recorder_.dropCamera();
    return id;
}

uint32_t FrameDriver::queue() {
    recorder_.requireOutsideObject();
    uint32_t id = 0;
    submit(applicationTarget(), &id);
    recorder_.clearScene();
    return id;
}

void FrameDriver::setThreads(unsigned threads) {
    recorder_.requireOutsidePrimitive();
    renderer_.setThreads(threads);
    recorder_.setBuildThreads(renderer_.threads());
}

} // namespace smart::compat
