// SPDX-License-Identifier: MIT
// The sorted ends of boxes that the exact kd-tree builder sweeps.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "libsmart/base/aabb.h"

namespace smart {

/// An end of a primitive's box on one axis, as one integer whose order is the sweep's: position
/// (32 bits), kind (2), primitive (30).
using KdEvent = uint64_t;

/// At one position boxes end before others start, so that touching ones count on one side each.
enum class KdEventKind : uint32_t { End = 0, Planar = 1, Start = 2 };

inline constexpr uint32_t kKdMaxPrims = 1u << 30;

inline KdEvent makeKdEvent(float position, KdEventKind kind, uint32_t prim) {
    const uint32_t bits = std::bit_cast<uint32_t>(position + 0.0f); // -0 becomes 0
    const uint32_t ordered = bits ^ ((bits >> 31) ? 0xffffffffu : 0x80000000u);
    return uint64_t(ordered) << 32 | uint64_t(kind) << 30 | prim;
}
inline float kdEventPosition(KdEvent event) {
    const uint32_t ordered = uint32_t(event >> 32);
    return std::bit_cast<float>(ordered ^ ((ordered >> 31) ? 0x80000000u : 0xffffffffu));
}
inline KdEventKind kdEventKind(KdEvent event) { return KdEventKind(uint32_t(event) >> 30); }
inline uint32_t kdEventPrim(KdEvent event) { return uint32_t(event) & (kKdMaxPrims - 1); }

/// The events of one cell, sorted, an axis a list. The memory belongs to a KdEventArena.
struct KdEventLists {
    KdEvent* events[3] = {};
    uint32_t size[3] = {};

    void add(const Aabb& box, uint32_t prim) {
        for (int k = 0; k < 3; ++k) {
            if (box.lo[k] == box.hi[k]) {
                events[k][size[k]++] = makeKdEvent(box.lo[k], KdEventKind::Planar, prim);
            } else {
                events[k][size[k]++] = makeKdEvent(box.lo[k], KdEventKind::Start, prim);
                events[k][size[k]++] = makeKdEvent(box.hi[k], KdEventKind::End, prim);
            }
        }
    }
    uint64_t total() const { return uint64_t(size[0]) + size[1] + size[2]; }
};

/// Memory for event lists, given back in the reverse order. Owned and used by one thread at a time.
class KdEventArena {
public:
    struct Mark {
        std::size_t chunk, used;
    };

    /// Empty lists with room for `prims` primitives, and for one event more on each axis.
    KdEventLists allocate(std::size_t prims);
    Mark mark() const { return {chunk_, used_}; }
    /// Gives back everything allocated since the mark was taken.
    void release(Mark mark) {
        chunk_ = mark.chunk;
        used_ = mark.used;
    }

private:
    struct Chunk {
        std::unique_ptr<KdEvent[]> events;
        std::size_t size;
    };
    std::vector<Chunk> chunks_;
    std::size_t chunk_ = 0; ///< the one in use; later ones are spare
    std::size_t used_ = 0;  ///< events of it that are taken
};

/// Sorts by position and kind; the order of equal ones is free, but the same each time.
/// `scratch` is room that the caller keeps for the next time.
void sortKdEvents(KdEvent* events, std::size_t count, std::vector<KdEvent>& scratch);

/// Merges sorted `added` into the sorted list of `count` events, which has room for both.
void mergeKdEvents(KdEvent* list, std::size_t count, const KdEvent* added, std::size_t addedCount);

} // namespace smart
