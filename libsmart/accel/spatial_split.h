// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "libsmart/accel/object_split.h"

namespace smart {

/// Nine floats a triangle: its vertices one after another.
using TriangleVertices = const float*;

/// Equal bins between two ends of each axis; the planes between them may cut triangles.
class SpacePlanes {
public:
    static constexpr int kMostBins = 16;
    /// Fewer bins for few references.
    SpacePlanes(const Box4& box, std::size_t references);
    int bins() const { return bins_; }
    bool divides(int axis) const { return scale_[axis] > 0; }
    float plane(int axis, int i) const { return low_[axis] + width_[axis] * float(i); }
    /// Bin of each coordinate.
    Int4 binsOf(Float4 point) const { return binsAt((point - low_) * scale_); }
    /// Bin of four coordinates of one axis.
    Int4 binsOf(Float4 along, int axis) const {
        return binsAt((along - allOf(low_[axis])) * allOf(scale_[axis]));
    }

private:
    Int4 binsAt(Float4 place) const {
        return toIntegers(greaterOf(lesserOf(place, allOf(float(bins_ - 1))), allOf(0.0f)));
    }

    Float4 low_, width_, scale_;
    int bins_;
};

/// A plane at which triangles are cut in two.
struct SpatialSplit {
    float cost = Aabb::kInf; ///< as ObjectSplit::cost
    int axis = 0;
    float plane = 0;
    Box4 left, right;
    uint32_t leftCount = 0, rightCount = 0; ///< references, those on both sides counted twice
};

/// Stich, Friedrich, Dietrich, "Spatial splits in bounding volume hierarchies", HPG 2009: a
/// triangle adds to each bin that it meets the box of its part there.
class SpatialBins {
public:
    SpatialBins();
    void add(std::span<const BoxReference> references, TriangleVertices vertices,
             const SpacePlanes& planes);
    void add(const SpatialBins& other);
    /// The best of those that make no more than `extra` references.
    SpatialSplit best(const SpacePlanes& planes, const BoxMeasure& measure,
                      std::size_t extra) const;

private:
    static constexpr int kBins = SpacePlanes::kMostBins;
    void addParts(const BoxReference& reference, TriangleVertices vertices,
                  const SpacePlanes& planes, int axis, int first, int last);

    Box4 boxes_[3][kBins];
    uint32_t begin_[3][kBins] = {}, end_[3][kBins] = {};
};

/// The two sides of a split.
struct SplitSides {
    std::vector<BoxReference> left, right;
    ReferenceBounds leftBounds, rightBounds;

    void clear() {
        left.clear();
        right.clear();
        leftBounds = rightBounds = {};
    }
    void addLeft(const BoxReference& reference) {
        left.push_back(reference);
        leftBounds.add(reference);
    }
    void addRight(const BoxReference& reference) {
        right.push_back(reference);
        rightBounds.add(reference);
    }
};

/// Appends references to the sides. A triangle that the plane cuts goes to both with the boxes of
/// its parts, unless one side is cheaper for the whole, or `extra` more references were made.
void divideAtPlane(std::span<const BoxReference> references, TriangleVertices vertices,
                   const SpatialSplit& split, const BoxMeasure& measure, std::size_t extra,
                   SplitSides& sides);

} // namespace smart
