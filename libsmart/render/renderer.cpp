// SPDX-License-Identifier: MIT
#include "libsmart/render/renderer.h"

#include <optional>
#include <utility>

#include "libsmart/render/frame_queue.h"
#include "libsmart/render/packet_tracer.h"
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
    PacketTracer tracer;
    FrameQueue queue{kQueueDepth};
    std::optional<ThreadTeam> team;
};

Renderer::Renderer(unsigned threads) : implementation_(std::make_unique<Implementation>(threads)) {}
Renderer::~Renderer() = default;

void Renderer::submit(std::shared_ptr<const Frame> frame) {
    implementation_->start();
    implementation_->queue.submit(std::move(frame));
}

void Renderer::wait(uint64_t frameId) {
    implementation_->queue.wait(frameId);
}

float Renderer::progress(uint64_t frameId) const {
    return implementation_->queue.progress(frameId);
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
