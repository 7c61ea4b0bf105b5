// SPDX-License-Identifier: MIT
#include "libsmart/render/frame_queue.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <latch>
#include <random>
#include <stdexcept>
#include <thread>
#include <vector>

#include "libsmart/render/worker.h"

namespace smart {
namespace {

using namespace std::chrono_literals;

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
        pixels.badPixels = 1;
    }

private:
    Before before_;
};

bool complete(const TestFrame& f) {
    const uint32_t width = f.frame->target.width;
    for (std::size_t i = 0; i < f.memory.size() / 4; ++i) {
        const float* p = &f.memory[4 * i];
        if (p[0] != float(i % width) || p[1] != float(i / width) || p[2] != float(f.frame->id))
            return false;
    }
    return true;
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

TEST(FrameQueue, OneThreadAndManyWriteTheSamePixels) {
    TestFrame alone(7, 333, 217), together(7, 333, 217);
    FrameQueue sequential(1);
    sequential.submit(alone.frame);
    sequential.close();
    work(sequential, FakeTracer());
    sequential.wait(7);
    EXPECT_TRUE(complete(alone));

    FakeTracer tracer;
    FrameQueue queue(1);
    Team team(5, queue, tracer);
    queue.submit(together.frame);
    queue.wait(7);
    EXPECT_EQ(alone.memory, together.memory);
}

TEST(FrameQueue, ManyFramesWithRandomDelaysCompleteInOrder) {
    constexpr uint64_t kFrames = 60;
    std::vector<TestFrame> frames;
    std::mt19937 random(1);
    for (uint64_t id = 1; id <= kFrames; ++id)
        frames.emplace_back(id, id % 7 == 0 ? 0 : 1 + random() % 150, 1 + random() % 150);
    FakeTracer tracer([](const Frame& frame, const Tile& tile) {
        const auto delay = (frame.id * 7919 + tile.x * 31 + tile.y) % 200;
        std::this_thread::sleep_for(std::chrono::microseconds(delay));
    });
    FrameQueue queue(3);
    Team team(4, queue, tracer);
    std::thread waiter([&] {
        for (uint64_t id = kFrames; id > 0; --id) queue.progress(id);
    });
    uint64_t pixels = 0;
    for (const TestFrame& f : frames) {
        queue.submit(f.frame);
        pixels += uint64_t(f.frame->target.width) * f.frame->target.height;
    }
    waiter.join();
    // A frame that is complete has all earlier ones complete.
    queue.wait(kFrames);
    for (const TestFrame& f : frames) {
        EXPECT_EQ(queue.progress(f.frame->id), 1.0f);
        EXPECT_TRUE(complete(f)) << f.frame->id;
    }
    EXPECT_EQ(queue.statistics().primaryRays, pixels);
    EXPECT_EQ(queue.statistics().shadowRays * 3, queue.statistics().secondaryRays * 2);
    EXPECT_EQ(queue.statistics().badPixels * 2, queue.statistics().shadowRays);
}

TEST(FrameQueue, HandsOutTilesOfTheNextFrameWhileTheLastIsRendered) {
    TestFrame first(1, 32, 32), second(2, 32, 32);
    FrameQueue queue(2);
    queue.submit(first.frame);
    queue.submit(second.frame);
    const auto a = queue.next();
    const auto b = queue.next();
    ASSERT_TRUE(a && b);
    EXPECT_EQ(a->frame->id, 1u);
    EXPECT_EQ(b->frame->id, 2u);
    const auto pixels = std::make_unique<TilePixels>();
    queue.done(*b, *pixels);
    // The second frame waits for the first to be delivered.
    const auto waiting = std::async(std::launch::async, [&] { queue.wait(2); });
    EXPECT_EQ(waiting.wait_for(20ms), std::future_status::timeout);
    queue.done(*a, *pixels);
    EXPECT_EQ(waiting.wait_for(10s), std::future_status::ready);
}

TEST(FrameQueue, HandsOutFramesInOrder) {
    FrameQueue queue(2);
    const auto pixels = std::make_unique<TilePixels>();
    std::vector<TestFrame> frames;
    for (uint64_t id = 1; id <= 9; ++id) frames.emplace_back(id, 40, 20); // two tiles each
    queue.submit(frames[0].frame);
    for (uint64_t id = 1; id <= 9; ++id) {
        if (id < 9) queue.submit(frames[id].frame);
        for (int tile = 0; tile < 2; ++tile) {
            const auto job = queue.next();
            ASSERT_TRUE(job);
            EXPECT_EQ(job->frame->id, id);
            queue.done(*job, *pixels);
        }
    }
    queue.close();
    EXPECT_FALSE(queue.next());
}

TEST(FrameQueue, SubmitBlocksWhileTheQueueIsFull) {
    TestFrame frames[3] = {{1, 64, 64}, {2, 64, 64}, {3, 64, 64}};
    std::latch go(1);
    FakeTracer tracer([&](const Frame&, const Tile&) { go.wait(); });
    FrameQueue queue(2);
    Team team(2, queue, tracer);
    queue.submit(frames[0].frame);
    queue.submit(frames[1].frame); // does not block: two may be queued
    EXPECT_LT(queue.progress(1), 1.0f);
    auto third = std::async(std::launch::async, [&] { queue.submit(frames[2].frame); });
    EXPECT_EQ(third.wait_for(50ms), std::future_status::timeout);
    go.count_down();
    third.get();
    queue.wait(3);
    for (const TestFrame& f : frames) EXPECT_TRUE(complete(f));
}

TEST(FrameQueue, FailedFrameIsReportedOnceAndTheNextGoesOn) {
    TestFrame bad(1, 320, 320), good(2, 320, 320);
    std::atomic<int> rendered{0};
    FakeTracer tracer([&](const Frame& frame, const Tile&) {
        if (frame.id != 1) return;
        if (rendered++ == 3) throw std::runtime_error("out of paper");
    });
    FrameQueue queue(2);
    Team team(2, queue, tracer);
    queue.submit(bad.frame);
    queue.submit(good.frame);
    try {
        queue.wait(1);
        FAIL() << "no exception";
    } catch (const std::runtime_error& error) {
        EXPECT_STREQ(error.what(), "out of paper");
    }
    EXPECT_LT(rendered.load(), 100); // the other tiles were dropped
    EXPECT_NO_THROW(queue.wait(1));
    EXPECT_NO_THROW(queue.wait(2));
    EXPECT_TRUE(complete(good));
    EXPECT_EQ(queue.progress(1), 1.0f);
}

TEST(FrameQueue, AllTilesFailingAtOnce) {
    FakeTracer tracer([](const Frame&, const Tile&) { throw std::bad_alloc(); });
    FrameQueue queue(2);
    Team team(4, queue, tracer);
    for (uint64_t id = 1; id <= 20; ++id) {
        TestFrame f(id, 200, 200);
        queue.submit(f.frame);
        EXPECT_THROW(queue.wait(id), std::bad_alloc);
    }
}

TEST(FrameQueue, ProgressRisesFromZeroToOne) {
    TestFrame f(1, 128, 96);
    FrameQueue queue(1);
    queue.submit(f.frame);
    EXPECT_EQ(queue.progress(1), 0.0f);
    const auto pixels = std::make_unique<TilePixels>();
    for (int tile = 1; tile <= 12; ++tile) {
        const auto job = queue.next();
        EXPECT_EQ(queue.progress(1), float((tile - 1) / 12.0)); // handed out is not finished
        queue.done(*job, *pixels);
        EXPECT_EQ(queue.progress(1), float(tile / 12.0));
    }
    EXPECT_EQ(queue.progress(99), 1.0f); // unknown
}

TEST(FrameQueue, ProgressSeenFromAnotherThreadNeverFalls) {
    FakeTracer tracer([](const Frame&, const Tile&) { std::this_thread::sleep_for(50us); });
    FrameQueue queue(2);
    Team team(3, queue, tracer);
    for (uint64_t id = 1; id <= 5; ++id) {
        TestFrame f(id, 300, 300);
        queue.submit(f.frame);
        float last = 0;
        while (last < 1.0f) {
            const float now = queue.progress(id);
            ASSERT_GE(now, last);
            last = now;
        }
        queue.wait(id);
        EXPECT_TRUE(complete(f));
    }
}

TEST(FrameQueue, FramesWithoutPixelsAreCompleteAtOnce) {
    FrameQueue queue(1);
    for (uint64_t id = 1; id <= 3; ++id) {
        TestFrame empty(id, 0, id == 2 ? 5 : 0);
        queue.submit(empty.frame);
        queue.wait(id); // nobody works here
        EXPECT_EQ(queue.progress(id), 1.0f);
    }
    // Behind a frame that is still rendered, they keep their place.
    FrameQueue two(2);
    TestFrame full(1, 8, 8), empty(2, 0, 0);
    two.submit(full.frame);
    two.submit(empty.frame);
    const auto job = two.next();
    two.done(*job, *std::make_unique<TilePixels>());
    two.wait(2);
    two.close();
    EXPECT_FALSE(two.next());
}

TEST(FrameQueue, LetsGoOfFramesThatAreComplete) {
    FrameQueue queue(2);
    std::weak_ptr<Frame> watch;
    {
        TestFrame f(1, 10, 10);
        watch = f.frame;
        queue.submit(f.frame);
        queue.close();
        work(queue, FakeTracer());
        queue.wait(1);
    }
    EXPECT_TRUE(watch.expired());
    queue.open();
    TestFrame again(2, 10, 10);
    queue.submit(again.frame);
    EXPECT_TRUE(queue.next());
}

} // namespace
} // namespace smart
