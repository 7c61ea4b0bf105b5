// SPDX-License-Identifier: MIT
#include "samples/vr/latency_report.h"

#include <algorithm>
#include <cstdio>
#include <utility>

namespace samples {

LatencyReport::LatencyReport(std::vector<std::string> events) {
    for (std::string& name : events) events_.push_back({std::move(name), {}});
}

void LatencyReport::happened(std::size_t event) {
    events_[event].milliseconds.push_back(
        std::chrono::duration<double, std::milli>(Clock::now() - read_).count());
}

void LatencyReport::print() const {
    std::printf("milliseconds from the head's pose    median     worst\n");
    for (const Event& event : events_) {
        std::vector<double> sorted = event.milliseconds;
        if (sorted.size() > 1) sorted.erase(sorted.begin());
        if (sorted.empty()) continue;
        std::sort(sorted.begin(), sorted.end());
        std::printf("%-34s  %7.1f   %7.1f\n", event.name.c_str(), sorted[sorted.size() / 2],
                    sorted.back());
    }
}

} // namespace samples
