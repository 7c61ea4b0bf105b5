// SPDX-License-Identifier: MIT
// The truth for millions of rays: the questions of ExactReference, answered with a tree of boxes,
// double arithmetic with an error bound, and exact sums where the bound does not decide. Shares
// no arithmetic with ExactReference, against which it is tested, and nothing with the library.
#pragma once

#include <vector>

#include "tests/support/exact_reference.h"
#include "tests/support/expansion.h"
#include "tests/support/verdict.h"

namespace smart::test {

/// A crossing, its distance in double and a bound of that distance's error.
struct Crossing : Touch {
    double t = 0, error = 0;
};

/// As ExactAnswer; where the distance is above the largest float, a hit is a may.
struct Truth {
    bool must = false;
    std::vector<Crossing> nearest, touches;
};

/// How far a claim is from the exact values at the triangle that it names.
struct ClaimErrors {
    double t;     ///< in units of the last place of a float at the exact t
    double uv;    ///< the larger of both, in 2^-24
    double uvUlp; ///< the same, each in units of the last place at its exact value
};

/// Immutable; any number of threads may ask.
class ExactScene {
public:
    /// The reference's corners must be exact in double.
    explicit ExactScene(const ExactReference& reference);

    const ExactReference& reference() const { return reference_; }
    bool crosses(uint32_t triangle, const Ray& ray, Crossing& crossing) const;
    Truth nearest(const Ray& ray) const;
    Verdict judge(const Truth& truth, const Ray& ray, const Claim& claim) const;
    /// For a triangle whose plane the ray is not parallel to.
    ClaimErrors errors(const Ray& ray, const Claim& claim) const;

private:
    struct Node {
        double lo[3], hi[3];
        uint32_t first, count; ///< leaf: places in order_; inner: 0, and the first child
    };
    struct Filtered;
    struct Exact;
    struct Contender;

    void build(uint32_t node, uint32_t first, uint32_t last);
    template <typename Visit>
    void visitNear(const Ray& ray, const Visit& visit) const;
    int compareT(const Ray& ray, Contender& a, Contender& b) const;
    int compareT(const Ray& ray, Contender& a, double limit) const;

    const ExactReference& reference_;
    double delta_, maxAbs_;
    std::vector<Node> nodes_;
    std::vector<uint32_t> order_;
};

} // namespace smart::test
