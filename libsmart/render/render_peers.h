// SPDX-License-Identifier: MIT
// Where a process that renders together with others comes in.
#pragma once

#include <memory>

#include "libsmart/render/frame_queue.h"

namespace smart {

/// What one renderer has to do with other processes; from its first frame until its threads end.
class Participation {
public:
    virtual ~Participation() = default;
    /// How many threads the renderer shall have where its context asks for `own`.
    virtual unsigned threads(unsigned own) const = 0;
    /// What those threads work for.
    virtual TileSource& source() = 0;
    /// Who is told of a frame instead of `own`, whom it tells.
    virtual std::shared_ptr<FrameListener> listener(std::shared_ptr<FrameListener> own) = 0;
    /// A frame is about to be queued.
    virtual void submitting(const QueuedFramePtr& frame) noexcept = 0;
    /// A finished picture becomes part of what later frames show. The processes that lack it get
    /// it from the one that has it.
    virtual void sharePicture(const PixelTarget& picture) = 0;
    /// The queue is closed and all its frames have ended: no thread of this object, and none that
    /// works for source(), remains in a call of the queue.
    virtual void close() noexcept = 0;
};

/// The other processes.
class RenderPeers {
public:
    virtual ~RenderPeers() = default;
    /// renderer: its number.
    virtual std::unique_ptr<Participation> join(FrameQueue& queue, uint64_t renderer) = 0;
};

/// Of this process; nullptr: it renders alone. Renderers look when their threads start.
RenderPeers* renderPeers() noexcept;
void setRenderPeers(RenderPeers* peers) noexcept;
/// For a new renderer: counts from 1 since there are peers; 0 without them, and for good.
uint64_t nextRendererNumber() noexcept;

} // namespace smart
