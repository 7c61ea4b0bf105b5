// SPDX-License-Identifier: MIT
// The triangles of a leaf of a wide tree, side by side: see WideView::blocks.
#pragma once

#include "libsmart/kernel/simd.h"
#include "libsmart/kernel/view.h"

namespace smart::SMART_ISA {

class TriangleBlock {
public:
    /// leaf: a child of a wide node that is one.
    TriangleBlock(const float* blocks, uint32_t leaf)
        : words_(blocks + std::size_t(kWordsOfTriangle) * ((leaf & ~kWideLeaf) >> 4)),
          count_((leaf & 15u) + 1) {}

    uint32_t count() const { return count_; }
    /// Bit i: triangle i.
    uint32_t all() const { return (2u << (count_ - 1)) - 1; }
    /// A coordinate of a vertex of all triangles; lanes beyond the last hold any bits.
    Real<kPacketSize> coordinate(int vertex, int axis) const {
        return Real<kPacketSize>::loadUnaligned(words_ + uint32_t(3 * vertex + axis) * count_);
    }
    uint32_t number(uint32_t i) const {
        uint32_t number;
        __builtin_memcpy(&number, words_ + 9 * count_ + i, sizeof number);
        return number;
    }
    HWY_INLINE void load(uint32_t i, Triangle& triangle) const {
        const float* from = words_ + i;
        for (float* vertex : {triangle.v0, triangle.v1, triangle.v2})
            for (int k = 0; k < 3; ++k, from += count_) vertex[k] = *from;
    }

private:
    const float* words_;
    uint32_t count_;
};

} // namespace smart::SMART_ISA
