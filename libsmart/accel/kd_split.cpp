// SPDX-License-Identifier: MIT
#include "libsmart/accel/kd_split.h"

#include <algorithm>
#include <cmath>

namespace smart {
namespace {

/// No cell is thinner, relative to its largest coordinate on the axis: 4 to 8 units in the last
/// place, what traversal pads its distances by.
constexpr double kMinThickness = 0x1p-21;

constexpr uint64_t kExtraBatch = 4096; ///< added to the shared counter at once

/// Added references of large cells weigh more: there most meshes have next to none, and those that
/// have go on so. It ends such a build early.
constexpr uint32_t kLargeCell = 8192;
constexpr uint64_t kLargeCellWeight = 4;

/// Costs on one axis, as half area times primitives. The half area of a slice of a cell is a
/// linear function of its thickness.
struct SliceCost {
    double face, rim; ///< half areas: of the two faces; of the sides, by unit of thickness
    double lo, hi;

    SliceCost(const Aabb& box, int axis) : lo(box.lo[axis]), hi(box.hi[axis]) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        const double du = double(box.hi[u]) - box.lo[u], dv = double(box.hi[v]) - box.lo[v];
        face = du * dv;
        rim = du + dv;
    }
    double leftArea(double position) const { return face + rim * (position - lo); }
    double rightArea(double position) const { return face + rim * (hi - position); }
};

/// Steps of the counts left and right of the sweep at an event, by its kind.
constexpr double kLeftStep[] = {0, 1, 1}, kRightStep[] = {1, 1, 0};

/// Whether primitives that lie in the plane are cheaper in its left child.
bool isPlanarLeftCheaper(const KdCell& cell, int axis, float position) {
    double left = 0, planar = 0, right = cell.count;
    for (const KdEvent *event = cell.lists.events[axis], *end = event + cell.lists.size[axis];
         event < end && kdEventPosition(*event) <= position; ++event) {
        const KdEventKind kind = kdEventKind(*event);
        const bool here = kdEventPosition(*event) == position;
        if (here && kind == KdEventKind::Start) break;
        if (here && kind == KdEventKind::Planar) {
            ++planar;
        } else {
            left += kLeftStep[int(kind)];
        }
        right -= kRightStep[int(kind)];
    }
    const SliceCost cost(cell.box, axis);
    const double leftArea = cost.leftArea(position), rightArea = cost.rightArea(position);
    return leftArea * (left + planar) + rightArea * right <
           leftArea * left + rightArea * (right + planar);
}

} // namespace

KdPlane findKdPlane(const KdCell& cell, const KdBuildOptions& options) {
    KdPlane best;
    const double area = cell.box.halfArea();
    if (!(area > 0)) return best;
    // Costs are compared as sums of half area times primitives; a plane must beat the leaf.
    const double count = cell.count;
    const double traversal = double(options.traversalCost) / options.intersectionCost * area;
    double bestCost = area * count - traversal;

    for (int axis = 0; axis < 3; ++axis) {
        const SliceCost cost(cell.box, axis);
        const double thinnest = std::max(std::fabs(cost.lo), std::fabs(cost.hi)) * kMinThickness;
        const double first = cost.lo + thinnest, last = cost.hi - thinnest;
        const KdEvent* const events = cell.lists.events[axis];
        const uint32_t size = cell.lists.size[axis];

        // Cut off the empty space before the first box or behind the last.
        const auto considerEmpty = [&](float position, double fullArea, bool planarLeft) {
            const double candidate =
                options.emptyFactor * (fullArea * count + traversal) - traversal;
            if (candidate < bestCost && position > first && position < last) {
                bestCost = candidate;
                best = {axis, position, planarLeft};
            }
        };
        const float front = kdEventPosition(events[0]), back = kdEventPosition(events[size - 1]);
        considerEmpty(front, cost.rightArea(front), false);
        considerEmpty(back, cost.leftArea(back), true);

        // Sweep, with the counts before and after each event. In the middle of several events in
        // one place the cost is over-estimated; their first or last gives it right. No branches:
        // which candidate is better can not be predicted.
        double left = 0, right = count;
        uint32_t i = 0;
        for (; i < size && kdEventPosition(events[i]) <= first; ++i) {
            left += kLeftStep[int(kdEventKind(events[i]))];
            right -= kRightStep[int(kdEventKind(events[i]))];
        }
        uint32_t end = size;
        while (end > i && kdEventPosition(events[end - 1]) >= last) --end;
        uint32_t bestIndex = size;
        for (; i < end; ++i) {
            const KdEvent event = events[i];
            const double position = kdEventPosition(event);
            const double leftArea = cost.leftArea(position), rightArea = cost.rightArea(position);
            const double before = leftArea * left + rightArea * right;
            left += kLeftStep[int(kdEventKind(event))];
            right -= kRightStep[int(kdEventKind(event))];
            const double after = leftArea * left + rightArea * right;
            const double candidate = std::min(before, after);
            bestIndex = candidate < bestCost ? i : bestIndex;
            bestCost = std::min(candidate, bestCost);
        }
        if (bestIndex < size) {
            const float position = kdEventPosition(events[bestIndex]);
            const KdEventKind kind = kdEventKind(events[bestIndex]);
            best = {axis, position,
                    kind == KdEventKind::Planar ? isPlanarLeftCheaper(cell, axis, position)
                                                : kind == KdEventKind::Start};
        }
    }
    return best;
}

