// SPDX-License-Identifier: MIT
#include "tests/support/socket_transport.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <stdexcept>
#include <utility>

namespace smart::test {

SocketPair::SocketPair() {
    int both[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, both) != 0)
        throw std::runtime_error("no pair of sockets");
    here = both[0];
    there = both[1];
}

SocketTransport::SocketTransport(const std::vector<int>& sockets)
    : peers_(sockets.size()), wake_(eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {
    for (std::size_t i = 0; i < sockets.size(); ++i) {
        peers_[i].socket = sockets[i];
        fcntl(sockets[i], F_SETFL, fcntl(sockets[i], F_GETFL) | O_NONBLOCK);
    }
}

SocketTransport::~SocketTransport() {
    for (const Peer& peer : peers_) ::close(peer.socket);
    ::close(wake_);
}

std::string SocketTransport::peerName(unsigned peer) const {
    return "process " + std::to_string(peer + 1);
}

void SocketTransport::write(Peer& peer) {
    while (!peer.outgoing.empty() && !peer.closed) {
        const std::vector<std::byte>& bytes = *peer.outgoing.front();
        const ssize_t count = ::send(peer.socket, bytes.data() + peer.sent,
                                     bytes.size() - peer.sent, MSG_NOSIGNAL | MSG_DONTWAIT);
        if (count < 0) {
            if (errno != EAGAIN && errno != EINTR) peer.closed = true;
            break;
        }
        peer.sent += std::size_t(count);
        if (peer.sent < bytes.size()) continue;
        peer.outgoing.pop_front();
        peer.sent = 0;
    }
    if (peer.closed) peer.outgoing.clear();
}

void SocketTransport::read(Peer& peer) {
    if (peer.taken > peer.incoming.size() / 2) {
        peer.incoming.erase(peer.incoming.begin(),
                            peer.incoming.begin() + std::ptrdiff_t(peer.taken));
        peer.taken = 0;
    }
    std::byte buffer[1 << 16];
    const ssize_t count = ::recv(peer.socket, buffer, sizeof buffer, MSG_DONTWAIT);
    if (count > 0)
        peer.incoming.insert(peer.incoming.end(), buffer, buffer + count);
    else if (count == 0 || (errno != EAGAIN && errno != EINTR))
        peer.closed = true;
}

void SocketTransport::send(unsigned peer, Packet packet) {
    const std::lock_guard lock(mutex_);
    Peer& p = peers_[peer];
    if (p.closed) return;
    p.outgoing.push_back(std::move(packet));
    write(p);
    if (p.outgoing.empty()) return;
    const uint64_t one = 1; // the rest is written by who receives
    [[maybe_unused]] const ssize_t written = ::write(wake_, &one, sizeof one);
}

bool SocketTransport::take(Peer& peer, std::vector<std::byte>& message) {
    const std::span<const std::byte> left = std::span(peer.incoming).subspan(peer.taken);
    if (left.size() < kHeaderSize) return false;
    std::size_t length = messageLength(left.first<kHeaderSize>());
    if (length == 0) { // nobody knows where the next one begins
        const std::lock_guard lock(mutex_);
        peer.closed = true;
        peer.taken = peer.incoming.size();
        return false;
    }
    if (left.size() < length) return false;
    message.assign(left.begin(), left.begin() + std::ptrdiff_t(length));
    peer.taken += length;
    return true;
}

void SocketTransport::pollAll(std::chrono::microseconds timeout) {
    std::vector<pollfd> waiting{{wake_, POLLIN, 0}};
    {
        const std::lock_guard lock(mutex_);
        for (const Peer& p : peers_)
            waiting.push_back({p.closed ? -1 : p.socket,
                               short(p.outgoing.empty() ? POLLIN : POLLIN | POLLOUT), 0});
    }
    const auto count = std::max<std::int64_t>(timeout.count(), 0);
    const timespec time{count / 1000000, count % 1000000 * 1000};
    if (ppoll(waiting.data(), waiting.size(), &time, nullptr) <= 0) return;
    uint64_t wakes = 0;
    if (waiting[0].revents) [[maybe_unused]] const ssize_t n = ::read(wake_, &wakes, sizeof wakes);
    const std::lock_guard lock(mutex_);
    for (std::size_t i = 0; i < peers_.size(); ++i) {
        if (waiting[i + 1].revents & POLLOUT) write(peers_[i]);
        if (waiting[i + 1].revents & (POLLIN | POLLHUP | POLLERR)) read(peers_[i]);
    }
}

Transport::Event SocketTransport::receive(std::chrono::microseconds timeout, unsigned& peer,
                                          std::vector<std::byte>& message) {
    const auto end = std::chrono::steady_clock::now() + timeout;
    for (bool late = false;; late = std::chrono::steady_clock::now() >= end) {
        for (std::size_t i = 0; i < peers_.size(); ++i) {
            next_ = (next_ + 1) % peers_.size();
            peer = unsigned(next_);
            if (take(peers_[next_], message)) return Event::Arrived;
            const std::lock_guard lock(mutex_);
            if (peers_[next_].closed && !std::exchange(peers_[next_].told, true))
                return Event::Closed;
        }
        if (late) return Event::Nothing;
        pollAll(std::chrono::duration_cast<std::chrono::microseconds>(
            end - std::chrono::steady_clock::now()));
    }
}

void SocketTransport::flush(std::chrono::milliseconds timeout) {
    const auto end = std::chrono::steady_clock::now() + timeout;
    for (;;) {
        bool empty = true;
        {
            const std::lock_guard lock(mutex_);
            for (Peer& p : peers_) {
                write(p);
                empty = empty && p.outgoing.empty();
            }
        }
        if (empty || std::chrono::steady_clock::now() >= end) return;
        usleep(1000);
    }
}

} // namespace smart::test
