// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <exception>
#include <optional>

#include "compat/recorder/recorder.h"
#include "libsmart/render/renderer.h"

namespace smart::compat {

/// Starts the frames of one context and waits for them; one at a time is in flight. Belongs to
/// the context's thread.
class FrameDriver {
public:
    FrameDriver(Recorder& recorder, unsigned threads);

    /// Freezes the scene and queues it; leaves an empty one.
    void start();
    /// Waits for the frame of start(); rethrows what made it fail. Throws Error, once a frame,
    /// where shaders failed in some of its pixels.
    void end();
    void render();
    /// Renders and waits for what was given so far, unless nothing was since the last time.
    void finish();

    /// Of the frame in flight, 0..1; 1 without one.
    float progress() const;
    /// Waits for frames in flight; 0: all cores.
    void setThreads(unsigned threads);
    /// The scene of the frame started last; empty before the first.
    const SceneStatistics& sceneStatistics();
    /// Of the frame waited for last.
    const RenderStatistics& frameStatistics() const { return frameStatistics_; }

private:
    void waitFor(uint64_t frame);
    void submit(const std::shared_ptr<const Frame>& frame);

    Recorder& recorder_;
    Renderer renderer_;
    std::optional<uint64_t> inFlight_;
    bool inFlightDone_ = false;
    std::exception_ptr inFlightFailure_; ///< for end(), when something else had to wait
    uint64_t finishedAdditions_ = 0;     ///< of the scene under way, at the last finish()
    ScenePtr lastScene_;                 ///< nullptr: lastSceneStatistics_ holds
    SceneStatistics lastSceneStatistics_;
    RenderStatistics before_, frameStatistics_;
};

} // namespace smart::compat
