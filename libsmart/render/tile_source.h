// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <mutex>

#include "libsmart/render/frame.h"

namespace smart {

/// A tile that several may be at work on, because one of them gave it back: the first result
/// counts.
struct TileClaim {
    std::mutex mutex; // guards settled, and the writing of the tile
    bool settled = false;
    // Of the source, while the tile waits to be handed out again:
    Tile tile;
    std::shared_ptr<TileClaim> behind;
};

struct TileJob {
    const Frame* frame = nullptr; ///< lives until the job is handed back
    Tile tile;
    // The source's own; workers leave them as they are, from one job to the next.
    std::shared_ptr<void> ticket;
    std::chrono::steady_clock::time_point since; ///< start of this job, or end of the last
    // Of SharedTileSource:
    std::shared_ptr<TileClaim> claim;
    bool remote = false;   ///< for another machine, which counts its time itself
    bool returned = false; ///< given back, and perhaps answered yet
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

/// A tile rendered elsewhere, in the target's formats (libsmart/render/stored_tile.h).
struct StoredTile {
    const std::byte* bytes = nullptr; ///< storedTileSize() of them
    uint64_t primaryRays = 0, shadowRays = 0, secondaryRays = 0, badPixels = 0;
    uint64_t busyNanoseconds = 0;
};

/// For workers that may be lost, or so slow that others should do their tiles. To next() they give
/// jobs that are `remote` and have a new claim, and get tiles of those frames alone that may be
/// rendered on other machines.
class SharedTileSource : public TileSource {
public:
    /// Like done().
    virtual void answered(TileJob& job, const StoredTile& tile) = 0;
    /// Hands the tile to others. The job may be dropped afterwards, or be answered while the
    /// source exists: the frame no longer waits for that, and takes it if nobody was faster.
    virtual void returned(TileJob& job) noexcept = 0;
};

} // namespace smart
