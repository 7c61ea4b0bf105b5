// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "libsmart/render/queued_frame.h"
#include "libsmart/render/render_statistics.h"

namespace smart {

/// Owns the frame queue and a team of threads that empty it. Belongs to one context's thread.
class Renderer {
public:
    /// threads: 0 = all cores. No thread is started before the first frame.
    explicit Renderer(unsigned threads = 0);
    /// Waits for the frames that are queued.
    ~Renderer();

    /// Makes ready to render a frame: everything that may fail. Throws where no thread can be
    /// started or memory is out.
    QueuedFramePtr prepare(std::shared_ptr<const Frame> frame,
                           std::shared_ptr<FrameListener> listener = nullptr);
    /// Queues the frame and returns at once, unless as many as the queue's depth are incomplete:
    /// then it waits until one is. Frames are rendered and completed in order.
    void submit(QueuedFramePtr frame) noexcept;
    /// A finished picture in its memory is going to be read by what frames are made of.
    void sharePicture(const PixelTarget& picture);
    /// Waits for all frames that are queued.
    void waitAll();
    /// How many frames may be incomplete at once; 2 at the start.
    void setDepth(unsigned depth);
    unsigned depth() const;
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
