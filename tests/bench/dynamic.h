// SPDX-License-Identifier: MIT
// Scenes that change, step by step, in every engine; and whole frames of them.
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <ostream>
#include <span>

#include "tests/bench/dynamic_engine.h"

namespace smart::bench {

/// Medians over the steps, in seconds.
struct DynamicResult {
    std::string engine;
    bool peer = false;
    double update = 0, build = 0, trace = 0;
    double step = 0;           ///< all three together
    std::size_t bytes = 0;
    double differing = 0;      ///< share of the rays with another answer than the last engine
    bool refused = false;      ///< too many: the speeds mean nothing
};

struct DynamicSeries {
    std::string scene;
    uint32_t instances = 1;
    std::size_t triangles = 0;
    std::vector<DynamicResult> results;
};

/// Frames through the queue's front door, one at a time: medians in seconds.
struct DynamicFrame {
    uint32_t instances = 1;
    bool lit = false;    ///< by one light with shadows; else flat colours
    double describe = 0; ///< the application's calls
    double freeze = 0;   ///< rtQueueFrame, mostly the tree over the instances: processor seconds
    double render = 0;   ///< until the frame has ended
    double whole = 0;    ///< all three together
};

struct DynamicReport {
    unsigned threads = 1;
    uint32_t size = 0;
    std::vector<DynamicSeries> series;
    std::vector<DynamicFrame> frames;

    bool anyRefused() const;
    nlohmann::json json() const;
};
std::ostream& operator<<(std::ostream& out, const DynamicReport& report);

struct DynamicOptions {
    std::vector<uint32_t> instances{100, 1000, 10000};
    uint32_t sheet = 200000; ///< triangles; 0: none
    uint32_t size = 512;
    unsigned threads = 1, repeat = 9;
    bool embree = false;
    bool plantError = false; ///< the first engine of a series stays a step behind
};

using DynamicProgress = std::function<void(const std::string&)>;

/// Engines take turns at each step; the first step is not counted.
DynamicReport measureDynamic(const DynamicOptions& options, const DynamicProgress& progress);
/// One frame after another, like rtRender.
DynamicFrame measureFrame(const DynamicScene& scene, const DynamicOptions& options, bool lit);

/// Seconds that the rays take by so many threads, from the moment when all are ready.
double timedTrace(const DynamicEngine& engine, const RaySet& rays, unsigned threads,
                  std::vector<DynamicFound>& found);

double median(std::vector<double> values);

} // namespace smart::bench
