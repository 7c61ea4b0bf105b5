// SPDX-License-Identifier: MIT
// What one thread of this machine can do at most, measured: the yardstick for cycles a ray.
#pragma once

namespace smart::bench {

struct Limits {
    double clockGHz = 0;         ///< additions that wait for each other, one a cycle
    double gigaflops = 0;        ///< multiplications and additions of floats, widest vectors
    double cacheGBs = 0;         ///< a = b + s * c in 256 KiB, bytes read and written
    double memoryGBs = 0;        ///< the same in 192 MiB
};

/// Takes some tenths of a second.
Limits measureLimits();

} // namespace smart::bench
