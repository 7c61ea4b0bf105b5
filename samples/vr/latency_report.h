// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

namespace samples {

/// How long after the head's pose was read its pictures are there.
class LatencyReport {
public:
    using Clock = std::chrono::steady_clock;

    explicit LatencyReport(std::vector<std::string> events);
    void poseRead() { read_ = Clock::now(); }
    /// The event-th happens, of the moment of the last pose.
    void happened(std::size_t event);
    /// A table: the median and the worst of each, in milliseconds. Without the first moment, in
    /// which objects are compiled, where there are others.
    void print() const;

private:
    struct Event {
        std::string name;
        std::vector<double> milliseconds;
    };
    Clock::time_point read_ = Clock::now();
    std::vector<Event> events_;
};

} // namespace samples
