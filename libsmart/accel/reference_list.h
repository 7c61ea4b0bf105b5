// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "libsmart/accel/object_split.h"
#include "libsmart/accel/build_crew.h"

namespace smart {

/// Boxes for one thread at a time.
inline constexpr std::size_t kBoxesOfPart = 16384;
inline std::size_t partsOfBoxes(std::size_t boxes) {
    return (boxes + kBoxesOfPart - 1) / kBoxesOfPart;
}

/// How many boxes that are not empty come before each part of them; the last entry: how many there
/// are. Throws Error where those are more than a tree can have.
std::vector<uint32_t> countBoxes(std::span<const Aabb> boxes, BuildCrew& crew);

/// References to the boxes that are not empty, in their order, and room for more, by their share.
struct ReferenceList {
    std::vector<BoxReference> references;
    std::size_t count = 0;
    ReferenceBounds bounds;
};
ReferenceList listReferences(std::span<const Aabb> boxes, double extraShare, BuildCrew& crew);

} // namespace smart
