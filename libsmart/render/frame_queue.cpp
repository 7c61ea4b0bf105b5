// SPDX-License-Identifier: MIT
#include "libsmart/render/frame_queue.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "libsmart/render/stored_tile.h"
#include "libsmart/render/tile_order.h"

namespace smart {

namespace {

using Clock = std::chrono::steady_clock;

/// Nanoseconds from `since` to now, which becomes the new `since`.
uint64_t lap(Clock::time_point& since) {
    const Clock::time_point now = Clock::now();
    const auto passed = std::chrono::duration_cast<std::chrono::nanoseconds>(now - since);
    since = now;
    return uint64_t(std::max<int64_t>(passed.count(), 0));
}

/// Lists of up to so many tiles are kept from one frame to the next of the same size.
constexpr std::size_t kKeptTiles = 1u << 16;

/// How many frames may wait for another frame's memory before those behind them wait too. Bounds
/// the search for work, not the queue.
constexpr int kLookAhead = 64;

} // namespace

FrameQueue::FrameQueue(unsigned depth, std::chrono::milliseconds patience)
    : signal_(std::make_shared<QueueSignal>()), patience_(patience), depth_(std::max(depth, 1u)) {}

FrameQueue::~FrameQueue() {
    while (first_) first_ = std::exchange(first_->behind_, nullptr); // one by one: no recursion
}

QueuedFramePtr FrameQueue::prepare(std::shared_ptr<const Frame> frame,
                                   std::shared_ptr<FrameListener> listener) {
    const PixelTarget& target = frame->target;
    QueuedFrame::Tiles tiles = lastTiles_;
    if (!tiles || lastWidth_ != target.width || lastHeight_ != target.height) {
        tiles = std::make_shared<const std::vector<Tile>>(mortonTiles(target.width, target.height));
        lastTiles_ = tiles->size() <= kKeptTiles ? tiles : nullptr;
        lastWidth_ = target.width;
        lastHeight_ = target.height;
    }
    const auto prepared = std::make_shared<QueuedFrame>(std::move(frame), std::move(tiles),
                                                        std::move(listener), signal_);
    const std::lock_guard lock(signal_->mutex);
    ++signal_->announced;
    prepared->announced_ = true;
    return prepared;
}

void FrameQueue::submit(QueuedFramePtr frame) noexcept {
    {
        std::unique_lock lock(signal_->mutex);
        ended_.wait(lock, [&] { return incomplete_ < depth_; });
        frame->announced_ = false;
        --signal_->announced;
        for (QueuedFrame* f = first_.get(); f && !frame->sharesMemory_; f = f->behind_.get())
            frame->sharesMemory_ = frame->sharesMemoryWith(*f);
        if (elsewhere_) frame->waiting_.store(0, std::memory_order_release);
        // It may have been cancelled already.
        if (frame->unfinished_.load(std::memory_order_acquire) == 0)
            signal_->settled.store(true, std::memory_order_release);
        QueuedFrame* const added = frame.get();
        (last_ ? last_->behind_ : first_) = std::move(frame);
        last_ = added;
        ++incomplete_;
        if (elsewhere_) endFrames(lock); // no worker of the queue does
    }
    signal_->work.notify_all();
}

bool FrameQueue::take(QueuedFrame& frame, TileJob& job) {
    if (frame.waiting_.load(std::memory_order_relaxed) <= 0) return false;
    const int64_t left = frame.waiting_.fetch_sub(1, std::memory_order_acq_rel);
    if (left <= 0) return false;
    job.frame = frame.frame_.get();
    job.tile = (*frame.tiles_)[std::size_t(frame.tileCount_) - std::size_t(left)];
    if (!job.remote) frame.countTime(0, lap(job.since));
    return true;
}

bool FrameQueue::takeReturned(QueuedFrame& frame, TileJob& job) {
    if (!frame.returned_) return false;
    job.claim = std::exchange(frame.returned_, nullptr);
    frame.returned_ = std::exchange(job.claim->behind, nullptr);
    job.frame = frame.frame_.get();
    job.tile = job.claim->tile;
    if (!job.remote) frame.countTime(0, lap(job.since));
    return true;
}

// Whether a tile that was given back needs no worker any more. Without the queue's lock, which who
// settles the claim at this moment may wait for.
bool FrameQueue::isSettled(const QueuedFrame& frame, TileClaim& claim) {
    const std::lock_guard lock(claim.mutex);
    claim.settled |= frame.outcomeSoFar() != FrameStatus::Done;
    return claim.settled;
}

bool FrameQueue::mayStart(const QueuedFrame& frame) const {
    if (!frame.sharesMemory_) return true;
    for (const QueuedFrame* f = first_.get(); f != &frame; f = f->behind_.get())
        if (frame.sharesMemoryWith(*f)) return false;
    return true;
}

bool FrameQueue::next(TileJob& job) {
    if (job.since == Clock::time_point()) job.since = Clock::now();
    if (job.ticket) {
        // A remote worker's frame may have been withdrawn.
        if (!job.remote && !signal_->settled.load(std::memory_order_acquire) &&
            take(*static_cast<QueuedFrame*>(job.ticket.get()), job))
            return true;
        job.ticket.reset();
    }
    for (;;) {
        if (!find(job)) return false;
        QueuedFrame& frame = *static_cast<QueuedFrame*>(job.ticket.get());
        if (!job.claim || !isSettled(frame, *job.claim)) return true;
        job.claim = job.remote ? std::make_shared<TileClaim>() : nullptr;
        finish(frame, 1);
    }
}

// Waits for a tile that may be handed out. One that was given back may be settled already.
bool FrameQueue::find(TileJob& job) {
    std::unique_lock lock(signal_->mutex);
    for (;;) {
        if (signal_->settled.load(std::memory_order_relaxed)) endFrames(lock);
        int left = kLookAhead;
        for (const QueuedFramePtr* f = &first_; *f && left > 0; f = &(*f)->behind_) {
            if (job.remote && !(*f)->offered_.load(std::memory_order_relaxed)) continue;
            // What others were asked for already comes last: they may still answer.
            const bool waits = (*f)->waiting_.load(std::memory_order_relaxed) > 0;
            if ((waits && mayStart(**f) && take(**f, job)) || takeReturned(**f, job)) {
                job.ticket = *f;
                return true;
            }
            if (waits) --left;
        }
        if (closed_ || deserted_ || !waitForWork(lock)) return false;
    }
}

/// False, and for all workers, where nothing has come for too long.
bool FrameQueue::waitForWork(std::unique_lock<std::mutex>& lock) {
    if (patience_ == kForever) {
        signal_->work.wait(lock);
        return true;
    }
    if (signal_->work.wait_for(lock, patience_) == std::cv_status::no_timeout || first_ ||
        signal_->announced > 0)
        return true;
    deserted_ = true;
    signal_->work.notify_all();
    return false;
}

template <class Result, class Store>
void FrameQueue::deliver(TileJob& job, const Result& result, const Store& store) {
    QueuedFrame& frame = *static_cast<QueuedFrame*>(job.ticket.get());
    const std::shared_ptr<TileClaim> claim = std::exchange(job.claim, nullptr);
    std::unique_lock<std::mutex> lock;
    if (claim) lock = std::unique_lock(claim->mutex);
    // Without a settled claim the frame waits for this tile, whoever holds it.
    if (claim && std::exchange(claim->settled, true)) return;
    store(job.frame->target);
    frame.count(result);
    if (frame.listener_) frame.listener_->tileDone(frame, job.tile);
}

void FrameQueue::done(TileJob& job, const TilePixels& pixels) {
    deliver(job, pixels,
            [&](const PixelTarget& target) { writeTile(target, job.tile, pixels); });
    QueuedFrame& frame = *static_cast<QueuedFrame*>(job.ticket.get());
    frame.countTime(lap(job.since), 0);
    finish(frame, 1);
}

void FrameQueue::answered(TileJob& job, const StoredTile& tile) {
    deliver(job, tile,
            [&](const PixelTarget& target) { placeTile(target, job.tile, tile.bytes); });
    if (job.returned) return; // who has it now hands it back
    QueuedFrame& frame = *static_cast<QueuedFrame*>(job.ticket.get());
    frame.countTime(tile.busyNanoseconds, 0);
    finish(frame, 1);
}

void FrameQueue::returned(TileJob& job) noexcept {
    QueuedFrame& frame = *static_cast<QueuedFrame*>(job.ticket.get());
    job.returned = true;
    job.claim->tile = job.tile;
    {
        const std::lock_guard lock(signal_->mutex);
        job.claim->behind = std::move(frame.returned_);
        frame.returned_ = job.claim;
    }
    signal_->work.notify_all();
}

void FrameQueue::failed(TileJob& job, std::exception_ptr reason) noexcept {
    if (const std::shared_ptr<TileClaim> claim = std::exchange(job.claim, nullptr)) {
        const std::lock_guard lock(claim->mutex);
        claim->settled = true;
    }
    QueuedFrame& frame = *static_cast<QueuedFrame*>(job.ticket.get());
    frame.countTime(lap(job.since), 0);
    frame.keepError(std::move(reason));
    frame.failed_.store(true, std::memory_order_release);
    // Drop the tiles that nobody has taken.
    const int64_t dropped = frame.waiting_.exchange(0, std::memory_order_acq_rel);
    finish(frame, uint64_t(std::max<int64_t>(dropped, 0)) + 1);
}

void FrameQueue::finish(QueuedFrame& frame, uint64_t tiles) noexcept {
    if (frame.unfinished_.fetch_sub(tiles, std::memory_order_acq_rel) != tiles) return;
    std::unique_lock lock(signal_->mutex);
    endFrames(lock);
}

// A frame without tiles that are under way or still to come: the first, or one that was cancelled.
QueuedFramePtr FrameQueue::findEnded() const {
    const auto settled = [](const QueuedFrame& frame) {
        return frame.unfinished_.load(std::memory_order_acquire) == 0;
    };
    if (first_ && settled(*first_)) return first_;
    if (signal_->cancelled.load(std::memory_order_acquire) == 0) return nullptr;
    for (const QueuedFramePtr* f = &first_; *f; f = &(*f)->behind_)
        if (settled(**f) && (*f)->cancelled_.load(std::memory_order_acquire)) return *f;
    return nullptr;
}

void FrameQueue::remove(const QueuedFrame& frame) {
    QueuedFrame* before = nullptr;
    QueuedFramePtr* link = &first_;
    while (link->get() != &frame) {
        before = link->get();
        link = &before->behind_;
    }
    if (last_ == &frame) last_ = before;
    *link = std::exchange((*link)->behind_, nullptr);
}

// Ends the frames that can be; without the lock where others are called. One thread at a time:
// frames end in order.
void FrameQueue::endFrames(std::unique_lock<std::mutex>& lock) noexcept {
    signal_->settled.store(false, std::memory_order_relaxed);
    if (ending_) return;
    ending_ = true;
    while (const QueuedFramePtr frame = findEnded()) {
        statistics_ += frame->statistics();
        lock.unlock();
        frame->end();
        lock.lock();
        remove(*frame); // now frames that share its memory may start
        if (frame->cancelled_.load(std::memory_order_relaxed))
            signal_->cancelled.fetch_sub(1, std::memory_order_relaxed);
        --incomplete_;
        ended_.notify_all();
        signal_->work.notify_all();
    }
    ending_ = false;
}

void FrameQueue::waitAll() {
    std::unique_lock lock(signal_->mutex);
    ended_.wait(lock, [&] { return incomplete_ == 0; });
}

void FrameQueue::setDepth(unsigned depth) {
    const std::lock_guard lock(signal_->mutex);
    depth_ = std::max(depth, 1u);
}

unsigned FrameQueue::depth() const {
    const std::lock_guard lock(signal_->mutex);
    return depth_;
}

void FrameQueue::renderElsewhere() {
    const std::lock_guard lock(signal_->mutex);
    elsewhere_ = true;
}

void FrameQueue::endElsewhere(QueuedFrame& frame, bool done) noexcept {
    if (!done) {
        signal_->cancelled.fetch_add(1, std::memory_order_relaxed);
        frame.cancelled_.store(true, std::memory_order_release);
    }
    frame.unfinished_.store(0, std::memory_order_release);
    std::unique_lock lock(signal_->mutex);
    endFrames(lock);
}

void FrameQueue::offer(QueuedFrame& frame, bool toRemote) noexcept {
    {
        const std::lock_guard lock(signal_->mutex);
        frame.offered_.store(toRemote, std::memory_order_relaxed);
    }
    signal_->work.notify_all();
}

RenderStatistics FrameQueue::statistics() const {
    const std::lock_guard lock(signal_->mutex);
    return statistics_;
}

bool FrameQueue::deserted() const {
    const std::lock_guard lock(signal_->mutex);
    return deserted_;
}

void FrameQueue::close() {
    {
        const std::lock_guard lock(signal_->mutex);
        closed_ = true;
    }
    signal_->work.notify_all();
}

void FrameQueue::open() {
    const std::lock_guard lock(signal_->mutex);
    closed_ = deserted_ = false;
}

} // namespace smart
