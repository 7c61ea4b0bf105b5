// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <mutex>
#include <vector>

#include "libsmart/render/frame.h"
#include "libsmart/render/render_statistics.h"
#include "libsmart/render/tile_source.h"

namespace smart {

enum class FrameStatus : uint8_t {
    Queued,    ///< no tile was started
    Rendering, ///< some were; or all are done, and an earlier frame is not
    Done,
    Cancelled, ///< with tiles that are never rendered
    Failed,
};

class QueuedFrame;

/// Hears of a frame from the threads that render it. While it is told, the frame() exists.
class FrameListener {
public:
    virtual ~FrameListener() = default;
    /// The tile is in the frame's memory. Several threads may tell of different tiles at once.
    virtual void tileDone(QueuedFrame& frame, const Tile& tile) noexcept = 0;
    /// Nothing more will happen to the frame or its memory. The last that is told of a frame;
    /// frames that are not cancelled end one after the other, in order.
    virtual void ended(QueuedFrame& frame, FrameStatus status) noexcept = 0;
};

/// How frames reach the workers of their queue; outlives the queue.
struct QueueSignal {
    std::mutex mutex; ///< of the queue
    std::condition_variable work;
    std::atomic<bool> settled{false};   ///< some frame may have ended that nobody works on
    std::atomic<uint64_t> cancelled{0}; ///< frames that were, and have not ended
    unsigned announced = 0; ///< frames that may be submitted yet; under the mutex
};

/// A frame on its way through a queue, and afterwards what became of it: then it holds neither
/// the frame nor anything else of size. Its public functions may be called from any thread.
class QueuedFrame {
public:
    using Tiles = std::shared_ptr<const std::vector<Tile>>;

    QueuedFrame(std::shared_ptr<const Frame> frame, Tiles tiles,
                std::shared_ptr<FrameListener> listener, std::shared_ptr<QueueSignal> signal);
    ~QueuedFrame();
    QueuedFrame(const QueuedFrame&) = delete;
    QueuedFrame& operator=(const QueuedFrame&) = delete;

    FrameStatus status() const noexcept;
    /// Share of the tiles that are finished or dropped, 0..1; never falls.
    float progress() const noexcept;
    /// Drops the tiles that no worker has taken; if there are none left it has no effect. The
    /// frame ends, before its turn, when the tiles under way are done.
    void cancel() noexcept;
    /// Waits until nothing touches the frame's memory or tells its listener any more.
    FrameStatus wait() const;
    bool ended() const;
    /// Of the tiles finished so far.
    RenderStatistics statistics() const noexcept;
    /// Something that went wrong; the first stays until it is taken. It does not make the frame
    /// fail.
    void keepError(std::exception_ptr error) noexcept;
    /// What went wrong, once; nullptr: nothing.
    std::exception_ptr takeError() noexcept;
    /// While the queue holds it; for listeners and the queue.
    const Frame& frame() const { return *frame_; }
    const std::shared_ptr<const Frame>& sharedFrame() const { return frame_; }

private:
    friend class FrameQueue;
    static constexpr std::size_t kCacheLine = 64;

    /// Addresses from `first` up to `end`.
    struct Memory {
        uintptr_t first = 0, end = 0;
    };
    /// Memory that this frame writes to is written to by the other too.
    bool sharesMemoryWith(const QueuedFrame& other) const noexcept;
    FrameStatus outcomeSoFar() const noexcept;
    /// Tells the listener, lets go of the frame, wakes those who wait.
    void end() noexcept;
    void keepBadPixels() noexcept;
    template <class Result>
    void count(const Result& tile) noexcept;
    void countTime(uint64_t busyNanoseconds, uint64_t idleNanoseconds) noexcept;

    const std::shared_ptr<QueueSignal> signal_;
    const uint64_t tileCount_;
    // These change only when no tile is handed out; who holds a tile may read them.
    std::shared_ptr<const Frame> frame_;
    Tiles tiles_;
    std::shared_ptr<FrameListener> listener_;

    std::array<Memory, 7> memory_; ///< colour and six auxiliary buffers
    // Of the queue, under its mutex:
    std::shared_ptr<QueuedFrame> behind_; ///< the next in the queue
    bool sharesMemory_ = false;           ///< with one that was in the queue before it
    bool announced_ = false;              ///< counted in QueueSignal::announced
    std::shared_ptr<TileClaim> returned_; ///< tiles to be handed out again, linked by behind

    // Tiles not handed out (0 and less: none), and tiles neither done, failed nor dropped.
    alignas(kCacheLine) std::atomic<int64_t> waiting_;
    alignas(kCacheLine) std::atomic<uint64_t> unfinished_;
    std::atomic<uint64_t> primaryRays_{0}, shadowRays_{0}, secondaryRays_{0}, badPixels_{0};
    std::atomic<uint64_t> busyNanoseconds_{0}, idleNanoseconds_{0};
    std::atomic<bool> cancelled_{false}, failed_{false}, offered_{false};
    std::atomic<FrameStatus> outcome_{FrameStatus::Queued}; ///< of an ended frame

    mutable std::mutex mutex_; // guards what follows
    mutable std::condition_variable endedSignal_;
    bool ended_ = false;
    std::exception_ptr error_;
};

using QueuedFramePtr = std::shared_ptr<QueuedFrame>;

} // namespace smart
