// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace openrt::test {

/// What a process is to its host, as far as a library could disturb it: floating-point control and
/// signal mask of the thread, signal handlers, locale, affinity, current folder, file mode mask,
/// what was written on stdout, environment.
class HostState {
public:
    /// As it is now, on the calling thread.
    static HostState now();
    /// Names of what differs; empty: nothing.
    std::string differences(const HostState& other) const;

private:
    std::string parts_[10];
};

/// Makes the host an unusual one, in which every careless restoration of a default shows: rounding
/// upwards, denormal numbers flushed, a signal blocked, a locale of its own, one core.
void makeHostUnusual();

} // namespace openrt::test
