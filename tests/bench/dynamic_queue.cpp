// SPDX-License-Identifier: MIT
#include "tests/bench/dynamic_queue.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <thread>

#include "openrt/rt.h"
#include "tests/bench/dynamic_frames.h"

namespace smart::bench {
namespace {

using Clock = std::chrono::steady_clock;

double seconds(Clock::time_point from, Clock::time_point to) {
    return std::chrono::duration<double>(to - from).count();
}

struct SystemTimes {
    double running = 0, ready = 0;
};

/// Of this process's threads whose names are the library's, as the system counts them.
SystemTimes systemTimes() {
    SystemTimes sum;
    std::error_code none;
    for (const auto& thread : std::filesystem::directory_iterator("/proc/self/task", none)) {
        std::string name;
        std::ifstream(thread.path() / "comm") >> name;
        if (name.rfind("openrt-", 0) != 0) continue;
        double running = 0, ready = 0;
        if (std::ifstream(thread.path() / "schedstat") >> running >> ready) {
            sum.running += 1e-9 * running;
            sum.ready += 1e-9 * ready;
        }
    }
    return sum;
}

double statistic(RTenum name) {
    RTint64 microseconds = 0;
    rtGetInteger64v(name, &microseconds);
    return 1e-6 * double(microseconds);
}

/// The longest time between two tiles of one thread, in nanoseconds.
std::atomic<int64_t> longestTile;

void RTAPIENTRY noteTile(RTuint frame, RTenum event, RTint, RTint, RTsizei, RTsizei, void*) {
    thread_local RTuint last = RT_INVALID;
    thread_local Clock::time_point then;
    const auto now = Clock::now();
    if (event == RT_FRAME_PROGRESS && frame == last) {
        const int64_t time = (now - then) / std::chrono::nanoseconds(1);
        int64_t most = longestTile.load();
        while (time > most && !longestTile.compare_exchange_weak(most, time)) {
        }
    }
    last = frame;
    then = now;
}

} // namespace

QueueFigures measureQueue(const DynamicScene& scene, const DynamicOptions& options,
                          unsigned frames) {
    constexpr unsigned kDepth = 4;
    const std::size_t bytes = std::size_t(options.size) * options.size * 4;
    std::vector<std::vector<RTubyte>> pixels(kDepth, std::vector<RTubyte>(bytes));
    BallFrames application(scene, options.threads, true);
    rtFrameDepth(kDepth);
    const auto queue = [&](unsigned number) {
        rtSetFrameBuffer(pixels[number % kDepth].data(), options.size, options.size, RT_RGBA_8);
        application.describe(scene.step(number));
        return rtQueueFrame();
    };
    rtWaitFrame(queue(0));

    QueueFigures figures{frames, kDepth, options.threads};
    const SystemTimes before = systemTimes();
    const auto start = Clock::now();
    std::vector<RTuint> queued(frames);
    const auto finish = [&](RTuint frame) {
        rtWaitFrame(frame);
        figures.busy += statistic(RT_STAT_BUSY_MICROSECONDS);
        figures.idle += statistic(RT_STAT_IDLE_MICROSECONDS);
    };
    for (unsigned i = 0; i < frames; ++i) {
        if (i >= kDepth) finish(queued[i - kDepth]);
        queued[i] = queue(i);
    }
    for (unsigned i = frames - std::min(frames, kDepth); i < frames; ++i) finish(queued[i]);
    figures.wall = seconds(start, Clock::now());
    const SystemTimes after = systemTimes();
    figures.processor = after.running - before.running;
    figures.ready = after.ready - before.ready;
    const double side = (options.size + 31) / 32;
    figures.tile = figures.busy / (frames * side * side);

    longestTile = 0;
    rtSetFrameCallback(noteTile, nullptr);
    rtWaitFrame(queue(0));
    figures.longestTile = 1e-9 * double(longestTile.load());
    rtSetFrameCallback(nullptr, nullptr);
    std::vector<double> cancels;
    for (unsigned i = 0; i < options.repeat; ++i) {
        const RTuint frame = queue(i);
        while (rtFrameProgress(frame) < float(i % 7) / 10) std::this_thread::yield();
        const auto cancelled = Clock::now();
        rtCancelFrame(frame);
        rtWaitFrame(frame);
        cancels.push_back(seconds(cancelled, Clock::now()));
    }
    figures.cancel = median(cancels);
    figures.longestCancel = *std::max_element(cancels.begin(), cancels.end());
    application.check();
    return figures;
}

nlohmann::json QueueFigures::json() const {
    return {{"frames", frames},       {"depth", depth},
            {"threads", threads},     {"wall", wall},
            {"busy", busy},           {"idle", idle},
            {"processor", processor}, {"ready", ready},
            {"tile", tile},           {"longestTile", longestTile},
            {"cancel", cancel},       {"longestCancel", longestCancel}};
}

std::ostream& operator<<(std::ostream& out, const QueueFigures& q) {
    out << std::fixed << "queue of depth " << q.depth << ": " << q.frames << " frames, "
        << std::setprecision(2) << q.frames / q.wall << " a second; threads idle "
        << 100 * q.idle / (q.idle + q.busy) << " %, busy " << std::setprecision(3) << q.busy
        << " s";
    if (q.processor > 0)
        out << "; the system counts " << q.processor << " s running and " << q.ready
            << " s ready to run, together " << std::setprecision(2)
            << 100 * (q.processor + q.ready) / (q.busy + q.idle) << " % of busy and idle";
    return out << "\ncancelled frames end after " << std::setprecision(3) << 1e3 * q.cancel
               << " ms, " << 1e3 * q.longestCancel << " ms at most; a tile takes "
               << 1e3 * q.tile << " ms, " << 1e3 * q.longestTile << " ms at most\n";
}

} // namespace smart::bench
