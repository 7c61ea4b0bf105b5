// SPDX-License-Identifier: MIT
#include "libsmart/render/frame_queue.h"

#include <algorithm>
#include <utility>

#include "libsmart/render/tile_order.h"

namespace smart {

FrameQueue::FrameQueue(unsigned depth)
    : depth_(std::max(depth, 1u)), slots_(std::make_unique<Slot[]>(depth_)) {}

void FrameQueue::submit(std::shared_ptr<const Frame> frame) {
    // List the tiles before anything is changed: it is what may run out of memory.
    const PixelTarget& target = frame->target;
    if (!lastTiles_ || lastWidth_ != target.width || lastHeight_ != target.height) {
        lastTiles_ =
            std::make_shared<const std::vector<Tile>>(mortonTiles(target.width, target.height));
        lastWidth_ = target.width;
        lastHeight_ = target.height;
    }
    {
        std::unique_lock lock(mutex_);
        failures_.try_emplace(frame->id); // here, so that failing needs no memory
        completedOne_.wait(lock, [&] { return submitted_ - completed_ < depth_; });
        Slot& slot = slotOf(submitted_);
        slot.frame = std::move(frame);
        slot.tiles = lastTiles_;
        slot.failure = nullptr;
        for (auto* counter :
             {&slot.primaryRays, &slot.shadowRays, &slot.secondaryRays, &slot.badPixels})
            counter->store(0, std::memory_order_relaxed);
        slot.unfinished.store(lastTiles_->size(), std::memory_order_relaxed);
        // Release: whoever takes a tile sees all of the above.
        slot.waiting.store(int64_t(lastTiles_->size()), std::memory_order_release);
        ++submitted_;
    }
    submittedOrClosed_.notify_all();
    if (lastTiles_->empty()) complete();
}

std::optional<TileJob> FrameQueue::next() {
    for (;;) {
        const uint64_t number = dealing_.load(std::memory_order_acquire);
        Slot& slot = slotOf(number);
        // A slot that a later frame has taken meanwhile is as good: its tiles want rendering too.
        const int64_t left = slot.waiting.fetch_sub(1, std::memory_order_acq_rel);
        if (left > 0) {
            const std::vector<Tile>& tiles = *slot.tiles;
            return TileJob{slot.frame, tiles[tiles.size() - std::size_t(left)],
                           uint64_t(&slot - slots_.get())};
        }
        // All handed out: step to the next frame, and wait for it.
        std::unique_lock lock(mutex_);
        if (dealing_.load(std::memory_order_relaxed) == number && number < submitted_ &&
            slot.waiting.load(std::memory_order_relaxed) <= 0)
            dealing_.store(number + 1, std::memory_order_release);
        submittedOrClosed_.wait(lock, [&] { return dealing_ < submitted_ || closed_; });
        if (dealing_ >= submitted_) return std::nullopt;
    }
}

void FrameQueue::done(const TileJob& job, const TilePixels& pixels) {
    writeTile(job.frame->target, job.tile, pixels);
    Slot& slot = slots_[job.ticket];
    slot.primaryRays.fetch_add(pixels.primaryRays, std::memory_order_relaxed);
    slot.shadowRays.fetch_add(pixels.shadowRays, std::memory_order_relaxed);
    slot.secondaryRays.fetch_add(pixels.secondaryRays, std::memory_order_relaxed);
    slot.badPixels.fetch_add(pixels.badPixels, std::memory_order_relaxed);
    finish(slot, 1);
}

void FrameQueue::failed(const TileJob& job, std::exception_ptr reason) noexcept {
    Slot& slot = slots_[job.ticket];
    {
        std::lock_guard lock(mutex_);
        if (!slot.failure) slot.failure = std::move(reason);
    }
    // Drop the tiles that nobody has taken.
    const int64_t dropped = slot.waiting.exchange(0, std::memory_order_acq_rel);
    finish(slot, uint64_t(std::max<int64_t>(dropped, 0)) + 1);
}

void FrameQueue::finish(Slot& slot, uint64_t tiles) noexcept {
    if (slot.unfinished.fetch_sub(tiles, std::memory_order_acq_rel) == tiles) complete();
}

// Takes finished frames off the queue's head.
void FrameQueue::complete() noexcept {
    for (;;) {
        std::shared_ptr<const Frame> frame; // let go without the lock: it may own a whole scene
        {
            std::lock_guard lock(mutex_);
            if (completed_ == submitted_) return;
            Slot& slot = slotOf(completed_);
            if (slot.unfinished.load(std::memory_order_acquire) != 0) return;
            frame = std::move(slot.frame);
            slot.tiles = nullptr;
            statistics_.primaryRays += slot.primaryRays.load(std::memory_order_relaxed);
            statistics_.shadowRays += slot.shadowRays.load(std::memory_order_relaxed);
            statistics_.secondaryRays += slot.secondaryRays.load(std::memory_order_relaxed);
            statistics_.badPixels += slot.badPixels.load(std::memory_order_relaxed);
            if (const auto entry = failures_.find(frame->id); entry != failures_.end()) {
                if (slot.failure)
                    entry->second = std::exchange(slot.failure, nullptr);
                else
                    failures_.erase(entry);
            }
            ++completed_;
            if (dealing_.load(std::memory_order_relaxed) < completed_)
                dealing_.store(completed_, std::memory_order_release);
        }
        completedOne_.notify_all();
    }
}

const FrameQueue::Slot* FrameQueue::find(uint64_t frameId) const {
    for (uint64_t number = completed_; number < submitted_; ++number)
        if (const Slot& slot = slotOf(number); slot.frame->id == frameId) return &slot;
    return nullptr;
}

void FrameQueue::wait(uint64_t frameId) {
    std::exception_ptr failure;
    {
        std::unique_lock lock(mutex_);
        completedOne_.wait(lock, [&] { return !find(frameId); });
        if (const auto entry = failures_.find(frameId); entry != failures_.end()) {
            failure = entry->second;
            failures_.erase(entry);
        }
    }
    if (failure) std::rethrow_exception(failure);
}

void FrameQueue::waitAll() {
    std::unique_lock lock(mutex_);
    completedOne_.wait(lock, [&, last = submitted_] { return completed_ >= last; });
}

float FrameQueue::progress(uint64_t frameId) const {
    std::lock_guard lock(mutex_);
    const Slot* slot = find(frameId);
    if (!slot || slot->tiles->empty()) return 1.0f;
    const double total = double(slot->tiles->size());
    const double unfinished = double(slot->unfinished.load(std::memory_order_acquire));
    return float((total - unfinished) / total);
}

RenderStatistics FrameQueue::statistics() const {
    std::lock_guard lock(mutex_);
    return statistics_;
}

void FrameQueue::close() {
    {
        std::lock_guard lock(mutex_);
        closed_ = true;
    }
    submittedOrClosed_.notify_all();
}

void FrameQueue::open() {
    std::lock_guard lock(mutex_);
    closed_ = false;
}

} // namespace smart
