// SPDX-License-Identifier: MIT
// What the kd-tree's tests share: triangles as primitives, and a checker of finished trees.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "libsmart/accel/kd_builder.h"
#include "libsmart/accel/triangle_clip.h"
#include "libsmart/kernel/view.h"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define KD_TEST_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define KD_TEST_SANITIZED 1
#endif
#endif
#ifndef KD_TEST_SANITIZED
#define KD_TEST_SANITIZED 0
#endif

namespace smart::test {

inline constexpr bool kSanitized = KD_TEST_SANITIZED;

inline Aabb boundsOf(const Triangle& triangle) {
    Aabb box;
    box.add(triangle.v0);
    box.add(triangle.v1);
    box.add(triangle.v2);
    return box;
}

class TrianglePrimitives : public KdPrimitives {
public:
    explicit TrianglePrimitives(const std::vector<Triangle>& triangles) : triangles_(triangles) {}
    virtual ~TrianglePrimitives() = default;
    uint32_t count() const override { return uint32_t(triangles_.size()); }
    Aabb bounds(uint32_t prim) const override { return boundsOf(triangles_[prim]); }
    Aabb clipped(uint32_t prim, const Aabb& cell) const override {
        const Triangle& triangle = triangles_[prim];
        return clipTriangle(triangle.v0, triangle.v1, triangle.v2, cell);
    }

protected:
    const std::vector<Triangle>& triangles_;
};

struct KdLeafCounts {
    uint64_t leaves = 0, emptyLeaves = 0, largestLeaf = 0;
    uint32_t depth = 0;
};

/// Whether nodes, leaves and cells are as kd_node.h says: each node and each reference used once,
/// splits strictly inside their cells (so that the leaves' cells partition the root's), the depth
/// within its limit. Empty when all is well, else the first fault in words.
std::string checkKdStructure(const KdTree& tree, uint32_t primCount,
                             KdLeafCounts* counts = nullptr);

/// How many times a triangle is missing from a leaf although it meets the inside of its cell by
/// more than 2^-40 of the coordinates (separating axes, in double), or a vertex lies in no cell,
/// faces included, whose leaf holds its triangle.
uint64_t countMissing(const KdTree& tree, const std::vector<Triangle>& triangles);

} // namespace smart::test
