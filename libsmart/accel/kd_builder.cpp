// SPDX-License-Identifier: MIT
#include "libsmart/accel/kd_builder.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <condition_variable>
#include <exception>
#include <limits>
#include <memory>
#include <mutex>
#include <numeric>
#include <queue>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "libsmart/accel/kd_subtree.h"
#include "libsmart/base/error.h"
#include "libsmart/base/signals_blocked.h"

namespace smart {
namespace {

/// Cells of no more primitives are built whole by one thread. It shapes the work, not the tree.
constexpr uint32_t kSubtreeSize = 8192;

/// Where splits make more references than this a primitive, the build is repeated with
/// kAllowance: crossing slivers would fill the memory for little gain.
constexpr uint64_t kMaxReferences = 8;
constexpr double kAllowance = 4;

using PrimIds = std::shared_ptr<const std::vector<uint32_t>>;

/// A cell near the root: split into two branches, or finished as a subtree.
struct Branch {
    KdCell cell;
    KdEventArena arena; ///< holds the cell's lists
    PrimIds ids;        ///< of the cell's numbers
    KdPlane plane;
    std::unique_ptr<Branch> left, right;
    KdSubtree subtree;
};

/// Numbers the cell's primitives anew, in the same order and without gaps: working memory by
/// number stays as small as the cell.
void renumber(Branch& branch) {
    std::vector<uint32_t> newNumber(branch.ids->size(), 0);
    KdEventLists& lists = branch.cell.lists;
    for (uint32_t i = 0; i < lists.size[0]; ++i) newNumber[kdEventPrim(lists.events[0][i])] = 1;
    auto ids = std::make_shared<std::vector<uint32_t>>();
    ids->reserve(branch.cell.count);
    for (std::size_t old = 0; old < newNumber.size(); ++old) {
        if (!newNumber[old]) continue;
        newNumber[old] = uint32_t(ids->size());
        ids->push_back((*branch.ids)[old]);
    }
    for (int k = 0; k < 3; ++k) {
        for (uint32_t i = 0; i < lists.size[k]; ++i) {
            KdEvent& event = lists.events[k][i];
            event += newNumber[kdEventPrim(event)] - KdEvent(kdEventPrim(event));
        }
    }
    branch.ids = std::move(ids);
}

/// Branches that wait for a thread, the largest first. A failure of one thread ends them all.
class BranchQueue {
public:
    void push(Branch* branch) {
        {
            const std::lock_guard lock(mutex_);
            waiting_.push(branch);
            ++unfinished_;
        }
        changed_.notify_one();
    }
    /// The next branch; nullptr when all are finished, or one has failed.
    Branch* next() {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return !waiting_.empty() || unfinished_ == 0 || failure_; });
        if (failure_ || waiting_.empty()) return nullptr;
        Branch* branch = waiting_.top();
        waiting_.pop();
        return branch;
    }
    void finish() {
        const std::lock_guard lock(mutex_);
        if (--unfinished_ == 0) changed_.notify_all();
    }
    void fail(std::exception_ptr failure) noexcept {
        const std::lock_guard lock(mutex_);
        if (!failure_) failure_ = std::move(failure);
        changed_.notify_all();
    }
    void rethrowFailure() const {
        if (failure_) std::rethrow_exception(failure_);
    }

private:
    struct Smaller {
        bool operator()(const Branch* a, const Branch* b) const {
            return a->cell.count < b->cell.count;
        }
    };
    std::mutex mutex_;
    std::condition_variable changed_;
    std::priority_queue<Branch*, std::vector<Branch*>, Smaller> waiting_;
    std::size_t unfinished_ = 0; ///< waiting, or in the hands of a thread
    std::exception_ptr failure_;
};

void processBranch(Branch& branch, KdSplitter& splitter, KdEventArena& arena, BranchQueue& queue) {
    const bool small = branch.cell.count <= kSubtreeSize;
    if (small || branch.ids->size() / 4 >= branch.cell.count) renumber(branch);
    if (!small) {
        auto left = std::make_unique<Branch>(), right = std::make_unique<Branch>();
        if (splitter.split(branch.cell, *branch.ids, branch.plane, left->arena, left->cell,
                           right->arena, right->cell)) {
            left->ids = right->ids = std::move(branch.ids);
            branch.arena = {};
            branch.left = std::move(left);
            branch.right = std::move(right);
            queue.push(branch.left.get());
            queue.push(branch.right.get());
            return;
        }
    }
    branch.subtree = buildKdSubtree(branch.cell, *branch.ids, splitter, arena);
    branch.arena = {};
    branch.ids.reset();
}

/// What every thread of a build does until nothing is left.
void buildBranches(BranchQueue& queue, KdBuildShared& shared,
                   std::atomic<uint64_t>& eventsSwept) noexcept {
    try {
        KdSplitter splitter(shared);
        KdEventArena arena;
        while (Branch* branch = queue.next()) {
            processBranch(*branch, splitter, arena, queue);
            queue.finish();
        }
        eventsSwept += splitter.eventsSwept();
    } catch (...) {
        queue.fail(std::current_exception());
    }
}

