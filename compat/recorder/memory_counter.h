// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <utility>

namespace smart::compat {

/// Bytes that the models and scenes of one context hold; they may end on any thread.
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

/// Place for an object that a counter counts as long as it lives. Made before the object, so that
/// nothing can fail once that exists.
template <class T>
class CountedPlace {
public:
    explicit CountedPlace(std::shared_ptr<MemoryCounter> counter) : counter_(std::move(counter)) {}
    ~CountedPlace() {
        object_.reset();
        counter_->subtract(bytes_);
    }
    CountedPlace(const CountedPlace&) = delete;
    CountedPlace& operator=(const CountedPlace&) = delete;

    /// The object, shared through the place.
    static std::shared_ptr<T> put(std::shared_ptr<CountedPlace> place, std::shared_ptr<T> object,
                                  uint64_t bytes) noexcept {
        T* const address = object.get();
        place->object_ = std::move(object);
        place->bytes_ = bytes;
        place->counter_->add(bytes);
        return std::shared_ptr<T>(std::move(place), address);
    }

private:
    std::shared_ptr<MemoryCounter> counter_;
    std::shared_ptr<T> object_;
    uint64_t bytes_ = 0;
};

} // namespace smart::compat
