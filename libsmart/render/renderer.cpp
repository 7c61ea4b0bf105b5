// SPDX-License-Identifier: MIT
#include "libsmart/render/renderer.h"

#include <chrono>
#include <optional>
#include <utility>

#include "libsmart/render/frame_queue.h"
#include "libsmart/render/render_peers.h"
#include "libsmart/render/tracers.h"
#include "libsmart/render/worker.h"

namespace smart {
namespace {

constexpr unsigned kQueueDepth = 2; // one frame is rendered while the next is described

/// Idle threads keep a process that ends its main thread alone, and cost memory. Starting them anew
/// takes less than a tenth of a millisecond each.
constexpr std::chrono::seconds kPatience{3};

unsigned countOrAll(unsigned threads) {
    return threads != 0 ? threads : coreCount();
}

} // namespace

class Renderer::Implementation {
public:
    explicit Implementation(unsigned threadCount) : threads(countOrAll(threadCount)) {}
    ~Implementation() { stop(); }

    void join() {
        if (team || number == 0) return;
        if (RenderPeers* const peers = renderPeers()) participation = peers->join(queue, number);
    }
    void start() {
        if (team && !queue.deserted()) return;
        team.reset();
        queue.open();
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
    /// Threads of other processes count on those of this one: here nobody goes home.
    FrameQueue queue{kQueueDepth, number != 0 ? FrameQueue::kForever : kPatience};
    std::unique_ptr<Participation> participation; ///< nullptr: this process renders alone
    std::optional<ThreadTeam> team;
};

Renderer::Renderer(unsigned threads) : implementation_(std::make_unique<Implementation>(threads)) {}
Renderer::~Renderer() = default;

QueuedFramePtr Renderer::prepare(std::shared_ptr<const Frame> frame,
                                 std::shared_ptr<FrameListener> listener) {
    implementation_->join();
    if (implementation_->participation)
        listener = implementation_->participation->listener(std::move(listener));
    QueuedFramePtr prepared =
        implementation_->queue.prepare(std::move(frame), std::move(listener));
    implementation_->start(); // from here on nobody goes home until the frame was rendered
    return prepared;
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
