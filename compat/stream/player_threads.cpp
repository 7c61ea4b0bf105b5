// SPDX-License-Identifier: MIT
#include "compat/stream/player_threads.h"

#include <condition_variable>
#include <exception>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

#include "compat/stream/call_player.h"

namespace smart::compat {

class PlayerThreads::Thread {
public:
    Thread() : thread_([this] { serve(); }) {}
    ~Thread() {
        {
            const std::lock_guard lock(mutex_);
            ends_ = true;
        }
        changed_.notify_all();
        thread_.join();
    }
    void run(const std::function<void()>& work) {
        std::unique_lock lock(mutex_);
        work_ = &work;
        changed_.notify_all();
        changed_.wait(lock, [this] { return !work_; });
        if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
    }

private:
    void serve() {
        std::unique_lock lock(mutex_);
        for (;;) {
            changed_.wait(lock, [this] { return work_ || ends_; });
            if (!work_) return;
            try {
                (*work_)();
            } catch (...) {
                error_ = std::current_exception();
            }
            work_ = nullptr;
            changed_.notify_all();
        }
    }

    std::mutex mutex_;
    std::condition_variable changed_;
    const std::function<void()>* work_ = nullptr;
    std::exception_ptr error_;
    bool ends_ = false;
    std::thread thread_; // last: it uses the others
};

PlayerThreads::PlayerThreads(unsigned most) : most_(most) {}
PlayerThreads::~PlayerThreads() = default;

void PlayerThreads::run(uint16_t number, const std::function<void()>& work) {
    if (first_ < 0) first_ = number;
    if (number == first_) return work();
    std::unique_ptr<Thread>& thread = threads_[number];
    if (!thread) {
        if (threads_.size() > most_)
            throw StreamError("the recorded program has more than " + std::to_string(most_) +
                              " threads");
        thread = std::make_unique<Thread>();
    }
    thread->run(work);
}

} // namespace smart::compat
