// SPDX-License-Identifier: MIT
#include "libsmart/geometry/model_tree.h"

#include <cmath>
#include <optional>
#include <utility>

#include "libsmart/accel/kd_builder.h"
#include "libsmart/accel/triangle_clip.h"
#include "libsmart/base/fp_environment.h"
#include "libsmart/geometry/kd_view.h"

namespace smart {
namespace {

thread_local std::exception_ptr buildFailure;

/// The triangles of a model as the kd-tree's builder sees them.
class TrianglePrimitives final : public KdPrimitives {
public:
    TrianglePrimitives(const std::vector<Triangle>& triangles, const std::vector<Aabb>& boxes)
        : triangles_(triangles), boxes_(boxes) {}

    uint32_t count() const override { return uint32_t(boxes_.size()); }
    Aabb bounds(uint32_t prim) const override { return boxes_[prim]; }
    Aabb clipped(uint32_t prim, const Aabb& cell) const override {
        const Triangle& triangle = triangles_[prim];
        return clipTriangle(triangle.v0, triangle.v1, triangle.v2, cell);
    }

private:
    const std::vector<Triangle>& triangles_;
    const std::vector<Aabb>& boxes_;
};

/// Computed in double, each entry rounded once.
TriangleRecord makeRecord(const Triangle& triangle) {
    double e1[3], e2[3], normal[3];
    for (int k = 0; k < 3; ++k) {
        e1[k] = double(triangle.v1[k]) - triangle.v0[k];
        e2[k] = double(triangle.v2[k]) - triangle.v0[k];
    }
    int axis = 0;
    for (int k = 0; k < 3; ++k) {
        const int ku = (k + 1) % 3, kv = (k + 2) % 3;
        normal[k] = e1[ku] * e2[kv] - e1[kv] * e2[ku];
        if (std::fabs(normal[k]) > std::fabs(normal[axis])) axis = k;
    }
    const int ku = (axis + 1) % 3, kv = (axis + 2) % 3;
    const double area = normal[axis];
    const double p = triangle.v0[ku], q = triangle.v0[kv];
    TriangleRecord record{};
    record.nu = float(normal[ku] / area);
    record.nv = float(normal[kv] / area);
    record.nd = float(triangle.v0[axis] + (normal[ku] * p + normal[kv] * q) / area);
    record.bu = float(e2[kv] / area);
    record.bv = float(-e2[ku] / area);
    record.bd = float((e2[ku] * q - e2[kv] * p) / area);
    record.cu = float(-e1[kv] / area);
    record.cv = float(e1[ku] / area);
    record.cd = float((e1[kv] * p - e1[ku] * q) / area);
    // Degenerate, not finite, or too small or too large for single precision: never hit.
    for (const float entry : {record.nu, record.nv, record.nd, record.bu, record.bv, record.bd,
                              record.cu, record.cv, record.cd}) {
        if (!std::isfinite(entry)) return {0, 0, 0, 3, 0, 0, 0, 0, 0, 0};
    }
    record.axis = uint32_t(axis);
    return record;
}

template <class T>
std::size_t heldBytes(const std::vector<T>& vector) {
    return vector.capacity() * sizeof(T);
}

} // namespace

std::exception_ptr takeBuildFailure() noexcept { return std::exchange(buildFailure, nullptr); }

const KdTree ModelTree::kNoTree;

ModelTree::ModelTree(const ModelBuildOptions& options)
    : DeferredView{&ModelTree::reach}, options_(options),
      counted_(options.memory, sizeof(ModelTree)) {}

TriangleBoxes ModelTree::survey(const std::vector<Triangle>& triangles) {
    TriangleBoxes boxes(triangles, options_.threads);
    bounds_ = boxes.bounds;
    reach_ = cornerReach(triangles, boxes);
    dropped_ = uint32_t(boxes.dropped);
    return boxes;
}

void ModelTree::make(const std::vector<Triangle>& triangles) {
    const TriangleBoxes boxes = survey(triangles);
    const CountedBytes working(options_.memory, heldBytes(boxes.boxes));
    if (!options_.lazy) build(triangles, boxes);
}

void ModelTree::makeMoved(const std::vector<Triangle>& triangles, const ModelTree& old) {
    moved_ = true;
    const TriangleBoxes boxes = survey(triangles);
    const CountedBytes working(options_.memory, heldBytes(boxes.boxes));
    if (options_.lazy) return;
    if (options_.quality != BuildQuality::KdTree && old.built()) {
        std::optional<TriangleTree> tree =
            old.wideTree_.refitted(triangles, boxes.boxes, options_.threads);
        if (tree && tree->decay() < TriangleTree::kDecayed)
            return setWideTree(std::move(*tree));
    }
    build(triangles, boxes);
}

void ModelTree::build(const std::vector<Triangle>& triangles, const TriangleBoxes& boxes) {
    if (boxes.bounds.empty()) return;
    if (options_.quality == BuildQuality::KdTree) {
        KdBuildOptions options;
        options.threads = options_.threads;
        KdBuildStats stats;
        setKdTree(buildKdTree(TrianglePrimitives(triangles, boxes.boxes), options, &stats));
        events_ = stats.events;
        return;
    }
    // Triangles that were cut in two are a burden once they move.
    const WideQuality quality =
        options_.quality == BuildQuality::Fastest             ? WideQuality::Fast
        : options_.quality == BuildQuality::Nicest && !moved_ ? WideQuality::Spatial
                                                              : WideQuality::Binned;
    setWideTree(TriangleTree(triangles, boxes.boxes, quality, options_.threads));
}

void ModelTree::setKdTree(KdTree tree) {
    kdTree_ = std::move(tree);
    sizes_.add(kdTree_);
    counted_.add(kdTree_.bytes());
}

void ModelTree::setWideTree(TriangleTree tree) {
    wideTree_ = std::move(tree);
    sizes_.add(wideTree_.nodes());
    counted_.add(wideTree_.bytes());
}

void ModelTree::show(const std::vector<Triangle>& triangles, const InstanceGroup& children) {
    triangles_ = &triangles;
    counted_.add(heldBytes(triangles));
    view_.triangles = triangles.data();
    children.show(view_);
    if (options_.lazy && !bounds_.empty()) {
        view_.deferred = this;
        return;
    }
    showTree(view_);
    ready_.store(&view_, std::memory_order_release);
}

void ModelTree::showTree(ModelView& view) const {
    view.tree = makeKdView(kdTree_, kdTree_.bounds);
    if (wideTree_.empty()) return;
    static_cast<BoxView&>(view.wide) = makeBoxView(wideTree_.bounds());
    view.wide.nodes = wideTree_.nodes().data();
    view.wide.blocks = wideTree_.blocks();
}

// The thread that comes first builds; those that come meanwhile wait for the lock.
const ModelView* ModelTree::reach(const DeferredView& view) {
    ModelTree& tree = const_cast<ModelTree&>(static_cast<const ModelTree&>(view));
    if (const ModelView* const ready = tree.ready_.load(std::memory_order_acquire)) return ready;
    try {
        const std::lock_guard lock(tree.mutex_);
        if (!tree.built()) tree.buildDeferred();
        return tree.ready_.load(std::memory_order_relaxed);
    } catch (...) {
        buildFailure = std::current_exception();
        return &tree.view_; // without a tree
    }
}

void ModelTree::buildDeferred() {
    const FpEnvironment standard;
    if (sizes_.nodes == 0) { // else there was no memory for the records last time
        const TriangleBoxes boxes(*triangles_, options_.threads);
        const CountedBytes working(options_.memory, heldBytes(boxes.boxes));
        build(*triangles_, boxes);
    }
    reached_ = view_;
    reached_.deferred = nullptr;
    showTree(reached_);
    if (wantsRecords_) makeRecords(reached_);
    ready_.store(&reached_, std::memory_order_release);
}

void ModelTree::makeRecords(ModelView& view) {
    if (view.records || triangles_->empty()) return;
    const FpEnvironment standard;
    std::vector<TriangleRecord> records;
    records.reserve(triangles_->size());
    for (const Triangle& triangle : *triangles_) records.push_back(makeRecord(triangle));
    records_ = std::move(records);
    counted_.add(heldBytes(records_));
    view.records = records_.data();
}

void ModelTree::prepareRecords() {
    const std::lock_guard lock(mutex_);
    wantsRecords_ = true;
    if (built()) makeRecords(shown());
}

} // namespace smart
