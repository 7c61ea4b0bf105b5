// SPDX-License-Identifier: MIT
#include "libsmart/accel/spatial_split.h"

#include <algorithm>

#include "libsmart/accel/triangle_clip.h"

namespace smart {
namespace {

/// A triangle to be cut by planes across an axis. What is asked of its three corners or edges is
/// asked of all, without branches: where planes cut triangles no predictor can learn.
class CutTriangle {
public:
    CutTriangle(TriangleVertices v, int axis)
        : corner_{{v[0], v[1], v[2], 0.0f}, {v[3], v[4], v[5], 0.0f}, {v[6], v[7], v[8], 0.0f}},
          along_{v[axis], v[3 + axis], v[6 + axis], 0.0f} {
        const Float4 next{along_[1], along_[2], along_[0], 0.0f};
        const Float4 inverse = allOf(1.0f) / (next - along_);
        for (int i = 0; i < 3; ++i)
            step_[i] = (corner_[(i + 1) % 3] - corner_[i]) * allOf(inverse[i]);
        low_ = lesserOf(along_, next);
        high_ = greaterOf(along_, next);
    }
    /// Where the corners are along the axis.
    Float4 along() const { return along_; }
    /// Box of some of the corners.
    Box4 corners(Int4 chosen) const {
        Box4 box;
        for (int i = 0; i < 3; ++i) addIf(chosen[i], corner_[i], box);
        return box;
    }
    /// Box of the edges' points in a plane.
    Box4 at(float plane) const {
        const Float4 there = allOf(plane), far = there - along_;
        const Int4 meets = (low_ < there) & (there < high_);
        Box4 box;
        for (int i = 0; i < 3; ++i) addIf(meets[i], corner_[i] + step_[i] * allOf(far[i]), box);
        return box;
    }

private:
    static void addIf(int32_t condition, Float4 point, Box4& box) {
        const Int4 all{condition, condition, condition, condition};
        box.add({all ? point : allOf(Aabb::kInf), all ? point : allOf(-Aabb::kInf)});
    }

