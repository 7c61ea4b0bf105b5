// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "libsmart/accel/kd_builder.h"
#include "libsmart/accel/kd_events.h"

namespace smart {

/// A cell on its way to become a leaf or an inner node.
struct KdCell {
    Aabb box;
    KdEventLists lists;
    uint32_t count = 0;   ///< primitives in it, each known by its events' number
    uint32_t depth = 0;
    double allowance = 0; ///< into how many references one of them may still become, on average
};

/// A plane that splits a cell; axis < 0: none pays.
struct KdPlane {
    int axis = -1;
    float position = 0;
    bool planarLeft = false; ///< which side takes the primitives that lie in it
};

/// The plane of least expected cost by the surface area heuristic, among all ends of boxes.
KdPlane findKdPlane(const KdCell& cell, const KdBuildOptions& options);

/// Thrown when splits have made more references than `maxExtra`: the build is to be repeated
/// with a finite allowance.
struct KdTooManyReferences {};

/// What all threads of a build share.
struct KdBuildShared {
    const KdPrimitives& primitives;
    const KdBuildOptions& options;
    uint32_t maxDepth;
    uint64_t maxExtra;              ///< references that splits may add, all together
    std::atomic<uint64_t> extra{0}; ///< references that splits have added, weighted by cell
};

/// Splits cells. Owned by one thread; keeps its working memory from one split to the next.
class KdSplitter {
public:
    explicit KdSplitter(KdBuildShared& shared) : shared_(shared) {}
    ~KdSplitter();
    KdSplitter(const KdSplitter&) = delete;
    KdSplitter& operator=(const KdSplitter&) = delete;

    /// Splits `cell`, whose primitives have numbers below `numbers`, number i being primitive
    /// ids[i]. False: it is a leaf. The children's lists come from the arenas, right first.
    bool split(const KdCell& cell, const std::vector<uint32_t>& ids, KdPlane& plane,
               KdEventArena& leftArena, KdCell& left, KdEventArena& rightArena, KdCell& right);

    uint64_t eventsSwept() const { return eventsSwept_; }

private:
    enum Side : uint8_t { kStraddles = 0, kLeft = 1, kRight = 2 };

    /// The straddlers' parts in one child.
    struct Clipped {
        uint32_t count;
        KdEventLists lists;
        std::vector<KdEvent> memory;
    };

    void classify(const KdCell& cell, const KdPlane& plane);
    void clipStraddlers(const std::vector<uint32_t>& ids, const Aabb& box, Clipped& clipped);
    void distribute(const KdEventLists& lists, KdCell& left, KdCell& right) const;
    void countExtra(uint64_t added, uint32_t cellCount);

    KdBuildShared& shared_;
    std::vector<uint8_t> sides_;        ///< by number
    std::vector<uint32_t> straddlers_;  ///< numbers
    uint32_t leftCount_ = 0, rightCount_ = 0;
    Clipped leftClipped_, rightClipped_;
    std::vector<KdEvent> sortScratch_;
    uint64_t eventsSwept_ = 0;
    uint64_t extra_ = 0; ///< weighted, not yet added to shared_.extra
};

} // namespace smart
