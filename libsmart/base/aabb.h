// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <limits>

namespace smart {

/// Axis-aligned box; empty (lo > hi) until something is added. Faces belong to it.
struct Aabb {
    float lo[3] = {kInf, kInf, kInf};
    float hi[3] = {-kInf, -kInf, -kInf};

    static constexpr float kInf = std::numeric_limits<float>::infinity();

    bool empty() const { return !(lo[0] <= hi[0] && lo[1] <= hi[1] && lo[2] <= hi[2]); }
    float extent(int axis) const { return hi[axis] - lo[axis]; }
    void add(const float point[3]) {
        for (int k = 0; k < 3; ++k) {
            lo[k] = std::min(lo[k], point[k]);
            hi[k] = std::max(hi[k], point[k]);
        }
    }
    void add(const Aabb& box) {
        for (int k = 0; k < 3; ++k) {
            lo[k] = std::min(lo[k], box.lo[k]);
            hi[k] = std::max(hi[k], box.hi[k]);
        }
    }
    /// Half the surface area; 0 for an empty box. In double: scenes of any scale.
    double halfArea() const {
        if (empty()) return 0;
        const double x = double(hi[0]) - lo[0], y = double(hi[1]) - lo[1], z = double(hi[2]) - lo[2];
        return x * y + y * z + z * x;
    }
};

inline Aabb intersection(const Aabb& a, const Aabb& b) {
    Aabb box;
    for (int k = 0; k < 3; ++k) {
        box.lo[k] = std::max(a.lo[k], b.lo[k]);
        box.hi[k] = std::min(a.hi[k], b.hi[k]);
    }
    return box;
}

} // namespace smart