/// The root: boxes and sorted events of all primitives that have a box.
void makeRoot(const KdPrimitives& primitives, Branch& root) {
    const uint32_t count = primitives.count();
    auto ids = std::make_shared<std::vector<uint32_t>>(count);
    std::iota(ids->begin(), ids->end(), 0u);
    root.ids = std::move(ids);
    KdCell& cell = root.cell;
    cell.lists = root.arena.allocate(count);
    for (uint32_t prim = 0; prim < count; ++prim) {
        const Aabb box = primitives.bounds(prim);
        if (box.empty()) continue;
        cell.box.add(box);
        cell.lists.add(box, prim);
        ++cell.count;
    }
    std::vector<KdEvent> scratch;
    for (int k = 0; k < 3; ++k) sortKdEvents(cell.lists.events[k], cell.lists.size[k], scratch);
}

void countParts(const Branch& branch, std::size_t& nodes, std::size_t& prims) {
    if (branch.left) {
        nodes += 1;
        countParts(*branch.left, nodes, prims);
        countParts(*branch.right, nodes, prims);
    } else {
        nodes += branch.subtree.nodes.size();
        prims += branch.subtree.prims.size();
    }
}

/// Writes a branch into nodes[slot] and behind the end, depth first, and frees its parts.
void assemble(Branch& branch, std::size_t slot, KdTree& tree) {
    if (branch.left) {
        const std::size_t child = tree.nodes.size();
        tree.nodes.resize(child + 2);
        tree.nodes[slot] = makeKdInner(branch.plane, child);
        assemble(*branch.left, child, tree);
        branch.left.reset();
        assemble(*branch.right, child + 1, tree);
        branch.right.reset();
        return;
    }
    const KdSubtree& subtree = branch.subtree;
    // Local node i > 0 goes to base + i; the local root to its parent's slot.
    const std::size_t base = tree.nodes.size() - 1, firstPrim = tree.prims.size();
    for (std::size_t i = 0; i < subtree.nodes.size(); ++i) {
        KdNode node = subtree.nodes[i];
        if ((node.bits & 3) == kKdLeaf) node.firstPrim += uint32_t(firstPrim);
        else node.bits += uint32_t(base) << 2;
        if (i == 0) tree.nodes[slot] = node;
        else tree.nodes.push_back(node);
    }
    tree.prims.insert(tree.prims.end(), subtree.prims.begin(), subtree.prims.end());
}

uint32_t deepestLeaf(const Branch& branch) {
    if (!branch.left) return branch.subtree.depth;
    return std::max(deepestLeaf(*branch.left), deepestLeaf(*branch.right));
}

/// One build; throws KdTooManyReferences, whatever the number of threads, when splits make more
/// than `maxExtra` references.
KdTree buildOnce(const KdPrimitives& primitives, const KdBuildOptions& options, uint64_t maxExtra,
                 double allowance, KdBuildStats& stats) {
    Branch root;
    makeRoot(primitives, root);
    KdTree tree;
    if (root.cell.count == 0) return tree;
    tree.bounds = root.cell.box;
    root.cell.allowance = allowance;

    const double depthLimit = 8 + 1.3 * std::log2(double(root.cell.count));
    KdBuildShared shared{primitives, options,
                         std::min(uint32_t(depthLimit), uint32_t(kKdMaxDepth)), maxExtra};
    std::atomic<uint64_t> eventsSwept{0};
    BranchQueue queue;
    const uint32_t useful = root.cell.count / kSubtreeSize + 1; // threads that can find work
    queue.push(&root);
    {
        std::vector<std::jthread> helpers;
        try {
            const SignalsBlocked signalsBlocked;
            while (helpers.size() + 1 < std::min(options.threads, useful)) {
                helpers.emplace_back([&] { buildBranches(queue, shared, eventsSwept); });
            }
        } catch (const std::system_error&) {
            // No more threads to be had: those that run do the work.
        } catch (...) {
            queue.fail(std::current_exception());
        }
        buildBranches(queue, shared, eventsSwept);
    }
    queue.rethrowFailure();
    if (shared.extra > maxExtra) throw KdTooManyReferences{};

    std::size_t nodes = 0, prims = 0;
    countParts(root, nodes, prims);
    constexpr std::size_t kMaxIndex = std::size_t(1) << 30;
    if (nodes >= kMaxIndex || prims >= kMaxIndex) {
        throw Error(ErrorCode::OutOfMemory, "kd-tree: more than 2^30 nodes or references");
    }
    stats.events += eventsSwept;
    stats.depth = deepestLeaf(root);
    tree.nodes.reserve(nodes);
    tree.prims.reserve(prims);
    tree.nodes.resize(1);
    assemble(root, 0, tree);
    return tree;
}

} // namespace

KdTree buildKdTree(const KdPrimitives& primitives, const KdBuildOptions& options,
                   KdBuildStats* stats) {
    const uint32_t count = primitives.count();
    if (count >= kKdMaxPrims) {
        throw Error(ErrorCode::OutOfMemory, "kd-tree: more than 2^30 primitives");
    }
    KdBuildStats result;
    KdTree tree;
    try {
        tree = buildOnce(primitives, options, (kMaxReferences - 1) * count,
                         std::numeric_limits<double>::infinity(), result);
    } catch (const KdTooManyReferences&) {
        tree = buildOnce(primitives, options, std::numeric_limits<uint64_t>::max(), kAllowance,
                         result);
    }
    if (stats) *stats = result;
    return tree;
}

} // namespace smart
