// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <span>
#include <string>
#include <thread>
#include <unordered_map>
#include <utility>
#include <vector>

#include "libsmart/remote/answer_packing.h"
#include "libsmart/remote/tile_patience.h"
#include "libsmart/remote/transport.h"
#include "libsmart/render/render_peers.h"

namespace smart {

struct RemoteOptions {
    const ByteCodec* codec = nullptr; ///< for what travels; the same in all processes
    std::string identity; ///< of the library
    /// Tiles that a peer has at once for each of its threads: one under way, the others hide the
    /// latency.
    unsigned tilesAhead = 3;
    /// After so long without an answer a tile is given to others too; later where all tiles take
    /// long (TilePatience).
    std::chrono::milliseconds stallAfter{1000};
    /// A peer that takes in no calls for so long while others wait for it is left out.
    std::chrono::milliseconds deafAfter{30000};
    uint64_t window = uint64_t(512) << 20; ///< bytes of calls that a peer may lag behind
};

/// Sums since the start.
struct RemoteTraffic {
    uint64_t callBytes = 0; ///< of calls and pictures, once for all peers
    uint64_t answerBytes = 0; ///< of pixels, as they came
    uint64_t pixelBytes = 0;  ///< and as they are
    uint64_t tilesSent = 0, tilesAnswered = 0, tilesReturned = 0;
};

/// A frame queue as remote workers see it; the queue ends before its users do.
struct QueueLink {
    std::mutex mutex; // held while the queue is used
    SharedTileSource* queue = nullptr;
};

/// The process that the application runs in, as its peers know it. It gives them all calls of the
/// interface and tiles of all frames, those that they are ready for. Whatever a peer does or does
/// not, frames are completed: its tiles go to others.
class RemoteWorkers final : public RenderPeers {
public:
    /// Is told why a peer takes part no more, or that it was late for the first time; from any
    /// thread. Where something has to be changed (another library, a plug-in that it lacks), that
    /// is an error of the next frame too.
    using Warn = std::function<void(const std::string&)>;

    /// The transport has to outlive it.
    RemoteWorkers(Transport& transport, RemoteOptions options, Warn warn);
    /// No renderer may take part any more.
    ~RemoteWorkers() override;

    /// A call is about to be made. Waits for peers that lag far behind.
    void addCall(std::span<const std::byte> record);
    /// Sends what addCall() kept together.
    void flushCalls();
    /// Tells all peers that there is no more to do. Nothing may follow, but renderers may end
    /// later.
    void leave() noexcept;

    std::unique_ptr<Participation> join(FrameQueue& queue, uint64_t renderer) override;

    /// Peers that take part now.
    unsigned working() const;
    /// Waits until each peer takes part or never will; false: not in this time.
    bool waitForPeers(std::chrono::milliseconds timeout);
    RemoteTraffic traffic() const;

private:
    friend class TileFeeder;
    using Clock = std::chrono::steady_clock;

    struct Peer {
        bool greeted = false, gone = false;
        bool wasLate = false;
        bool stalled = false; ///< a tile of it is late, and it has answered nothing since
        unsigned room = 0;    ///< tiles that it may have beyond those that it has
        uint64_t taken = 0;   ///< bytes of calls and pictures
        uint64_t arrived = 0; ///< bytes of pixels, as they came
        bool takesTiles() const { return greeted && !gone && !stalled && room > 0; }
    };
    struct Ticket {
        TileJob job;
        std::shared_ptr<QueueLink> link;
        unsigned peer = 0;
        StoredLayout layout;   ///< of the answer
        std::size_t bytes = 0;
        Clock::time_point sent;
    };
    struct SharedFrame {
        QueuedFramePtr queued;
        FrameQueue* queue = nullptr;
        uint64_t fingerprint = 0;
        std::vector<bool> ready; ///< by peer
    };
    struct EarlyPeer {
        unsigned peer;
        uint64_t fingerprint;
    };

    // Of feeders:
    bool waitForRoom(const std::atomic<bool>& closing);
    void wakeFeeders();
    /// Sends the tile to a peer, or gives it back.
    void hand(TileJob& job, const std::shared_ptr<QueueLink>& link,
              const std::atomic<bool>& closing);
    void shareFrame(uint64_t renderer, const QueuedFramePtr& frame, FrameQueue& queue);
    void endFrame(const QueuedFrame& frame, bool done) noexcept;
    void sharePicture(uint64_t renderer, const PixelTarget& picture);
    void forget(const QueueLink& link);

    void receive();
    void handle(unsigned peer, std::span<const std::byte> bytes);
    void take(unsigned peer, const Hello& hello);
    void take(unsigned peer, const FrameReady& ready);
    void take(unsigned peer, const TileAnswer& answer);
    void take(unsigned peer, const Progress& progress);
    [[noreturn]] void take(unsigned peer, const Trouble& trouble);
    template <class Other>
    [[noreturn]] void take(unsigned peer, const Other&);
    void drop(unsigned peer, const std::string& reason, bool isError = false) noexcept;
    void giveBackStalled();
    void markReady(SharedFrame& frame, unsigned peer);
    void sendToAll(const Message& message);
    void sendCalls(); ///< with callMutex_
    void waitForSlowPeers();

    Transport& transport_;
    const RemoteOptions options_;
    const Warn warn_;

    mutable std::mutex mutex_; // guards what follows
    std::condition_variable room_, changed_;
    std::vector<Peer> peers_;
    std::unordered_map<uint64_t, Ticket> tickets_;
    uint64_t lastTicket_ = 0;
    TilePatience patience_;
    std::map<FrameKey, SharedFrame> frames_;
    std::map<FrameKey, std::vector<EarlyPeer>> early_; ///< of frames that are still to come
    std::map<uint64_t, uint64_t> lastFrame_, lastPicture_; ///< numbers by renderer
    RemoteTraffic traffic_;
    std::string error_; ///< to be told with the next frame; empty: none

    std::mutex callMutex_; // guards what follows; taken before mutex_
    std::vector<std::byte> calls_;
    uint64_t sentBytes_ = 0;

    AnswerUnpacker unpacker_; // of the thread that receives, but for one question
    std::atomic<bool> stopped_{false};
    std::atomic<unsigned> present_{0}; ///< peers that are not gone
    std::jthread receiver_;            // last: ends before what it uses
};

} // namespace smart
