// SPDX-License-Identifier: MIT
#include "libsmart/render/all_hits.h"

#include <algorithm>

namespace smart {
namespace {

constexpr std::size_t kAtFirst = 256;

/// The order in which triangles were given: a model's own before those of its children.
bool submittedBefore(const Hit& a, const Hit& b) {
    for (uint32_t level = 0; level < a.levels && level < b.levels; ++level)
        if (a.path[level] != b.path[level]) return a.path[level] < b.path[level];
    return a.levels != b.levels ? a.levels < b.levels : a.triangle < b.triangle;
}

} // namespace

void AllHits::find(Kernel intersectAll, const ModelView& scene, const RayPacket& rays) {
    if (met_.empty()) {
        met_.resize(kAtFirst);
        lanes_.resize(kAtFirst);
    }
    HitList list{};
    while (true) {
        list = {met_.data(), lanes_.data(), uint32_t(met_.size()), 0};
        intersectAll(scene, rays, list);
        if (list.count <= list.capacity) break;
        met_.resize(list.count);
        lanes_.resize(list.count);
    }
    std::fill_n(ends_, kPacketSize, 0u);
    for (uint32_t i = 0; i < list.count; ++i) ++ends_[lanes_[i]];
    uint32_t before = 0;
    for (int lane = 0; lane < kPacketSize; ++lane) {
        begins_[lane] = before;
        before += ends_[lane];
        ends_[lane] = begins_[lane];
    }
    hits_.resize(std::max<std::size_t>(hits_.size(), list.count));
    for (uint32_t i = 0; i < list.count; ++i) hits_[ends_[lanes_[i]]++] = met_[i];
    for (int lane = 0; lane < kPacketSize; ++lane) {
        const auto first = hits_.begin() + begins_[lane], end = hits_.begin() + ends_[lane];
        std::sort(first, end, submittedBefore);
        const auto last = std::unique(first, end, [](const Hit& a, const Hit& b) {
            return !submittedBefore(a, b); // sorted: not before is the same
        });
        ends_[lane] = uint32_t(last - hits_.begin());
    }
}

} // namespace smart
