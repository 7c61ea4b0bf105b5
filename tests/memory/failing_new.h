// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace openrt::test {

/// What operator new does in a program that links failing_new.cpp, on all threads together.
enum class Failing { Never, Once, FromThenOn };

/// Lets the n-th allocation from now on fail (counted from 0), or it and all that follow.
void failAllocation(Failing how, int64_t n);
/// No further allocation fails; how many there were since failAllocation(), failed ones included.
int64_t endFailing();
/// How many allocations have failed since failAllocation().
int64_t failedAllocations();
/// Blocks that are allocated now.
int64_t liveBlocks();

} // namespace openrt::test
