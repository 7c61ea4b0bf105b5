// SPDX-License-Identifier: MIT
// Which answers about a ray are right, from the triangles alone: double arithmetic and a tree of
// boxes that share nothing with any engine.
//
// A ray of floats is itself rounded, so it stands for all rays near it: each number of its origin
// within half a unit in the last place of the origin's largest number, each of its direction
// likewise, its limits likewise. An answer is right if one of these rays has it. Between
// neighbouring triangles one of the two is hit by every such ray, so that light through a gap is
// wrong; beside a silhouette both the edge and what lies behind it are right. Of the rays near a
// ray those at the corners of that box are tried, where edge functions are largest and smallest,
// and some between them. Two distances are equal where they differ by less than two units in the
// last place of a float.
#pragma once

#include <cstdint>
#include <mutex>
#include <vector>

#include "libsmart/kernel/packet.h"
#include "libsmart/kernel/view.h"

namespace smart::bench {

enum class Verdict {
    Right, ///< what the ray as given has
    Tie,   ///< what a ray near it has
    Wrong
};

class Truth {
public:
    /// Keeps a reference to the triangles. The tree is made when it is first needed.
    explicit Truth(const std::vector<Triangle>& triangles) : triangles_(triangles) {}

    /// The nearest hit is said to be `triangle` at t; kNoHit: none.
    Verdict closest(const Ray& ray, uint32_t triangle, float t) const;
    /// Something, or nothing, is said to lie in the ray's range.
    Verdict any(const Ray& ray, bool blocked) const;

private:
    struct Node {
        float lo[3], hi[3];
        uint32_t first, count; ///< leaf: places in order_; inner: its first child, and 0
    };
    struct NearRay; ///< in double

    void build() const;
    void split(uint32_t node, uint32_t first, uint32_t last) const;
    std::vector<uint32_t> candidates(const Ray& ray) const;
    template <class Accept>
    Verdict judge(const Ray& ray, const Accept& accept) const;

    const std::vector<Triangle>& triangles_;
    mutable std::once_flag built_;
    mutable std::vector<Node> nodes_;
    mutable std::vector<uint32_t> order_;
    mutable double largest_ = 0; ///< coordinate
};

} // namespace smart::bench
