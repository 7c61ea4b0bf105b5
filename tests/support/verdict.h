// SPDX-License-Identifier: MIT
// Judges an engine's answer about a ray against the exact one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iosfwd>

#include "tests/support/exact_reference.h"

namespace smart::test {

enum class Verdict : uint32_t {
    Right,     ///< as exact arithmetic says, or an exact tie, or a may
    Miss,      ///< a surface must be hit, nothing was reported
    Through,   ///< a later surface that is really there, or one that faces the other way, farther
    Slide,     ///< more than delta too far, on a surface that faces the same way
    Early,     ///< more than delta too near, on a surface that faces the same way
    Order,     ///< a real hit, but behind the nearest by at most delta
    False,     ///< a hit where nothing is
    Gross,     ///< the reported point is more than delta from the reported triangle
    WrongPrim, ///< another triangle within delta: benign
    Count
};

/// What an engine says; `triangle` by the reference's numbers, kNoHit for a miss.
struct Claim {
    uint32_t triangle = kNoHit;
    float t = 0, u = 0, v = 0;
};

/// The distance that separates a neighbour from an error: min(2^-16 of the largest absolute
/// coordinate, a quarter of the extent).
double verdictDelta(const ExactReference& reference);

Verdict judge(const ExactReference& reference, const ExactAnswer& truth, const Ray& ray,
              const Claim& claim);

/// Counts verdicts; errors of t in ulp, and of u, v in 2^-24, where the triangle is an exact one.
struct VerdictCounts {
    std::size_t rays = 0, hits = 0;
    std::size_t of[std::size_t(Verdict::Count)] = {};
    double worstT = 0, worstUv = 0;

    std::size_t operator[](Verdict verdict) const { return of[std::size_t(verdict)]; }
    std::size_t lost() const { return (*this)[Verdict::Miss] + (*this)[Verdict::Through]; }
    /// All that is neither right nor benign.
    std::size_t wrong() const {
        return rays - (*this)[Verdict::Right] - (*this)[Verdict::WrongPrim];
    }
    void add(const ExactReference& reference, const Ray& ray, const Claim& claim);
    void add(const ExactReference& reference, const ExactAnswer& truth, const Ray& ray,
             const Claim& claim);
};
std::ostream& operator<<(std::ostream& out, const VerdictCounts& counts);

} // namespace smart::test
