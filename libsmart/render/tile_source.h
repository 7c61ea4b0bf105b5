// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <exception>
#include <memory>

#include "libsmart/render/frame.h"

namespace smart {

struct TileJob {
    const Frame* frame = nullptr; ///< lives until the job is handed back
    Tile tile;
    // The source's own; workers leave them as they are, from one job to the next.
    std::shared_ptr<void> ticket;
    std::chrono::steady_clock::time_point since; ///< start of this job, or end of the last
};

/// The whole contract between those who have work and those who do it: threads, other machines
/// and tests are callers alike. Thread-safe. A worker has one TileJob, empty at first, which it
/// gives to next() again and again and hands back in between, to done() or failed().
class TileSource {
public:
    virtual ~TileSource() = default;
    /// Blocks until there is work, and puts it into the job. False: go home.
    virtual bool next(TileJob& job) = 0;
    virtual void done(TileJob& job, const TilePixels& pixels) = 0;
    virtual void failed(TileJob& job, std::exception_ptr reason) noexcept = 0;
};

} // namespace smart
