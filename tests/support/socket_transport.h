// SPDX-License-Identifier: MIT
// Messages over stream sockets: between the processes of a test on one machine.
#pragma once

#include <cstddef>
#include <deque>
#include <mutex>
#include <vector>

#include "libsmart/remote/transport.h"

namespace smart::test {

/// A connected pair of sockets; each end belongs to one SocketTransport.
struct SocketPair {
    SocketPair();
    int here = -1, there = -1;
};

class SocketTransport final : public Transport {
public:
    /// One socket for each peer; it closes them in the end.
    explicit SocketTransport(const std::vector<int>& sockets);
    ~SocketTransport() override;
    SocketTransport(const SocketTransport&) = delete;
    SocketTransport& operator=(const SocketTransport&) = delete;

    unsigned peers() const override { return unsigned(peers_.size()); }
    std::string peerName(unsigned peer) const override;
    void send(unsigned peer, Packet packet) override;
    Event receive(std::chrono::microseconds timeout, unsigned& peer,
                  std::vector<std::byte>& message) override;
    void flush(std::chrono::milliseconds timeout) override;

private:
    struct Peer {
        int socket = -1;
        bool closed = false, told = false;
        std::vector<std::byte> incoming;
        std::size_t taken = 0;      ///< of incoming
        std::deque<Packet> outgoing;
        std::size_t sent = 0; ///< of the first of outgoing
    };
    bool take(Peer& peer, std::vector<std::byte>& message);
    static void write(Peer& peer);
    static void read(Peer& peer);
    void pollAll(std::chrono::microseconds timeout);

    std::mutex mutex_; // guards outgoing, sent and closed
    std::vector<Peer> peers_;
    std::size_t next_ = 0; ///< whose turn it is
    int wake_ = -1;
};

} // namespace smart::test
