// SPDX-License-Identifier: MIT
// A renderer that takes part with other processes, without the interface above it.
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "libsmart/render/render_peers.h"
#include "tests/libsmart/render/fake_frames.h"

namespace smart::test {

class SharedRenderer {
public:
    SharedRenderer(RenderPeers& peers, uint64_t number, unsigned threads, const Tracer& tracer)
        : participation_(peers.join(queue_, number)) {
        team_.emplace(participation_->threads(threads), participation_->source(), tracer);
    }
    ~SharedRenderer() {
        queue_.waitAll();
        queue_.close();
        participation_->close();
        team_.reset();
    }
    QueuedFramePtr submit(const std::shared_ptr<const Frame>& frame) {
        QueuedFramePtr queued = queue_.prepare(frame, participation_->listener(nullptr));
        participation_->submitting(queued);
        queue_.submit(queued);
        return queued;
    }
    QueuedFramePtr submit(const TestFrame& frame) { return submit(frame.frame); }
    Participation& participation() { return *participation_; }

private:
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
