// SPDX-License-Identifier: MIT
// The frames that a player has in flight: a damaged stream may look at a picture before its end.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <vector>

#include "openrt/types.h"

namespace smart::compat {

class PlayedFrames {
public:
    /// Frames draw to the memory of these keys.
    void queued(RTuint frame, const std::vector<uint64_t>& keys);
    void started(RTcontext context, std::vector<uint64_t> keys);
    void ended(RTcontext context) { started_.erase(context); }
    /// Waits for the queued frames that draw there. Throws StreamError if one draws there that was
    /// started, and is yet to be ended.
    void await(uint64_t key);

private:
    std::map<uint64_t, std::deque<RTuint>> queued_; ///< from the first that may be in flight
    std::map<RTcontext, std::vector<uint64_t>> started_;
};

} // namespace smart::compat
