// SPDX-License-Identifier: MIT
#pragma once

#include <condition_variable>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "libsmart/remote/answer_packing.h"
#include "libsmart/remote/call_bytes.h"
#include "libsmart/remote/remote_workers.h"

namespace smart {

/// A process that works for another: it makes the calls that the master makes, and renders tiles
/// that the master asks for. Its frames are handed out by the master and end when that says so.
class RemoteService final : public RenderPeers {
public:
    /// The transport, which has to outlive it, has the master as its only peer. threads: that
    /// render, whatever the calls say. codec: the master's, or nullptr.
    RemoteService(Transport& transport, const std::string& identity, unsigned threads,
                  const ByteCodec* codec = nullptr, Packing packing = Packing::WhenItPays);
    /// No renderer may take part any more.
    ~RemoteService() override;

    /// Waits for the master's next call; false: it has left.
    bool nextCall(std::vector<std::byte>& record);
    /// Tells the master why this process can not go on. It is asked for nothing more.
    void giveUp(const std::string& reason) noexcept;
    void waitForLeave();

    std::unique_ptr<Participation> join(FrameQueue& queue, uint64_t renderer) override;
    AnswerPacker& packer() { return packer_; }

private:
    friend class TileServer;

    struct KnownFrame {
        std::shared_ptr<const Frame> frame;
        QueuedFramePtr queued;
        class TileServer* server = nullptr;
    };

    void enter(uint64_t renderer, const QueuedFramePtr& frame, class TileServer& server);
    void leaveOut(const class TileServer& server);
    void takePicture(uint64_t renderer, const PixelTarget& picture);
    void count(std::size_t bytes); ///< of calls and pictures, with mutex_
    void send(const Message& message);

    void receive();
    void take(const CallBytes& calls);
    void take(const TileRequest& request);
    void take(const FrameOver& over);
    void take(const PictureBytes& picture);
    void take(const Leave&);
    template <class Other>
    void take(const Other&);
    void end() noexcept;

    Transport& transport_;
    const unsigned threads_;
    AnswerPacker packer_;

    std::mutex endMutex_; // held while queues are told of ends; taken before mutex_
    std::mutex mutex_;    // guards what follows
    std::condition_variable news_;
    CallAssembler calls_;
    std::map<FrameKey, KnownFrame> frames_;
    std::map<FrameKey, bool> over_; ///< of frames that are still to come: whether they were done
    std::map<FrameKey, std::pair<std::vector<std::byte>, bool>> pictures_; ///< whole or not
    std::map<uint64_t, uint64_t> lastFrame_, lastPicture_; ///< numbers by renderer
    uint64_t taken_ = 0, told_ = 0; ///< bytes of calls and pictures
    bool ended_ = false;
    std::atomic<bool> stopped_{false};
    std::jthread receiver_; // last: ends before what it uses
};

} // namespace smart
