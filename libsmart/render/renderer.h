// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>

#include "libsmart/render/frame.h"
#include "libsmart/render/render_statistics.h"

namespace smart {

/// Owns the frame queue and a team of threads that empty it. Belongs to one context's thread.
class Renderer {
public:
    /// threads: 0 = all cores. No thread is started before the first frame.
    explicit Renderer(unsigned threads = 0);
    /// Waits for the frames that are queued.
    ~Renderer();

    /// Queues a frame and returns at once, unless two are queued already: then it waits for the
    /// first. Frames are rendered and completed in order. Throws where no thread can be started
    /// or memory is out; the frame is not queued then.
    void submit(std::shared_ptr<const Frame> frame);
    /// Waits until the frame of this id is complete and forgets it; rethrows what made it fail.
    void wait(uint64_t frameId);
    /// 0..1, never decreasing; 1 for a frame that is complete or unknown. From any thread.
    float progress(uint64_t frameId) const;
    /// Waits for all queued frames, then changes the number of threads; 0 = all cores.
    void setThreads(unsigned threads);
    unsigned threads() const;
    /// Of all frames completed so far.
    RenderStatistics statistics() const;

private:
    class Implementation;
    std::unique_ptr<Implementation> implementation_;
};

} // namespace smart
