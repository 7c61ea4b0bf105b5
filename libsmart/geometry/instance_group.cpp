// SPDX-License-Identifier: MIT
#include "libsmart/geometry/instance_group.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "libsmart/accel/build_crew.h"
#include "libsmart/base/fp_environment.h"
#include "libsmart/geometry/box_view.h"
#include "libsmart/geometry/model.h"
#include "libsmart/kernel/affine_inverse.h"

namespace smart {
namespace {

constexpr std::size_t kInstancesOfPart = 2048;
/// Fewer are looked at in less time than it takes to start a thread and to wait for it.
constexpr std::size_t kInstancesForThreads = 32768;
/// Of fewer the better tree takes a small part of a frame's time, whatever else there is in it.
constexpr std::size_t kInstancesForFastTree = 4096;

float roundedDown(double value) {
    constexpr double kMax = std::numeric_limits<float>::max();
    if (!(value > -kMax)) return float(-kMax); // NaN too: as far out as floats reach
    const float rounded = float(std::min(value, kMax));
    return double(rounded) <= value ? rounded : std::nextafter(rounded, -Aabb::kInf);
}

float roundedUp(double value) {
    return -roundedDown(-value);
}

/// Box around what is in the transformed box, as the eight corners span it or the ellipsoid of this
/// reach (corner_reach.h), whichever is less. Padded by some units in the last place of its terms,
/// since rays are rounded to float in object space.
Aabb transformed(const AffineColumns& matrix, const Aabb& box, double reach) {
    Aabb result;
    if (box.empty()) return result;
    for (int row = 0; row < 3; ++row) {
        double lo = matrix[3][row], hi = lo, magnitude = std::fabs(lo);
        double middle = lo, squares = 0;
        for (int column = 0; column < 3; ++column) {
            const double a = matrix[column][row] * box.lo[column];
            const double b = matrix[column][row] * box.hi[column];
            lo += std::min(a, b);
            hi += std::max(a, b);
            magnitude += std::max(std::fabs(a), std::fabs(b));
            middle += 0.5 * (a + b);
            squares += 0.25 * (b - a) * (b - a);
        }
        const double half = reach * std::sqrt(squares);
        if (middle - half > lo) lo = middle - half; // not where something overflows: NaN
        if (middle + half < hi) hi = middle + half;
        const double pad = 0x1p-21 * magnitude;
        result.lo[row] = roundedDown(lo - pad);
        result.hi[row] = roundedUp(hi + pad);
    }
    return result;
}

bool isIdentity(const AffineColumns& matrix) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row)
            if (matrix[column][row] != (row == column)) return false;
    return true;
}

/// Fills in what the matrix and the model decide; the box in the parent's space. Returns whether
/// the matrix has an inverse.
bool complete(InstanceView& instance, Aabb& box) {
    const Model* const model = instance.traits->model.get();
    instance.identity = isIdentity(instance.toParent);
    instance.usual = isUsual(instance.toParent);
    instance.model = nullptr;
    if (!instance.identity && !isInvertible(instance.toParent)) return false;
    if (!model) return true;
    box = transformed(instance.toParent, model->bounds, model->reach());
    if (!box.empty()) instance.model = &model->view();
    return true;
}

} // namespace

InstanceGroup::InstanceGroup(InstanceList instances, unsigned threads, GroupLife life)
    : list_(std::move(instances)) {
    const FpEnvironment standard;
    list_.shrink();
    const std::span<InstanceView> views = list_.views();
    std::vector<Aabb> boxes(views.size());
    struct Found {
        Aabb bounds;
        uint32_t dropped = 0;
    };
    std::vector<Found> found((views.size() + kInstancesOfPart - 1) / kInstancesOfPart);
    const unsigned helping = views.size() < kInstancesForThreads ? 1 : threads;
    BuildCrew(helping).forEach(found.size(), [&](std::size_t part) {
        const std::size_t begin = part * kInstancesOfPart;
        const std::size_t end = std::min(begin + kInstancesOfPart, views.size());
        for (std::size_t i = begin; i < end; ++i) {
            found[part].dropped += !complete(views[i], boxes[i]);
            found[part].bounds.add(boxes[i]);
        }
    });
    for (const Found& part : found) {
        dropped_ += part.dropped;
        bounds_.add(part.bounds);
    }
    if (views.size() < 2) return;
    const bool fast = life == GroupLife::OneFrame && views.size() >= kInstancesForFastTree;
    tree_ = (fast ? buildWideTreeFast : buildWideTree)(boxes, std::max(threads, 1u),
                                                       kInstanceCosts);
}

void InstanceGroup::show(ModelView& view) const {
    view.children = list_.views().data();
    static_cast<BoxView&>(view.childTree) = makeBoxView(bounds_);
    view.childTree.nodes = tree_.nodes.empty() ? nullptr : tree_.nodes.data();
    view.childTree.prims = tree_.prims.data();
    view.childCount = bounds_.empty() ? 0 : uint32_t(list_.size());
}

} // namespace smart
