// SPDX-License-Identifier: MIT
#include "compat/openrt/other_processes.h"

#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "compat/openrt/init_arguments.h"
#include "compat/recorder/context.h"
#include "compat/recorder/error_log.h"
#include "compat/remote/mpi_job.h"
#include "compat/stream/call_player.h"
#include "compat/stream/call_recording.h"
#include "compat/stream/call_sink.h"
#include "libsmart/base/immortal.h"
#include "libsmart/remote/build_id.h"
#include "libsmart/remote/remote_service.h"
#include "libsmart/remote/remote_workers.h"
#include "libsmart/render/worker.h"
#include "openrt/rt_core.h"
#include "openrt/version.h"

namespace smart::compat {
namespace {

using namespace std::chrono_literals;

constexpr auto kStart = 10s; ///< so long all processes have for the way to rtInit
constexpr auto kEnd = 10s;  ///< and, when nothing moves, for the end

void warn(const std::string& text) noexcept {
    std::fprintf(stderr, "openrt: %s\n", text.c_str());
    logError(ErrorCode::InvalidOperation, "rtInit", text.c_str());
}

/// Pictures are equal to the bit where this is.
std::string libraryIdentity() {
    return OPENRT_VERSION_STRING " build " + buildId();
}

Packing packingFromEnvironment() {
    const char* const text = secure_getenv("OPENRT_MPI_PACK");
    const std::string wish = text ? text : "";
    if (wish == "always") return Packing::Always;
    if (wish == "never") return Packing::Never;
    if (!wish.empty()) warn("OPENRT_MPI_PACK=" + wish + ": neither always nor never; tiles are "
                            "packed when that pays");
    return Packing::WhenItPays;
}

class SharingSink final : public CallSink {
public:
    explicit SharingSink(RemoteWorkers& workers) : workers_(workers) {}
    void record(std::span<const std::byte> records) override { workers_.addCall(records); }
    void flush() override { workers_.flushCalls(); }
    bool wantsPictures() const override { return false; }

private:
    RemoteWorkers& workers_;
};

/// Of this process. Never ends: threads may still have contexts when it does.
struct Job {
    pid_t process = 0; ///< and not its children's
    MpiRanks* ranks = nullptr;
    std::unique_ptr<RemoteWorkers> workers;
    std::unique_ptr<SharingSink> sink;
    std::unique_ptr<RemoteService> service;
    bool isServing = false;
};

Job& job() {
    static Immortal<Job> instance;
    return instance.get();
}

/// What the ranks did, where the environment asks for it.
void report(const Job& j) {
    if (!secure_getenv("OPENRT_MPI_REPORT")) return;
    const RemoteTraffic t = j.workers->traffic();
    std::fprintf(stderr,
                 "openrt: this process had %llu of its tiles by %u other ranks; sent %llu bytes of "
                 "calls, received %llu bytes of pixels as %llu; %llu tiles were given to others\n",
                 static_cast<unsigned long long>(t.tilesAnswered), j.workers->working(),
                 static_cast<unsigned long long>(t.callBytes),
                 static_cast<unsigned long long>(t.pixelBytes),
                 static_cast<unsigned long long>(t.answerBytes),
                 static_cast<unsigned long long>(t.tilesReturned));
}

/// At the end of the process, after its contexts.
void leave() {
    Job& j = job();
    if (j.process != getpid()) return;
    setCallSink(nullptr);
    if (!onWorkerThread()) destroyAllContexts(); // where one was made before this was registered
    setRenderPeers(nullptr);
    report(j);
    j.workers->leave();
    if (!j.ranks->finish(kEnd)) warn("some ranks do not end");
}

void lead(Job& j) {
    RemoteOptions options;
    options.identity = libraryIdentity();
    options.codec = &j.ranks->codec();
    j.workers = std::make_unique<RemoteWorkers>(*j.ranks, std::move(options), warn);
    j.sink = std::make_unique<SharingSink>(*j.workers);
    std::atexit(leave);
    if (j.ranks->peers() == 0) return;
    setRenderPeers(j.workers.get());
    setCallSink(j.sink.get());
    if (!j.workers->waitForPeers(kStart))
        warn("some ranks have not come to rtInit yet; they render when they have");
}

void join() {
    if (!isMpiAskedFor()) return;
    if (isRecording()) return warn("this process renders alone: its calls are being recorded");
    std::string problem;
    Job& j = job();
    j.ranks = openMpi(problem);
    if (!j.ranks) return warn("this process renders alone: " + problem);
    j.process = getpid();
    if (j.ranks->rank() == 0) return lead(j);
    const unsigned threads = threadsFromEnvironment();
    j.service = std::make_unique<RemoteService>(*j.ranks, libraryIdentity(),
                                                threads != 0 ? threads : coreCount(),
                                                &j.ranks->codec(), packingFromEnvironment());
    setRenderPeers(j.service.get());
}

/// The application's results are nobody's here, and a difference ends the work.
class ServicePolicy final : public PlayPolicy {
public:
    explicit ServicePolicy(RemoteService& service) : service_(service) {}
    bool plays(const CallSignature& call) override { return call.kind != CallKind::Query; }
    void diverged(const Divergence& d) override {
        // What went wrong with pixels of a frame is an error of the process that has them all, and
        // read there by rtGetError. Frames that differ are found out by their fingerprints.
        const CallSignature* const call = findCall(d.function);
        if (call && call->kind != CallKind::State) return;
        if (std::strcmp(d.function, "rtGetError") == 0) return;
        const char* const why = rtGetErrorText();
        service_.giveUp(std::string(d.function) + " " + d.text + (why && *why ? ": " : "") +
                        (why ? why : ""));
    }

private:
    RemoteService& service_;
};

void serve(RemoteService& service) {
    PlayLimits limits;
    limits.memory = uint64_t(1) << 46; // whatever the application has
    limits.pixels = uint64_t(1) << 40;
    ServicePolicy policy(service);
    CallPlayer player(&policy, limits);
    try {
        std::vector<std::byte> record;
        while (service.nextCall(record)) player.play(record);
    } catch (const std::exception& problem) {
        service.giveUp(problem.what());
    }
    for (;;) pause(); // until the thread below ends the process
}

} // namespace

void joinOtherProcesses() noexcept {
    static std::once_flag once;
    try {
        std::call_once(once, join);
    } catch (const std::exception& problem) {
        warn(std::string("this process renders alone: ") + problem.what());
    }
}

void serveOtherProcess() noexcept {
    Job& j = job();
    if (!j.service || std::exchange(j.isServing, true)) return;
    // A call may last, or wait for what does not come any more.
    std::thread([&j] {
        j.service->waitForLeave();
        j.ranks->finish(kEnd);
        std::_Exit(0);
    }).detach();
    serve(*j.service);
}

} // namespace smart::compat
