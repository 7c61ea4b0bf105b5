// SPDX-License-Identifier: MIT
#include "tests/accuracy/tally.h"

#include <algorithm>
#include <cmath>

namespace smart::test {

void Tally::add(const ExactScene& scene, const Truth& truth, const Ray& ray, const Claim& claim) {
    const Verdict verdict = scene.judge(truth, ray, claim);
    ++counts.rays;
    ++counts.of[std::size_t(verdict)];
    if (claim.triangle == kNoHit) return;
    ++counts.hits;
    const auto names = [&](const Crossing& crossing) {
        return crossing.triangle == claim.triangle;
    };
    const bool exact = std::any_of(truth.nearest.begin(), truth.nearest.end(), names) ||
                       std::any_of(truth.touches.begin(), truth.touches.end(), names);
    const bool real = claim.triangle < scene.reference().count() && std::isfinite(claim.t) &&
                      !scene.reference().degenerate(claim.triangle);
    if (!real) return;
    const ClaimErrors errors = scene.errors(ray, claim);
    if (std::isfinite(errors.t)) worstPlaneT = std::max(worstPlaneT, errors.t);
    if (!exact) return;
    ++measured;
    sumT += errors.t;
    counts.worstT = std::max(counts.worstT, errors.t);
    counts.worstUv = std::max(counts.worstUv, errors.uv);
    worstUvUlp = std::max(worstUvUlp, errors.uvUlp);
    beyondHalfT += errors.t > 0.5;
    beyondHalfUv += errors.uvUlp > 0.5;
}

void Tally::add(const Tally& other) {
    counts.rays += other.counts.rays;
    counts.hits += other.counts.hits;
    for (std::size_t k = 0; k < std::size_t(Verdict::Count); ++k)
        counts.of[k] += other.counts.of[k];
    counts.worstT = std::max(counts.worstT, other.counts.worstT);
    counts.worstUv = std::max(counts.worstUv, other.counts.worstUv);
    measured += other.measured;
    sumT += other.sumT;
    worstUvUlp = std::max(worstUvUlp, other.worstUvUlp);
    beyondHalfT += other.beyondHalfT;
    beyondHalfUv += other.beyondHalfUv;
    worstPlaneT = std::max(worstPlaneT, other.worstPlaneT);
}

} // namespace smart::test
