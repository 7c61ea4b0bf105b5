// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace openrt::test {

/// A state of librtut in which calls are made.
struct RtutPlace {
    const char* name;
    /// A program off-screen, from its start to the end of its main loop, that makes the calls once.
    void (*run)(const std::function<void()>& calls);
    bool hasWindow = true; ///< a current one
    bool isStarted = true; ///< what is asked for does not start it
    bool isOpen = false;   ///< in a primitive or list, where little can be asked for
    bool isInLoop = false; ///< the main loop is running
};

/// Each needs a process of its own, in which no call has been made before.
const std::vector<RtutPlace>& rtutPlaces();

/// Takes a line on what a program has seen: its callbacks, in order, with clock and window.
extern std::function<void(const std::string&)> tellSeen;

/// Calls that the programs of rtutPlaces() recorded as errors so far.
extern unsigned rtutErrors;

} // namespace openrt::test
