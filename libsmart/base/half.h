// SPDX-License-Identifier: MIT
// Numbers of 16 bits, IEEE 754's binary16: 1 sign, 5 exponent, 10 mantissa bits.
#pragma once

#include <bit>
#include <cstdint>

namespace smart {

/// Exact. No step has a subnormal float, so that flushing those changes nothing.
inline float halfToFloat(uint16_t half) {
    const uint32_t sign = uint32_t(half & 0x8000u) << 16;
    const uint32_t exponent = (half >> 10) & 31u, mantissa = half & 0x3FFu;
    if (exponent == 0) {
        const float size = float(mantissa) * 0x1p-24f;
        return sign ? -size : size;
    }
    const uint32_t raised = exponent == 31 ? 255u : exponent + 112u;
    return std::bit_cast<float>(sign | raised << 23 | mantissa << 13);
}

/// The nearest half, of two equally near ones the even one; from 65520 on infinity.
inline uint16_t floatToHalf(float value) {
    const uint32_t bits = std::bit_cast<uint32_t>(value);
    const uint16_t sign = uint16_t(bits >> 16 & 0x8000u);
    const uint32_t size = bits & 0x7FFFFFFFu;
    if (size > 0x7F800000u) return uint16_t(sign | 0x7E00u); // NaN
    if (size >= 0x477FF000u) return uint16_t(sign | 0x7C00u);
    uint32_t exact = 0; // the half's bits, and below them `dropped` bits more
    uint32_t dropped = 13;
    if (size >= 0x38800000u) { // 2^-14: normal
        exact = size - (112u << 23);
    } else {
        const uint32_t exponent = size >> 23;
        if (exponent < 102) return sign; // below half of the smallest
        exact = (size & 0x7FFFFFu) | 0x800000u;
        dropped = 126 - exponent;
    }
    const uint32_t half = exact >> dropped, rest = exact & ((1u << dropped) - 1);
    const uint32_t middle = 1u << (dropped - 1);
    const bool up = rest > middle || (rest == middle && (half & 1u));
    return uint16_t(sign | (half + (up ? 1u : 0u)));
}

} // namespace smart
