// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>

namespace smart::compat {

/// A set of names from 1 to 2^32 - 1, kept as ranges: a million consecutive names are one entry.
/// A function that throws has changed nothing.
class NameRanges {
public:
    bool contains(uint32_t name) const;
    /// Adds the lowest n consecutive names that are free and returns the first; 0: there are none.
    /// Names next to a taken one need no memory: of several calls for one name only the first may
    /// throw.
    uint32_t addFree(uint32_t n);
    void add(uint32_t name) { insert(name, name); }
    /// Removes first..last, as far as they are there.
    void remove(uint32_t first, uint32_t last);

private:
    void insert(uint32_t first, uint32_t last);

    std::map<uint32_t, uint32_t> ranges_; ///< first -> last; apart from each other
};

} // namespace smart::compat
