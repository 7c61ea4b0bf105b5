// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace smart::compat {

struct GridBox {
    int32_t low[2], high[2];
};

/// Finds the boxes that overlap or touch: divides them at medians, those in both parts being
/// looked at twice, as long as these are not many, and sweeps along x over what is left.
template <class Visit>
class BoxPairs {
public:
    /// Calls visit(i, k), i > k, at least once for each pair that overlaps, and for few others.
    /// Boxes are in the order of low[0].
    BoxPairs(const std::vector<GridBox>& boxes, const Visit& visit)
        : boxes_(boxes), visit_(visit), copiesLeft_(8 * boxes.size()) {
        std::vector<uint32_t> all(boxes.size());
        std::iota(all.begin(), all.end(), 0u);
        find(all);
    }

private:
    using Set = std::vector<uint32_t>; ///< ascending

    struct Split {
        int axis;
        int32_t at;
        std::size_t below, above; ///< how many reach to `at`, and beyond it
        std::size_t larger() const { return std::max(below, above); }
    };

    void find(const Set& set) {
        constexpr std::size_t kFew = 32;
        if (set.size() <= kFew) return sweep(set);
        const Split x = median(set, 0), y = median(set, 1);
        const Split& split = x.larger() <= y.larger() ? x : y;
        const std::size_t copies = split.below + split.above - set.size();
        if (copies > std::min(set.size() / 2, copiesLeft_) ||
            split.larger() > set.size() / 5 * 4)
            return sweep(set);
        copiesLeft_ -= copies;
        find(part(set, split.below, [&](const GridBox& box) {
            return box.low[split.axis] <= split.at;
        }));
        find(part(set, split.above, [&](const GridBox& box) {
            return box.high[split.axis] > split.at;
        }));
    }

    Split median(const Set& set, int axis) const {
        std::vector<int32_t> middles;
        middles.reserve(set.size());
        for (const uint32_t i : set)
            middles.push_back(std::midpoint(boxes_[i].low[axis], boxes_[i].high[axis]));
        const auto middle = middles.begin() + std::ptrdiff_t(middles.size() / 2);
        std::nth_element(middles.begin(), middle, middles.end());
        Split split{axis, *middle, 0, 0};
        for (const uint32_t i : set) {
            split.below += boxes_[i].low[axis] <= split.at;
            split.above += boxes_[i].high[axis] > split.at;
        }
        return split;
    }

    template <class Holds>
    Set part(const Set& set, std::size_t count, Holds&& holds) const {
        Set result;
        result.reserve(count);
        for (const uint32_t i : set)
            if (holds(boxes_[i])) result.push_back(i);
        return result;
    }

    void sweep(const Set& set) {
        Set active;
        for (const uint32_t i : set) {
            std::erase_if(active, [&](uint32_t k) { return boxes_[k].high[0] < boxes_[i].low[0]; });
            for (const uint32_t k : active) visit_(i, k);
            active.push_back(i);
        }
    }

    const std::vector<GridBox>& boxes_;
    const Visit& visit_;
    std::size_t copiesLeft_; ///< bounds memory and time where boxes lie across all medians
};

} // namespace smart::compat
