// SPDX-License-Identifier: MIT
// Workers in processes of their own, at the other ends of sockets: whatever becomes of them, every
// frame is complete, and equal to the bit to what one thread renders.
#include "libsmart/remote/remote_workers.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstring>
#include <future>
#include <list>
#include <memory>
#include <random>
#include <string>
#include <thread>

#include "compat/mpi/lz4_codec.h"
#include "tests/libsmart/remote/shared_renderer.h"
#include "tests/support/delayed_transport.h"
#include "tests/support/socket_transport.h"
#include "tests/support/worker_process.h"

namespace smart::test {
namespace {

using namespace std::chrono_literals;

/// A master with its workers.
class Company {
public:
    explicit Company(std::vector<WorkerProcess> workers, RemoteOptions options = quick(),
                     unsigned threads = 1, FakeTracer::Before before = {},
                     std::chrono::microseconds latency = 0us)
        : processes(std::move(workers)), sockets_(socketsOf(processes)),
          delayed_(sockets_, latency), tracer_(std::move(before)) {
        Transport& transport = latency > 0us ? static_cast<Transport&>(delayed_) : sockets_;
        remote = std::make_unique<RemoteWorkers>(transport, std::move(options),
                                                 [this](const std::string& text) {
                                                     const std::lock_guard lock(mutex_);
                                                     warnings_.push_back(text);
                                                 });
        renderer = std::make_unique<SharedRenderer>(*remote, 1, threads, tracer_);
    }
    static RemoteOptions quick() {
        RemoteOptions options;
        static const compat::Lz4Codec codec;
        options.identity = "test";
        options.codec = &codec;
        options.stallAfter = 60ms;
        options.deafAfter = 2s;
        return options;
    }
    /// Nobody is called late, however busy the machine is.
    static RemoteOptions patient() {
        RemoteOptions options = quick();
        options.stallAfter = options.deafAfter = 1h;
        return options;
    }
    QueuedFramePtr submit(const TestFrame& frame, bool picture = false) {
        const FrameCall call{frame.frame->id, frame.frame->target.width,
                             frame.frame->target.height, picture, 0};
        remote->addCall(std::as_bytes(std::span(&call, 1)));
        return renderer->submit(frame);
    }
    std::vector<std::string> warnings() {
        const std::lock_guard lock(mutex_);
        return warnings_;
    }

