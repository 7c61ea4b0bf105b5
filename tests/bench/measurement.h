// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <span>

#include "tests/bench/agreement.h"

namespace smart::bench {

enum class Kind { Primary, Shadow };

/// One engine at one kind of rays and one number of threads.
struct Result {
    std::string engine;
    bool peer = false;
    std::vector<double> mraysPerSecond; ///< one for each repeat
    Mistakes mistakes;
    /// Too many wrong answers: the speeds mean nothing. A peer stays the yardstick that it is, its
    /// wrong answers printed beside.
    bool refused = false;

    double median() const;
};

struct Series {
    Kind kind;
    unsigned threads;
    std::size_t rays;
    std::vector<Result> results;
};

using Progress = std::function<void(const std::string&)>;

/// All engines in turn, `repeats` times over, so that a disturbance meets all alike; then their
/// answers are compared.
Series measure(const std::vector<Triangle>& triangles, const RaySet& rays, Kind kind,
               std::span<const EnginePtr> engines, unsigned threads, unsigned repeats,
               const Progress& progress);

} // namespace smart::bench
