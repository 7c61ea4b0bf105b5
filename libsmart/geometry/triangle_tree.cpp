// SPDX-License-Identifier: MIT
#include "libsmart/geometry/triangle_tree.h"

#include <atomic>
#include <cstring>

#include "libsmart/accel/reference_list.h"
#include "libsmart/accel/wide_refit.h"
#include "libsmart/kernel/packet.h"

namespace smart {
namespace {

constexpr std::size_t kNodesOfPart = 64;

std::size_t wordsFor(std::size_t entries) { return entries * kWordsOfTriangle + kPacketSize; }

/// Uninitialised but for the words behind the last leaf.
std::unique_ptr<float[]> makeBlocks(std::size_t entries) {
    const std::size_t words = wordsFor(entries);
    auto blocks = std::make_unique_for_overwrite<float[]>(words);
    std::memset(blocks.get() + words - kPacketSize, 0, kPacketSize * sizeof(float));
    return blocks;
}

const float* verticesOf(const Triangle& triangle) {
    static_assert(sizeof(Triangle) == 9 * sizeof(float));
    return triangle.v0;
}

/// Writes a leaf's block as WideView::blocks says.
void layOutLeaf(float* block, const uint32_t* numbers, uint32_t count,
                std::span<const Triangle> triangles) {
    for (uint32_t i = 0; i < count; ++i) {
        const float* const vertices = verticesOf(triangles[numbers[i]]);
        for (uint32_t component = 0; component < 9; ++component)
            block[component * count + i] = vertices[component];
    }
    std::memcpy(block + 9 * std::size_t(count), numbers, count * sizeof(uint32_t));
}

float* blockOf(float* blocks, uint32_t first) {
    return blocks + std::size_t(first) * kWordsOfTriangle;
}

} // namespace

TriangleTree::TriangleTree(std::span<const Triangle> triangles, std::span<const Aabb> boxes,
                           WideQuality quality, unsigned threads) {
    if (boxes.empty()) return;
    WideTree tree = quality == WideQuality::Fast ? buildWideTreeFast(boxes, threads)
                    : quality == WideQuality::Binned
                        ? buildWideTree(boxes, threads)
                        : buildWideTreeSpatial(boxes, verticesOf(triangles[0]), threads);
    if (tree.nodes.empty()) return;
    blocks_ = makeBlocks(tree.prims.size());
    BuildCrew crew(threads);
    const std::size_t parts = (tree.nodes.size() + kNodesOfPart - 1) / kNodesOfPart;
    crew.forEach(parts, [&](std::size_t part) {
        const std::size_t begin = part * kNodesOfPart;
        const std::size_t end = std::min(tree.nodes.size(), begin + kNodesOfPart);
        for (std::size_t i = begin; i < end; ++i) {
            for (int slot = 0; slot < kWideChildren; ++slot) {
                const uint32_t child = tree.nodes[i].child[slot];
                if (!(child & kWideLeaf)) continue;
                const auto [first, count] = leafEntries(child);
                layOutLeaf(blockOf(blocks_.get(), first), tree.prims.data() + first, count,
                           triangles);
            }
        }
    });
    entries_ = tree.prims.size();
    primitives_ = tree.primitives;
    bounds_ = tree.bounds;
    cost_ = builtCost_ = tree.cost;
    nodes_ = std::move(tree.nodes);
}

std::optional<TriangleTree> TriangleTree::refitted(std::span<const Triangle> moved,
                                                   std::span<const Aabb> boxes,
                                                   unsigned threads) const {
    BuildCrew crew(threads);
    if (countBoxes(boxes, crew).back() != primitives_) return std::nullopt;
    TriangleTree tree;
    if (empty()) return tree;
    tree.nodes_ = nodes_;
    tree.blocks_ = makeBlocks(entries_);
    tree.entries_ = entries_;
    tree.primitives_ = primitives_;
    tree.builtCost_ = builtCost_;
    std::atomic<bool> same{true};
    tree.bounds_ = refitNodes(std::span(tree.nodes_), [&](uint32_t child) {
        const auto [first, count] = leafEntries(child);
        uint32_t numbers[kWideLeafSize];
        std::memcpy(numbers, blockOf(blocks_.get(), first) + 9 * std::size_t(count),
                    count * sizeof(uint32_t));
        Box4 box;
        for (uint32_t i = 0; i < count; ++i) {
            if (numbers[i] >= boxes.size() || boxes[numbers[i]].empty()) {
                same.store(false, std::memory_order_relaxed);
                return box;
            }
            box.add(Box4(boxes[numbers[i]]));
        }
        layOutLeaf(blockOf(tree.blocks_.get(), first), numbers, count, moved);
        return box;
    }, crew);
    if (!same) return std::nullopt;
    tree.cost_ = wideTreeCost(tree.nodes_, tree.bounds_, kTriangleCosts);
    return tree;
}

std::size_t TriangleTree::bytes() const {
    return nodes_.capacity() * sizeof(WideNode) +
           (blocks_ ? wordsFor(entries_) * sizeof(float) : 0);
}

} // namespace smart
