// SPDX-License-Identifier: MIT
// Rays through the kernels, in every way that they can be called.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "libsmart/kernel/kernels.h"

namespace smart::test {

/// The kernel tables that this machine can run, generic first.
std::vector<const KernelTable*> availableKernels();

/// How rays are put into packets. Full: 16 neighbours. Sparse: 5 rays in scattered lanes, the
/// inactive lanes full of NaN.
enum class Filling { Full, Sparse };

std::vector<Hit> tracePackets(const KernelTable& kernels, Precision precision,
                              const ModelView& scene, std::span<const Ray> rays, Filling filling);
std::vector<Hit> traceSingles(const KernelTable& kernels, Precision precision,
                              const ModelView& scene, std::span<const Ray> rays);
/// 1 where something lies in the range of the ray.
std::vector<uint8_t> blockedPackets(const KernelTable& kernels, Precision precision,
                                    const ModelView& scene, std::span<const Ray> rays,
                                    Filling filling);
std::vector<uint8_t> blockedSingles(const KernelTable& kernels, Precision precision,
                                    const ModelView& scene, std::span<const Ray> rays);

/// The same for tiles of packets.
std::vector<Hit> traceTiles(const KernelTable& kernels, Precision precision,
                            const ModelView& scene, std::span<const Ray> rays, Filling filling);
std::vector<uint8_t> blockedTiles(const KernelTable& kernels, Precision precision,
                                  const ModelView& scene, std::span<const Ray> rays,
                                  Filling filling);

/// The same for streams of packets: all rays in one call.
std::vector<Hit> traceStream(const KernelTable& kernels, Precision precision,
                             const ModelView& scene, std::span<const Ray> rays, Filling filling);
std::vector<uint8_t> blockedStream(const KernelTable& kernels, Precision precision,
                                   const ModelView& scene, std::span<const Ray> rays,
                                   Filling filling);

/// Equal in every bit that is defined.
bool sameHit(const Hit& a, const Hit& b);
/// Number of hits that differ.
std::size_t differences(std::span<const Hit> a, std::span<const Hit> b);

} // namespace smart::test
