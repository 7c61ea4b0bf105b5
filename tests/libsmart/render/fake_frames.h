// SPDX-License-Identifier: MIT
// Frames of a known colour at every pixel, and threads that render them.
#pragma once

#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "libsmart/render/frame_queue.h"
#include "libsmart/render/worker.h"

namespace smart::test {

/// A frame with its own memory, four floats a pixel.
struct TestFrame {
    std::vector<float> memory;
    std::shared_ptr<Frame> frame = std::make_shared<Frame>();

    TestFrame(uint64_t id, uint32_t width, uint32_t height)
        : memory(std::size_t(width) * height * 4, -1.0f) {
        frame->id = id;
        frame->target.memory = memory.data();
        frame->target.width = width;
        frame->target.height = height;
        frame->target.format = PixelFormat::Rgba32f;
    }
};

/// Colours each pixel by its place and its frame; `before` may wait or throw.
class FakeTracer final : public Tracer {
public:
    using Before = std::function<void(const Frame&, const Tile&)>;
    explicit FakeTracer(Before before = {}) : before_(std::move(before)) {}

    void render(const Frame& frame, const Tile& tile, TilePixels& pixels) const override {
        if (before_) before_(frame, tile);
        for (uint32_t j = 0; j < tile.height; ++j)
            for (uint32_t i = 0; i < tile.width; ++i)
                pixels.color[j * kTileSize + i] = {float(tile.x + i), float(tile.y + j),
                                                   float(frame.id), 1.0f};
        pixels.primaryRays = uint64_t(tile.width) * tile.height;
        pixels.shadowRays = 2;
        pixels.secondaryRays = 3;
        pixels.badPixels = 0;
    }

private:
    Before before_;
};

/// Whether memory of so many floats holds all of the frame, as FakeTracer colours it.
inline bool isComplete(const std::vector<float>& memory, uint32_t width, uint64_t frameId) {
    for (std::size_t i = 0; i < memory.size() / 4; ++i) {
        const float* p = &memory[4 * i];
        if (p[0] != float(i % width) || p[1] != float(i / width) || p[2] != float(frameId))
            return false;
    }
    return true;
}
inline bool isComplete(const TestFrame& f) {
    return isComplete(f.memory, f.frame->target.width, f.frame->id);
}

inline QueuedFramePtr submit(FrameQueue& queue, const TestFrame& f,
                             std::shared_ptr<FrameListener> listener = nullptr) {
    QueuedFramePtr queued = queue.prepare(f.frame, std::move(listener));
    queue.submit(queued);
    return queued;
}

/// Threads on a queue, sent home at the end.
class Team {
public:
    Team(unsigned threads, FrameQueue& queue, const Tracer& tracer)
        : queue_(queue), team_(threads, queue, tracer) {}
    ~Team() { queue_.close(); }

private:
    FrameQueue& queue_;
    ThreadTeam team_;
};

} // namespace smart::test
