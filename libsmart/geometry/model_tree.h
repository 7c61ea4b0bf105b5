// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <mutex>
#include <vector>

#include "libsmart/accel/kd_tree.h"
#include "libsmart/geometry/corner_reach.h"
#include "libsmart/geometry/model.h"
#include "libsmart/geometry/triangle_boxes.h"
#include "libsmart/geometry/triangle_tree.h"

namespace smart {

/// The tree over a model's triangles, of either kind, and the records of the fast mode, with the
/// view that shows them to kernels: made at once, or, of a lazy model, by the thread whose ray
/// reaches it first.
class ModelTree : private DeferredView {
public:
    explicit ModelTree(const ModelBuildOptions& options);
    ModelTree(const ModelTree&) = delete;
    ModelTree& operator=(const ModelTree&) = delete;

    /// Looks at the triangles, and builds unless that is to wait. Throws std::bad_alloc.
    void make(const std::vector<Triangle>& triangles);
    /// The same for the triangles of another model after they have moved: its wide tree is refitted
    /// while that is not much worse than a new one.
    void makeMoved(const std::vector<Triangle>& triangles, const ModelTree& old);
    /// Makes the view. The triangles have come to where they stay.
    void show(const std::vector<Triangle>& triangles, const InstanceGroup& children);

    const ModelView& view() const { return view_; }
    const Aabb& bounds() const { return bounds_; }
    double reach() const { return reach_; } ///< into the corners of the bounds
    uint32_t dropped() const { return dropped_; }
    bool built() const { return ready_.load(std::memory_order_acquire) != nullptr; }
    /// Empty where there is none, or none yet.
    const KdTree& kdTree() const { return built() ? kdTree_ : kNoTree; }
    uint64_t events() const { return built() ? events_ : 0; }
    TreeSizes sizes() const { return built() ? sizes_ : TreeSizes(); }
    std::size_t bytes() const { return std::size_t(counted_.bytes()); }

    /// May come later: thread-safe, while rays walk the tree. Of a lazy model with its tree.
    void prepareRecords();

private:
    static const KdTree kNoTree;

    static const ModelView* reach(const DeferredView& view);
    TriangleBoxes survey(const std::vector<Triangle>& triangles);
    void build(const std::vector<Triangle>& triangles, const TriangleBoxes& boxes);
    /// Of a lazy model; the lock is held.
    void buildDeferred();
    void setKdTree(KdTree tree);
    void setWideTree(TriangleTree tree);
    void makeRecords(ModelView& view);
    void showTree(ModelView& view) const;
    ModelView& shown() { return options_.lazy ? reached_ : view_; }

    const ModelBuildOptions options_;
    CountedBytes counted_;
    const std::vector<Triangle>* triangles_ = nullptr;
    Aabb bounds_;
    double reach_ = kReachesCorners;
    uint32_t dropped_ = 0;
    KdTree kdTree_;
    TriangleTree wideTree_;
    std::vector<TriangleRecord> records_;
    TreeSizes sizes_;
    uint64_t events_ = 0;
    ModelView view_{};    ///< what instances refer to
    ModelView reached_{}; ///< of a lazy model: what its rays walk
    std::mutex mutex_;    ///< of what is made later
    std::atomic<const ModelView*> ready_{nullptr}; ///< the view with the tree, once there is one
    bool wantsRecords_ = false;
    bool moved_ = false;
};

} // namespace smart
