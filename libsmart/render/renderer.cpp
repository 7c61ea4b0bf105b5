// SPDX-License-Identifier: MIT
#include "libsmart/render/renderer.h"

#include <optional>
#include <utility>

#include "libsmart/render/frame_queue.h"
#include "libsmart/render/render_peers.h"
#include "libsmart/render/tracers.h"
#include "libsmart/render/worker.h"

namespace smart {
namespace {

constexpr unsigned kQueueDepth = 2; // one frame is rendered while the next is described

unsigned countOrAll(unsigned threads) {
    return threads != 0 ? threads : coreCount();
}

} // namespace

class Renderer::Implementation {
public:
    explicit Implementation(unsigned threadCount) : threads(countOrAll(threadCount)) {}
    ~Implementation() { stop(); }

    void start() {
        if (team) return;
        RenderPeers* const peers = number != 0 ? renderPeers() : nullptr;
        if (peers) participation = peers->join(queue, number);
        if (participation)
            team.emplace(participation->threads(threads), participation->source(), tracer);
        else
            team.emplace(threads, queue, tracer);
    }
    void stop() {
        queue.waitAll();
        queue.close();
        if (participation) participation->close();
        team.reset();
        participation.reset();
        queue.open();
    }

    const uint64_t number = nextRendererNumber();
    unsigned threads;
    FrameTracer tracer;
    FrameQueue queue{kQueueDepth};
    std::unique_ptr<Participation> participation; ///< nullptr: this process renders alone
    std::optional<ThreadTeam> team;
};

Renderer::Renderer(unsigned threads) : implementation_(std::make_unique<Implementation>(threads)) {}
Renderer::~Renderer() = default;

QueuedFramePtr Renderer::prepare(std::shared_ptr<const Frame> frame,
                                 std::shared_ptr<FrameListener> listener) {
    implementation_->start();
    if (implementation_->participation)
        listener = implementation_->participation->listener(std::move(listener));
    return implementation_->queue.prepare(std::move(frame), std::move(listener));
}

void Renderer::submit(QueuedFramePtr frame) noexcept {
    if (implementation_->participation) implementation_->participation->submitting(frame);
    implementation_->queue.submit(std::move(frame));
}

void Renderer::sharePicture(const PixelTarget& picture) {
    implementation_->start();
    if (implementation_->participation) implementation_->participation->sharePicture(picture);
}

void Renderer::waitAll() {
    implementation_->queue.waitAll();
}

void Renderer::setDepth(unsigned depth) {
    implementation_->queue.setDepth(depth);
}

unsigned Renderer::depth() const {
    return implementation_->queue.depth();
}

void Renderer::setThreads(unsigned threads) {
    implementation_->stop();
    implementation_->threads = countOrAll(threads);
}

unsigned Renderer::threads() const {
    return implementation_->threads;
}

RenderStatistics Renderer::statistics() const {
    return implementation_->queue.statistics();
}

} // namespace smart
