// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace smart {

inline constexpr int kWideChildren = 16;
inline constexpr uint32_t kWideLeaf = 0x80000000u;
inline constexpr uint32_t kWideLeafSize = 16; ///< primitives of a leaf, at most
inline constexpr uint32_t kWordsOfTriangle = 10; ///< in a leaf's block: vertices and number
inline constexpr int kWideMaxDepth = 64;      ///< nodes from the root to a leaf, at most

/// Up to sixteen child boxes side by side. A child is the number of another node, or a leaf:
/// kWideLeaf, the number of its first entry in WideTree::prims in the 27 bits above 4, and the
/// count less one in those. Places without a child hold an empty box.
struct alignas(64) WideNode {
    float lo[3][kWideChildren];
    float hi[3][kWideChildren];
    uint32_t child[kWideChildren];
};

} // namespace smart
