// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "libsmart/kernel/packet.h"
#include "libsmart/kernel/view.h"

namespace smart {

/// How exact an intersection is. Fast: Wald's projection, edges may leak. Watertight: no ray
/// passes between triangles that share an edge or a vertex. Precise: what exact arithmetic finds
/// for the rays, vertices and matrices as given.
enum class Precision : uint32_t { Fast = 0, Watertight = 1, Precise = 2 };
inline constexpr int kPrecisionCount = 3;
inline constexpr uint32_t kTilePackets = 4; ///< packets that may be traced together

/// Every entry finds the same hits, to the bit, whatever the instruction set. Equal distances go
/// to the lowest path, then to the lowest triangle; a model's own triangles before its children;
/// or, where the scene's view says lastOfEqual, to the last one in this order.
/// t, u and v of a hit are computed in double from the ray as given and rounded once; in precise
/// mode they are the exact ones, correctly rounded.
/// Fast needs ModelView::records in every model that the rays may reach.
struct KernelTable {
    const char* name; ///< generic, sse4, avx2, avx512, neon
    void (*intersect[kPrecisionCount])(const ModelView&, const RayPacket&, HitPacket&);
    /// blocked: bit i set where something lies in lane i's range
    void (*occluded[kPrecisionCount])(const ModelView&, const RayPacket&, uint32_t& blocked);
    void (*intersect1[kPrecisionCount])(const ModelView&, const Ray&, Hit&);
    bool (*occluded1[kPrecisionCount])(const ModelView&, const Ray&);
    /// The same for `count` packets, up to four, that lie close together: fastest where all their
    /// rays come from one point, or occluded where all head for one, in models with wide trees; the
    /// same hits in any case.
    void (*intersectTile[kPrecisionCount])(const ModelView&, const RayPacket*, uint32_t count,
                                           HitPacket*);
    void (*occludedTile[kPrecisionCount])(const ModelView&, const RayPacket*, uint32_t count,
                                          uint32_t* blocked);
    /// The same for any number of packets whose rays have nothing in common; hundreds of rays at a
    /// time are fastest.
    void (*intersectStream[kPrecisionCount])(const ModelView&, const RayPacket*, uint32_t count,
                                             HitPacket*);
    void (*occludedStream[kPrecisionCount])(const ModelView&, const RayPacket*, uint32_t count,
                                            uint32_t* blocked);
    /// Everything that each ray meets in its range, in no order, a triangle perhaps more than once.
    /// Where the list is too short, again with a longer one.
    void (*intersectAll[kPrecisionCount])(const ModelView&, const RayPacket&, HitList&);
    /// intersect that also adds up what it did
    void (*intersectCounted[kPrecisionCount])(const ModelView&, const RayPacket&, HitPacket&,
                                              TraversalCounts&);
};

/// The table for this machine, chosen at the first call: the best instruction set it has, or the
/// one that the environment variable OPENRT_ISA names (ignored in set-uid programs). Thread-safe.
const KernelTable& kernels();

/// Table by name; nullptr where the library or the machine has none of that name.
const KernelTable* findKernels(const char* name);

/// Forces a table for what follows; false, and no change, for a name that findKernels refuses.
/// Not while frames are being rendered.
bool selectKernels(const char* name);

} // namespace smart
