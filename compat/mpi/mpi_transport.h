// SPDX-License-Identifier: MIT
#pragma once

#include <mpi.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "compat/mpi/lz4_codec.h"
#include "compat/mpi/mpi_component.h"

namespace smart::compat {

/// One thread makes all calls of MPI, from the first to the last, and none of them waits for
/// another rank, but for the end. MPI does not tell that a rank is gone, so rank 0 lets the others
/// hear from it every few seconds, and they take it for lost when they have not for long.
class MpiTransport final : public MpiRanks {
public:
    /// Throws std::runtime_error where MPI can not be used.
    MpiTransport();
    ~MpiTransport() override;
    MpiTransport(const MpiTransport&) = delete;
    MpiTransport& operator=(const MpiTransport&) = delete;

    unsigned rank() const override { return unsigned(rank_); }
    const ByteCodec& codec() const override { return codec_; }
    unsigned peers() const override { return unsigned(peers_.size()); }
    std::string peerName(unsigned peer) const override;
    void send(unsigned peer, Packet packet) override;
    Event receive(std::chrono::microseconds timeout, unsigned& peer,
                  std::vector<std::byte>& message) override;
    void flush(std::chrono::milliseconds timeout) override;
    bool finish(std::chrono::milliseconds timeout) noexcept override;

private:
    struct Sending {
        unsigned peer = 0;
        Packet packet;
    };
    struct Peer {
        std::deque<Packet> outgoing;
        unsigned underWay = 0; ///< messages that MPI has
        bool closed = false;
    };
    struct Arrival {
        Event event = Event::Nothing;
        unsigned peer = 0;
        std::vector<std::byte> message;
    };

    void run();
    std::string start(); ///< why it can not; empty: it did
    bool startSends();
    bool endSends();
    bool takeMessage();
    void sendHeartbeats();
    void loseLocked(unsigned peer);
    int rankOf(unsigned peer) const { return rank_ == 0 ? int(peer) + 1 : 0; }

    // Of the thread that calls MPI:
    MPI_Comm ranks_ = MPI_COMM_NULL;
    std::vector<MPI_Request> requests_;
    std::vector<Sending> sending_; ///< to requests_
    std::vector<MPI_Request> heartbeats_; ///< the last one to each peer
    std::chrono::steady_clock::time_point lastHeartbeat_, lastHeard_;
    std::chrono::seconds silence_{};

    const Lz4Codec codec_;
    int rank_ = 0;
    mutable std::mutex mutex_; // guards what follows
    std::condition_variable wake_, arrived_, changed_;
    std::vector<Peer> peers_;
    std::deque<Arrival> arrivals_;
    std::size_t unsent_ = 0; ///< messages that MPI has not finished with
    uint64_t moved_ = 0; ///< messages that were sent or came
    bool started_ = false, finishing_ = false, finished_ = false;
    std::string problem_;
    std::thread thread_;
};

} // namespace smart::compat
