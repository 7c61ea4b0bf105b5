// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "libsmart/kernel/packet.h"

namespace smart {

/// What was found out about triangles on the ways on which a scene's hits meet them. Neighbouring
/// rays meet few: a triangle has one place here, and the last one that asked for it stays.
/// Belongs to one thread.
template <class Value>
class WayCache {
public:
    WayCache() : entries_(kEntries) {}

    void clear() {
        for (Entry& entry : entries_) entry.levels = 0;
    }
    /// The hit's entry; `isNew`: it holds what belongs to no hit, and is to be filled. Valid up to
    /// the next question.
    Value& find(const Hit& hit, bool& isNew) {
        uint32_t mixed = hit.triangle * 0x9E3779B1u;
        for (uint32_t level = 0; level < hit.levels; ++level)
            mixed = (mixed ^ hit.path[level]) * 0x85EBCA6Bu;
        Entry& entry = entries_[mixed >> (32 - kBits)];
        isNew = entry.triangle != hit.triangle || entry.levels != hit.levels ||
                !std::equal(hit.path, hit.path + hit.levels, entry.path);
        if (isNew) {
            entry.triangle = hit.triangle;
            entry.levels = hit.levels;
            std::copy_n(hit.path, hit.levels, entry.path);
        }
        return entry.value;
    }

private:
    static constexpr int kBits = 7;
    static constexpr std::size_t kEntries = std::size_t(1) << kBits;
    struct Entry {
        uint32_t levels = 0, triangle = 0; ///< no levels: of no hit
        uint32_t path[kMaxLevels];
        Value value;
    };

    std::vector<Entry> entries_;
};

} // namespace smart
