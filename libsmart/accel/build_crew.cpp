// SPDX-License-Identifier: MIT
#include "libsmart/accel/build_crew.h"

#include <system_error>
#include <utility>

#include "libsmart/base/fp_environment.h"
#include "libsmart/base/signals_blocked.h"

namespace smart {

BuildCrew::~BuildCrew() {
    {
        const std::lock_guard lock(mutex_);
        closing_ = true;
    }
    begun_.notify_all();
    for (std::thread& helper : helpers_) helper.join();
}

void BuildCrew::startHelpers(std::size_t useful) {
    const SignalsBlocked signalsBlocked;
    try {
        while (helpers_.size() + 1 < threads_ && helpers_.size() + 1 < useful)
            helpers_.emplace_back([this, seen = round_] { help(seen); });
    } catch (const std::system_error&) {
        // No more threads to be had: those that run do the work.
    }
}

void BuildCrew::run(std::size_t count, Part part, const void* work) {
    if (threads_ < 2 || count < 2) {
        for (std::size_t i = 0; i < count; ++i) part(work, i);
        return;
    }
    startHelpers(count);
    {
        const std::lock_guard lock(mutex_);
        count_ = count;
        part_ = part;
        work_ = work;
        next_.store(0, std::memory_order_relaxed);
        failure_ = nullptr;
        open_ = true;
        ++round_;
    }
    begun_.notify_all();
    takeParts();
    std::unique_lock lock(mutex_);
    open_ = false;
    ended_.wait(lock, [this] { return working_ == 0; });
    if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

void BuildCrew::takeParts() {
    try {
        for (;;) {
            const std::size_t i = next_.fetch_add(1, std::memory_order_relaxed);
            if (i >= count_) return;
            part_(work_, i);
        }
    } catch (...) {
        const std::lock_guard lock(mutex_);
        if (!failure_) failure_ = std::current_exception();
        next_.store(count_, std::memory_order_relaxed);
    }
}

void BuildCrew::help(uint64_t seen) {
    const FpEnvironment standard;
    std::unique_lock lock(mutex_);
    for (;;) {
        begun_.wait(lock, [&] { return closing_ || (open_ && round_ != seen); });
        if (closing_) return;
        seen = round_;
        ++working_;
        lock.unlock();
        takeParts();
        lock.lock();
        if (--working_ == 0) ended_.notify_one();
    }
}

} // namespace smart
