// SPDX-License-Identifier: MIT
#include "libsmart/render/renderer.h"

#include <optional>
#include <utility>

#include "libsmart/render/frame_queue.h"
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
        if (!team) team.emplace(threads, queue, tracer);
    }
    void stop() {
        queue.waitAll();
        queue.close();
        team.reset();
        queue.open();
    }

    unsigned threads;
    FrameTracer tracer;
    FrameQueue queue{kQueueDepth};
    std::optional<ThreadTeam> team;
};

Renderer::Renderer(unsigned threads) : implementation_(std::make_unique<Implementation>(threads)) {}
Renderer::~Renderer() = default;

QueuedFramePtr Renderer::prepare(std::shared_ptr<const Frame> frame,
                                 std::shared_ptr<FrameListener> listener) {
    implementation_->start();
    return implementation_->queue.prepare(std::move(frame), std::move(listener));
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
