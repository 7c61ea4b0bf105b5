// SPDX-License-Identifier: MIT
#include "libsmart/geometry/tile_trees.h"

#include "libsmart/geometry/instance_group.h"
#include "libsmart/kernel/packet.h"

namespace smart {
namespace {

/// Lays the triangles of each leaf out as WideView::corners says.
std::vector<float> layOut(const WideTree& tree, const std::vector<Triangle>& triangles) {
    std::vector<float> corners(tree.prims.size() * 9 + kPacketSize);
    for (const WideNode& node : tree.nodes) {
        for (const uint32_t child : node.child) {
            if (!(child & kWideLeaf)) continue;
            const uint32_t first = (child & ~kWideLeaf) >> 4, count = (child & 15u) + 1;
            float* to = corners.data() + std::size_t(first) * 9;
            for (int component = 0; component < 9; ++component) {
                for (uint32_t i = first; i < first + count; ++i) {
                    const Triangle& triangle = triangles[tree.prims[i]];
                    const float* const vertices[] = {triangle.v0, triangle.v1, triangle.v2};
                    *to++ = vertices[component / 3][component % 3];
                }
            }
        }
    }
    return corners;
}

WideView viewOf(const WideTree& tree, const std::vector<float>& corners) {
    if (tree.nodes.empty()) return {};
    return {tree.nodes.data(), tree.prims.data(), corners.empty() ? nullptr : corners.data()};
}

} // namespace

TileTrees::TileTrees(const std::vector<Triangle>& triangles, const std::vector<Aabb>& boxes,
                     const InstanceGroup& children)
    : triangles_(buildWideTree(boxes)) {
    if (!triangles_.nodes.empty()) corners_ = layOut(triangles_, triangles);
    if (!children.tree().nodes.empty()) children_ = buildWideTree(children.boxes());
}

std::size_t TileTrees::bytes() const {
    return triangles_.bytes() + children_.bytes() + corners_.capacity() * sizeof(float);
}

void TileTrees::show(ModelView& view) const {
    view.wide = viewOf(triangles_, corners_);
    view.wideChildren = viewOf(children_, {});
}

} // namespace smart
