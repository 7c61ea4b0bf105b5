// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>

#include "libsmart/render/frame.h"

namespace smart {

/// Sums over the tiles of finished frames.
struct RenderStatistics {
    uint64_t primaryRays = 0, shadowRays = 0, secondaryRays = 0, badPixels = 0;
};

/// Owns the frame queue and a team of threads that empty it. Belongs to one context's thread.
class Renderer {
public:
    /// threads: 0 = all cores. No thread is started before the first frame.
    explicit Renderer(unsigned threads = 0);
    /// Waits for the frames that are queued.
    ~Renderer();

    /// Queues a frame and returns at once. Frames are rendered and completed in order.
    void submit(std::shared_ptr<const Frame> frame);
    /// Waits until the frame of this id is complete and forgets it; rethrows what made it fail.
    void wait(uint64_t frameId);
    /// 0..1, never decreasing; 1 for a frame that is complete or unknown. From any thread.
    float progress(uint64_t frameId) const;
    /// Waits for all queued frames, then changes the number of threads.
    void setThreads(unsigned threads);
    unsigned threads() const;
    /// Of all frames completed so far.
    RenderStatistics statistics() const;

private:
    class Implementation;
    std::unique_ptr<Implementation> implementation_;
};

} // namespace smart