    Float4 corner_[3];
    Float4 along_;
    Float4 step_[3];    ///< along each edge, for a step of 1 along the axis
    Float4 low_, high_; ///< ends of the edges, along the axis
};

Box4 common(const Box4& a, const Box4& b) {
    return {greaterOf(a.lo, b.lo), lesserOf(a.hi, b.hi)};
}

} // namespace

SpacePlanes::SpacePlanes(const Box4& box, std::size_t references)
    : low_(box.lo), width_(allOf(0.0f)), scale_(allOf(0.0f)),
      bins_(references < 16 ? 4 : references < 256 ? 8 : kMostBins) {
    low_[3] = 0;
    for (int k = 0; k < 3; ++k) {
        const float extent = box.hi[k] - box.lo[k];
        const float scale = float(bins_) * 0.9999f / extent;
        if (!(extent < Aabb::kInf) || !(scale < Aabb::kInf)) continue;
        scale_[k] = scale;
        width_[k] = 1.0f / scale;
    }
}

SpatialBins::SpatialBins() = default;

void SpatialBins::add(std::span<const BoxReference> references, TriangleVertices vertices,
                      const SpacePlanes& planes) {
    for (const BoxReference& reference : references) {
        const Int4 first = planes.binsOf(reference.lo), last = planes.binsOf(reference.hi);
        for (int axis = 0; axis < 3; ++axis) {
            if (!planes.divides(axis)) continue;
            ++begin_[axis][first[axis]];
            ++end_[axis][last[axis]];
            if (first[axis] == last[axis])
                boxes_[axis][first[axis]].add(reference);
            else
                addParts(reference, vertices + 9 * std::size_t(reference.number()), planes, axis,
                         first[axis], last[axis]);
        }
    }
}

/// The parts' boxes only weigh planes against each other: they need not be conservative.
void SpatialBins::addParts(const BoxReference& reference, TriangleVertices vertices,
                           const SpacePlanes& planes, int axis, int first, int last) {
    const CutTriangle triangle(vertices, axis);
    const float begin = reference.lo[axis], end = reference.hi[axis];
    const Int4 inside = (triangle.along() >= allOf(begin)) & (triangle.along() <= allOf(end));
    const Int4 bins = planes.binsOf(triangle.along(), axis) | ~inside; // -1 for those outside
    Box4 lower = triangle.at(begin);
    for (int k = first; k <= last; ++k) {
        const Box4 upper = triangle.at(k < last ? planes.plane(axis, k + 1) : end);
        Box4 part = triangle.corners(bins == Int4{k, k, k, k});
        part.add(lower);
        part.add(upper);
        part = common(part, reference);
        if (!part.empty()) boxes_[axis][k].add(part);
        lower = upper;
    }
}

void SpatialBins::add(const SpatialBins& other) {
    for (int axis = 0; axis < 3; ++axis) {
        for (int i = 0; i < kBins; ++i) {
            boxes_[axis][i].add(other.boxes_[axis][i]);
            begin_[axis][i] += other.begin_[axis][i];
            end_[axis][i] += other.end_[axis][i];
        }
    }
}

SpatialSplit SpatialBins::best(const SpacePlanes& planes, const BoxMeasure& measure,
                               std::size_t extra) const {
    SpatialSplit best;
    for (int axis = 0; axis < 3; ++axis) {
        if (!planes.divides(axis)) continue;
        Box4 rightBoxes[kBins];
        uint32_t rightCounts[kBins];
        Box4 box;
        uint32_t n = 0;
        for (int i = planes.bins() - 1; i > 0; --i) {
            box.add(boxes_[axis][i]);
            n += end_[axis][i];
            rightBoxes[i] = box;
            rightCounts[i] = n;
        }
        const uint32_t all = n + end_[axis][0];
        box = Box4();
        n = 0;
        for (int i = 1; i < planes.bins(); ++i) {
            box.add(boxes_[axis][i - 1]);
            n += begin_[axis][i - 1];
            const uint32_t right = rightCounts[i];
            if (n == 0 || right == 0 || n == all || right == all) continue;
            if (box.empty() || rightBoxes[i].empty() || std::size_t(n) + right - all > extra)
                continue;
            const float total =
                measure(box) * float(n) + measure(rightBoxes[i]) * float(right);
            if (total < best.cost)
                best = {total, axis, planes.plane(axis, i), box, rightBoxes[i], n, right};
        }
    }
    return best;
}

void divideAtPlane(std::span<const BoxReference> references, TriangleVertices vertices,
                   const SpatialSplit& split, const BoxMeasure& measure, std::size_t extra,
                   SplitSides& sides) {
    const int axis = split.axis;
    const float leftMeasure = measure(split.left), rightMeasure = measure(split.right);
    const float leftCount = float(split.leftCount), rightCount = float(split.rightCount);
    for (const BoxReference& reference : references) {
        if (reference.hi[axis] <= split.plane) {
            sides.addLeft(reference);
            continue;
        }
        if (reference.lo[axis] >= split.plane) {
            sides.addRight(reference);
            continue;
        }
        Box4 whole = split.left;
        whole.add(reference);
        const float allLeft = measure(whole) * leftCount + rightMeasure * (rightCount - 1);
        whole = split.right;
        whole.add(reference);
        const float allRight = leftMeasure * (leftCount - 1) + measure(whole) * rightCount;
        const bool cut = extra > 0 && !(std::min(allLeft, allRight) <= split.cost);
        if (!cut) {
            if (allLeft <= allRight)
                sides.addLeft(reference);
            else
                sides.addRight(reference);
            continue;
        }
        const uint32_t number = reference.number();
        const float* const v = vertices + 9 * std::size_t(number);
        Aabb left = reference.aabb(), right = left;
        left.hi[axis] = right.lo[axis] = split.plane;
        left = clipTriangle(v, v + 3, v + 6, left);
        right = clipTriangle(v, v + 3, v + 6, right);
        if (left.empty() && right.empty()) { // what is left of it is thinner than rounding
            sides.addLeft(reference);
            continue;
        }
        if (!left.empty()) sides.addLeft(BoxReference(Box4(left), number));
        if (!right.empty()) sides.addRight(BoxReference(Box4(right), number));
        extra -= !left.empty() && !right.empty();
    }
}

} // namespace smart
