// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "libsmart/accel/build_crew.h"
#include "libsmart/accel/box_reference.h"

namespace smart {

/// A box by its place on a space-filling curve: Morton code of the centre in the upper half, number
/// in the lower.
using MortonKey = uint64_t;
inline uint32_t mortonCode(MortonKey key) { return uint32_t(key >> 32); }
inline uint32_t mortonNumber(MortonKey key) { return uint32_t(key); }

/// Keys along the curve, and the bounds of what they stand for.
struct MortonOrder {
    std::vector<MortonKey> keys;
    Box4 bounds;
};

/// The boxes that are not empty. Where many share a code of 10 bits an
/// axis, they are in the order of the curve through their own bounds. The same for any number of
/// threads.
MortonOrder mortonOrder(std::span<const Aabb> boxes, BuildCrew& crew);

/// Where the range of keys is divided by the first bit in which its codes differ, or in the middle
/// where they do not: how many are on the left.
std::size_t mortonSplit(std::span<const MortonKey> keys);

} // namespace smart
