// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <thread>
#include <vector>

#include "libsmart/render/tile_source.h"
#include "libsmart/render/tracer.h"

namespace smart {

/// The loop of every worker: renders tiles until the source sends it home.
void work(TileSource& source, const Tracer& tracer);

/// Threads that work for one source. Signals of the process are left to the application's own
/// threads: no handler of it ever runs in a worker.
class ThreadTeam {
public:
    /// Starts up to `threads` workers; throws std::system_error if not even one can be.
    ThreadTeam(unsigned threads, TileSource& source, const Tracer& tracer);
    /// Waits for the workers: the source has to send them home.
    ~ThreadTeam() = default;

private:
    std::vector<std::jthread> threads_;
};

/// A thread of the library's that may hand tiles back and therefore tell of frames: as those of a
/// ThreadTeam are, but for what it does. Throws std::system_error.
std::jthread startWorkerThread(const char* name, std::function<void()> run);

/// Whether the calling thread is one of a ThreadTeam's: it must not wait for frames.
bool onWorkerThread() noexcept;

/// Processor cores that this process may use; at least 1.
unsigned coreCount();

} // namespace smart
