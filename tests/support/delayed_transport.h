// SPDX-License-Identifier: MIT
// A slow network: what comes is delivered later.
#pragma once

#include <algorithm>
#include <deque>
#include <utility>
#include <vector>

#include "libsmart/remote/transport.h"

namespace smart::test {

/// Each message takes `latency`, and all of them share a line of so many bytes a second (0: no
/// limit). Of the direction that is received.
class DelayedTransport final : public Transport {
public:
    DelayedTransport(Transport& inner, std::chrono::microseconds latency,
                     double bytesPerSecond = 0)
        : inner_(inner), latency_(latency), bytesPerSecond_(bytesPerSecond) {}

    unsigned peers() const override { return inner_.peers(); }
    std::string peerName(unsigned peer) const override { return inner_.peerName(peer); }
    void send(unsigned peer, Packet packet) override { inner_.send(peer, std::move(packet)); }
    void flush(std::chrono::milliseconds timeout) override { inner_.flush(timeout); }
    Event receive(std::chrono::microseconds timeout, unsigned& peer,
                  std::vector<std::byte>& message) override {
        const Clock::time_point end = Clock::now() + timeout;
        for (;;) {
            const Clock::time_point now = Clock::now();
            if (!line_.empty() && line_.front().due <= now) {
                Delivery delivery = std::move(line_.front());
                line_.pop_front();
                peer = delivery.peer;
                message.swap(delivery.message);
                return delivery.event;
            }
            if (now >= end) return Event::Nothing;
            const Clock::time_point until =
                line_.empty() ? end : std::min(end, line_.front().due);
            Delivery next;
            next.event = inner_.receive(
                std::chrono::duration_cast<std::chrono::microseconds>(until - now), next.peer,
                next.message);
            if (next.event == Event::Nothing) continue;
            const Clock::time_point came = Clock::now();
            if (bytesPerSecond_ > 0) {
                const std::chrono::duration<double> busy(double(next.message.size()) /
                                                         bytesPerSecond_);
                free_ = std::max(free_, came) + std::chrono::duration_cast<Clock::duration>(busy);
            } else {
                free_ = came;
            }
            next.due = free_ + latency_;
            line_.push_back(std::move(next));
        }
    }

private:
    using Clock = std::chrono::steady_clock;
    struct Delivery {
        Event event = Event::Nothing;
        unsigned peer = 0;
        std::vector<std::byte> message;
        Clock::time_point due;
    };
    Transport& inner_;
    const std::chrono::microseconds latency_;
    const double bytesPerSecond_;
    std::deque<Delivery> line_;
    Clock::time_point free_;
};

} // namespace smart::test
