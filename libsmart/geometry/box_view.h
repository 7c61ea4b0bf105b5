// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include "libsmart/base/aabb.h"
#include "libsmart/kernel/view.h"

namespace smart {

inline BoxView makeBoxView(const Aabb& box) {
    BoxView view{};
    for (int k = 0; k < 3; ++k) {
        view.lo[k] = box.lo[k];
        view.hi[k] = box.hi[k];
        if (box.empty()) continue;
        view.maxAbs = std::max({view.maxAbs, std::fabs(box.lo[k]), std::fabs(box.hi[k])});
    }
    return view;
}

} // namespace smart
