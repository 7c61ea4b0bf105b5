// SPDX-License-Identifier: MIT
#include "libsmart/remote/tile_feeder.h"

#include <utility>

#include "libsmart/render/worker.h"

namespace smart {
namespace {

/// Tells the peers when a frame is over, after whoever else hears of it.
class SharedFrameListener final : public FrameListener {
public:
    SharedFrameListener(std::function<void(const QueuedFrame&, bool)> over,
                        std::shared_ptr<FrameListener> own)
        : over_(std::move(over)), own_(std::move(own)) {}
    void tileDone(QueuedFrame& frame, const Tile& tile) noexcept override {
        if (own_) own_->tileDone(frame, tile);
    }
    void ended(QueuedFrame& frame, FrameStatus status) noexcept override {
        if (own_) own_->ended(frame, status);
        over_(frame, status == FrameStatus::Done);
    }

private:
    const std::function<void(const QueuedFrame&, bool)> over_;
    const std::shared_ptr<FrameListener> own_;
};

} // namespace

TileFeeder::TileFeeder(RemoteWorkers& workers, FrameQueue& queue, uint64_t renderer)
    : workers_(workers), queue_(queue), renderer_(renderer) {
    link_->queue = &queue;
    thread_ = startWorkerThread("feeder", [this] { run(); });
}

TileFeeder::~TileFeeder() {
    close();
}

std::shared_ptr<FrameListener> TileFeeder::listener(std::shared_ptr<FrameListener> own) {
    return std::make_shared<SharedFrameListener>(
        [&workers = workers_](const QueuedFrame& frame, bool done) {
            workers.endFrame(frame, done);
        },
        std::move(own));
}

void TileFeeder::submitting(const QueuedFramePtr& frame) noexcept {
    try {
        workers_.shareFrame(renderer_, frame, queue_);
    } catch (...) { // out of memory: this process renders the frame alone
    }
}

void TileFeeder::sharePicture(const PixelTarget& picture) {
    workers_.sharePicture(renderer_, picture);
}

void TileFeeder::close() noexcept {
    closing_ = true;
    workers_.wakeFeeders();
    if (thread_.joinable()) thread_.join();
    {
        const std::lock_guard lock(link_->mutex);
        link_->queue = nullptr;
    }
    workers_.forget(*link_);
}

void TileFeeder::run() {
    TileJob job;
    job.remote = true;
    while (workers_.waitForRoom(closing_)) {
        job.claim = std::make_shared<TileClaim>();
        job.returned = false;
        if (!queue_.next(job)) return;
        workers_.hand(job, link_, closing_);
    }
}

} // namespace smart
