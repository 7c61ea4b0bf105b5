// SPDX-License-Identifier: MIT
// Cancelling frames, and what listeners hear.
#include "libsmart/render/queued_frame.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <future>
#include <mutex>
#include <random>
#include <stdexcept>
#include <thread>
#include <vector>

#include "tests/libsmart/render/fake_frames.h"

namespace smart::test {
namespace {

using namespace std::chrono_literals;

/// Notes what it is told of each frame, and that it is told by workers only.
class Listener final : public FrameListener {
public:
    struct Heard {
        uint64_t frame;
        FrameStatus status;
        uint64_t pixels; ///< in tiles before
    };
    void tileDone(QueuedFrame& frame, const Tile& tile) noexcept override {
        const std::lock_guard lock(mutex_);
        expect(frame.frame().id == current(frame).frame);
        current(frame).pixels += uint64_t(tile.width) * tile.height;
        expect(frame.progress() < 1.0f && !frame.ended());
    }
    void ended(QueuedFrame& frame, FrameStatus status) noexcept override {
        const std::lock_guard lock(mutex_);
        current(frame).status = status;
        expect(frame.status() == status && frame.progress() == 1.0f && !frame.ended());
        inOrder_.push_back(current(frame));
        if (atEnd) atEnd(frame);
    }
    std::vector<Heard> inOrder() {
        const std::lock_guard lock(mutex_);
        return inOrder_;
    }
    bool wrong() const { return wrong_; }
    std::function<void(QueuedFrame&)> atEnd;

private:
    Heard& current(QueuedFrame& frame) {
        for (Heard& heard : open_)
            if (heard.frame == frame.frame().id) return heard;
        return open_.emplace_back(Heard{frame.frame().id, FrameStatus::Queued, 0});
    }
    void expect(bool condition) {
        if (!condition || !onWorkerThread()) wrong_ = true;
    }

