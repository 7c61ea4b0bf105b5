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

/// One way to trace rays. Several threads may trace at once, each after enterThread().
class Engine {
public:
    virtual ~Engine() = default;
    virtual std::string name() const = 0;
    virtual bool peer() const = 0;                 ///< another library, the yardstick
    virtual bool robust() const { return false; }  ///< a peer in its more exact form
    virtual void enterThread() const {}
    /// Brings rays into memory of the engine's own form, where it has one: not part of the time.
    virtual void load(const RaySet&, Query) {}
    virtual void closest(const RaySet& rays, std::size_t first, std::size_t count,
                         Found* found) const = 0;
    /// Bit i of blocked[p]: something lies in the range of lane i.
    virtual void any(const RaySet& rays, std::size_t first, std::size_t count,
                     uint32_t* blocked) const = 0;
    /// The answers of an engine that left them in memory of its own, which it gives back; only
    /// that of the query is written to. Not part of the time.
    virtual void unload(const RaySet&, Found*, uint32_t*) {}
};

using EnginePtr = std::unique_ptr<Engine>;

} // namespace smart::bench
