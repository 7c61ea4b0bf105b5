// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <memory>
#include <thread>

#include "libsmart/remote/remote_workers.h"

namespace smart {

/// Takes tiles of one renderer's frames for RemoteWorkers, while some peer has room for them. The
/// renderer's own threads work as ever.
class TileFeeder final : public Participation {
public:
    /// Throws std::system_error.
    TileFeeder(RemoteWorkers& workers, FrameQueue& queue, uint64_t renderer);
    ~TileFeeder() override;

    unsigned threads(unsigned own) const override { return own; }
    TileSource& source() override { return queue_; }
    std::shared_ptr<FrameListener> listener(std::shared_ptr<FrameListener> own) override;
    void submitting(const QueuedFramePtr& frame) noexcept override;
    void sharePicture(const PixelTarget& picture) override;
    void close() noexcept override;

private:
    void run();

    RemoteWorkers& workers_;
    FrameQueue& queue_;
    const uint64_t renderer_;
    const std::shared_ptr<QueueLink> link_ = std::make_shared<QueueLink>();
    std::atomic<bool> closing_{false};
    std::jthread thread_;
};

} // namespace smart
