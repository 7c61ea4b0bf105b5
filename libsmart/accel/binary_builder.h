// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "libsmart/accel/binary_costs.h"
#include "libsmart/accel/build_crew.h"
#include "libsmart/accel/object_split.h"
#include "libsmart/accel/reference_list.h"
#include "libsmart/accel/spatial_split.h"

namespace smart {

/// Divides references into a binary tree with the slots of wide nodes distributed: by the surface
/// area heuristic over bins (Wald, "On fast construction of SAH-based bounding volume hierarchies",
/// 2007), with spatial splits where boxes overlap. Threads share the work; the tree does not depend
/// on how many. A leaf's references stand at [first, first + count); of one that was made of a
/// divided node, at those of the leaves below it.
class BinaryBuilder {
public:
    /// At least one reference. vertices: nullptr, or triangles that may be cut, the numbers of
    /// references being theirs; this makes no more references than there is room for. subtrees:
    /// empty, or what takes the place of each reference, by its number. The root becomes node 0 of
    /// `tree`, which has room for two nodes a reference and one source of them a thread.
    BinaryBuilder(ReferenceList list, TriangleVertices vertices,
                  std::span<const BinarySubtree> subtrees, const BinaryCosts& costs,
                  BinaryTree& tree, BuildCrew& crew);

    const BoxReference& reference(uint32_t at) const { return references_[at]; }

private:
    /// References from `first` on with room up to `end`.
    struct Range {
        uint32_t first = 0, count = 0, end = 0;
        int depth = 0;
        ReferenceBounds bounds;
        std::size_t extra() const { return end - first - count; }
    };
    /// A range near the root: divided by all threads together, or built whole by one.
    struct Branch {
        uint32_t node = 0;
        Range range;
        uint32_t left = 0; ///< number of the left branch, the right one follows it; 0: built whole
        SlotCosts costs;
    };
    /// What one thread works with.
    struct Workplace {
        explicit Workplace(BinaryTree& tree, bool isFirst) : nodes(tree, isFirst) {}
        BinaryTree::Source nodes;
        SplitSides sides;
    };

    class Workplaces;

    void plant(std::size_t count, const ReferenceBounds& bounds, BuildCrew& crew);
    SlotCosts finish(uint32_t node, const Range& range);
    bool canBeLeaf(const Range& range) const {
        return subtrees_.empty() && range.count <= kWideLeafSize;
    }
    SlotCosts build(uint32_t node, const Range& range, Workplace& place);
    void divide(const Range& range, Workplace& place, Range& left, Range& right);
    void divideByAll(const Range& range, BuildCrew& crew, Range& left, Range& right);
    void halve(const Range& range, Range& left, Range& right);
    bool wantsSpatial(const Range& range, const ObjectSplit& split) const;
    /// Where the sides of a divided range go, and how the room that is left is shared.
    static void place(const Range& range, uint32_t leftCount, uint32_t rightCount, Range& left,
                      Range& right);

    std::vector<BoxReference> references_;
    const TriangleVertices vertices_;
    const std::span<const BinarySubtree> subtrees_;
    const BinaryCosts& costs_;
    const uint32_t smallest_; ///< references that are never divided
    BinaryTree& tree_;
};

} // namespace smart
