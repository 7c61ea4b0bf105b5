// SPDX-License-Identifier: MIT
#include "libsmart/accel/object_split.h"

#include <algorithm>

namespace smart {

ReferenceBounds boundsOf(std::span<const BoxReference> references) {
    ReferenceBounds bounds;
    for (const BoxReference& reference : references) bounds.add(reference);
    return bounds;
}

CentreBins::CentreBins(const Box4& centres, int bins)
    : low_(centres.lo), scale_(allOf(0.0f)), last_(float(bins - 1)) {
    for (int k = 0; k < 3; ++k) {
        const float scale = float(bins) * 0.9999f / (centres.hi[k] - centres.lo[k]);
        if (scale < Aabb::kInf) scale_[k] = scale;
    }
    low_[3] = 0;
}

template <int kBins>
void ObjectBins<kBins>::add(std::span<const BoxReference> references, const CentreBins& bins) {
    for (const BoxReference& reference : references) {
        const Int4 at = bins(reference);
        for (int axis = 0; axis < 3; ++axis) {
            boxes_[axis][at[axis]].add(reference);
            ++counts_[axis][at[axis]];
        }
    }
}

template <int kBins>
void ObjectBins<kBins>::add(const ObjectBins& other) {
    for (int axis = 0; axis < 3; ++axis) {
        for (int i = 0; i < kBins; ++i) {
            boxes_[axis][i].add(other.boxes_[axis][i]);
            counts_[axis][i] += other.counts_[axis][i];
        }
    }
}

template <int kBins>
ObjectSplit ObjectBins<kBins>::best(const CentreBins& bins, const BoxMeasure& measure) const {
    ObjectSplit best;
    for (int axis = 0; axis < 3; ++axis) {
        if (!bins.divides(axis)) continue;
        const Box4* const boxes = boxes_[axis];
        const uint32_t* const counts = counts_[axis];
        Box4 rightBoxes[kBins];
        float rightCosts[kBins];
        Box4 box;
        uint32_t n = 0;
        float cost = -1.0f; // of nothing
        for (int i = kBins - 1; i > 0; --i) {
            if (counts[i] > 0) {
                box.add(boxes[i]);
                n += counts[i];
                cost = measure(box) * float(n);
            }
            rightBoxes[i] = box;
            rightCosts[i] = cost;
        }
        box = Box4();
        n = 0;
        for (int i = 1; i < kBins; ++i) {
            if (rightCosts[i] < 0) break;
            if (counts[i - 1] == 0) continue;
            box.add(boxes[i - 1]);
            n += counts[i - 1];
            const float total = measure(box) * float(n) + rightCosts[i];
            if (total < best.cost) best = {total, axis, i, box, rightBoxes[i]};
        }
    }
    return best;
}

template class ObjectBins<kMostBins>;

namespace {

template <int kBins>
ObjectSplit findAmong(std::span<const BoxReference> references, const Box4& centres,
                      const BoxMeasure& measure, CentreBins& bins) {
    bins = CentreBins(centres, kBins);
    if (!bins.divides(0) && !bins.divides(1) && !bins.divides(2)) return {};
    ObjectBins<kBins> found;
    found.add(references, bins);
    return found.best(bins, measure);
}

} // namespace

ObjectSplit findObjectSplit(std::span<const BoxReference> references, const Box4& centres,
                            const BoxMeasure& measure, CentreBins& bins) {
    if (references.size() < 32) return findAmong<8>(references, centres, measure, bins);
    if (references.size() < 512) return findAmong<16>(references, centres, measure, bins);
    return findAmong<kMostBins>(references, centres, measure, bins);
}

} // namespace smart
