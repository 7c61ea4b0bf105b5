// SPDX-License-Identifier: MIT
// Rays as given -> rays that traversal can trust.
#pragma once

#include "libsmart/kernel/search.h"

namespace smart::SMART_ISA {

inline bool isFinite(float x) { return magnitude(x) <= 0x1.fffffep127f; }

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
/// neither overflow nor lose bits. Other lanes get a harmless ray with an empty range.
template <int N, HitMode M, class Counter>
uint32_t prepareRays(const float* const org[3], const float* const dir[3], const float* tNear,
                     const float* tFar, uint32_t active, LocalRays<N>& rays,
                     Search<N, M, Counter>& query) {
    uint32_t legal = 0;
    for (int i = 0; i < N; ++i) {
        const float largest = maximum(maximum(magnitude(dir[0][i]), magnitude(dir[1][i])),
                                      magnitude(dir[2][i]));
        bool good = (active >> i & 1) && largest > 0 && tNear[i] <= tFar[i] && tFar[i] >= 0;
        for (int k = 0; k < 3; ++k) good = good && isFinite(org[k][i]) && isFinite(dir[k][i]);
        for (int k = 0; k < 3; ++k) {
            rays.org[k][i] = good ? org[k][i] : 0.0f;
            rays.dir[k][i] = good ? dir[k][i] : 1.0f;
        }
        query.tNear[i] = good ? maximum(tNear[i], 0.0f) : 1.0f;
        query.best[i] = good ? tFar[i] : 0.0f;
        query.triangle[i] = kNoHit;
        legal |= uint32_t(good) << i;
        if (good && !(largest >= 0x1p-16f && largest <= 0x1p16f)) {
            const double scale = inverseBinade(largest);
            for (int k = 0; k < 3; ++k) rays.dir[k][i] = float(dir[k][i] * scale);
            query.tNear[i] = float(query.tNear[i] / scale);
            query.best[i] = float(query.best[i] / scale);
        }
    }
    return legal;
}

} // namespace smart::SMART_ISA
