// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <utility>

namespace smart {

/// Memory that a thread uses again for one tile after the other. Whoever asks while it is lent
/// gets some of its own.
template <class T>
class ThreadLoan {
public:
    ThreadLoan() : lent_(std::move(spare())) {
        if (!lent_) lent_ = std::make_unique<T>();
    }
    ~ThreadLoan() { spare() = std::move(lent_); }
    ThreadLoan(const ThreadLoan&) = delete;
    ThreadLoan& operator=(const ThreadLoan&) = delete;

    T& operator*() const { return *lent_; }
    T* operator->() const { return lent_.get(); }

private:
    static std::unique_ptr<T>& spare() {
        thread_local std::unique_ptr<T> kept;
        return kept;
    }

    std::unique_ptr<T> lent_;
};

} // namespace smart
