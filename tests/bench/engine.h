// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "tests/bench/workload.h"

namespace smart::bench {

/// What the engines say about a packet of a RaySet.
struct Found {
    float t[kPacketSize];
    uint32_t triangle[kPacketSize]; ///< kNoHit: nothing
};

struct BuildReport {
    double seconds = 0;
    std::size_t bytes = 0; ///< of all that traversal needs
};

/// One way to trace rays. Several threads may call it at once, each after enterThread().
class Engine {
public:
    virtual ~Engine() = default;
    virtual std::string name() const = 0;
    virtual bool peer() const = 0; ///< another library, the yardstick
    virtual void enterThread() const {}
    virtual void closest(const RaySet& rays, std::size_t first, std::size_t count,
                         Found* found) const = 0;
    /// Bit i of blocked[p]: something lies in the range of lane i.
    virtual void any(const RaySet& rays, std::size_t first, std::size_t count,
                     uint32_t* blocked) const = 0;
};

using EnginePtr = std::unique_ptr<const Engine>;

} // namespace smart::bench
