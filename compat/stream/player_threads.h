// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>

namespace smart::compat {

/// A thread for each of a recorded program; one of them runs at a time. The first number that is
/// asked for is the calling thread itself.
class PlayerThreads {
public:
    explicit PlayerThreads(unsigned most);
    ~PlayerThreads();
    /// Runs work there and waits for its end; rethrows what it throws. Throws StreamError where
    /// there would be too many threads.
    void run(uint16_t number, const std::function<void()>& work);

private:
    class Thread;
    unsigned most_;
    int first_ = -1;
    std::map<uint16_t, std::unique_ptr<Thread>> threads_;
};

} // namespace smart::compat