KdSplitter::~KdSplitter() { shared_.extra += extra_; }

void KdSplitter::countExtra(uint64_t added, uint32_t cellCount) {
    extra_ += cellCount > kLargeCell ? kLargeCellWeight * added : added;
    if (extra_ < kExtraBatch) return;
    if (shared_.extra.fetch_add(extra_) + extra_ > shared_.maxExtra) throw KdTooManyReferences{};
    extra_ = 0;
}

/// Finds each primitive's side from the events of the split axis alone.
void KdSplitter::classify(const KdCell& cell, const KdPlane& plane) {
    const KdEvent* events = cell.lists.events[plane.axis];
    const uint32_t size = cell.lists.size[plane.axis];
    const KdEvent border = makeKdEvent(
        plane.position, plane.planarLeft ? KdEventKind::Start : KdEventKind::Planar, 0);
    straddlers_.clear();
    leftCount_ = rightCount_ = 0;
    uint32_t i = 0;
    for (; i < size && events[i] < border; ++i) {
        const bool staysLeft = kdEventKind(events[i]) != KdEventKind::Start;
        // What starts straddles, unless its end comes before the border too.
        sides_[kdEventPrim(events[i])] = staysLeft ? kLeft : kStraddles;
        leftCount_ += staysLeft;
    }
    for (; i < size; ++i) {
        const uint32_t prim = kdEventPrim(events[i]);
        if (kdEventKind(events[i]) != KdEventKind::End) {
            sides_[prim] = kRight;
            ++rightCount_;
        } else if (sides_[prim] == kStraddles) {
            straddlers_.push_back(prim);
        }
    }
}

/// Makes sorted events of the straddlers' parts in a child's box.
void KdSplitter::clipStraddlers(const std::vector<uint32_t>& ids, const Aabb& box,
                                Clipped& clipped) {
    const std::size_t perAxis = 2 * straddlers_.size();
    if (clipped.memory.size() < 3 * perAxis) clipped.memory.resize(3 * perAxis);
    clipped.count = 0;
    clipped.lists = {};
    for (std::size_t k = 0; k < 3; ++k) {
        clipped.lists.events[k] = clipped.memory.data() + k * perAxis;
    }
    for (const uint32_t number : straddlers_) {
        const Aabb part = intersection(shared_.primitives.clipped(ids[number], box), box);
        if (part.empty()) continue;
        clipped.lists.add(part, number);
        ++clipped.count;
    }
    for (int k = 0; k < 3; ++k) {
        sortKdEvents(clipped.lists.events[k], clipped.lists.size[k], sortScratch_);
    }
}

/// Hands the events of primitives on one side down, in order, and merges those of clipped ones.
void KdSplitter::distribute(const KdEventLists& lists, KdCell& left, KdCell& right) const {
    for (int k = 0; k < 3; ++k) {
        KdEvent *leftEnd = left.lists.events[k], *rightEnd = right.lists.events[k];
        for (uint32_t i = 0; i < lists.size[k]; ++i) {
            const KdEvent event = lists.events[k][i];
            const uint8_t side = sides_[kdEventPrim(event)];
            *leftEnd = event; // written to both, kept where the end moves on: no branch
            *rightEnd = event;
            leftEnd += side & kLeft;
            rightEnd += side >> 1;
        }
        const auto merge = [k](KdCell& child, const KdEvent* end, const Clipped& clipped) {
            const std::size_t kept = std::size_t(end - child.lists.events[k]);
            mergeKdEvents(child.lists.events[k], kept, clipped.lists.events[k],
                          clipped.lists.size[k]);
            child.lists.size[k] = uint32_t(kept) + clipped.lists.size[k];
        };
        merge(left, leftEnd, leftClipped_);
        merge(right, rightEnd, rightClipped_);
    }
}

bool KdSplitter::split(const KdCell& cell, const std::vector<uint32_t>& ids, KdPlane& plane,
                       KdEventArena& leftArena, KdCell& left, KdEventArena& rightArena,
                       KdCell& right) {
    const KdBuildOptions& options = shared_.options;
    if (cell.depth >= shared_.maxDepth) return false;
    // The best split imaginable leaves nothing to intersect.
    if (options.intersectionCost * cell.count <= options.emptyFactor * options.traversalCost) {
        return false;
    }
    plane = findKdPlane(cell, options);
    eventsSwept_ += cell.lists.total();
    if (plane.axis < 0) return false;

    if (sides_.size() < ids.size()) sides_.resize(ids.size());
    classify(cell, plane);
    left.box = right.box = cell.box;
    left.box.hi[plane.axis] = right.box.lo[plane.axis] = plane.position;
    clipStraddlers(ids, left.box, leftClipped_);
    clipStraddlers(ids, right.box, rightClipped_);
    left.count = leftCount_ + leftClipped_.count;
    right.count = rightCount_ + rightClipped_.count;

    const uint64_t total = uint64_t(left.count) + right.count;
    left.allowance = right.allowance = cell.allowance * cell.count / double(total);
    if (left.allowance < 1) return false;
    if (total > cell.count) countExtra(total - cell.count, cell.count);

    left.depth = right.depth = cell.depth + 1;
    right.lists = rightArena.allocate(right.count);
    left.lists = leftArena.allocate(left.count);
    distribute(cell.lists, left, right);
    return true;
}

} // namespace smart
