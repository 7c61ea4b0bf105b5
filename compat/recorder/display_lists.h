// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <memory>

#include "compat/recorder/display_list.h"
#include "compat/recorder/name_ranges.h"

namespace smart::compat {

/// The display lists of one context by name, the one under compilation, and how deep a replay is.
/// A function that throws has changed nothing, unless it says so.
class DisplayLists {
public:
    static constexpr unsigned kMaxNesting = 64;
    /// Calls of lists that one call from outside may come to: lists that call each other several
    /// times would else make 2^64 calls within the depth allowed.
    static constexpr uint32_t kMaxCalls = 1u << 20;

    /// n consecutive names that exist from now on; 0: there are none.
    uint32_t generate(uint32_t n) { return names_.addFree(n); }
    bool exists(uint32_t name) const { return names_.contains(name); }
    void remove(uint32_t first, uint32_t n);
    /// nullptr: none of that name, or nothing in it.
    std::shared_ptr<DisplayList> find(uint32_t name) const;

    /// The list under compilation, or nullptr.
    ListRecording* recording() const { return recording_.get(); }
    void start(uint32_t name, bool executes);
    /// The list takes the place of the one of its name. Throws std::bad_alloc; no list is under
    /// compilation afterwards all the same.
    void finish();

    uint32_t base() const { return base_; }
    void setBase(uint32_t base) { base_ = base; }

    /// As long as it lives, a list is being replayed.
    class Replay {
    public:
        explicit Replay(DisplayLists& lists) : lists_(lists) {
            if (lists_.depth_++ == 0) lists_.calls_ = 0;
            ++lists_.calls_;
        }
        ~Replay() { --lists_.depth_; }
        Replay(const Replay&) = delete;
        Replay& operator=(const Replay&) = delete;

    private:
        DisplayLists& lists_;
    };
    unsigned depth() const { return depth_; }
    bool callsExhausted() const { return depth_ > 0 && calls_ >= kMaxCalls; }

private:
    NameRanges names_;
    std::map<uint32_t, std::shared_ptr<DisplayList>> lists_; ///< those with contents
    std::unique_ptr<ListRecording> recording_;
    uint32_t base_ = 0;
    unsigned depth_ = 0;
    uint32_t calls_ = 0;
};

} // namespace smart::compat
