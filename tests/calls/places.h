// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

namespace openrt::test {

/// A state of the library in which a call is made.
struct Place {
    const char* name;
    void (*enter)();
    void (*leave)();
    /// Without a current context nothing can be recorded, and nothing may happen.
    bool current = true;
};

/// Those within one process and thread; each starts in a fresh context.
const std::vector<Place>& places();

/// Makes the calls in the callback of a frame that is being rendered.
void insideFrameCallback(const std::function<void()>& calls);
/// Makes the calls in the child of a fork, with frames in flight in the parent; whether the child
/// ended with exit status 0, within a minute.
bool inChild(const std::function<int()>& calls);

} // namespace openrt::test
