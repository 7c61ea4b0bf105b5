// SPDX-License-Identifier: MIT
#include "libsmart/geometry/tile_trees.h"

#include <cstring>

#include "libsmart/geometry/box_view.h"
#include "libsmart/kernel/packet.h"

namespace smart {
namespace {

/// Lays the triangles of each leaf out as WideView::corners says.
std::vector<float> layOut(const WideTree& tree, const std::vector<Triangle>& triangles) {
    std::vector<float> blocks(tree.prims.size() * kWordsOfTriangle + kPacketSize);
    for (const WideNode& node : tree.nodes) {
        for (const uint32_t child : node.child) {
            if (!(child & kWideLeaf)) continue;
            const uint32_t first = (child & ~kWideLeaf) >> 4, count = (child & 15u) + 1;
            float* to = blocks.data() + std::size_t(first) * kWordsOfTriangle;
            for (int component = 0; component < 9; ++component) {
                for (uint32_t i = first; i < first + count; ++i) {
                    const Triangle& triangle = triangles[tree.prims[i]];
                    const float* const vertices[] = {triangle.v0, triangle.v1, triangle.v2};
                    *to++ = vertices[component / 3][component % 3];
                }
            }
            std::memcpy(to, tree.prims.data() + first, count * sizeof(uint32_t));
        }
    }
    return blocks;
}

} // namespace

TileTrees::TileTrees(const std::vector<Triangle>& triangles, const std::vector<Aabb>& boxes)
    : triangles_(buildWideTree(boxes)) {
    if (!triangles_.nodes.empty()) blocks_ = layOut(triangles_, triangles);
    std::vector<uint32_t>().swap(triangles_.prims);
}

std::size_t TileTrees::bytes() const {
    return triangles_.bytes() + blocks_.capacity() * sizeof(float);
}

void TileTrees::show(ModelView& view) const {
    if (triangles_.nodes.empty()) return;
    static_cast<BoxView&>(view.wide) = makeBoxView(triangles_.bounds);
    view.wide.nodes = triangles_.nodes.data();
    view.wide.blocks = blocks_.data();
}

} // namespace smart