    std::mutex mutex_;
    std::vector<Heard> open_, inOrder_;
    std::atomic<bool> wrong_{false};
};

TEST(QueuedFrame, ACancelledFrameGetsNoMoreTilesAndEndsWithThoseUnderWay) {
    TestFrame f(1, 320, 320);
    FrameQueue queue(1);
    const QueuedFramePtr queued = submit(queue, f);
    TileJob a, b;
    const auto pixels = std::make_unique<TilePixels>();
    ASSERT_TRUE(queue.next(a) && queue.next(b));
    queued->cancel();
    queued->cancel(); // again: no effect
    EXPECT_EQ(queued->status(), FrameStatus::Rendering);
    EXPECT_EQ(queued->progress(), 0.98f);
    queue.done(a, *pixels);
    queue.close();
    EXPECT_FALSE(queue.next(a));
    EXPECT_FALSE(queued->ended());
    queue.done(b, *pixels);
    EXPECT_EQ(queued->wait(), FrameStatus::Cancelled);
    EXPECT_EQ(queued->progress(), 1.0f);
    queued->cancel();
    EXPECT_EQ(queued->status(), FrameStatus::Cancelled);
}

TEST(QueuedFrame, CancellingTooLateHasNoEffect) {
    TestFrame f(1, 32, 32);
    FrameQueue queue(1);
    const QueuedFramePtr queued = submit(queue, f);
    TileJob job;
    ASSERT_TRUE(queue.next(job));
    queued->cancel();
    queue.done(job, *std::make_unique<TilePixels>());
    EXPECT_EQ(queued->wait(), FrameStatus::Done);
    queued->cancel();
    EXPECT_EQ(queued->status(), FrameStatus::Done);
}

TEST(QueuedFrame, ACancelledFrameDoesNotWaitForItsTurn) {
    TestFrame first(1, 64, 64), second(2, 64, 64), third(3, 64, 64);
    FrameQueue queue(2);
    const QueuedFramePtr a = submit(queue, first), b = submit(queue, second);
    TileJob job;
    ASSERT_TRUE(queue.next(job));
    b->cancel();
    EXPECT_EQ(b->status(), FrameStatus::Cancelled); // nobody works on it
    queue.done(job, *std::make_unique<TilePixels>());
    ASSERT_TRUE(queue.next(job)); // where the worker ends it, though its own frame has more tiles
    EXPECT_TRUE(b->ended());
    EXPECT_EQ(job.frame->id, 1u);
    const QueuedFramePtr c = submit(queue, third); // its place is free
    EXPECT_EQ(a->status(), FrameStatus::Rendering);
    EXPECT_EQ(c->status(), FrameStatus::Queued);
}

TEST(QueuedFrame, CancelledBeforeItIsSubmitted) {
    TestFrame f(1, 64, 64);
    FrameQueue queue(1);
    const QueuedFramePtr queued = queue.prepare(f.frame);
    queued->cancel();
    queue.submit(queued);
    queue.close();
    work(queue, FakeTracer());
    EXPECT_EQ(queued->wait(), FrameStatus::Cancelled);
    EXPECT_EQ(f.memory[0], -1.0f);
}

TEST(QueuedFrame, OutlivesItsQueue) {
    TestFrame f(1, 64, 64);
    QueuedFramePtr queued;
    {
        FrameQueue queue(3);
        queued = submit(queue, f);
    }
    queued->cancel();
    EXPECT_EQ(queued->status(), FrameStatus::Cancelled);
    EXPECT_FALSE(queued->ended());
}

TEST(QueuedFrame, TheFirstErrorIsKeptUntilItIsTaken) {
    TestFrame f(1, 8, 8);
    FrameQueue queue(1);
    const QueuedFramePtr queued = queue.prepare(f.frame);
    queued->keepError(std::make_exception_ptr(std::runtime_error("first")));
    queued->keepError(std::make_exception_ptr(std::logic_error("second")));
    EXPECT_THROW(std::rethrow_exception(queued->takeError()), std::runtime_error);
    EXPECT_FALSE(queued->takeError());
}

TEST(QueuedFrame, PixelsLostToShadersAreTheErrorOfADoneFrame) {
    TestFrame f(1, 8, 8);
    FrameQueue queue(1);
    const QueuedFramePtr queued = submit(queue, f);
    TileJob job;
    ASSERT_TRUE(queue.next(job));
    const auto pixels = std::make_unique<TilePixels>();
    pixels->badPixels = 3;
    queue.done(job, *pixels);
    EXPECT_EQ(queued->wait(), FrameStatus::Done);
    EXPECT_TRUE(queued->takeError());
    EXPECT_EQ(queued->statistics().badPixels, 3u);
}

TEST(QueuedFrame, ListenersHearOfEveryTileThenOfTheEndInOrder) {
    const auto listener = std::make_shared<Listener>();
    FakeTracer tracer([](const Frame& frame, const Tile& tile) {
        std::this_thread::sleep_for(std::chrono::microseconds((frame.id * 31 + tile.x) % 97));
    });
    FrameQueue queue(3);
    std::vector<TestFrame> frames;
    for (uint64_t id = 1; id <= 40; ++id) frames.emplace_back(id, 70 + uint32_t(id), 50);
    {
        Team team(4, queue, tracer);
        for (const TestFrame& f : frames) submit(queue, f, listener);
        queue.waitAll();
    }
    const auto heard = listener->inOrder();
    ASSERT_EQ(heard.size(), 40u);
    for (std::size_t i = 0; i < 40; ++i) {
        EXPECT_EQ(heard[i].frame, i + 1);
        EXPECT_EQ(heard[i].status, FrameStatus::Done);
        EXPECT_EQ(heard[i].pixels, (71 + i) * 50);
    }
    EXPECT_FALSE(listener->wrong());
}

TEST(QueuedFrame, WaitingLastsUntilTheListenerHasBeenTold) {
    const auto listener = std::make_shared<Listener>();
    std::atomic<bool> told{false};
    listener->atEnd = [&](QueuedFrame&) {
        std::this_thread::sleep_for(20ms);
        told = true;
    };
    FakeTracer tracer;
    FrameQueue queue(1);
    Team team(2, queue, tracer);
    TestFrame f(1, 64, 64);
    submit(queue, f, listener)->wait();
    EXPECT_TRUE(told);
}

// The listener of the first frame cancels the others, of which one is waited for to be queued.
TEST(QueuedFrame, AListenerMayCancelWhileTheQueueIsFull) {
    FakeTracer tracer([](const Frame&, const Tile&) { std::this_thread::sleep_for(1ms); });
    FrameQueue queue(2);
    Team team(1, queue, tracer);
    for (int round = 0; round < 20; ++round) {
        TestFrame first(1, 64, 64), second(2, 320, 320), third(3, 32, 32);
        const QueuedFramePtr b = queue.prepare(second.frame);
        const auto listener = std::make_shared<Listener>();
        listener->atEnd = [&](QueuedFrame&) { b->cancel(); };
        submit(queue, first, listener);
        queue.submit(b);
        const QueuedFramePtr c = submit(queue, third); // the queue is full until b has ended
        c->wait();
        queue.waitAll();
        EXPECT_EQ(c->status(), FrameStatus::Done);
        EXPECT_EQ(b->status(), FrameStatus::Cancelled);
    }
}

// Several threads cancel at random moments; whatever comes of it, every frame ends, is told of
// once, and is complete exactly if it is done.
TEST(QueuedFrame, CancelledAtRandomMoments) {
    FakeTracer tracer([](const Frame&, const Tile&) { std::this_thread::yield(); });
    FrameQueue queue(4);
    Team team(3, queue, tracer);
    std::mt19937 random(7);
    int done = 0, cancelled = 0;
    for (int round = 0; round < 200; ++round) {
        const auto listener = std::make_shared<Listener>();
        std::vector<TestFrame> frames;
        std::vector<QueuedFramePtr> queued;
        for (uint64_t id = 1; id <= 4; ++id) {
            frames.emplace_back(id, 96, 64);
            queued.push_back(queue.prepare(frames.back().frame, listener));
        }
        std::vector<std::thread> cancelling;
        for (int thread = 0; thread < 3; ++thread) {
            const std::size_t victim = random() % 4;
            const auto pause = std::chrono::microseconds(random() % 400);
            cancelling.emplace_back([&, victim, pause] {
                std::this_thread::sleep_for(pause);
                queued[victim]->cancel();
            });
        }
        for (const QueuedFramePtr& f : queued) queue.submit(f);
        for (std::size_t i = 0; i < 4; ++i) {
            const FrameStatus status = queued[i]->wait();
            const bool isDone = status == FrameStatus::Done;
            ASSERT_TRUE(isDone || status == FrameStatus::Cancelled);
            EXPECT_EQ(isComplete(frames[i]), isDone);
            ++(isDone ? done : cancelled);
        }
        for (std::thread& thread : cancelling) thread.join();
        queue.waitAll();
        EXPECT_EQ(listener->inOrder().size(), 4u);
        EXPECT_FALSE(listener->wrong());
    }
    EXPECT_GT(done, 0);
    EXPECT_GT(cancelled, 0);
}

} // namespace
} // namespace smart::test
