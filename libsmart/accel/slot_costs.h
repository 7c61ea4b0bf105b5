// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "libsmart/accel/box_reference.h"
#include "libsmart/accel/wide_node.h"

namespace smart {

/// To fill n slots of a wide node at the least cost: how many of them the left child takes; 0: it is
/// better to fill fewer. And how many where the node is made a wide node itself.
struct SlotShares {
    std::array<uint8_t, kWideChildren + 1> left;
    uint8_t own;
};

/// Least cost of filling up to so many slots of a wide node with a subtree.
class SlotCosts {
public:
    /// Of what takes one slot, and has no use for more.
    explicit SlotCosts(float cost = 0.0f) {
        std::fill_n(of_, kWideChildren, Aabb::kInf);
        std::fill_n(of_ + kWideChildren, kWideChildren, cost);
    }

    float ofSlots(int n) const { return of_[kWideChildren - 1 + n]; }

    /// Distributes slots between two subtrees, for each number of them. `node`: what a wide node
    /// costs by itself. `leaf`: what one leaf of everything costs, infinite where that can not be.
    /// Whether the leaf is cheapest.
    bool distribute(const SlotCosts& left, const SlotCosts& right, float node, float leaf,
                    SlotShares& shares) {
        useful_ = std::min(left.useful_ + right.useful_, kWideChildren);
        // Four numbers of slots at a time.
        for (int n = 1; n <= useful_; n += 4) {
            Float4 least = allOf(Aabb::kInf);
            Int4 share{};
            const int end = std::min(left.useful_, n + 2);
            for (int i = std::max(1, n - right.useful_); i <= end; ++i) {
                const float* const r = &right.of_[kWideChildren - 1 + n - i];
                const Float4 cost = allOf(left.ofSlots(i)) + Float4{r[0], r[1], r[2], r[3]};
                const Int4 better = cost < least;
                least = better ? cost : least;
                share = better ? Int4{i, i, i, i} : share;
            }
            for (int k = 0; k < 4; ++k) {
                set(n + k, least[k]);
                shares.left[std::size_t(n + k)] = uint8_t(share[k]);
            }
        }
        shares.own = shares.left[std::size_t(useful_)];
        set(1, node + ofSlots(useful_));
        const bool isLeaf = !(ofSlots(1) < leaf) && leaf < Aabb::kInf;
        if (isLeaf) set(1, leaf);
        float least = ofSlots(1);
        for (int n = 2; n <= useful_; ++n) {
            if (ofSlots(n) < least) {
                least = ofSlots(n);
            } else {
                set(n, least);
                shares.left[std::size_t(n)] = 0;
            }
        }
        for (int n = useful_ + 1; n <= kWideChildren; ++n) {
            set(n, least);
            shares.left[std::size_t(n)] = 0;
        }
        return isLeaf;
    }

private:
    void set(int n, float cost) { of_[kWideChildren - 1 + n] = cost; }

    float of_[2 * kWideChildren]; ///< infinite where there are no slots
    int useful_ = 1;              ///< more slots save nothing
};

} // namespace smart
