// SPDX-License-Identifier: MIT
// Machines that render together: what a tile costs, what follows for many of them, and whether a
// simulated network agrees.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <memory>
#include <thread>
#include <vector>

#include "libsmart/render/tile_order.h"
#include "libsmart/render/tracers.h"
#include "libsmart/render/worker.h"
#include "tests/bench/command.h"
#include "tests/bench/openrt_engine.h"
#include "tests/bench/options.h"
#include "tests/bench/phong_frame.h"
#include "tests/bench/remote_job.h"
#include "tests/bench/remote_model.h"
#include "tests/bench/remote_packing.h"

namespace smart::bench {
namespace {

using namespace std::chrono_literals;

struct Options {
    std::string scene;
    ViewOptions view;
    uint32_t size = 512;
    unsigned workers = 3, repeat = 5, threads = 16;
    double millisecondsOfTile = 2;
};

constexpr uint32_t kWidth = 1920, kHeight = 1080;
constexpr double kAnswerHead = kHeaderSize + 49; ///< bytes of a TileAnswer but its pixels

/// Takes its time for a tile and no processor; knows how long it really slept, which on a busy
/// machine is longer than it was told.
class SleepingTracer final : public Tracer {
public:
    explicit SleepingTracer(std::chrono::microseconds time) : time_(time) {}
    void render(const Frame&, const Tile&, TilePixels& pixels) const override {
        const auto start = std::chrono::steady_clock::now();
        std::fill(std::begin(pixels.color), std::end(pixels.color), glm::vec4(0.5f));
        std::this_thread::sleep_until(start + time_);
        const std::chrono::nanoseconds slept = std::chrono::steady_clock::now() - start;
        slept_.fetch_add(slept.count(), std::memory_order_relaxed);
        tiles_.fetch_add(1, std::memory_order_relaxed);
    }
    /// Mean of the tiles since the last call.
    double secondsOfTile() const {
        return double(slept_.exchange(0)) * 1e-9 / double(std::max<int64_t>(tiles_.exchange(0), 1));
    }

private:
    std::chrono::microseconds time_;
    mutable std::atomic<int64_t> slept_ = 0, tiles_ = 0;
};

std::shared_ptr<Frame> emptyFrame(std::vector<uint32_t>& pixels) {
    pixels.resize(std::size_t(kWidth) * kHeight);
    const auto frame = std::make_shared<Frame>();
    frame->target.memory = pixels.data();
    frame->target.width = kWidth;
    frame->target.height = kHeight;
    frame->target.format = PixelFormat::Rgba8;
    return frame;
}

/// With tiles as they are, and packed.
void printTable(const RemoteCosts& measured, const PackingCosts& packing, const char* format,
                unsigned threads) {
    const uint64_t tiles = mortonTiles(kWidth, kHeight).size();
    struct Line {
        const char* name;
        double bitsPerSecond, latency; ///< of a switched network of this kind, one way, with MPI
    };
    constexpr Line kLines[] = {{"1 Gbit/s", 1e9, 50e-6},
                               {"10 Gbit/s", 1e10, 15e-6},
                               {"100 Gbit/s", 1e11, 3e-6}};
    std::printf("\nExpected at %ux%u, %s, %u threads a rank, all as fast as the one measured "
                "here\n"
                "ranks  network      frames/s  alone ms  efficiency  limit                         "
                "  packed: frames/s  efficiency  limit\n",
                kWidth, kHeight, format, threads);
    for (const unsigned ranks : {8u, 64u, 512u})
        for (const Line& line : kLines) {
            RemoteCosts costs = measured;
            costs.lineBytesPerSecond = line.bitsPerSecond / 8 * 0.94; // less what TCP/IP adds
            costs.latencySeconds = line.latency;
            costs.answerBytes = packing.plainBytes + kAnswerHead;
            const RemotePrediction p = predict(costs, tiles, ranks, threads);
            costs.tileSeconds += packing.packSeconds;
            costs.masterSeconds += packing.unpackSeconds;
            costs.answerBytes = packing.packedBytes + kAnswerHead;
            const RemotePrediction q = predict(costs, tiles, ranks, threads);
            std::printf("%5u  %-10s  %9.1f  %8.2f  %9.0f%%  %-30s  %16.1f  %9.0f%%  %s\n", ranks,
                        line.name, p.framesPerSecond, p.frameSeconds * 1e3, p.efficiency * 100,
                        p.limit, q.framesPerSecond, q.efficiency * 100, q.limit);
        }
}

void printPacking(const RemoteCosts& costs, const Frame& frame, const char* format,
                  const Options& options) {
    const PackingCosts packing = packingCosts(frame, options.repeat);
    const double pixels = double(frame.target.width) * frame.target.height;
    const double tiles = pixels / (kTileSize * kTileSize);
    std::printf("\n%s: %.0f bytes a frame, packed %.0f (%.1f to 1); a tile is packed in %.1f us "
                "and unpacked in %.1f us\n",
                format, packing.plainBytes * tiles, packing.packedBytes * tiles,
                packing.plainBytes / packing.packedBytes, packing.packSeconds * 1e6,
                packing.unpackSeconds * 1e6);
    printTable(costs, packing, format, options.threads);
}

/// The model against a job in this process whose tiles take time and no processor.
bool checkModel(const RemoteCosts& measured, const Options& options) {
    struct Case {
        unsigned workers;
        std::chrono::microseconds latency;
        double bytesPerSecond;
    };
    constexpr Case kCases[] = {{3, 0us, 0}, {7, 1000us, 0}, {7, 10000us, 0}, {15, 1000us, 0},
                               {15, 1000us, 4e6}, {31, 1000us, 20e6}};
    std::vector<uint32_t> pixels;
    const std::shared_ptr<Frame> frame = emptyFrame(pixels);
    const uint64_t tiles = mortonTiles(kWidth, kHeight).size();
    const auto tileTime =
        std::chrono::microseconds(std::llround(options.millisecondsOfTile * 1000));
    const SleepingTracer tracer(tileTime);
    std::printf("\nThe model against simulated networks: tiles that sleep %.1f ms\n"
                "ranks  tile ms  latency ms  line MB/s  frame ms  model ms  difference  limit\n",
                options.millisecondsOfTile);
    bool good = true;
    for (const Case& c : kCases) {
        RemoteJob job(c.workers, tracer, frame, {c.latency, c.bytesPerSecond});
        const double seconds = job.secondsOfFrame(options.repeat);
        RemoteCosts costs = measured;
        costs.tileSeconds = tracer.secondsOfTile();
        costs.answerBytes = kTileSize * kTileSize * 4 + kAnswerHead;
        costs.latencySeconds = std::chrono::duration<double>(c.latency).count();
        costs.lineBytesPerSecond = c.bytesPerSecond;
        const RemotePrediction p = predict(costs, tiles, c.workers + 1, 1);
        const double difference = seconds / p.frameSeconds - 1;
        std::printf("%5u  %7.2f  %10.1f  %9.1f  %8.1f  %8.1f  %+9.1f%%  %s\n", c.workers + 1,
                    costs.tileSeconds * 1e3, costs.latencySeconds * 1e3, c.bytesPerSecond * 1e-6,
                    seconds * 1e3, p.frameSeconds * 1e3, difference * 100, p.limit);
        good = good && std::abs(difference) < 0.5;
    }
    return good;
}

int run(const Options& options) {
    const std::vector<Triangle> triangles = readTriangles(options.scene);
    BuildReport built;
    const ScenePtr scene = buildOpenrt(triangles, Precision::Watertight, coreCount(), built);
    std::vector<float> floats;
    const std::shared_ptr<Frame> frame =
        phongFrame(scene, options.view.view(options.scene), options.size, floats);
    std::vector<uint32_t> pixels(std::size_t(options.size) * options.size);
    frame->target.memory = pixels.data();
    frame->target.format = PixelFormat::Rgba8;

    const FrameTracer tracer;
    const uint64_t tiles = mortonTiles(options.size, options.size).size();
    std::printf("%u x %u pixels, %zu tiles; one thread a rank\n"
                "ranks  frame ms  queued ms  call bytes  answer bytes  remote tiles\n",
                options.size, options.size, std::size_t(tiles));
    RemoteCosts costs;
    double alone = 0;
    for (unsigned workers = 0; workers <= options.workers; ++workers) {
        RemoteJob job(workers, tracer, frame);
        const double seconds = job.secondsOfFrame(options.repeat);
        const double queued = job.secondsOfQueue(2 * options.repeat);
        if (workers == 0) alone = seconds;
        const RemoteTraffic t = job.traffic();
        const double frames = 3.0 * options.repeat + 2;
        std::printf("%5u  %8.2f  %9.2f  %10.0f  %12.0f  %12.1f\n", workers + 1, seconds * 1e3,
                    queued * 1e3, double(t.callBytes) / frames, double(t.answerBytes) / frames,
                    double(t.tilesAnswered) / frames);
    }
    // Once more, as the machine may have been busy with something else the first time.
    alone = std::min(alone, RemoteJob(0, tracer, frame).secondsOfFrame(options.repeat));
    costs.tileSeconds = alone / double(tiles);
    costs.masterSeconds = servingSeconds(*frame, 20000) + 2e-6;
    costs.latencySeconds = socketLatency(4096, 2000);
    std::printf("\ntile %.0f us, serving a remote one %.1f us (2 us of that assumed for MPI),\n"
                "message of 4 KB from thread to thread here %.0f us\n",
                costs.tileSeconds * 1e6, costs.masterSeconds * 1e6, costs.latencySeconds * 1e6);
    printPacking(costs, *frame, "four bytes a pixel", options);
    printSimulatedPacking(frame, 4 * options.repeat);
    frame->target.memory = floats.data();
    frame->target.format = PixelFormat::Rgba32f;
    RemoteJob(0, tracer, frame).secondsOfFrame(1);
    costs.masterSeconds = servingSeconds(*frame, 20000) + 2e-6;
    printPacking(costs, *frame, "four floats a pixel", options);
    if (checkModel(costs, options)) return 0;
    std::printf("the model is refused: it is off by half or more\n");
    return kExitRefused;
}

} // namespace

Run addRemote(CLI::App& app) {
    const auto options = std::make_shared<Options>();
    addScene(app, options->scene);
    addSize(app, options->size);
    options->view.add(app);
    addRepeat(app, options->repeat);
    app.add_option("--workers", options->workers, "ranks beside the first, up to so many")
        ->check(CLI::Range(1u, 16u))
        ->capture_default_str();
    app.add_option("--threads-a-rank", options->threads,
                   "threads of each of the machines that are computed")
        ->check(CLI::Range(1u, 1024u))
        ->capture_default_str();
    app.add_option("--tile-time", options->millisecondsOfTile, "milliseconds of a tile, simulated")
        ->check(CLI::Range(0.1, 100.0))
        ->capture_default_str();
    return [options] { return run(*options); };
}

} // namespace smart::bench
