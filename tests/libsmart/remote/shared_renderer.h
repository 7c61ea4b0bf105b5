// SPDX-License-Identifier: MIT
// A renderer of frames of known colours that takes part with other processes.
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "libsmart/render/render_peers.h"
#include "tests/libsmart/render/fake_frames.h"

namespace smart::test {

class SharedRenderer {
public:
    SharedRenderer(RenderPeers& peers, uint64_t number, unsigned threads,
                   FakeTracer::Before before = {})
        : tracer_(std::move(before)), participation_(peers.join(queue_, number)) {
        team_.emplace(participation_->threads(threads), participation_->source(), tracer_);
    }
    ~SharedRenderer() {
        queue_.waitAll();
        queue_.close();
        participation_->close();
        team_.reset();
    }
    QueuedFramePtr submit(const TestFrame& frame) {
        QueuedFramePtr queued = queue_.prepare(frame.frame, participation_->listener(nullptr));
        participation_->submitting(queued);
        queue_.submit(queued);
        return queued;
    }
    Participation& participation() { return *participation_; }
    RenderStatistics statistics() const { return queue_.statistics(); }

private:
    FakeTracer tracer_;
    FrameQueue queue_{2};
    std::unique_ptr<Participation> participation_;
    std::optional<ThreadTeam> team_;
};

/// The record of a call that renders a frame.
struct FrameCall {
    uint64_t id = 0;
    uint32_t width = 0, height = 0;
    uint32_t picture = 0; ///< 1: and shares the picture
    uint32_t unused = 0;
};

} // namespace smart::test
