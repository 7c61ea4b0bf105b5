// SPDX-License-Identifier: MIT
#include "libsmart/geometry/degenerate.h"

#include <cmath>

namespace smart {
namespace {

/// Whether the terms sum up to exactly zero, while nothing overflows. Grow-Expansion of
/// Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates",
/// Discrete & Computational Geometry 18 (1997), section 2.3: components that do not overlap and
/// add up to the exact sum, so that the sum is zero only where every component is.
template <int N>
bool isZeroSum(const double (&terms)[N]) {
    double components[N];
    for (int count = 0; count < N; ++count) {
        double carried = terms[count];
        for (int i = 0; i < count; ++i) { // Two-Sum, after Knuth
            const double sum = carried + components[i];
            const double virtualPart = sum - carried;
            const double error = (carried - (sum - virtualPart)) + (components[i] - virtualPart);
            components[i] = error;
            carried = sum;
        }
        components[count] = carried;
    }
    for (const double component : components) {
        if (component != 0) return false;
    }
    return true;
}

} // namespace

bool isFinite(const Triangle& triangle) {
    for (int k = 0; k < 3; ++k) {
        if (!std::isfinite(triangle.v0[k]) || !std::isfinite(triangle.v1[k]) ||
            !std::isfinite(triangle.v2[k])) {
            return false;
        }
    }
    return true;
}

bool isDegenerate(const Triangle& triangle) {
    // Where a component exceeds the bound of its rounding errors, it is not zero: each difference
    // has one error of 2^-53, each product three, the result four.
    double a[3], b[3];
    for (int k = 0; k < 3; ++k) {
        a[k] = double(triangle.v1[k]) - triangle.v0[k];
        b[k] = double(triangle.v2[k]) - triangle.v0[k];
    }
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const double left = a[i] * b[j], right = a[j] * b[i];
        if (std::fabs(left - right) > 0x1p-50 * (std::fabs(left) + std::fabs(right))) return false;
    }
    // Multiplied out, each component is a sum of products of two coordinates, each exact in double.
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const double p0 = triangle.v0[i], p1 = triangle.v1[i], p2 = triangle.v2[i];
        const double q0 = triangle.v0[j], q1 = triangle.v1[j], q2 = triangle.v2[j];
        if (!isZeroSum({p0 * q1, -q0 * p1, p1 * q2, -q1 * p2, p2 * q0, -q2 * p0})) return false;
    }
    return true;
}

} // namespace smart
