// SPDX-License-Identifier: MIT
#include "libsmart/render/frame_queue.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <future>
#include <latch>
#include <mutex>
#include <random>
#include <stdexcept>
#include <thread>
#include <vector>

#include "tests/libsmart/render/fake_frames.h"

namespace smart::test {
namespace {

using namespace std::chrono_literals;

TEST(FrameQueue, OneThreadAndManyWriteTheSamePixels) {
    TestFrame alone(7, 333, 217), together(7, 333, 217);
    FrameQueue sequential(1);
    submit(sequential, alone);
    sequential.close();
    work(sequential, FakeTracer());
    EXPECT_TRUE(isComplete(alone));

    FakeTracer tracer;
    FrameQueue queue(1);
    Team team(5, queue, tracer);
    EXPECT_EQ(submit(queue, together)->wait(), FrameStatus::Done);
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
    uint64_t pixels = 0;
    std::vector<QueuedFramePtr> queued;
    for (const TestFrame& f : frames) {
        queued.push_back(submit(queue, f));
        pixels += uint64_t(f.frame->target.width) * f.frame->target.height;
    }
    // A frame that is complete has all earlier ones complete.
    queued.back()->wait();
    for (std::size_t i = 0; i < kFrames; ++i) {
        EXPECT_TRUE(queued[i]->ended());
        EXPECT_EQ(queued[i]->status(), FrameStatus::Done);
        EXPECT_EQ(queued[i]->progress(), 1.0f);
        EXPECT_TRUE(isComplete(frames[i])) << frames[i].frame->id;
    }
    queue.waitAll();
    EXPECT_EQ(queue.statistics().primaryRays, pixels);
    EXPECT_EQ(queue.statistics().shadowRays * 3, queue.statistics().secondaryRays * 2);
    EXPECT_GT(queue.statistics().busyNanoseconds, 0u);
}

TEST(FrameQueue, HandsOutTilesOfTheNextFrameWhileTheLastIsRendered) {
    TestFrame first(1, 32, 32), second(2, 32, 32);
    FrameQueue queue(2);
    submit(queue, first);
    const QueuedFramePtr queued = submit(queue, second);
    TileJob a, b;
    ASSERT_TRUE(queue.next(a) && queue.next(b));
    EXPECT_EQ(a.frame->id, 1u);
    EXPECT_EQ(b.frame->id, 2u);
    const auto pixels = std::make_unique<TilePixels>();
    queue.done(b, *pixels);
    // The second frame waits for the first to be delivered.
    EXPECT_EQ(queued->status(), FrameStatus::Rendering);
    const auto waiting = std::async(std::launch::async, [&] { queued->wait(); });
    EXPECT_EQ(waiting.wait_for(20ms), std::future_status::timeout);
    queue.done(a, *pixels);
    EXPECT_EQ(waiting.wait_for(10s), std::future_status::ready);
}

TEST(FrameQueue, HandsOutFramesInOrder) {
    FrameQueue queue(2);
    const auto pixels = std::make_unique<TilePixels>();
    std::vector<TestFrame> frames;
    for (uint64_t id = 1; id <= 9; ++id) frames.emplace_back(id, 40, 20); // two tiles each
    submit(queue, frames[0]);
    TileJob job;
    for (uint64_t id = 1; id <= 9; ++id) {
        if (id < 9) submit(queue, frames[id]);
        for (int tile = 0; tile < 2; ++tile) {
            ASSERT_TRUE(queue.next(job));
            EXPECT_EQ(job.frame->id, id);
            queue.done(job, *pixels);
        }
    }
    queue.close();
    EXPECT_FALSE(queue.next(job));
}

TEST(FrameQueue, SubmitBlocksWhileTheQueueIsFull) {
    TestFrame frames[3] = {{1, 64, 64}, {2, 64, 64}, {3, 64, 64}};
    std::latch go(1);
    FakeTracer tracer([&](const Frame&, const Tile&) { go.wait(); });
    FrameQueue queue(2);
    Team team(2, queue, tracer);
    const QueuedFramePtr first = submit(queue, frames[0]);
    submit(queue, frames[1]); // does not block: two may be queued
    EXPECT_LT(first->progress(), 1.0f);
    auto third = std::async(std::launch::async, [&] { return submit(queue, frames[2]); });
    EXPECT_EQ(third.wait_for(50ms), std::future_status::timeout);
    go.count_down();
    third.get()->wait();
    for (const TestFrame& f : frames) EXPECT_TRUE(isComplete(f));
}

TEST(FrameQueue, TheDepthChangesWhileFramesAreInFlight) {
    std::vector<TestFrame> frames;
    for (uint64_t id = 1; id <= 12; ++id) frames.emplace_back(id, 40, 40);
    std::latch go(1);
    FakeTracer tracer([&](const Frame&, const Tile&) { go.wait(); });
    FrameQueue queue(1);
    Team team(2, queue, tracer);
    submit(queue, frames[0]);
    queue.setDepth(4000000000u); // costs nothing
    for (int i = 1; i < 11; ++i) submit(queue, frames[std::size_t(i)]);
    queue.setDepth(2); // those in flight go on
    EXPECT_EQ(queue.depth(), 2u);
    auto last = std::async(std::launch::async, [&] { return submit(queue, frames[11]); });
    EXPECT_EQ(last.wait_for(20ms), std::future_status::timeout);
    go.count_down();
    EXPECT_EQ(last.get()->wait(), FrameStatus::Done);
    for (const TestFrame& f : frames) EXPECT_TRUE(isComplete(f));
}

TEST(FrameQueue, FailedFrameIsReportedOnceAndTheNextGoesOn) {
    for (const unsigned threads : {1u, 2u}) {
        TestFrame bad(1, 320, 320), good(2, 320, 320);
        std::atomic<int> rendered{0};
        FakeTracer tracer([&](const Frame& frame, const Tile&) {
            if (frame.id != 1) return;
            if (rendered++ == 3) throw std::runtime_error("out of paper");
        });
        FrameQueue queue(2);
        Team team(threads, queue, tracer);
        const QueuedFramePtr failed = submit(queue, bad), next = submit(queue, good);
        EXPECT_EQ(failed->wait(), FrameStatus::Failed);
        try {
            std::rethrow_exception(failed->takeError());
        } catch (const std::runtime_error& error) {
            EXPECT_STREQ(error.what(), "out of paper");
        }
        // The other tiles are dropped; another thread may be far ahead until this one has said so.
        if (threads == 1) {
            EXPECT_EQ(rendered.load(), 4);
        }
        EXPECT_FALSE(failed->takeError());
        EXPECT_EQ(failed->progress(), 1.0f);
        EXPECT_EQ(next->wait(), FrameStatus::Done);
        EXPECT_FALSE(next->takeError());
        EXPECT_TRUE(isComplete(good));
    }
}

TEST(FrameQueue, AllTilesFailingAtOnce) {
    FakeTracer tracer([](const Frame&, const Tile&) { throw std::bad_alloc(); });
    FrameQueue queue(2);
    Team team(4, queue, tracer);
    for (uint64_t id = 1; id <= 20; ++id) {
        TestFrame f(id, 200, 200);
        const QueuedFramePtr queued = submit(queue, f);
        EXPECT_EQ(queued->wait(), FrameStatus::Failed);
        EXPECT_THROW(std::rethrow_exception(queued->takeError()), std::bad_alloc);
    }
}

TEST(FrameQueue, ProgressRisesFromZeroToOne) {
    TestFrame f(1, 128, 96);
    FrameQueue queue(1);
    const QueuedFramePtr queued = submit(queue, f);
    EXPECT_EQ(queued->progress(), 0.0f);
    EXPECT_EQ(queued->status(), FrameStatus::Queued);
    const auto pixels = std::make_unique<TilePixels>();
    TileJob job;
    for (int tile = 1; tile <= 12; ++tile) {
        ASSERT_TRUE(queue.next(job));
        EXPECT_EQ(queued->progress(), float((tile - 1) / 12.0)); // handed out is not finished
        EXPECT_EQ(queued->status(), FrameStatus::Rendering);
        queue.done(job, *pixels);
        EXPECT_EQ(queued->progress(), float(tile / 12.0));
    }
    EXPECT_EQ(queued->status(), FrameStatus::Done);
}

TEST(FrameQueue, ProgressSeenFromAnotherThreadNeverFalls) {
    FakeTracer tracer([](const Frame&, const Tile&) { std::this_thread::sleep_for(50us); });
    FrameQueue queue(2);
    Team team(3, queue, tracer);
    for (uint64_t id = 1; id <= 5; ++id) {
        TestFrame f(id, 300, 300);
        const QueuedFramePtr queued = submit(queue, f);
        float last = 0;
        FrameStatus status = FrameStatus::Queued;
        while (last < 1.0f) {
            const float now = queued->progress();
            ASSERT_GE(now, last);
            last = now;
            const FrameStatus next = queued->status();
            ASSERT_GE(int(next), int(status));
            status = next;
        }
        queued->wait();
        EXPECT_TRUE(isComplete(f));
    }
}

TEST(FrameQueue, FramesWithoutPixelsKeepTheirPlace) {
    FrameQueue queue(4);
    TestFrame none(1, 0, 0), full(2, 8, 8), flat(3, 0, 5);
    const QueuedFramePtr a = submit(queue, none), b = submit(queue, full), c = submit(queue, flat);
    TileJob job;
    ASSERT_TRUE(queue.next(job)); // frames end where their queue is worked on
    EXPECT_EQ(a->status(), FrameStatus::Done);
    EXPECT_FALSE(c->ended());
    queue.done(job, *std::make_unique<TilePixels>());
    EXPECT_EQ(b->wait(), FrameStatus::Done);
    EXPECT_EQ(c->wait(), FrameStatus::Done);
    queue.close();
    EXPECT_FALSE(queue.next(job));
}

TEST(FrameQueue, LetsGoOfFramesThatHaveEnded) {
    FrameQueue queue(2);
    std::weak_ptr<Frame> watch;
    QueuedFramePtr queued;
    {
        TestFrame f(1, 10, 10);
        watch = f.frame;
        queued = submit(queue, f);
        queue.close();
        work(queue, FakeTracer());
    }
    EXPECT_EQ(queued->status(), FrameStatus::Done);
    EXPECT_TRUE(watch.expired());
    queue.open();
    TestFrame again(2, 10, 10);
    submit(queue, again);
    TileJob job;
    EXPECT_TRUE(queue.next(job));
}

// The memory of frames in flight is never written by two of them, and the last one wins.
TEST(FrameQueue, AFrameWaitsForTheOneWhoseMemoryItWritesTo) {
    TestFrame first(1, 64, 32), second(2, 64, 32), other(3, 64, 32);
    second.frame->target.memory = first.memory.data() + 4 * 64 * 31; // one row in common
    second.frame->target.height = 1;
    FrameQueue queue(3);
    submit(queue, first);
    const QueuedFramePtr blocked = submit(queue, second);
    submit(queue, other);
    const auto pixels = std::make_unique<TilePixels>();
    TileJob jobs[4];
    for (TileJob& job : jobs) ASSERT_TRUE(queue.next(job));
    for (int i = 0; i < 4; ++i) EXPECT_EQ(jobs[i].frame->id, i < 2 ? 1u : 3u);
    queue.done(jobs[3], *pixels);
    queue.done(jobs[0], *pixels);
    EXPECT_EQ(blocked->status(), FrameStatus::Queued);
    queue.done(jobs[1], *pixels);
    ASSERT_TRUE(queue.next(jobs[0]));
    EXPECT_EQ(jobs[0].frame->id, 2u);
}

TEST(FrameQueue, AuxiliaryBuffersAreMemoryToo) {
    std::vector<float> depth(32 * 32);
    for (const bool shared : {false, true}) {
        TestFrame first(1, 32, 32), second(2, 32, 32);
        first.frame->target.aux.depth = depth.data();
        if (shared) second.frame->target.aux.distance = depth.data();
        FrameQueue queue(2);
        submit(queue, first);
        const QueuedFramePtr queued = submit(queue, second);
        TileJob a, b;
        ASSERT_TRUE(queue.next(a));
        queue.close();
        EXPECT_EQ(queue.next(b), !shared);
    }
}

TEST(FrameQueue, ManyFramesInOneMemoryByManyThreads) {
    TestFrame base(0, 100, 70);
    FakeTracer tracer;
    FrameQueue queue(5);
    Team team(4, queue, tracer);
    for (uint64_t id = 1; id <= 200; ++id) {
        const auto frame = std::make_shared<Frame>();
        frame->id = id;
        frame->target = base.frame->target;
        queue.submit(queue.prepare(frame));
        if (id % 50 != 0) continue;
        queue.waitAll();
        EXPECT_TRUE(isComplete(base.memory, 100, id));
    }
}

// While the queue holds a frame no worker waits, whatever the number of frames: of two the one
// renders all that there is while the other is still at the very first tile.
TEST(FrameQueue, WorkersAreBusyWhileTheQueueHoldsFrames) {
    constexpr uint64_t kFrames = 30;
    constexpr int kTiles = int(kFrames) * 16;
    std::mutex mutex;
    std::condition_variable changed;
    int begun = 0, ended = 0;
    bool allInTime = true;
    FakeTracer tracer([&](const Frame&, const Tile&) {
        std::unique_lock lock(mutex);
        if (begun++ == 0) // a minute: only where it would never be
            allInTime = changed.wait_for(lock, 60s, [&] { return ended == kTiles - 1; });
        ++ended;
        changed.notify_all();
    });
    std::vector<TestFrame> frames;
    for (uint64_t id = 0; id < kFrames; ++id) frames.emplace_back(id, 128, 128);
    FrameQueue queue(kFrames);
    std::vector<QueuedFramePtr> queued;
    for (const TestFrame& f : frames) queued.push_back(submit(queue, f));
    {
        Team team(2, queue, tracer);
        queue.waitAll();
    }
    EXPECT_TRUE(allInTime);
    EXPECT_EQ(ended, kTiles);
    for (const TestFrame& f : frames) EXPECT_TRUE(isComplete(f));
}

// A worker that has nothing to do is seen, and how long one is at a tile.
TEST(FrameQueue, TheTraceShowsWorkersThatWait) {
    FakeTracer tracer([](const Frame&, const Tile&) { std::this_thread::sleep_for(2ms); });
    FrameQueue queue(2);
    Team team(1, queue, tracer);
    TestFrame first(1, 32, 32), second(2, 32, 32);
    submit(queue, first)->wait();
    std::this_thread::sleep_for(200ms);
    const QueuedFramePtr late = submit(queue, second);
    late->wait();
    EXPECT_GT(late->statistics().idleNanoseconds, 20000000u);
    EXPECT_GE(late->statistics().busyNanoseconds, 2000000u);
}

} // namespace
} // namespace smart::test
