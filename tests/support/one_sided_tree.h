// SPDX-License-Identifier: MIT
// A planted defect that checkers must find.
#pragma once

#include <cstdint>
#include <vector>

#include "libsmart/scene/scene.h"

namespace smart::test {

/// The tree of a scene of one model, with each triangle that lies on both sides of a split plane
/// on one side only: in the first leaf alone that holds it.
struct OneSidedTree {
    std::vector<KdNode> nodes;
    std::vector<uint32_t> prims;
    ModelView model;
    InstanceView child;
    ModelView scene;
    std::size_t dropped = 0;

    explicit OneSidedTree(const Scene& source) : scene(source.view()) {
        const Model& whole = *source.group().instances()[0].traits->model;
        nodes = whole.kdTree().nodes;
        prims = whole.kdTree().prims;
        std::vector<uint8_t> seen(whole.triangles.size());
        for (KdNode& node : nodes) {
            if ((node.bits & 3) != kKdLeaf) continue;
            const uint32_t count = node.bits >> 2;
            uint32_t kept = 0;
            for (uint32_t i = 0; i < count; ++i) {
                const uint32_t triangle = prims[node.firstPrim + i];
                if (seen[triangle]++)
                    ++dropped;
                else
                    prims[node.firstPrim + kept++] = triangle;
            }
            node.bits = kept << 2 | kKdLeaf;
        }
        model = whole.view();
        model.tree.nodes = nodes.data();
        model.tree.prims = prims.data();
        child = scene.children[0];
        child.model = &model;
        scene.children = &child;
    }
    OneSidedTree(const OneSidedTree&) = delete;
    OneSidedTree& operator=(const OneSidedTree&) = delete;
};

} // namespace smart::test
