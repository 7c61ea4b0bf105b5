// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "libsmart/render/render_statistics.h"
#include "libsmart/render/tile_source.h"

namespace smart {

/// Frames in the order of submission, handed out tile by tile: the next frame's tiles go out
/// while the last ones of the frame before are still being rendered. Frames complete in order.
/// submit() belongs to one thread, all else to any. Handing out and taking back a tile changes
/// nothing shared but the frame's own counters, unless a worker has to wait or a frame ends.
class FrameQueue final : public TileSource {
public:
    /// depth: how many frames may be incomplete at once; at least 1.
    explicit FrameQueue(unsigned depth = 2);

    /// Queues a frame; blocks while the queue is full.
    void submit(std::shared_ptr<const Frame> frame);
    /// Waits until no frame of this id is in the queue; rethrows, once, what made it fail.
    void wait(uint64_t frameId);
    /// Waits until all frames submitted so far are complete.
    void waitAll();
    /// Share of the tiles that are finished; 1 for a frame that is not in the queue.
    float progress(uint64_t frameId) const;
    /// Of the frames completed so far.
    RenderStatistics statistics() const;
    /// Sends workers home once every tile is handed out; open() ends that.
    void close();
    void open();

    std::optional<TileJob> next() override;
    void done(const TileJob& job, const TilePixels& pixels) override;
    void failed(const TileJob& job, std::exception_ptr reason) noexcept override;

private:
    static constexpr std::size_t kCacheLine = 64;
    using Tiles = std::shared_ptr<const std::vector<Tile>>;

    /// Where a frame sits while it is incomplete. `frame` and `tiles` change only while no tile
    /// is handed out; who holds a tile may read them.
    struct Slot {
        std::shared_ptr<const Frame> frame;
        Tiles tiles;
        std::exception_ptr failure; // guarded by mutex_
        // Tiles not handed out (0 and less: none), and tiles neither done, failed nor dropped.
        alignas(kCacheLine) std::atomic<int64_t> waiting{0};
        alignas(kCacheLine) std::atomic<uint64_t> unfinished{0};
        std::atomic<uint64_t> primaryRays{0}, shadowRays{0}, secondaryRays{0}, badPixels{0};
    };

    Slot& slotOf(uint64_t number) const { return slots_[number % depth_]; }
    const Slot* find(uint64_t frameId) const;
    void finish(Slot& slot, uint64_t tiles) noexcept;
    void complete() noexcept;

    const unsigned depth_;
    const std::unique_ptr<Slot[]> slots_;

    mutable std::mutex mutex_; // guards what follows; dealing_ is read without it
    std::condition_variable submittedOrClosed_, completedOne_;
    std::atomic<uint64_t> dealing_{0}; // number of the frame whose tiles go out
    uint64_t submitted_ = 0, completed_ = 0;
    bool closed_ = false;
    std::map<uint64_t, std::exception_ptr> failures_; // by frame id; null while in the queue
    RenderStatistics statistics_;
    Tiles lastTiles_; // of the picture size used last
    uint32_t lastWidth_ = 0, lastHeight_ = 0;
};

} // namespace smart
