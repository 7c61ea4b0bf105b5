// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "libsmart/accel/box_reference.h"

namespace smart {

/// Boxes of references, and of their Box4::quarter, which are binned.
struct ReferenceBounds {
    Box4 box, centres;

    void add(const BoxReference& reference) {
        box.add(reference);
        centres.add(reference.quarter());
    }
    void add(const ReferenceBounds& bounds) {
        box.add(bounds.box);
        centres.add(bounds.centres);
    }
};
ReferenceBounds boundsOf(std::span<const BoxReference> references);

/// Which bin the centre of a box is in, of each axis.
class CentreBins {
public:
    CentreBins() = default;
    CentreBins(const Box4& centres, int bins);
    bool divides(int axis) const { return scale_[axis] > 0; }
    Int4 operator()(const BoxReference& reference) const {
        const Float4 place = (reference.quarter() - low_) * scale_;
        return toIntegers(greaterOf(lesserOf(place, allOf(last_)), allOf(0.0f)));
    }

private:
    Float4 low_{}, scale_{};
    float last_ = 0;
};

/// A plane between two bins; references go by their centres.
struct ObjectSplit {
    float cost = Aabb::kInf; ///< measure times number of references, both sides together
    int axis = 0;
    int bin = 0; ///< first one of the right side
    Box4 left, right;

    bool exists() const { return cost < Aabb::kInf; }
    bool isLeft(const CentreBins& bins, const BoxReference& reference) const {
        return bins(reference)[axis] < bin;
    }
};

/// Boxes and counts of bins. Parts of the references can be binned apart and added.
template <int kBins>
class ObjectBins {
public:
    void add(std::span<const BoxReference> references, const CentreBins& bins);
    void add(const ObjectBins& other);
    ObjectSplit best(const CentreBins& bins, const BoxMeasure& measure) const;

private:
    Box4 boxes_[3][kBins];
    uint32_t counts_[3][kBins] = {};
};
inline constexpr int kMostBins = 32;
extern template class ObjectBins<kMostBins>;

/// The best of at most kMostBins bins; of fewer where there are few references. `bins` is set to
/// what it is found with.
ObjectSplit findObjectSplit(std::span<const BoxReference> references, const Box4& centres,
                            const BoxMeasure& measure, CentreBins& bins);

} // namespace smart
