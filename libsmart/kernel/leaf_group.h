// SPDX-License-Identifier: MIT
// Leaves of a wide tree that a tile goes through together: most have so few triangles that two or
// three of them fill a register.
#pragma once

#include "libsmart/kernel/beam.h"

namespace smart::SMART_ISA {

/// Triangles side by side, as many as a packet has rays, with bits for the packets that may meet
/// each.
class LeafGroup {
public:
    static constexpr int N = kPacketSize;

    LeafGroup() { clear(); }

    uint32_t count() const { return count_; }
    bool hasRoomFor(uint32_t leaf) const { return count_ + (leaf & 15u) + 1 <= uint32_t(N); }
    /// leaf: a child of a wide node that is one. rays: of each packet, those that meet its box.
    HWY_INLINE void add(const float* blocks, uint32_t leaf, uint32_t packets,
                        const Mask<N>* rays) {
        const uint32_t count = (leaf & 15u) + 1;
        const float* from = blocks + std::size_t(kWordsOfTriangle) * ((leaf & ~kWideLeaf) >> 4);
        for (uint32_t row = 0; row < kWordsOfTriangle; ++row, from += count)
            Real<N>::loadUnaligned(from).storeUnaligned(words_[row] + count_);
        for (int v = 0; v < kTileVectors; ++v) rays_[v] = rays_[v] | rays[v];
        // Sixteen equal bits for each packet.
        const uint64_t lowest = (packets & 1u) | uint64_t(packets & 2u) << 15 |
                                uint64_t(packets & 4u) << 30 | uint64_t(packets & 8u) << 45;
        pairs_ |= lowest * ((1u << count) - 1u) << count_;
        packets_ |= packets;
        count_ += count;
    }
    void clear() {
        for (Mask<N>& rays : rays_) rays = Mask<N>::fromBits(0);
        pairs_ = packets_ = count_ = 0;
    }

    uint32_t packets() const { return packets_; }
    uint64_t pairs() const { return pairs_; } ///< bit 16 v + i: packet v and triangle i
    const Mask<N>& rays(int v) const { return rays_[v]; } ///< that meet one of the leaves
    /// A coordinate of a vertex of all triangles; beyond the last any number.
    const float* coordinates(int vertex, int axis) const { return words_[3 * vertex + axis]; }
    uint32_t number(int i) const {
        uint32_t number;
        __builtin_memcpy(&number, words_[kWordsOfTriangle - 1] + i, sizeof number);
        return number;
    }
    void load(int i, Triangle& triangle) const {
        const float* from = words_[0] + i;
        for (float* vertex : {triangle.v0, triangle.v1, triangle.v2})
            for (int k = 0; k < 3; ++k, from += 2 * N) vertex[k] = *from;
    }

private:
    alignas(64) float words_[kWordsOfTriangle][2 * N];
    Mask<N> rays_[kTileVectors];
    uint64_t pairs_;
    uint32_t packets_, count_;
};

} // namespace smart::SMART_ISA
