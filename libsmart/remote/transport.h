// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

#include "libsmart/remote/wire.h"

namespace smart {

/// Carries messages between this process and others, its peers, numbered from 0. Messages of one
/// peer arrive whole and in order, or not at all. What they hold may be anything.
class Transport {
public:
    enum class Event { Nothing, Arrived, Closed };

    virtual ~Transport() = default;
    virtual unsigned peers() const = 0;
    /// For people.
    virtual std::string peerName(unsigned peer) const = 0;
    /// From any thread; never waits. What a closed peer would get is lost.
    virtual void send(unsigned peer, Packet packet) = 0;
    /// What came, and from whom; each peer is closed once at most. One thread at a time.
    virtual Event receive(std::chrono::microseconds timeout, unsigned& peer,
                          std::vector<std::byte>& message) = 0;
    /// Waits until what was sent so far is on its way, or for so long.
    virtual void flush(std::chrono::milliseconds timeout) = 0;
};

} // namespace smart
