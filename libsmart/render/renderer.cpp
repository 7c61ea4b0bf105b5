// SPDX-License-Identifier: MIT
#include "libsmart/render/renderer.h"

#include <chrono>
#include <optional>
#include <utility>

#include "libsmart/render/frame_queue.h"
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

    void start() {
        if (team && !queue.deserted()) return;
        team.reset();
        queue.open();
        team.emplace(threads, queue, tracer);
    }
    void stop() {
        queue.waitAll();
        queue.close();
        team.reset();
        queue.open();
    }

    unsigned threads;
    FrameTracer tracer;
    FrameQueue queue{kQueueDepth, kPatience};
    std::optional<ThreadTeam> team;
};

Renderer::Renderer(unsigned threads) : implementation_(std::make_unique<Implementation>(threads)) {}
Renderer::~Renderer() = default;

QueuedFramePtr Renderer::prepare(std::shared_ptr<const Frame> frame,
                                 std::shared_ptr<FrameListener> listener) {
    QueuedFramePtr prepared =
        implementation_->queue.prepare(std::move(frame), std::move(listener));
    implementation_->start(); // from here on nobody goes home until the frame was rendered
    return prepared;
}

void Renderer::submit(QueuedFramePtr frame) noexcept {
    implementation_->queue.submit(std::move(frame));
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
