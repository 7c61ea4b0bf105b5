// SPDX-License-Identifier: MIT
#include "libsmart/render/queued_frame.h"

#include <string>
#include <utility>

#include "libsmart/base/error.h"

namespace smart {

QueuedFrame::QueuedFrame(std::shared_ptr<const Frame> frame, Tiles tiles,
                         std::shared_ptr<FrameListener> listener,
                         std::shared_ptr<QueueSignal> signal)
    : signal_(std::move(signal)),
      tileCount_(tiles->size()),
      frame_(std::move(frame)),
      tiles_(std::move(tiles)),
      listener_(std::move(listener)),
      waiting_(int64_t(tileCount_)),
      unfinished_(tileCount_) {
    const PixelTarget& target = frame_->target;
    std::size_t count = 0;
    const auto add = [&](const void* memory, std::size_t bytes) {
        const auto first = reinterpret_cast<uintptr_t>(memory);
        if (memory) memory_[count++] = {first, first + bytes};
    };
    const std::size_t pixels = std::size_t(target.width) * target.height;
    if (pixels == 0) return;
    const std::size_t row = target.width * bytesPerPixel(target.format);
    add(target.memory, (target.height - 1) * (target.stride ? target.stride : row) + row);
    const AuxBuffers& aux = target.aux;
    for (const void* values : {static_cast<const void*>(aux.depth),
                               static_cast<const void*>(aux.distance),
                               static_cast<const void*>(aux.objectId),
                               static_cast<const void*>(aux.instanceId),
                               static_cast<const void*>(aux.primitiveId)})
        add(values, 4 * pixels);
    add(aux.normal, 12 * pixels);
}

QueuedFrame::~QueuedFrame() {
    if (!announced_) return;
    const std::lock_guard lock(signal_->mutex);
    --signal_->announced;
}

bool QueuedFrame::sharesMemoryWith(const QueuedFrame& other) const noexcept {
    for (const Memory& a : memory_)
        for (const Memory& b : other.memory_)
            if (a.first < b.end && b.first < a.end) return true;
    return false;
}

FrameStatus QueuedFrame::outcomeSoFar() const noexcept {
    return failed_.load(std::memory_order_acquire)      ? FrameStatus::Failed
           : cancelled_.load(std::memory_order_acquire) ? FrameStatus::Cancelled
                                                        : FrameStatus::Done;
}

FrameStatus QueuedFrame::status() const noexcept {
    const FrameStatus outcome = outcome_.load(std::memory_order_acquire);
    if (outcome != FrameStatus::Queued) return outcome;
    if (unfinished_.load(std::memory_order_acquire) == 0 &&
        cancelled_.load(std::memory_order_acquire))
        return outcomeSoFar();
    return waiting_.load(std::memory_order_relaxed) == int64_t(tileCount_)
               ? FrameStatus::Queued
               : FrameStatus::Rendering;
}

float QueuedFrame::progress() const noexcept {
    if (tileCount_ == 0) return 1.0f;
    const uint64_t unfinished = unfinished_.load(std::memory_order_acquire);
    return float(double(tileCount_ - unfinished) / double(tileCount_));
}

void QueuedFrame::cancel() noexcept {
    const int64_t dropped = waiting_.exchange(0, std::memory_order_acq_rel);
    if (dropped <= 0) return;
    signal_->cancelled.fetch_add(1, std::memory_order_relaxed);
    cancelled_.store(true, std::memory_order_release);
    if (unfinished_.fetch_sub(uint64_t(dropped), std::memory_order_acq_rel) != uint64_t(dropped))
        return; // who finishes the last tile ends the frame
    {
        const std::lock_guard lock(signal_->mutex);
        signal_->settled.store(true, std::memory_order_release);
    }
    signal_->work.notify_one();
}

FrameStatus QueuedFrame::wait() const {
    std::unique_lock lock(mutex_);
    endedSignal_.wait(lock, [&] { return ended_; });
    return outcome_.load(std::memory_order_acquire);
}

bool QueuedFrame::ended() const {
    const std::lock_guard lock(mutex_);
    return ended_;
}

void QueuedFrame::end() noexcept {
    const FrameStatus outcome = outcomeSoFar();
    if (outcome == FrameStatus::Done) keepBadPixels();
    outcome_.store(outcome, std::memory_order_release);
    if (listener_) listener_->ended(*this, outcome);
    frame_.reset();
    tiles_.reset();
    listener_.reset();
    {
        const std::lock_guard lock(mutex_);
        ended_ = true;
    }
    endedSignal_.notify_all();
}

void QueuedFrame::keepBadPixels() noexcept {
    const uint64_t bad = badPixels_.load(std::memory_order_relaxed);
    if (bad == 0) return;
    try {
        throw Error(ErrorCode::InvalidOperation,
                    "the picture is complete, but " + std::to_string(bad) +
                        (bad == 1 ? " pixel is" : " pixels are") +
                        " black: a shader failed there, or its colour was not finite");
    } catch (...) {
        keepError(std::current_exception());
    }
}

void QueuedFrame::keepError(std::exception_ptr error) noexcept {
    const std::lock_guard lock(mutex_);
    if (!error_) error_ = std::move(error);
}

std::exception_ptr QueuedFrame::takeError() noexcept {
    const std::lock_guard lock(mutex_);
    return std::exchange(error_, nullptr);
}

template <class Result>
void QueuedFrame::count(const Result& tile) noexcept {
    primaryRays_.fetch_add(tile.primaryRays, std::memory_order_relaxed);
    shadowRays_.fetch_add(tile.shadowRays, std::memory_order_relaxed);
    secondaryRays_.fetch_add(tile.secondaryRays, std::memory_order_relaxed);
    badPixels_.fetch_add(tile.badPixels, std::memory_order_relaxed);
}
template void QueuedFrame::count(const TilePixels&) noexcept;
template void QueuedFrame::count(const StoredTile&) noexcept;

void QueuedFrame::countTime(uint64_t busyNanoseconds, uint64_t idleNanoseconds) noexcept {
    busyNanoseconds_.fetch_add(busyNanoseconds, std::memory_order_relaxed);
    idleNanoseconds_.fetch_add(idleNanoseconds, std::memory_order_relaxed);
}

RenderStatistics QueuedFrame::statistics() const noexcept {
    const auto now = [](const std::atomic<uint64_t>& counter) {
        return counter.load(std::memory_order_relaxed);
    };
    return {now(primaryRays_), now(shadowRays_),      now(secondaryRays_),
            now(badPixels_),   now(busyNanoseconds_), now(idleNanoseconds_)};
}

} // namespace smart
