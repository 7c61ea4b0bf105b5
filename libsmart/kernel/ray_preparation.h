// SPDX-License-Identifier: MIT
// Rays as given -> rays that traversal can trust.
#pragma once

#include "libsmart/kernel/search.h"

namespace smart::SMART_ISA {

/// 2^-e with 2^e <= x < 2^(e+1), exact in double for every finite x > 0.
inline double inverseBinade(float x) {
    const double d = x; // a denormal float is a normal double
    uint64_t bits;
    __builtin_memcpy(&bits, &d, sizeof bits);
    bits = (uint64_t(2046) << 52) - (bits & (uint64_t(2047) << 52));
    double result;
    __builtin_memcpy(&result, &bits, sizeof result);
    return result;
}

/// Copies N rays; returns the lanes of `active` that carry a legal ray. Directions whose largest
/// component is far from 1 are scaled by a power of two, limits inversely, so that reciprocals
/// neither overflow nor lose bits; `scale` is that power, 1 for others. Lanes without a legal ray
/// get a harmless one with an empty range.
template <int N, HitMode M, class Counter>
uint32_t prepareRays(const float* const org[3], const float* const dir[3], const float* tNear,
                     const float* tFar, uint32_t active, LocalRays<N>& rays,
                     double (&scale)[N], Search<N, M, Counter>& query) {
    const Real<N> zero(0.0f), largestFinite(0x1.fffffep127f);
    const Real<N> near = Real<N>::load(tNear), far = Real<N>::load(tFar);
    Mask<N> legal = Mask<N>::fromBits(active) & (near <= far) & (far >= zero);
    Real<N> largest = zero;
    for (int k = 0; k < 3; ++k) {
        const Real<N> size = magnitude(Real<N>::load(dir[k]));
        legal = legal & (size <= largestFinite) &
                (magnitude(Real<N>::load(org[k])) <= largestFinite);
        largest = max(largest, size);
    }
    legal = legal & (largest > zero);
    for (int k = 0; k < 3; ++k) {
        select(legal, Real<N>::load(org[k]), zero).store(rays.org[k]);
        select(legal, Real<N>::load(dir[k]), Real<N>(1.0f)).store(rays.dir[k]);
    }
    select(legal, max(near, zero), Real<N>(1.0f)).store(query.tNear);
    select(legal, far, zero).store(query.best);
    Word<N>(kNoHit).store(query.triangle);
    for (int i = 0; i < N; ++i) scale[i] = 1;

    const Mask<N> extreme =
        legal & ((largest < Real<N>(0x1p-16f)) | (largest > Real<N>(0x1p16f)));
    if (any(extreme)) {
        alignas(64) float size[N];
        largest.store(size);
        for (uint32_t rest = extreme.bits(); rest; rest &= rest - 1) {
            const int i = lowestBit(rest);
            scale[i] = inverseBinade(size[i]);
            for (int k = 0; k < 3; ++k) rays.dir[k][i] = float(dir[k][i] * scale[i]);
            query.tNear[i] = float(query.tNear[i] / scale[i]);
            query.best[i] = float(query.best[i] / scale[i]);
        }
    }
    return legal.bits();
}

} // namespace smart::SMART_ISA
