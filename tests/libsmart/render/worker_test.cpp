// SPDX-License-Identifier: MIT
#include "libsmart/render/worker.h"

#include <gtest/gtest.h>
#include <pthread.h>

#include <cfenv>
#include <csignal>
#include <mutex>
#include <set>
#include <string>

#include "libsmart/render/frame_queue.h"

namespace smart {
namespace {

/// Notes how the threads are that render.
class Observer final : public Tracer {
public:
    void render(const Frame&, const Tile&, TilePixels& pixels) const override {
        char name[16] = "";
        pthread_getname_np(pthread_self(), name, sizeof name);
        sigset_t blocked;
        pthread_sigmask(SIG_SETMASK, nullptr, &blocked);
        const std::lock_guard lock(mutex_);
        names_.insert(name);
        terminationBlocked_ &= sigismember(&blocked, SIGTERM) == 1;
        alarmBlocked_ &= sigismember(&blocked, SIGALRM) == 1;
        faultBlocked_ |= sigismember(&blocked, SIGSEGV) == 1;
        const volatile double tiny = 1e-30;
        roundsUp_ |= 1.0 + tiny != 1.0;
        pixels = TilePixels();
    }

    mutable std::mutex mutex_;
    mutable std::set<std::string> names_;
    mutable bool terminationBlocked_ = true, alarmBlocked_ = true;
    mutable bool faultBlocked_ = false, roundsUp_ = false;
};

TEST(Worker, ThreadsAreNamedTakeNoSignalsAndRoundToNearest) {
    sigset_t before, after;
    pthread_sigmask(SIG_SETMASK, nullptr, &before);
    std::fesetround(FE_UPWARD); // threads inherit this from who starts them
    Observer observer;
    FrameQueue queue(1);
    std::vector<float> memory(std::size_t(400) * 400 * 3);
    {
        ThreadTeam team(3, queue, observer);
        EXPECT_EQ(std::fegetround(), FE_UPWARD);
        auto frame = std::make_shared<Frame>();
        frame->id = 1;
        frame->target = {memory.data(), 400, 400, PixelFormat::Rgb32f, 0, false, {}};
        queue.submit(queue.prepare(std::move(frame)));
        queue.waitAll();
        queue.close();
    }
    std::fesetround(FE_TONEAREST);
    EXPECT_FALSE(observer.names_.empty());
    for (const std::string& name : observer.names_) EXPECT_EQ(name.substr(0, 7), "openrt-");
    EXPECT_TRUE(observer.terminationBlocked_);
    EXPECT_TRUE(observer.alarmBlocked_);
    EXPECT_FALSE(observer.faultBlocked_);
    EXPECT_FALSE(observer.roundsUp_);
    pthread_sigmask(SIG_SETMASK, nullptr, &after);
    for (int signal = 1; signal < 32; ++signal)
        EXPECT_EQ(sigismember(&before, signal), sigismember(&after, signal)) << signal;
}

TEST(Worker, ThreadsKnowWhatTheyAre) {
    EXPECT_FALSE(onWorkerThread());
    class Asking final : public Tracer {
    public:
        void render(const Frame&, const Tile&, TilePixels& pixels) const override {
            pixels = TilePixels();
            pixels.badPixels = onWorkerThread() ? 0 : 1;
        }
    } asking;
    FrameQueue queue(1);
    auto frame = std::make_shared<Frame>();
    frame->target.width = frame->target.height = 8;
    {
        ThreadTeam team(1, queue, asking);
        queue.submit(queue.prepare(frame));
        queue.waitAll();
        queue.close();
    }
    EXPECT_EQ(queue.statistics().badPixels, 0u);
    queue.submit(queue.prepare(frame));
    work(queue, asking); // the same loop on this thread
    EXPECT_EQ(queue.statistics().badPixels, 1u);
}

TEST(Worker, ThereIsACore) {
    EXPECT_GE(coreCount(), 1u);
}

} // namespace
} // namespace smart
