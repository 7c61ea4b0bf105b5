// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>

#include "libsmart/render/queued_frame.h"
#include "libsmart/render/tile_source.h"

namespace smart {

/// Frames in the order of submission, handed out tile by tile: the next frame's tiles go out
/// while the last ones of the frame before are still being rendered. Frames end in order, unless
/// they are cancelled. One that writes to memory of a frame before it is started when that has
/// ended.
///
/// Frames end on the threads that call next(), done() and failed(), and only there, so that a
/// frame's listener is told by nobody else. prepare(), submit(), waitAll() and setDepth() belong
/// to one thread, all else to any. Handing out and taking back a tile changes nothing shared but
/// the frame's own counters, unless a worker turns to another frame or one ends.
class FrameQueue final : public SharedTileSource {
public:
    /// depth: how many frames may be incomplete at once; at least 1.
    /// patience: how long workers wait for a frame before all of them go home; see deserted().
    explicit FrameQueue(unsigned depth = 2, std::chrono::milliseconds patience = kForever);
    static constexpr auto kForever = std::chrono::milliseconds::max();
    /// Nobody may be inside a call; frames that did not end never will.
    ~FrameQueue() override;

    /// A frame for submit(), and all memory that it needs on its way.
    QueuedFramePtr prepare(std::shared_ptr<const Frame> frame,
                           std::shared_ptr<FrameListener> listener = nullptr);
    /// Queues a frame; blocks while the queue is full.
    void submit(QueuedFramePtr frame) noexcept;
    /// Waits until all frames submitted so far have ended.
    void waitAll();
    void setDepth(unsigned depth);
    unsigned depth() const;
    /// Of the frames that have ended.
    RenderStatistics statistics() const;
    /// Whether the workers went home for want of frames. They do not while there is a frame that
    /// was prepared and not submitted: who finds no workers after prepare() has to open() the queue
    /// and send new ones.
    bool deserted() const;
    /// From now on tiles are handed out by somebody else, and frames end by endElsewhere().
    void renderElsewhere();
    /// Ends a frame whose tiles were handed out elsewhere; it counts as cancelled unless `done`.
    void endElsewhere(QueuedFrame& frame, bool done) noexcept;
    /// Whether the frame's tiles may go to remote workers from now on; not at the start.
    void offer(QueuedFrame& frame, bool toRemote) noexcept;
    /// Sends workers home once every tile is handed out; open() ends that.
    void close();
    void open();

    bool next(TileJob& job) override;
    void done(TileJob& job, const TilePixels& pixels) override;
    void failed(TileJob& job, std::exception_ptr reason) noexcept override;
    void answered(TileJob& job, const StoredTile& tile) override;
    void returned(TileJob& job) noexcept override;

private:
    static bool take(QueuedFrame& frame, TileJob& job);
    static bool takeReturned(QueuedFrame& frame, TileJob& job);
    static bool isSettled(const QueuedFrame& frame, TileClaim& claim);
    bool find(TileJob& job);
    template <class Result, class Store>
    void deliver(TileJob& job, const Result& result, const Store& store);
    bool mayStart(const QueuedFrame& frame) const;
    bool waitForWork(std::unique_lock<std::mutex>& lock);
    void finish(QueuedFrame& frame, uint64_t tiles) noexcept;
    void endFrames(std::unique_lock<std::mutex>& lock) noexcept;
    QueuedFramePtr findEnded() const;
    void remove(const QueuedFrame& frame);

    const std::shared_ptr<QueueSignal> signal_; // its mutex guards what follows
    std::condition_variable ended_;
    QueuedFramePtr first_; // linked by behind_
    QueuedFrame* last_ = nullptr;
    const std::chrono::milliseconds patience_;
    unsigned depth_, incomplete_ = 0;
    bool closed_ = false;
    bool deserted_ = false;
    bool elsewhere_ = false;
    bool ending_ = false; ///< some thread is ending frames, and will look again
    RenderStatistics statistics_;

    // Of the picture size used last; of the thread that submits.
    QueuedFrame::Tiles lastTiles_;
    uint32_t lastWidth_ = 0, lastHeight_ = 0;
};

} // namespace smart
