// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace smart {

/// Four floats in one register, by the vector extension of GCC and Clang.
typedef float Float4 __attribute__((vector_size(16)));
typedef int32_t Int4 __attribute__((vector_size(16)));

/// The second where one is no number.
inline Float4 lesserOf(Float4 a, Float4 b) { return a < b ? a : b; }
inline Float4 greaterOf(Float4 a, Float4 b) { return a > b ? a : b; }
inline Float4 allOf(float x) { return Float4{x, x, x, x}; }
/// Rounded towards zero.
inline Int4 toIntegers(Float4 x) { return __builtin_convertvector(x, Int4); }

} // namespace smart
