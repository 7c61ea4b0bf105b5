// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <condition_variable>
#include <mutex>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "libsmart/remote/transport.h"
#include "tests/fuzz/input.h"

namespace openrt::test {

/// Peers that send what the input says: messages that fit to what they were sent, and any others.
/// At the input's end they close.
class ForgedTransport final : public smart::Transport {
public:
    static constexpr const char* kIdentity = "test";
    static constexpr uint32_t kWidth = 40, kHeight = 36; ///< of every frame, in four floats a pixel

    /// The input belongs to the thread that receives. fingerprints: of the frames from number 1 on.
    ForgedTransport(Input& input, unsigned peers, std::vector<uint64_t> fingerprints);

    unsigned peers() const override { return unsigned(requests_.size()); }
    std::string peerName(unsigned peer) const override { return std::to_string(peer); }
    void send(unsigned peer, smart::Packet packet) override;
    Event receive(std::chrono::microseconds timeout, unsigned& peer,
                  std::vector<std::byte>& message) override;
    void flush(std::chrono::milliseconds) override {}

private:
    smart::Packet next(unsigned peer);
    smart::Packet fitting(unsigned peer, uint8_t type);
    smart::FrameKey key();
    std::vector<std::byte> someBytes();
    /// Waits a little, and not too often, until something is so.
    template <class Condition>
    void waitFor(std::unique_lock<std::mutex>& lock, Condition condition);

    Input& input_;
    const std::vector<uint64_t> fingerprints_;
    unsigned closed_ = 0;
    int patience_ = 8;

    std::mutex mutex_; // guards what follows
    std::condition_variable news_;
    std::vector<std::vector<uint64_t>> requests_; ///< tickets by peer, without answer
    std::vector<std::size_t> requestBytes_;       ///< of the answers to the latest, by peer
    std::set<smart::FrameKey> ready_;
};

/// As encode() does it, of any type and payload.
smart::Packet framed(uint16_t type, std::span<const std::byte> payload);

} // namespace openrt::test
