// SPDX-License-Identifier: MIT
#pragma once

#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>

#include "libsmart/remote/remote_service.h"

namespace smart {

/// One renderer of a RemoteService: its threads render what the master asks for.
class TileServer final : public Participation, public TileSource {
public:
    TileServer(RemoteService& service, FrameQueue& queue, uint64_t renderer);
    ~TileServer() override;

    unsigned threads(unsigned) const override;
    TileSource& source() override { return *this; }
    std::shared_ptr<FrameListener> listener(std::shared_ptr<FrameListener> own) override {
        return own;
    }
    void submitting(const QueuedFramePtr& frame) noexcept override;
    void sharePicture(const PixelTarget& picture) override;
    void close() noexcept override;

    bool next(TileJob& job) override;
    void done(TileJob& job, const TilePixels& pixels) override;
    void failed(TileJob& job, std::exception_ptr reason) noexcept override;

    /// Queues a tile of a frame of this renderer's.
    void ask(const TileRequest& request, std::shared_ptr<const Frame> frame);
    /// Tiles of it that no thread has begun are not wanted any more.
    void dropRequests(FrameKey frame);
    FrameQueue& queue() { return queue_; }

private:
    struct Request {
        uint64_t ticket = 0;
        FrameKey key;
        std::shared_ptr<const Frame> frame;
        Tile tile;
        bool mayPack = false;
    };

    RemoteService& service_;
    FrameQueue& queue_;
    const uint64_t renderer_;
    std::mutex mutex_; // guards what follows
    std::condition_variable news_;
    std::deque<Request> requests_;
    bool closed_ = false;
};

} // namespace smart
