// SPDX-License-Identifier: MIT
#include "tests/libsmart/accel/kd_test_support.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace smart::test {
namespace {

bool isLeaf(const KdNode& node) { return (node.bits & 3) == kKdLeaf; }

/// Akenine-Moeller, "Fast 3D triangle-box overlap testing", JGT 6(1), 2001: no axis separates the
/// triangle from the box shrunk by `margin`.
bool meetsInside(const Triangle& triangle, const Aabb& cell) {
    double half[3], corner[3][3], scale = 0, widest = 0;
    const float* const vertices[3] = {triangle.v0, triangle.v1, triangle.v2};
    for (int k = 0; k < 3; ++k) {
        half[k] = (double(cell.hi[k]) - cell.lo[k]) / 2;
        widest = std::max(widest, half[k]);
    }
    for (int k = 0; k < 3; ++k) {
        const double centre = (double(cell.hi[k]) + cell.lo[k]) / 2;
        scale = std::max({scale, std::fabs(double(cell.lo[k])), std::fabs(double(cell.hi[k]))});
        for (int i = 0; i < 3; ++i) {
            corner[i][k] = vertices[i][k] - centre;
            scale = std::max(scale, std::fabs(double(vertices[i][k])));
        }
        if (half[k] == 0) half[k] = widest; // a flat scene: every triangle lies in the cell's plane
    }
    const double margin = scale * 0x1p-40;
    const auto separates = [&](double x, double y, double z) {
        const double length = std::sqrt(x * x + y * y + z * z);
        if (length == 0) return false;
        const double reach = half[0] * std::fabs(x) + half[1] * std::fabs(y) +
                             half[2] * std::fabs(z) - margin * length;
        double least = INFINITY, most = -INFINITY;
        for (const auto& p : corner) {
            const double along = p[0] * x + p[1] * y + p[2] * z;
            least = std::min(least, along);
            most = std::max(most, along);
        }
        return least >= reach || most <= -reach;
    };
    if (separates(1, 0, 0) || separates(0, 1, 0) || separates(0, 0, 1)) return false;
    double edge[3][3];
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) edge[i][k] = corner[(i + 1) % 3][k] - corner[i][k];
        const double* e = edge[i];
        if (separates(0, e[2], -e[1]) || separates(-e[2], 0, e[0]) || separates(e[1], -e[0], 0)) {
            return false;
        }
    }
    const double *a = edge[0], *b = edge[1];
    return !separates(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                      a[0] * b[1] - a[1] * b[0]);
}

bool holds(const KdTree& tree, const KdNode& leaf, uint32_t prim) {
    const auto first = tree.prims.begin() + leaf.firstPrim, last = first + (leaf.bits >> 2);
    return std::find(first, last, prim) != last;
}

/// Calls leaf(node, cell) for every leaf below that `enter(cell)` does not refuse.
template <class Enter, class Leaf>
void visit(const KdTree& tree, uint32_t index, const Aabb& cell, const Enter& enter,
           const Leaf& leaf) {
    if (!enter(cell)) return;
    const KdNode& node = tree.nodes[index];
    if (isLeaf(node)) {
        leaf(node, cell);
        return;
    }
    const uint32_t axis = node.bits & 3;
    Aabb left = cell, right = cell;
    left.hi[axis] = right.lo[axis] = node.split;
    visit(tree, node.bits >> 2, left, enter, leaf);
    visit(tree, (node.bits >> 2) + 1, right, enter, leaf);
}

} // namespace

std::string checkKdStructure(const KdTree& tree, uint32_t primCount, KdLeafCounts* counts) {
    if (tree.nodes.empty()) return tree.prims.empty() ? "" : "references without nodes";
    KdLeafCounts found;
    std::vector<char> nodeSeen(tree.nodes.size(), 0), referenceSeen(tree.prims.size(), 0);
    struct Step {
        uint32_t index, depth;
        Aabb cell;
    };
    std::vector<Step> stack{{0, 0, tree.bounds}};
    while (!stack.empty()) {
        const Step step = stack.back();
        stack.pop_back();
        if (step.index >= tree.nodes.size()) return "child index out of range";
        if (std::exchange(nodeSeen[step.index], 1)) return "node reached twice";
        const KdNode& node = tree.nodes[step.index];
        if (isLeaf(node)) {
            const uint64_t count = node.bits >> 2;
            if (node.firstPrim + count > tree.prims.size()) return "leaf out of range";
            std::vector<uint32_t> prims(tree.prims.begin() + node.firstPrim,
                                        tree.prims.begin() + node.firstPrim + ptrdiff_t(count));
            for (uint64_t i = 0; i < count; ++i) {
                if (std::exchange(referenceSeen[node.firstPrim + i], 1)) return "leaves overlap";
                if (prims[i] >= primCount) return "no such primitive";
            }
            std::sort(prims.begin(), prims.end());
            if (std::adjacent_find(prims.begin(), prims.end()) != prims.end()) {
                return "primitive twice in a leaf";
            }
            ++found.leaves;
            found.emptyLeaves += count == 0;
            found.largestLeaf = std::max(found.largestLeaf, count);
            found.depth = std::max(found.depth, step.depth);
            continue;
        }
        const uint32_t axis = node.bits & 3;
        if (!(step.cell.lo[axis] < node.split && node.split < step.cell.hi[axis])) {
            return "split outside its cell";
        }
        Step left = step, right = step;
        left.index = node.bits >> 2;
        right.index = left.index + 1;
        left.depth = right.depth = step.depth + 1;
        left.cell.hi[axis] = right.cell.lo[axis] = node.split;
        stack.push_back(right);
        stack.push_back(left);
    }
    if (std::count(nodeSeen.begin(), nodeSeen.end(), 0) > 0) return "node not reached";
    if (std::count(referenceSeen.begin(), referenceSeen.end(), 0) > 0) return "reference not used";
    const double limit = 8 + 1.3 * std::log2(double(std::max(primCount, 1u)));
    if (found.depth > kKdMaxDepth || found.depth > limit) return "too deep";
    if (counts) *counts = found;
    return "";
}

uint64_t countMissing(const KdTree& tree, const std::vector<Triangle>& triangles) {
    if (tree.nodes.empty()) return triangles.size();
    uint64_t missing = 0;
    for (uint32_t prim = 0; prim < triangles.size(); ++prim) {
        const Triangle& triangle = triangles[prim];
        const Aabb box = boundsOf(triangle);
        bool vertexHeld[3] = {};
        const float* const vertices[3] = {triangle.v0, triangle.v1, triangle.v2};
        const auto meets = [&](const Aabb& cell) { return !intersection(box, cell).empty(); };
        const auto checkLeaf = [&](const KdNode& leaf, const Aabb& cell) {
            if (!holds(tree, leaf, prim)) {
                missing += meetsInside(triangle, cell);
                return;
            }
            for (int i = 0; i < 3; ++i) {
                Aabb point;
                point.add(vertices[i]);
                vertexHeld[i] = vertexHeld[i] || !intersection(point, cell).empty();
            }
        };
        visit(tree, 0, tree.bounds, meets, checkLeaf);
        missing += uint64_t(!vertexHeld[0]) + !vertexHeld[1] + !vertexHeld[2];
    }
    return missing;
}

} // namespace smart::test
