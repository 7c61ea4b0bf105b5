// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <utility>

namespace smart {

/// Bytes that models and scenes hold, for instance those of one context; they may end on any
/// thread.
class MemoryCounter {
public:
    uint64_t bytes() const { return bytes_.load(std::memory_order_relaxed); }
    uint64_t peak() const { return peak_.load(std::memory_order_relaxed); }

    void add(uint64_t bytes) {
        const uint64_t now = bytes_.fetch_add(bytes, std::memory_order_relaxed) + bytes;
        uint64_t peak = peak_.load(std::memory_order_relaxed);
        while (now > peak && !peak_.compare_exchange_weak(peak, now, std::memory_order_relaxed)) {
        }
    }
    void subtract(uint64_t bytes) { bytes_.fetch_sub(bytes, std::memory_order_relaxed); }

private:
    std::atomic<uint64_t> bytes_{0}, peak_{0};
};

/// Bytes that are counted as long as this lives; by nobody where there is no counter.
class CountedBytes {
public:
    CountedBytes() = default;
    explicit CountedBytes(std::shared_ptr<MemoryCounter> counter, uint64_t bytes = 0)
        : counter_(std::move(counter)) {
        add(bytes);
    }
    ~CountedBytes() {
        if (counter_) counter_->subtract(bytes());
    }
    CountedBytes(const CountedBytes&) = delete;
    CountedBytes& operator=(const CountedBytes&) = delete;

    /// May be called by several threads.
    void add(uint64_t bytes) {
        bytes_.fetch_add(bytes, std::memory_order_relaxed);
        if (counter_) counter_->add(bytes);
    }
    uint64_t bytes() const { return bytes_.load(std::memory_order_relaxed); }

private:
    std::shared_ptr<MemoryCounter> counter_;
    std::atomic<uint64_t> bytes_{0};
};

/// Something whose bytes are counted as long as it lives.
template <class T>
struct Counted {
    explicit Counted(std::shared_ptr<MemoryCounter> counter) : bytes(std::move(counter)) {}

    T value;
    CountedBytes bytes;
};

} // namespace smart
