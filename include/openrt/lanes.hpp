// SPDX-License-Identifier: MIT
// Numbers of the sixteen lanes of a packet, and which of the lanes. Every operation does in each
// lane exactly what the same operation does with one float, so that a shader written as a template
// gives the same bits for a packet as for a point. The loops become SIMD instructions of whatever
// set the shader is compiled for.
//
// The functions below for float and bool let such a shader say `select` and `any` for one point.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>

#include "openrt/rts_packet.h"

namespace openrt {

inline constexpr int kLanes = RTS_PACKET_SIZE;

/// Which lanes: bit i for lane i.
struct Mask {
    RTuint bits = 0;

    constexpr Mask() = default;
    constexpr explicit Mask(RTuint b) : bits(b) {}
    constexpr bool operator[](int lane) const { return (bits >> lane & 1u) != 0; }
    constexpr bool operator==(const Mask&) const = default;
};

namespace detail {
/// 1 << i: with the bits in a table the loops over lanes below become SIMD code.
inline constexpr RTuint kLaneBit[kLanes] = {1u << 0,  1u << 1,  1u << 2,  1u << 3,
                                            1u << 4,  1u << 5,  1u << 6,  1u << 7,
                                            1u << 8,  1u << 9,  1u << 10, 1u << 11,
                                            1u << 12, 1u << 13, 1u << 14, 1u << 15};
} // namespace detail

constexpr Mask operator&(const Mask& a, const Mask& b) { return Mask(a.bits & b.bits); }
constexpr Mask operator|(const Mask& a, const Mask& b) { return Mask(a.bits | b.bits); }
constexpr Mask& operator&=(Mask& a, const Mask& b) { return a = a & b; }
constexpr Mask& operator|=(Mask& a, const Mask& b) { return a = a | b; }
constexpr Mask operator!(const Mask& a) { return Mask(~a.bits & ((1u << kLanes) - 1u)); }
constexpr bool any(const Mask& mask) { return mask.bits != 0; }
constexpr bool any(bool condition) { return condition; }

/// A number in each lane. A plain number stands for the same one in all lanes.
struct Floats : RTSfloats {
    Floats() : RTSfloats{} {}
    Floats(float value) { // NOLINT: numbers mix with lanes
        for (float& l : lane) l = value;
    }
    explicit Floats(const float* values) {
        for (int i = 0; i < kLanes; ++i) lane[i] = values[i];
    }
    Floats(const RTSfloats& values) : RTSfloats(values) {} // NOLINT: the same thing
    float operator[](int i) const { return lane[i]; }
    float& operator[](int i) { return lane[i]; }
};

/// function(value of a lane ...) for every lane.
template <class Function, std::same_as<Floats>... Values>
inline Floats forEachLane(Function&& function, const Values&... values) {
    Floats result;
    for (int i = 0; i < kLanes; ++i) result.lane[i] = function(values.lane[i]...);
    return result;
}

inline Floats operator+(const Floats& a, const Floats& b) {
    return forEachLane([](float x, float y) { return x + y; }, a, b);
}
inline Floats operator-(const Floats& a, const Floats& b) {
    return forEachLane([](float x, float y) { return x - y; }, a, b);
}
inline Floats operator*(const Floats& a, const Floats& b) {
    return forEachLane([](float x, float y) { return x * y; }, a, b);
}
inline Floats operator/(const Floats& a, const Floats& b) {
    return forEachLane([](float x, float y) { return x / y; }, a, b);
}
inline Floats operator-(const Floats& a) {
    return forEachLane([](float x) { return -x; }, a);
}
inline Floats& operator+=(Floats& a, const Floats& b) { return a = a + b; }
inline Floats& operator-=(Floats& a, const Floats& b) { return a = a - b; }
inline Floats& operator*=(Floats& a, const Floats& b) { return a = a * b; }
inline Floats& operator/=(Floats& a, const Floats& b) { return a = a / b; }

namespace detail {
#if defined(__GNUC__)
// Compilers make branches of conditions on lanes where they unroll a loop before they look for
// SIMD code. So these are vectors from the start, as wide as the registers.
#if defined(__AVX512F__)
inline constexpr int kWide = 16;
#elif defined(__AVX2__)
inline constexpr int kWide = 8;
#else
inline constexpr int kWide = 4;
#endif
typedef float WideFloats __attribute__((vector_size(4 * kWide), may_alias, aligned(4)));
typedef int WideInts __attribute__((vector_size(4 * kWide), may_alias, aligned(4)));

inline WideFloats wideAt(const RTSfloats& values, int lane) {
    return *reinterpret_cast<const WideFloats*>(values.lane + lane);
}
inline WideInts wideBitsAt(int lane) {
    return *reinterpret_cast<const WideInts*>(kLaneBit + lane);
}
#endif
} // namespace detail

/// Lanes where condition(a, b) holds.
template <class Condition>
inline Mask compare(const Floats& a, const Floats& b, Condition&& condition) {
    RTuint bits = 0;
#if defined(__GNUC__)
    detail::WideInts some = {};
    for (int i = 0; i < kLanes; i += detail::kWide)
        some |= condition(detail::wideAt(a, i), detail::wideAt(b, i)) & detail::wideBitsAt(i);
    for (int k = 0; k < detail::kWide; ++k) bits |= RTuint(some[k]);
#else
    for (int i = 0; i < kLanes; ++i)
        bits |= condition(a.lane[i], b.lane[i]) ? detail::kLaneBit[i] : 0u;
#endif
    return Mask(bits);
}
inline Mask operator<(const Floats& a, const Floats& b) {
    return compare(a, b, [](auto x, auto y) { return x < y; });
}
inline Mask operator>(const Floats& a, const Floats& b) { return b < a; }
inline Mask operator<=(const Floats& a, const Floats& b) {
    return compare(a, b, [](auto x, auto y) { return x <= y; });
}
inline Mask operator>=(const Floats& a, const Floats& b) { return b <= a; }
inline Mask operator==(const Floats& a, const Floats& b) {
    return compare(a, b, [](auto x, auto y) { return x == y; });
}
inline Mask operator!=(const Floats& a, const Floats& b) { return !(a == b); }

/// `yes` in the lanes of the mask, `no` in the others.
inline Floats select(const Mask& mask, const Floats& yes, const Floats& no) {
    Floats result;
#if defined(__GNUC__)
    const detail::WideInts bits = int(mask.bits) - detail::WideInts{};
    for (int i = 0; i < kLanes; i += detail::kWide) {
        const detail::WideInts chosen = (bits & detail::wideBitsAt(i)) != 0;
        const auto y = reinterpret_cast<detail::WideInts>(detail::wideAt(yes, i)),
                   n = reinterpret_cast<detail::WideInts>(detail::wideAt(no, i));
        *reinterpret_cast<detail::WideInts*>(result.lane + i) = (y & chosen) | (n & ~chosen);
    }
#else
    for (int i = 0; i < kLanes; ++i) {
        const float y = yes.lane[i], n = no.lane[i]; // both are read: no branch
        result.lane[i] = (mask.bits & detail::kLaneBit[i]) != 0 ? y : n;
    }
#endif
    return result;
}
constexpr float select(bool condition, float yes, float no) { return condition ? yes : no; }

inline Floats sqrt(const Floats& a) {
    return forEachLane([](float x) { return std::sqrt(x); }, a);
}
inline Floats floor(const Floats& a) {
    return forEachLane([](float x) { return std::floor(x); }, a);
}
inline Floats abs(const Floats& a) {
    return forEachLane([](float x) { return std::fabs(x); }, a);
}
using std::abs;
using std::floor;
using std::sqrt;

/// As std::min and std::max.
inline Floats min(const Floats& a, const Floats& b) {
    return forEachLane([](float x, float y) { return y < x ? y : x; }, a, b);
}
inline Floats max(const Floats& a, const Floats& b) {
    return forEachLane([](float x, float y) { return x < y ? y : x; }, a, b);
}
using std::max;
using std::min;

} // namespace openrt
