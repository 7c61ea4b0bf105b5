// SPDX-License-Identifier: MIT
#include "libsmart/accel/spatial_split.h"

#include <algorithm>

#include "libsmart/accel/triangle_clip.h"

namespace smart {
namespace {

Float4 corner(TriangleVertices triangle, int i) {
    return Float4{triangle[3 * i], triangle[3 * i + 1], triangle[3 * i + 2], 0.0f};
}

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
    Box4 parts[kBins];
    const float begin = reference.lo[axis], end = reference.hi[axis];
    for (int i = 0; i < 3; ++i) {
        const Float4 a = corner(vertices, i), b = corner(vertices, (i + 1) % 3);
        if (begin <= a[axis] && a[axis] <= end) parts[planes.binsOf(a)[axis]].add(a);
        const float low = std::min(a[axis], b[axis]), high = std::max(a[axis], b[axis]);
        if (!(low < high)) continue;
        const Float4 step = (b - a) * allOf(1.0f / (b[axis] - a[axis]));
        const auto crossing = [&](float plane) { return a + step * allOf(plane - a[axis]); };
        if (low < begin && begin < high) parts[first].add(crossing(begin));
        if (low < end && end < high) parts[last].add(crossing(end));
        const int firstPlane = low > begin ? planes.binsOf(allOf(low))[axis] + 1 : first + 1;
        const int lastPlane = high < end ? planes.binsOf(allOf(high))[axis] : last;
        for (int k = firstPlane; k <= lastPlane; ++k) {
            const Float4 point = crossing(planes.plane(axis, k));
            parts[k - 1].add(point);
            parts[k].add(point);
        }
    }
    for (int k = first; k <= last; ++k) {
        const Box4 part = common(parts[k], reference);
        if (!part.empty()) boxes_[axis][k].add(part);
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
