// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "compat/recorder/picture.h"
#include "compat/recorder/recorder.h"
#include "libsmart/render/renderer.h"

namespace smart::compat {

/// Who gets what is read from a picture.
enum class PictureUse {
    Application,
    Scene, ///< what later frames show: all processes that render have to see the picture
};

/// Starts the frames of one context and waits for them. Belongs to the context's thread.
class FrameDriver {
public:
    FrameDriver(Recorder& recorder, unsigned threads);

    /// Freezes the bound scene and queues it; leaves an empty one. One such frame at a time.
    void start();
    /// Waits for the frame of start(); rethrows what went wrong with it.
    void end();
    void render();
    /// Renders what was given so far, unless nothing was since the last time, and waits for all
    /// frames.
    void finish();
    /// What finish() leaves, to be read until the next frame is started. Without a frame buffer of
    /// the application's the library's own serves. `depth`: with window depth.
    Picture finishedPicture(bool depth, PictureUse use);
    /// Like start(), any number of times; the frame's id. Waits while the queue is full.
    uint32_t queue();
    /// Queues what the frame before shows, seen by the camera in use now; the frame's id.
    uint32_t queueView();
    /// A frame was waited for: from now on the statistics are its own.
    void waitedFor(const QueuedFrame& frame);
    /// Whether a frame of start() is yet to be ended.
    bool hasStarted() const { return inFlight_ != nullptr; }
    /// The id of the frame submitted last, 0 before the first; and where it goes to.
    uint32_t latestFrame() const { return lastId_; }
    const PixelTarget& latestTarget() const { return last_; }

    /// How many frames may be incomplete; 2 at the start.
    void setDepth(unsigned depth) { renderer_.setDepth(depth); }
    unsigned depth() const { return renderer_.depth(); }
    /// Hears of the frames queued from now on.
    void setListener(std::shared_ptr<FrameListener> listener) { listener_ = std::move(listener); }

    /// Of the frame in flight by start(), 0..1; 1 without one.
    float progress() const { return inFlight_ ? inFlight_->progress() : 1.0f; }
    /// Waits for frames in flight; 0: all cores.
    void setThreads(unsigned threads);
    /// The scene of the frame queued last; empty before the first.
    const SceneStatistics& sceneStatistics() const { return sceneStatistics_; }
    /// Of the frame waited for last.
    const RenderStatistics& frameStatistics() const { return frameStatistics_; }

private:
    /// Freezes the bound scene and submits it.
    QueuedFramePtr submit(const PixelTarget& target, uint32_t* id = nullptr);
    /// `id`: where the frame's goes; without it there need be none.
    QueuedFramePtr submit(const std::shared_ptr<Frame>& frame, uint32_t* id);
    void countRays();
    /// Where frames go: the application's memory, or for readers the library's own.
    const PixelTarget& applicationTarget() const;
    PixelTarget ownTarget();
    /// With the library's own depth buffer, from when it was first asked for.
    PixelTarget withDepth(PixelTarget target);

    Recorder& recorder_;
    Renderer renderer_;
    std::shared_ptr<FrameListener> listener_;
    QueuedFramePtr inFlight_;
    // Memory of the library's own, which frames keep alive.
    std::shared_ptr<std::vector<uint32_t>> ownPixels_;
    std::shared_ptr<std::vector<float>> ownDepth_;
    bool keepsDepth_ = false;
    PixelTarget last_; ///< of the frame submitted last
    /// That frame where queueView() may ask for it: where a camera shader took it.
    std::shared_ptr<const Frame> viewed_;
    SceneStatistics sceneStatistics_;
    RenderStatistics frameStatistics_;
    uint32_t lastId_ = 0;
};

} // namespace smart::compat
