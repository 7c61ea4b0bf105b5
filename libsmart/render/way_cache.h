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
    WayCache() : ways_(kEntries), values_(kEntries) {}

    void clear() {
        for (Way& way : ways_) way.levels = 0;
    }
    /// The hit's entry; `isNew`: it holds what belongs to no hit, and is to be filled. Valid up to
    /// the next question.
    Value& find(const Hit& hit, bool& isNew) {
        uint32_t mixed = hit.triangle * 0x9E3779B1u;
        for (uint32_t level = 0; level < hit.levels; ++level)
            mixed = (mixed ^ hit.path[level]) * 0x85EBCA6Bu;
        const uint32_t place = mixed >> (32 - kBits);
        Way& way = ways_[place];
        isNew = way.triangle != hit.triangle || way.levels != hit.levels;
        for (uint32_t level = 0; level < hit.levels && !isNew; ++level)
            isNew = way.path[level] != hit.path[level]; // paths are too short for a call
        if (isNew) {
            way.triangle = hit.triangle;
            way.levels = hit.levels;
            std::copy_n(hit.path, hit.levels, way.path);
        }
        return values_[place];
    }

private:
    static constexpr int kBits = 7;
    static constexpr std::size_t kEntries = std::size_t(1) << kBits;
    struct Way {
        uint32_t levels = 0, triangle = 0; ///< no levels: of no hit
        uint32_t path[kMaxLevels];
    };

    std::vector<Way> ways_; // apart from the values, which may be large
    std::vector<Value> values_;
};

} // namespace smart
