// SPDX-License-Identifier: MIT
// Workers without frames go home, and no frame is left without workers.
#include <gtest/gtest.h>

#include <chrono>
#include <optional>
#include <random>
#include <thread>

#include "tests/libsmart/render/fake_frames.h"

namespace smart::test {
namespace {

using namespace std::chrono_literals;

/// The queue's workers, sent anew when they are gone: as Renderer does.
class Renewed {
public:
    Renewed(FrameQueue& queue, const Tracer& tracer) : queue_(queue), tracer_(tracer) {}
    ~Renewed() { queue_.close(); }

    void require() {
        if (team_ && !queue_.deserted()) return;
        team_.reset(); // hangs unless they leave
        queue_.open();
        team_.emplace(3, queue_, tracer_);
        ++teams;
    }
    int teams = 0;

private:
    FrameQueue& queue_;
    const Tracer& tracer_;
    std::optional<ThreadTeam> team_;
};

bool becomesDeserted(const FrameQueue& queue) {
    for (int i = 0; i < 5000 && !queue.deserted(); ++i) std::this_thread::sleep_for(1ms);
    return queue.deserted();
}

TEST(IdleWorkers, GoHomeAndComeBack) {
    FakeTracer tracer;
    FrameQueue queue(2, 20ms);
    Renewed workers(queue, tracer);
    for (uint64_t id = 1; id <= 3; ++id) {
        const TestFrame picture(id, 100, 80);
        const QueuedFramePtr frame = queue.prepare(picture.frame);
        workers.require();
        queue.submit(frame);
        EXPECT_EQ(frame->wait(), FrameStatus::Done);
        EXPECT_TRUE(isComplete(picture));
        EXPECT_TRUE(becomesDeserted(queue));
    }
    EXPECT_EQ(workers.teams, 3);
}

TEST(IdleWorkers, StayWhereNoPatienceIsSet) {
    FakeTracer tracer;
    FrameQueue queue(2);
    const Team team(2, queue, tracer);
    std::this_thread::sleep_for(50ms);
    EXPECT_FALSE(queue.deserted());
    EXPECT_EQ(submit(queue, TestFrame(1, 64, 64))->wait(), FrameStatus::Done);
}

TEST(IdleWorkers, StayForAFrameThatIsOnItsWay) {
    FakeTracer tracer;
    FrameQueue queue(2, 5ms);
    Renewed workers(queue, tracer);
    const TestFrame picture(1, 64, 64), dropped(2, 64, 64);
    QueuedFramePtr frame = queue.prepare(picture.frame);
    QueuedFramePtr other = queue.prepare(dropped.frame);
    workers.require();
    std::this_thread::sleep_for(100ms);
    EXPECT_FALSE(queue.deserted());
    queue.submit(frame);
    EXPECT_EQ(frame->wait(), FrameStatus::Done);
    std::this_thread::sleep_for(100ms);
    EXPECT_FALSE(queue.deserted());
    other.reset(); // it will not come
    EXPECT_TRUE(becomesDeserted(queue));
    EXPECT_EQ(workers.teams, 1);
}

TEST(IdleWorkers, NoFrameIsLostAtTheMomentTheyLeave) {
    FakeTracer tracer;
    FrameQueue queue(2, 1ms);
    Renewed workers(queue, tracer);
    std::mt19937 random(1);
    for (uint64_t id = 1; id <= 400; ++id) {
        const TestFrame picture(id, 64, 64);
        const QueuedFramePtr frame = queue.prepare(picture.frame);
        workers.require();
        if (id % 4 == 0) std::this_thread::sleep_for(std::chrono::microseconds(random() % 2000));
        queue.submit(frame);
        if (id % 3 == 0) frame->cancel();
        frame->wait();
        std::this_thread::sleep_for(std::chrono::microseconds(900 + random() % 300));
    }
    EXPECT_GT(workers.teams, 2) << "the control: they do leave";
}

} // namespace
} // namespace smart::test