    std::vector<WorkerProcess> processes;

private:
    static std::vector<int> socketsOf(const std::vector<WorkerProcess>& workers) {
        std::vector<int> all;
        for (const WorkerProcess& w : workers) all.push_back(w.socket);
        return all;
    }
    std::mutex mutex_;
    std::vector<std::string> warnings_;
    SocketTransport sockets_;
    DelayedTransport delayed_;
    FakeTracer tracer_;

public:
    std::unique_ptr<RemoteWorkers> remote;
    std::unique_ptr<SharedRenderer> renderer;
};

std::vector<WorkerProcess> workers(unsigned count, const std::string& mode = "honest",
                                   unsigned number = 0) {
    std::vector<WorkerProcess> all;
    for (unsigned i = 0; i < count; ++i) all.emplace_back(mode, number);
    return all;
}

/// Slow enough that others get tiles.
void slowly(const Frame&, const Tile&) {
    std::this_thread::sleep_for(300us);
}

constexpr uint32_t kWidth = 333, kHeight = 217; // 77 tiles

TEST(RemoteWorkers, FramesAreSharedAndComplete) {
    for (const unsigned count : {0u, 1u, 3u}) {
        Company company(workers(count), Company::patient(), 1, slowly);
        ASSERT_TRUE(company.remote->waitForPeers(10s));
        EXPECT_EQ(company.remote->working(), count);
        std::list<TestFrame> frames;
        for (uint64_t id = 1; id <= 20; ++id) {
            TestFrame& frame = frames.emplace_back(id, kWidth, kHeight);
            company.submit(frame);
        }
        company.renderer.reset(); // waits
        for (const TestFrame& frame : frames) EXPECT_TRUE(isComplete(frame)) << frame.frame->id;
        EXPECT_EQ(company.remote->traffic().tilesSent > 0, count > 0);
        EXPECT_TRUE(company.warnings().empty());
        company.remote.reset();
        for (WorkerProcess& process : company.processes) EXPECT_EQ(process.wait(), 0);
    }
}

TEST(RemoteWorkers, PackedTilesAreWholeAgain) {
    std::vector<WorkerProcess> all = workers(1, "packing");
    all.emplace_back("honest");
    RemoteOptions options = Company::quick();
    options.stallAfter = 60s;
    Company company(std::move(all), options, 1, slowly);
    ASSERT_TRUE(company.remote->waitForPeers(10s));
    for (uint64_t id = 1; id <= 10 || company.remote->traffic().tilesAnswered == 0; ++id) {
        TestFrame frame(id, kWidth, kHeight);
        EXPECT_EQ(company.submit(frame)->wait(), FrameStatus::Done);
        EXPECT_TRUE(isComplete(frame));
    }
    const RemoteTraffic traffic = company.remote->traffic();
    EXPECT_LT(traffic.answerBytes, traffic.pixelBytes);
    EXPECT_TRUE(company.warnings().empty());
}

TEST(RemoteWorkers, WhoPacksUnaskedIsLeftOut) {
    RemoteOptions options = Company::quick();
    options.codec = nullptr;
    options.stallAfter = 60s;
    Company company(workers(1, "packing"), options, 1, slowly);
    ASSERT_TRUE(company.remote->waitForPeers(10s));
    for (uint64_t id = 1; id <= 10 || company.remote->working() != 0; ++id) {
        TestFrame frame(id, kWidth, kHeight);
        EXPECT_EQ(company.submit(frame)->wait(), FrameStatus::Done);
        EXPECT_TRUE(isComplete(frame));
    }
    ASSERT_EQ(company.warnings().size(), 1u);
    EXPECT_EQ(company.warnings()[0], "process 1 renders no more: its packed tile is none");
}

TEST(RemoteWorkers, RaysAreCountedWhereverTheyAreTraced) {
    Company company(workers(2), Company::quick(), 1, slowly);
    ASSERT_TRUE(company.remote->waitForPeers(10s));
    TestFrame frame(1, kWidth, kHeight);
    const QueuedFramePtr queued = company.submit(frame);
    EXPECT_EQ(queued->wait(), FrameStatus::Done);
    EXPECT_EQ(queued->statistics().primaryRays, uint64_t(kWidth) * kHeight);
    EXPECT_EQ(queued->statistics().shadowRays, 77u * 2);
    EXPECT_EQ(queued->progress(), 1.0f);
}

TEST(RemoteWorkers, MoreProcessesThanTiles) {
    Company company(workers(4));
    ASSERT_TRUE(company.remote->waitForPeers(10s));
    for (uint64_t id = 1; id <= 30; ++id) {
        TestFrame frame(id, 1 + uint32_t(id) % 40, 1);
        EXPECT_EQ(company.submit(frame)->wait(), FrameStatus::Done);
        EXPECT_TRUE(isComplete(frame));
    }
}

TEST(RemoteWorkers, PicturesReachThoseWhoLackThem) {
    Company company(workers(2), Company::quick(), 1, slowly);
    ASSERT_TRUE(company.remote->waitForPeers(10s));
    for (uint64_t id = 1; id <= 5; ++id) {
        TestFrame frame(id, kWidth, kHeight);
        company.submit(frame, true)->wait();
        company.renderer->participation().sharePicture(frame.frame->target);
    }
    company.renderer.reset();
    company.remote.reset();
    for (WorkerProcess& process : company.processes) EXPECT_EQ(process.wait(), 0); // saw them
}

TEST(RemoteWorkers, LatencyDelaysAndChangesNothing) {
    Company company(workers(2), Company::quick(), 1, slowly, 5ms);
    ASSERT_TRUE(company.remote->waitForPeers(10s));
    TestFrame frame(1, kWidth, kHeight);
    EXPECT_EQ(company.submit(frame)->wait(), FrameStatus::Done);
    EXPECT_TRUE(isComplete(frame));
}

TEST(RemoteWorkers, SlowOnesDoNotHoldUpTheFrame) {
    Company company(workers(1, "slow", 400000), Company::quick(), 1, slowly);
    ASSERT_TRUE(company.remote->waitForPeers(10s));
    for (uint64_t id = 1; id <= 4; ++id) {
        TestFrame frame(id, kWidth, kHeight);
        EXPECT_EQ(company.submit(frame)->wait(), FrameStatus::Done);
        EXPECT_TRUE(isComplete(frame));
    }
    EXPECT_GT(company.remote->traffic().tilesReturned, 0u);
    EXPECT_EQ(company.remote->working(), 1u); // it may still be of use
}

TEST(RemoteWorkers, OthersLibrariesAreLeftOut) {
    std::vector<WorkerProcess> all = workers(1);
    all.emplace_back("other");
    Company company(std::move(all), Company::patient(), 1, slowly);
    ASSERT_TRUE(company.remote->waitForPeers(10s));
    EXPECT_EQ(company.remote->working(), 1u);
    TestFrame frame(1, kWidth, kHeight);
    company.submit(frame)->wait();
    EXPECT_TRUE(isComplete(frame));
    ASSERT_EQ(company.warnings().size(), 1u);
    EXPECT_EQ(company.warnings()[0], "process 2 renders no more: its library is another one: "
                                     "another, not test");
}

TEST(RemoteWorkers, WhoCanNotGoOnSaysSo) {
    Company company(workers(1, "diverge"), Company::patient(), 1, slowly);
    ASSERT_TRUE(company.remote->waitForPeers(10s));
    for (uint64_t id = 1; id <= 6; ++id) {
        TestFrame frame(id, kWidth, kHeight);
        company.submit(frame)->wait();
        EXPECT_TRUE(isComplete(frame));
    }
    for (int i = 0; i < 1000 && company.warnings().empty(); ++i) std::this_thread::sleep_for(10ms);
    ASSERT_EQ(company.warnings().size(), 1u);
    EXPECT_EQ(company.warnings()[0], "process 1 renders no more: no such plug-in here");
    EXPECT_EQ(company.remote->working(), 0u);
}

// What it is ready for is kept until there is such a frame: but once.
TEST(RemoteWorkers, WhoIsReadyAgainAndAgainIsLeftOut) {
    const SocketPair pair;
    SocketTransport here({pair.here}), there({pair.there});
    std::promise<std::string> warning;
    RemoteWorkers remote(here, Company::patient(),
                         [&](const std::string& text) { warning.set_value(text); });
    there.send(0, encode(Hello{"test", 1}));
    there.send(0, encode(FrameReady{{1, 1}, 7}));
    there.send(0, encode(FrameReady{{1, 2}, 7}));
    ASSERT_TRUE(remote.waitForPeers(10s));
    there.send(0, encode(FrameReady{{1, 2}, 7}));
    EXPECT_EQ(warning.get_future().get(), "process 1 renders no more: it said twice that "
                                          "it is ready for a frame");
    EXPECT_EQ(remote.working(), 0u);
}

/// Renders frames while something happens to the first worker when this process has rendered a
/// random number of tiles. How often it was noticed while there were frames: warnings, and tiles
/// that others got.
struct Noticed {
    std::size_t warnings = 0;
    uint64_t tiles = 0;
};
void disturb(const std::string& mode, int signal, int moments, Noticed& noticed) {
    std::mt19937 random(unsigned(signal) + 5);
    for (int moment = 0; moment < moments; ++moment) {
        std::vector<WorkerProcess> all;
        all.emplace_back(mode, unsigned(moment));
        if (moment % 2 == 1) all.emplace_back("honest");
        // Half of them only once the other has answered, however slow it is. Nothing is awaited
        // from then on: one that is stopped after its greeting counts as working, and never answers.
        const bool isAwaited = moment % 2 == 0;
        const unsigned fatal = random() % 40;
        unsigned rendered = 0;
        Company company(std::move(all), Company::quick(), 1, [&](const Frame&, const Tile&) {
            std::this_thread::sleep_for(50us);
            if (rendered++ != fatal || signal == 0) return;
            for (int i = 0; i < 10000 && isAwaited && company.remote->working() > 0 &&
                            company.remote->traffic().tilesAnswered == 0; ++i)
                std::this_thread::sleep_for(1ms);
            company.processes[0].kill(signal);
        });
        const bool begun = moment % 10 == 0 || company.remote->waitForPeers(10s);
        ASSERT_TRUE(begun);
        std::list<TestFrame> frames;
        std::vector<QueuedFramePtr> queued;
        for (uint64_t id = 1; id <= 3; ++id)
            queued.push_back(company.submit(frames.emplace_back(id, kWidth, kHeight)));
        for (const QueuedFramePtr& frame : queued) ASSERT_EQ(frame->wait(), FrameStatus::Done);
        for (const TestFrame& frame : frames) ASSERT_TRUE(isComplete(frame)) << moment;
        ASSERT_LE(company.warnings().size(), company.processes.size() * 2); // late, and gone
        noticed.warnings += company.warnings().size();
        noticed.tiles += company.remote->traffic().tilesReturned;
    }
}

TEST(RemoteWorkers, KilledAtAnyMoment) {
    Noticed noticed;
    disturb("honest", SIGKILL, 100, noticed);
    EXPECT_GT(noticed.warnings, 10u);
}

TEST(RemoteWorkers, StalledAtAnyMoment) {
    Noticed noticed;
    disturb("honest", SIGSTOP, 100, noticed);
    EXPECT_GT(noticed.warnings, 10u);
    EXPECT_GT(noticed.tiles, 10u);
}

TEST(RemoteWorkers, LyingAtAnyMoment) {
    Noticed noticed;
    disturb("lie", 0, 100, noticed);
    EXPECT_GT(noticed.warnings, 10u);
}

TEST(RemoteWorkers, WhoTakesInNothingIsLeftOut) {
    RemoteOptions options = Company::quick();
    options.window = 1u << 20;
    options.deafAfter = 100ms;
    Company company(workers(1), options);
    ASSERT_TRUE(company.remote->waitForPeers(10s));
    company.processes[0].kill(SIGSTOP);
    const std::vector<std::byte> call(1u << 20);
    for (int i = 0; i < 4; ++i) company.remote->addCall(call);
    EXPECT_EQ(company.remote->working(), 0u);
    ASSERT_EQ(company.warnings().size(), 1u);
    EXPECT_EQ(company.warnings()[0], "process 1 renders no more: it takes in nothing");
}

} // namespace
} // namespace smart::test
