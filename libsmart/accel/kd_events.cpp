// SPDX-License-Identifier: MIT
#include "libsmart/accel/kd_events.h"

#include <algorithm>
#include <array>

namespace smart {

KdEventLists KdEventArena::allocate(std::size_t prims) {
    const std::size_t perAxis = 2 * prims + 1, needed = 3 * perAxis;
    if (chunk_ == chunks_.size() || chunks_[chunk_].size - used_ < needed) {
        if (chunk_ < chunks_.size() && used_ > 0) ++chunk_;
        if (chunk_ == chunks_.size() || chunks_[chunk_].size < needed) {
            const std::size_t last = chunk_ > 0 ? chunks_[chunk_ - 1].size : 0;
            chunks_.erase(chunks_.begin() + std::ptrdiff_t(chunk_), chunks_.end()); // too small
            const std::size_t size = std::max(needed, 2 * last);
            chunks_.push_back({std::make_unique_for_overwrite<KdEvent[]>(size), size});
        }
        used_ = 0;
    }
    KdEventLists lists;
    for (std::size_t k = 0; k < 3; ++k) {
        lists.events[k] = chunks_[chunk_].events.get() + used_ + k * perAxis;
    }
    used_ += needed;
    return lists;
}

// Radix sort, least significant digit first, over position and kind.
void sortKdEvents(KdEvent* events, std::size_t count, std::vector<KdEvent>& scratch) {
    if (count < 2048) {
        std::sort(events, events + count);
        return;
    }
    constexpr int kDigitBits = 12, kFirstBit = 28; // three digits reach to the top
    constexpr std::size_t kDigits = std::size_t(1) << kDigitBits;
    if (scratch.size() < count) scratch.resize(count);
    KdEvent *from = events, *to = scratch.data();
    for (int shift = kFirstBit; shift < 64; shift += kDigitBits) {
        std::array<std::size_t, kDigits> next{};
        for (std::size_t i = 0; i < count; ++i) ++next[(from[i] >> shift) & (kDigits - 1)];
        std::size_t start = 0;
        for (std::size_t& position : next) {
            const std::size_t size = position;
            position = start;
            start += size;
        }
        for (std::size_t i = 0; i < count; ++i) {
            to[next[(from[i] >> shift) & (kDigits - 1)]++] = from[i];
        }
        std::swap(from, to);
    }
    std::copy_n(from, count, events); // an odd number of passes ends in the scratch room
}

void mergeKdEvents(KdEvent* list, std::size_t count, const KdEvent* added,
                   std::size_t addedCount) {
    // From the back, so that nothing is overwritten; what lies before the first added event stays.
    while (addedCount > 0 && count > 0) {
        const KdEvent a = list[count - 1], b = added[addedCount - 1];
        const bool fromList = a > b;
        list[count + addedCount - 1] = fromList ? a : b;
        count -= fromList;
        addedCount -= !fromList;
    }
    std::copy_n(added, addedCount, list);
}

} // namespace smart
