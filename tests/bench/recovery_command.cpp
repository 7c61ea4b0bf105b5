// SPDX-License-Identifier: MIT
// Workers that die or fall silent within a frame: how long until others have their tiles, and how
// much longer the frame takes.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <random>
#include <thread>
#include <vector>

#include "libsmart/remote/remote_workers.h"
#include "tests/bench/command.h"
#include "tests/bench/options.h"
#include "tests/libsmart/remote/shared_renderer.h"
#include "tests/support/worker_process.h"

namespace smart::bench {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr unsigned kWorkers = 3, kMicrosecondsOfTile = 4000;
constexpr uint32_t kSize = 1024; // pixels, squared

struct Options {
    unsigned repeat = 15, stallAfter = 1000;
};

double since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// What a signal to one of the workers did.
struct Recovery {
    double noticed = 0, longer = 0; ///< milliseconds
};

/// Waits for what the master does about it; whether it did.
bool noticed(const RemoteWorkers& remote, int signal, Clock::time_point limit) {
    for (; Clock::now() < limit; std::this_thread::sleep_for(100us))
        if (signal == SIGKILL ? remote.working() < kWorkers : remote.traffic().tilesReturned > 0)
            return true;
    return false;
}

/// Frames of tiles that sleep, by one thread here and two in each worker.
class Frames {
public:
    explicit Frames(const Options& options) {
        std::vector<int> sockets;
        for (unsigned i = 0; i < kWorkers; ++i) {
            workers_.emplace_back("slow", kMicrosecondsOfTile);
            sockets.push_back(workers_.back().socket);
        }
        sockets_ = std::make_unique<test::SocketTransport>(sockets);
        RemoteOptions remoteOptions;
        remoteOptions.identity = "test";
        remoteOptions.stallAfter = std::chrono::milliseconds(options.stallAfter);
        remote_ =
            std::make_unique<RemoteWorkers>(*sockets_, remoteOptions, [](const std::string&) {});
        if (!remote_->waitForPeers(30s)) throw std::runtime_error("workers do not start");
        renderer_ = std::make_unique<test::SharedRenderer>(*remote_, 1, 1, tracer_);
    }
    ~Frames() {
        renderer_.reset();
        remote_.reset();
    }

    Recovery disturb(int signal, std::mt19937& random) {
        double usual = 1e300;
        for (int i = 0; i < 2; ++i) {
            const Clock::time_point start = Clock::now();
            submit()->wait();
            usual = std::min(usual, since(start));
        }
        Recovery result;
        const Clock::time_point start = Clock::now();
        const QueuedFramePtr frame = submit();
        std::this_thread::sleep_for(
            std::chrono::duration<double, std::milli>(usual * (0.1 + random() % 70 * 0.01)));
        const Clock::time_point then = Clock::now();
        workers_[0].kill(signal);
        if (!noticed(*remote_, signal, then + 20s)) throw std::runtime_error("nobody noticed");
        result.noticed = since(then);
        frame->wait();
        result.longer = since(start) - usual;
        return result;
    }

private:
    QueuedFramePtr submit() {
        frames_.push_back(std::make_unique<test::TestFrame>(frames_.size() + 1, kSize, kSize));
        const test::FrameCall call{frames_.size(), kSize, kSize};
        remote_->addCall(std::as_bytes(std::span(&call, 1)));
        return renderer_->submit(*frames_.back());
    }
    std::vector<test::WorkerProcess> workers_;
    std::unique_ptr<test::SocketTransport> sockets_;
    std::vector<std::unique_ptr<test::TestFrame>> frames_;
    const test::FakeTracer tracer_{[](const Frame&, const Tile&) {
        std::this_thread::sleep_for(std::chrono::microseconds(kMicrosecondsOfTile));
    }};
    std::unique_ptr<RemoteWorkers> remote_;
    std::unique_ptr<test::SharedRenderer> renderer_;
};

int run(const Options& options) {
    std::printf(
        "%ux%u pixels, tiles of %.0f ms, %u worker processes of two threads and one thread "
        "here; a tile is late after %u ms\n"
        "a worker is  noticed after ms (median, worst)  the frame took longer, ms (median, "
        "worst)  of\n",
        kSize, kSize, kMicrosecondsOfTile * 1e-3, kWorkers, options.stallAfter);
    std::mt19937 random(1);
    for (const int signal : {SIGKILL, SIGSTOP}) {
        std::vector<double> noticed, longer;
        for (unsigned i = 0; i < options.repeat; ++i) {
            const Recovery r = Frames(options).disturb(signal, random);
            noticed.push_back(r.noticed);
            longer.push_back(r.longer);
        }
        std::sort(noticed.begin(), noticed.end());
        std::sort(longer.begin(), longer.end());
        const std::size_t middle = noticed.size() / 2;
        std::printf("%-11s  %13.2f  %17.2f  %19.1f  %22.1f  %7u\n",
                    signal == SIGKILL ? "killed" : "stopped", noticed[middle], noticed.back(),
                    longer[middle], longer.back(), options.repeat);
    }
    return 0;
}

} // namespace

Run addRecovery(CLI::App& app) {
    const auto options = std::make_shared<Options>();
    addRepeat(app, options->repeat);
    app.add_option("--stall-after", options->stallAfter, "milliseconds until a tile is late")
        ->check(CLI::Range(50u, 60000u))
        ->capture_default_str();
    return [options] { return run(*options); };
}

} // namespace smart::bench
