// SPDX-License-Identifier: MIT
#pragma once

#include "tests/support/exact_scene.h"

namespace smart::test {

/// What an engine's answers to many rays were worth.
struct Tally {
    VerdictCounts counts;
    std::size_t measured = 0; ///< hits of an exactly nearest triangle: errors below are theirs
    double sumT = 0;          ///< ulp, for the mean
    double worstUvUlp = 0;    ///< counts.worstUv is in 2^-24
    std::size_t beyondHalfT = 0, beyondHalfUv = 0; ///< not correctly rounded
    double worstPlaneT = 0; ///< ulp; of any triangle reported, against its own plane

    void add(const ExactScene& scene, const Truth& truth, const Ray& ray, const Claim& claim);
    void add(const Tally& other);
    double meanT() const { return measured ? sumT / double(measured) : 0; }
};

} // namespace smart::test
