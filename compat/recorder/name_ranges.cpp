// SPDX-License-Identifier: MIT
#include "compat/recorder/name_ranges.h"

#include <iterator>
#include <utility>

namespace smart::compat {

bool NameRanges::contains(uint32_t name) const {
    const auto after = ranges_.upper_bound(name);
    return after != ranges_.begin() && std::prev(after)->second >= name;
}

uint32_t NameRanges::addFree(uint32_t n) {
    if (n == 0) return 0;
    uint64_t first = 1;
    for (const auto& [start, last] : ranges_) {
        if (first + n <= start) break;
        first = uint64_t(last) + 1;
    }
    if (first + n - 1 > 0xFFFFFFFFu) return 0;
    insert(uint32_t(first), uint32_t(first + n - 1));
    return uint32_t(first);
}

void NameRanges::insert(uint32_t first, uint32_t last) {
    if (contains(first) && contains(last)) return; // one name, or all were free
    const auto after = ranges_.upper_bound(first);
    const bool meetsAfter = after != ranges_.end() && after->first == uint64_t(last) + 1;
    if (after != ranges_.begin()) {
        const auto before = std::prev(after);
        if (uint64_t(before->second) + 1 == first) {
            before->second = meetsAfter ? after->second : last;
            if (meetsAfter) ranges_.erase(after);
            return;
        }
    }
    if (meetsAfter) {
        auto node = ranges_.extract(after);
        node.key() = first;
        ranges_.insert(std::move(node));
        return;
    }
    ranges_.emplace_hint(after, first, last);
}

void NameRanges::remove(uint32_t first, uint32_t last) {
    auto range = ranges_.upper_bound(first);
    if (range != ranges_.begin() && std::prev(range)->second >= first) --range;
    // What is left above `last` is the only part that has to be added.
    if (range != ranges_.end() && range->first < first && range->second > last) {
        ranges_.emplace_hint(std::next(range), last + 1, range->second);
        range->second = first - 1;
        return;
    }
    while (range != ranges_.end() && range->first <= last) {
        if (range->first < first) {
            range->second = first - 1;
            ++range;
        } else if (range->second > last) {
            auto node = ranges_.extract(range);
            node.key() = last + 1;
            ranges_.insert(std::move(node));
            return;
        } else {
            range = ranges_.erase(range);
        }
    }
}

} // namespace smart::compat
