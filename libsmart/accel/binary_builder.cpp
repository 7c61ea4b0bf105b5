// SPDX-License-Identifier: MIT
#include "libsmart/accel/binary_builder.h"

#include <algorithm>

namespace smart {
namespace {

/// Ranges of no more references are built whole by one thread, larger ones are divided by all of
/// them, in parts of this size. It shapes the work, and the tree by the order of additions only:
/// so it does not depend on the number of threads.
constexpr uint32_t kSubtreeSize = 8192;

/// Below, ranges are halved: 2^28 references in 28 levels, one more for nodes made of groups.
constexpr int kSplitDepth = kWideMaxDepth - 30;

/// Spatial splits are tried where the children of an object split have so much in common: of the
/// whole scene, which is Stich's alpha, and of the range itself.
constexpr float kOverlapOfAll = 1e-5f, kOverlapOfRange = 0.1f;

std::size_t partsOf(std::size_t count) { return (count + kSubtreeSize - 1) / kSubtreeSize; }

} // namespace

/// Workplaces that threads borrow, no more than there are threads.
class BinaryBuilder::Workplaces {
public:
    explicit Workplaces(BinaryTree& tree) : tree_(tree) {
        free_.push_back(std::make_unique<Workplace>(tree, true));
    }
    std::unique_ptr<Workplace> borrow() {
        {
            const std::lock_guard lock(mutex_);
            if (!free_.empty()) {
                std::unique_ptr<Workplace> place = std::move(free_.back());
                free_.pop_back();
                return place;
            }
        }
        return std::make_unique<Workplace>(tree_, false);
    }
    void giveBack(std::unique_ptr<Workplace> place) {
        const std::lock_guard lock(mutex_);
        free_.push_back(std::move(place));
    }

private:
    BinaryTree& tree_;
    std::mutex mutex_;
    std::vector<std::unique_ptr<Workplace>> free_;
};

BinaryBuilder::BinaryBuilder(ReferenceList list, TriangleVertices vertices,
                             std::span<const BinarySubtree> subtrees, const BinaryCosts& costs,
                             BinaryTree& tree, BuildCrew& crew)
    : references_(std::move(list.references)), vertices_(vertices), subtrees_(subtrees),
      costs_(costs), smallest_(subtrees.empty() ? costs.smallestLeaf() : 1), tree_(tree) {
    plant(list.count, list.bounds, crew);
}

void BinaryBuilder::plant(std::size_t count, const ReferenceBounds& bounds, BuildCrew& crew) {
    std::vector<Branch> branches(1);
    Range& all = branches[0].range;
    all.count = uint32_t(count);
    all.end = uint32_t(references_.size());
    all.bounds = bounds;

    Workplaces places(tree_);
    std::unique_ptr<Workplace> first = places.borrow();
    std::vector<uint32_t> whole; // branches that are built by one thread each
    for (uint32_t i = 0; i < branches.size(); ++i) {
        const Range range = branches[i].range;
        if (range.count <= kSubtreeSize) {
            whole.push_back(i);
            continue;
        }
        Branch left, right;
        tree_[branches[i].node].describe(range.bounds.box, range.first, range.count);
        divideByAll(range, crew, left.range, right.range);
        left.node = first->nodes.takePair();
        right.node = left.node + 1;
        tree_[branches[i].node].left = left.node;
        branches[i].left = uint32_t(branches.size());
        branches.push_back(left);
        branches.push_back(right);
    }
    places.giveBack(std::move(first));
    std::sort(whole.begin(), whole.end(), [&](uint32_t a, uint32_t b) {
        return branches[a].range.count > branches[b].range.count;
    });
    crew.forEach(whole.size(), [&](std::size_t i) {
        std::unique_ptr<Workplace> place = places.borrow();
        Branch& branch = branches[whole[i]];
        branch.costs = build(branch.node, branch.range, *place);
        places.giveBack(std::move(place));
    });
    for (std::size_t i = branches.size(); i-- > 0;) {
        Branch& branch = branches[i];
        if (branch.left)
            branch.costs =
                costs_.ofDivided(tree_[branch.node], branches[branch.left].costs,
                                 branches[branch.left + 1].costs, canBeLeaf(branch.range));
    }
}

SlotCosts BinaryBuilder::finish(uint32_t node, const Range& range) {
    BinaryNode& to = tree_[node];
    if (subtrees_.empty()) {
        to.describe(range.bounds.box, range.first, range.count);
        return costs_.ofLeaf(to);
    }
    const BinarySubtree& subtree = subtrees_[references_[range.first].number()];
    to = subtree.root;
    return subtree.costs;
}

SlotCosts BinaryBuilder::build(uint32_t node, const Range& range, Workplace& place) {
    if (range.count <= smallest_) return finish(node, range);
    tree_[node].describe(range.bounds.box, range.first, range.count);
    Range left, right;
    divide(range, place, left, right);
    const uint32_t pair = place.nodes.takePair();
    tree_[node].left = pair;
    const SlotCosts leftCosts = build(pair, left, place);
    const SlotCosts rightCosts = build(pair + 1, right, place);
    return costs_.ofDivided(tree_[node], leftCosts, rightCosts, canBeLeaf(range));
}

bool BinaryBuilder::wantsSpatial(const Range& range, const ObjectSplit& split) const {
    if (!vertices_ || range.extra() == 0) return false;
    if (!split.exists()) return true;
    const Box4 both(greaterOf(split.left.lo, split.right.lo), lesserOf(split.left.hi, split.right.hi));
    if (both.empty()) return false;
    const float overlap = costs_.measure().share(both);
    return overlap > kOverlapOfAll &&
           overlap > kOverlapOfRange * costs_.measure().share(range.bounds.box);
}

void BinaryBuilder::place(const Range& range, uint32_t leftCount, uint32_t rightCount, Range& left,
                          Range& right) {
    const uint64_t room = range.end - range.first - leftCount - rightCount;
    const uint32_t ofLeft = uint32_t(room * leftCount / (uint64_t(leftCount) + rightCount));
    left.first = range.first;
    left.count = leftCount;
    left.end = range.first + leftCount + ofLeft;
    right.first = left.end;
    right.count = rightCount;
    right.end = range.end;
    left.depth = right.depth = range.depth + 1;
}

void BinaryBuilder::halve(const Range& range, Range& left, Range& right) {
    const uint32_t half = range.count / 2;
    BoxReference* const from = references_.data() + range.first;
    left.bounds = boundsOf({from, half});
    right.bounds = boundsOf({from + half, range.count - half});
    place(range, half, range.count - half, left, right);
    if (right.first != range.first + half)
        std::copy_backward(from + half, from + range.count,
                           references_.data() + right.first + right.count);
}

void BinaryBuilder::divide(const Range& range, Workplace& work, Range& left, Range& right) {
    BoxReference* const from = references_.data() + range.first;
    const std::span<const BoxReference> all(from, range.count);
    if (range.depth >= kSplitDepth) return halve(range, left, right);

    CentreBins centres;
    const ObjectSplit split = findObjectSplit(all, range.bounds.centres, costs_.measure(), centres);
    if (wantsSpatial(range, split)) {
        const SpacePlanes planes(range.bounds.box, range.count);
        SpatialBins parts;
        parts.add(all, vertices_, planes);
        const SpatialSplit spatial = parts.best(planes, costs_.measure(), range.extra());
        if (spatial.cost < split.cost) {
            SplitSides& sides = work.sides;
            sides.clear();
            divideAtPlane(all, vertices_, spatial, costs_.measure(), range.extra(), sides);
            if (!sides.left.empty() && !sides.right.empty()) {
                place(range, uint32_t(sides.left.size()), uint32_t(sides.right.size()), left, right);
                left.bounds = sides.leftBounds;
                right.bounds = sides.rightBounds;
                std::copy(sides.left.begin(), sides.left.end(), from);
                std::copy(sides.right.begin(), sides.right.end(),
                          references_.begin() + right.first);
                return;
            }
        }
    }
    if (!split.exists()) return halve(range, left, right);

    BoxReference *low = from, *high = from + range.count;
    for (;;) {
        for (; low < high && split.isLeft(centres, *low); ++low) left.bounds.add(*low);
        for (; low < high && !split.isLeft(centres, high[-1]); --high) right.bounds.add(high[-1]);
        if (low == high) break;
        std::swap(*low, high[-1]);
    }
    const uint32_t leftCount = uint32_t(low - from);
    place(range, leftCount, range.count - leftCount, left, right);
    if (right.first != range.first + leftCount)
        std::copy_backward(low, from + range.count,
                           references_.data() + right.first + right.count);
}

void BinaryBuilder::divideByAll(const Range& range, BuildCrew& crew, Range& left, Range& right) {
    if (range.depth >= kSplitDepth) return halve(range, left, right);
    const std::size_t parts = partsOf(range.count);
    const auto part = [&](std::size_t i) {
        const std::size_t begin = i * kSubtreeSize;
        return std::span<const BoxReference>(
            references_.data() + range.first + begin,
            std::min<std::size_t>(kSubtreeSize, range.count - begin));
    };
    const CentreBins centres(range.bounds.centres, kMostBins);
    std::vector<ObjectBins<kMostBins>> bins(parts);
    crew.forEach(parts, [&](std::size_t i) { bins[i].add(part(i), centres); });
    for (std::size_t i = 1; i < parts; ++i) bins[0].add(bins[i]);
    const ObjectSplit split = bins[0].best(centres, costs_.measure());

    std::vector<SplitSides> sides(parts);
    bool divided = false;
    std::size_t leftCount = 0, rightCount = 0;
    const auto addUp = [&] {
        leftCount = rightCount = 0;
        for (const SplitSides& side : sides) {
            leftCount += side.left.size();
            rightCount += side.right.size();
        }
        divided = leftCount > 0 && rightCount > 0;
    };
    if (wantsSpatial(range, split)) {
        const SpacePlanes planes(range.bounds.box, range.count);
        std::vector<SpatialBins> spatialBins(parts);
        crew.forEach(parts, [&](std::size_t i) {
            spatialBins[i].add(part(i), vertices_, planes);
        });
        for (std::size_t i = 1; i < parts; ++i) spatialBins[0].add(spatialBins[i]);
        const SpatialSplit spatial = spatialBins[0].best(planes, costs_.measure(), range.extra());
        if (spatial.cost < split.cost) {
            crew.forEach(parts, [&](std::size_t i) {
                const std::size_t extra = range.extra() * part(i).size() / range.count;
                divideAtPlane(part(i), vertices_, spatial, costs_.measure(), extra, sides[i]);
            });
            addUp();
        }
    }
    if (!divided) {
        if (!split.exists()) return halve(range, left, right);
        crew.forEach(parts, [&](std::size_t i) {
            sides[i].clear();
            for (const BoxReference& reference : part(i)) {
                if (split.isLeft(centres, reference))
                    sides[i].addLeft(reference);
                else
                    sides[i].addRight(reference);
            }
        });
        addUp();
    }
    place(range, uint32_t(leftCount), uint32_t(rightCount), left, right);
    std::vector<std::size_t> leftAt(parts), rightAt(parts);
    std::size_t atLeft = left.first, atRight = right.first;
    for (std::size_t i = 0; i < parts; ++i) {
        leftAt[i] = atLeft;
        rightAt[i] = atRight;
        atLeft += sides[i].left.size();
        atRight += sides[i].right.size();
        left.bounds.add(sides[i].leftBounds);
        right.bounds.add(sides[i].rightBounds);
    }
    crew.forEach(parts, [&](std::size_t i) {
        std::copy(sides[i].left.begin(), sides[i].left.end(), references_.data() + leftAt[i]);
        std::copy(sides[i].right.begin(), sides[i].right.end(), references_.data() + rightAt[i]);
    });
}

} // namespace smart
