// SPDX-License-Identifier: MIT
#include "libsmart/render/worker.h"

#include <algorithm>
#include <exception>
#include <string>
#include <system_error>
#include <utility>

#if defined(__linux__)
#include <pthread.h>
#include <sched.h>
#endif

#include "libsmart/base/fp_environment.h"
#include "libsmart/base/signals_blocked.h"
#include "libsmart/geometry/model.h"

namespace smart {
namespace {

thread_local bool isWorker = false;

/// By the one who starts the thread: what comes after finds it by its name.
void nameThread([[maybe_unused]] std::jthread& thread, [[maybe_unused]] const std::string& what) {
#if defined(__linux__)
    const std::string name = "openrt-" + what; // the system takes 15 characters
    pthread_setname_np(thread.native_handle(), name.substr(0, 15).c_str());
#endif
}

} // namespace

void work(TileSource& source, const Tracer& tracer) {
    TilePixels pixels;
    TileJob job;
    while (source.next(job)) {
        std::exception_ptr failure; // handed on when this thread holds nothing of it any more
        try {
            tracer.render(*job.frame, job.tile, pixels);
        } catch (...) {
            failure = std::current_exception();
        }
        const std::exception_ptr unbuilt = takeBuildFailure();
        if (!failure) failure = unbuilt;
        if (failure)
            source.failed(job, std::move(failure));
        else
            source.done(job, pixels);
    }
}

std::jthread startWorkerThread(const char* name, std::function<void()> run) {
    const SignalsBlocked signalsBlocked;
    std::jthread thread([run = std::move(run)] {
        const FpEnvironment standard;
        isWorker = true;
        run();
    });
    nameThread(thread, name);
    return thread;
}

bool onWorkerThread() noexcept {
    return isWorker;
}

ThreadTeam::ThreadTeam(unsigned threads, TileSource& source, const Tracer& tracer) {
    const SignalsBlocked signalsBlocked;
    threads_.reserve(threads);
    for (unsigned i = 0; i < threads; ++i) {
        try {
            threads_.emplace_back([&source, &tracer] {
                const FpEnvironment standard;
                isWorker = true;
                work(source, tracer);
            });
        } catch (const std::system_error&) {
            if (threads_.empty()) throw;
            break; // the machine has no more to give: fewer do the same work
        }
        nameThread(threads_.back(), std::to_string(i));
    }
}

unsigned coreCount() {
#if defined(__linux__)
    cpu_set_t mine;
    if (sched_getaffinity(0, sizeof mine, &mine) == 0)
        return unsigned(std::max(CPU_COUNT(&mine), 1));
#endif
    return std::max(std::thread::hardware_concurrency(), 1u);
}

} // namespace smart
