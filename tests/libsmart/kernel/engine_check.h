// SPDX-License-Identifier: MIT
// What every kernel must say about a set of rays.
#pragma once

#include <gtest/gtest.h>

#include <iostream>
#include <string>

#include "tests/support/kernel_runs.h"
#include "tests/support/traced_scene.h"

namespace smart::test {

/// All tables, packets full and sparse, and single rays: the bits of `first`, or, where that is
/// empty, the same bits as each other; any hit as closest hit.
inline void traceAllWays(const ModelView& view, std::span<const Ray> rays, Precision precision,
                         std::vector<Hit>& first) {
    for (const KernelTable* kernels : availableKernels()) {
        SCOPED_TRACE(kernels->name);
        const std::vector<Hit> full = tracePackets(*kernels, precision, view, rays, Filling::Full);
        if (first.empty()) first = full;
        EXPECT_EQ(differences(full, first), 0u) << "against " << availableKernels()[0]->name;
        const std::vector<Hit> sparse =
            tracePackets(*kernels, precision, view, rays, Filling::Sparse);
        EXPECT_EQ(differences(sparse, first), 0u) << "sparse packets";
        const std::vector<Hit> single = traceSingles(*kernels, precision, view, rays);
        EXPECT_EQ(differences(single, first), 0u) << "single rays";

        const auto fullBlocked = blockedPackets(*kernels, precision, view, rays, Filling::Full);
        const auto sparseBlocked = blockedPackets(*kernels, precision, view, rays, Filling::Sparse);
        const auto singleBlocked = blockedSingles(*kernels, precision, view, rays);
        std::size_t unlike[3] = {};
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const bool hit = first[i].triangle != kNoHit;
            unlike[0] += (fullBlocked[i] != 0) != hit;
            unlike[1] += (sparseBlocked[i] != 0) != hit;
            unlike[2] += (singleBlocked[i] != 0) != hit;
        }
        EXPECT_EQ(unlike[0], 0u) << "any hit, full packets";
        EXPECT_EQ(unlike[1], 0u) << "any hit, sparse packets";
        EXPECT_EQ(unlike[2], 0u) << "any hit, single rays";
    }
}

/// Returns the hits.
inline std::vector<Hit> traceAllWays(const ModelView& view, std::span<const Ray> rays,
                                     Precision precision = Precision::Watertight) {
    std::vector<Hit> hits;
    traceAllWays(view, rays, precision, hits);
    return hits;
}

/// The same in kd-trees and in wide trees.
inline std::vector<Hit> traceAllWays(const TracedScene& scene, std::span<const Ray> rays,
                                     Precision precision = Precision::Watertight) {
    std::vector<Hit> hits = traceAllWays(scene.view(), rays, precision);
    SCOPED_TRACE("wide trees");
    traceAllWays(scene.wideView(), rays, precision, hits);
    return hits;
}

/// traceAllWays, judged by the exact reference: nothing wrong, t within 16 ulp, u and v within
/// 16 units of 2^-24. Neighbours that are benign are counted in the result.
inline VerdictCounts checkWatertight(const TracedScene& scene, std::span<const Ray> rays,
                                     const std::string& name) {
    SCOPED_TRACE(name);
    const std::vector<ExactAnswer> truth = scene.truth(rays);
    const std::vector<Hit> hits = traceAllWays(scene, rays);
    const VerdictCounts counts = scene.judgeAll(rays, truth, hits);
    EXPECT_EQ(counts.wrong(), 0u) << counts;
    EXPECT_LE(counts.worstT, 16) << counts;
    EXPECT_LE(counts.worstUv, 16) << counts;
    std::cout << "    " << name << ": " << counts << '\n';
    return counts;
}

} // namespace smart::test
