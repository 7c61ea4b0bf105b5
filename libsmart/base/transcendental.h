// SPDX-License-Identifier: MIT
// Transcendental functions for everything that a pixel depends on: the C library chooses other
// code, hence other bits, by machine. Each is computed in double by polynomials and rounded to
// float once; the error stays below 0.51 ulp. Only +, -, *, /, sqrt and floor, each rounded as
// IEEE 754 says, provided that the compiler contracts nothing.
//
// Range reductions after Cody and Waite (1980), and Payne and Hanek (1983) for large arguments.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace smart::math {

inline constexpr double kPi = 3.14159265358979323846;

namespace detail {

template <int n>
inline double polynomial(const double (&coefficients)[n], double x) {
    double sum = coefficients[n - 1];
    for (int i = n - 2; i >= 0; --i) sum = sum * x + coefficients[i];
    return sum;
}

/// e^x for |x| < 700, relative error below 1e-15.
inline double expOf(double x) {
    constexpr double kLog2E = 1.4426950408889634074;
    constexpr double kLn2High = 0x1.62e42fefap-1, kLn2Low = 0x1.cf79abc9e3b3ap-40;
    constexpr double kTaylor[] = {1.0,
                                  1.0,
                                  1.0 / 2,
                                  1.0 / 6,
                                  1.0 / 24,
                                  1.0 / 120,
                                  1.0 / 720,
                                  1.0 / 5040,
                                  1.0 / 40320,
                                  1.0 / 362880,
                                  1.0 / 3628800,
                                  1.0 / 39916800,
                                  1.0 / 479001600};
    const double k = std::floor(x * kLog2E + 0.5);
    const double r = (x - k * kLn2High) - k * kLn2Low;
    const uint64_t power = uint64_t(int64_t(k) + 1023) << 52;
    return polynomial(kTaylor, r) * std::bit_cast<double>(power);
}

/// Natural logarithm of a positive normal number, relative error below 1e-15.
inline double logOf(double x) {
    constexpr double kLn2 = 0.69314718055994530942;
    constexpr double kOdd[] = {1.0,      1.0 / 3,  1.0 / 5,  1.0 / 7,  1.0 / 9, 1.0 / 11,
                               1.0 / 13, 1.0 / 15, 1.0 / 17, 1.0 / 19, 1.0 / 21};
    const uint64_t bits = std::bit_cast<uint64_t>(x);
    int64_t exponent = int64_t(bits >> 52) - 1023;
    double m = std::bit_cast<double>((bits & 0x000FFFFFFFFFFFFFull) | 0x3FF0000000000000ull);
    if (m > 1.41421356237309504880) { // m in [sqrt(1/2), sqrt(2)]
        m *= 0.5;
        ++exponent;
    }
    const double s = (m - 1) / (m + 1);
    return double(exponent) * kLn2 + 2 * s * polynomial(kOdd, s * s);
}

/// x = quadrant * pi/2 + the result, which lies in [-pi/4, pi/4]; x finite.
inline double reduceAngle(float x, int& quadrant) {
    if (std::fabs(x) < 100000.0f) {
        constexpr double kTwoOverPi = 0.63661977236758134308;
        constexpr double kHigh = 0x1.921fb544p0, kLow = 0x1.0b4611a626331p-34;
        const double k = std::floor(double(x) * kTwoOverPi + 0.5);
        quadrant = int(int64_t(k) & 3);
        return (double(x) - k * kHigh) - k * kLow; // k * kHigh is exact
    }
    // A quarter of 2/pi to 224 bits; the product's first bits are multiples of 4 quadrants and
    // dropped.
    constexpr uint32_t kTwoOverPi[] = {0x28be60db, 0x9391054a, 0x7f09d5f4, 0x7d4d3770,
                                       0x36d8a566, 0x4f10e410, 0x7f9458ea};
    const uint32_t bits = std::bit_cast<uint32_t>(x);
    const uint32_t mantissa = ((bits & 0x007FFFFFu) << 8) | 0x80000000u;
    const uint32_t exponent = ((bits >> 23) & 0xFFu) - 126u;
    const uint32_t word = exponent >> 5, shift = exponent & 31u;
    uint32_t high = word ? kTwoOverPi[word - 1] : 0, middle = kTwoOverPi[word],
             low = kTwoOverPi[word + 1];
    if (shift) {
        high = (high << shift) | (middle >> (32 - shift));
        middle = (middle << shift) | (low >> (32 - shift));
        low = (low << shift) | (kTwoOverPi[word + 2] >> (32 - shift));
    }
    uint64_t product = uint64_t(mantissa) * low; // ends as 2.62 fixed point
    product = uint64_t(mantissa) * middle + (product >> 32);
    product = (uint64_t(mantissa * high) << 32) + product;
    uint32_t q = uint32_t(product >> 62);
    int64_t fraction = int64_t(product & 0x3FFFFFFFFFFFFFFFull);
    if (fraction & 0x2000000000000000ll) {
        fraction -= 0x4000000000000000ll;
        ++q;
    }
    const double angle = double(fraction) * (kPi / 2 * 0x1p-62);
    quadrant = int((x < 0 ? 0u - q : q) & 3u);
    return x < 0 ? -angle : angle;
}

/// sin(r) or cos(r) of a reduced angle, by quadrant: 0 sin, 1 cos, 2 -sin, 3 -cos.
inline float sineOfQuadrant(double r, int quadrant) {
    constexpr double kSin[] = {1.0,           -1.0 / 6,         1.0 / 120,
                               -1.0 / 5040,   1.0 / 362880,     -1.0 / 39916800,
                               1.0 / 6227020800.0, -1.0 / 1307674368000.0};
    constexpr double kCos[] = {1.0,          -1.0 / 2,       1.0 / 24,
                               -1.0 / 720,   1.0 / 40320,    -1.0 / 3628800,
                               1.0 / 479001600.0, -1.0 / 87178291200.0, 1.0 / 20922789888000.0};
    const double value =
        (quadrant & 1) ? polynomial(kCos, r * r) : r * polynomial(kSin, r * r);
    return float((quadrant & 2) ? -value : value);
}

/// Arc tangent for 0 <= x <= 1, relative error below 1e-12.
inline double atanOf(double x) {
    constexpr double kOdd[] = {1.0,      -1.0 / 3, 1.0 / 5,   -1.0 / 7, 1.0 / 9,
                               -1.0 / 11, 1.0 / 13, -1.0 / 15, 1.0 / 17};
    constexpr double kTanEighth = 0.41421356237309504880; // tan(pi/8)
    double base = 0, z = x;
    if (x > 0.66817863791929891999) { // tan(3 pi/16)
        base = kPi / 4;
        z = (x - 1) / (x + 1);
    } else if (x > 0.19891236737965800691) { // tan(pi/16)
        base = kPi / 8;
        z = (x - kTanEighth) / (1 + x * kTanEighth);
    }
    return base + z * polynomial(kOdd, z * z);
}

inline double atan2Of(double y, double x) {
    const double ay = std::fabs(y), ax = std::fabs(x);
    constexpr double kInf = std::numeric_limits<double>::infinity();
    double angle = 0; // in the first quadrant
    if (ax == kInf && ay == kInf) angle = kPi / 4;
    else if (ay > ax) angle = kPi / 2 - atanOf(ax / ay);
    else if (ax > 0) angle = atanOf(ay / ax);
    if (std::signbit(x)) angle = kPi - angle;
    return std::signbit(y) ? -angle : angle;
}

} // namespace detail

inline float exp(float x) {
    if (x != x) return x;
    if (x > 89.0f) return std::numeric_limits<float>::infinity();
    if (x < -104.0f) return 0.0f;
    return float(detail::expOf(x));
}

inline float log(float x) {
    if (x != x || x < 0) return std::numeric_limits<float>::quiet_NaN();
    if (x == 0) return -std::numeric_limits<float>::infinity();
    if (x == std::numeric_limits<float>::infinity()) return x;
    return float(detail::logOf(x));
}

/// Special cases as in C99.
inline float pow(float x, float y) {
    constexpr float kInf = std::numeric_limits<float>::infinity();
    if (y == 0 || x == 1) return 1.0f;
    if (x != x || y != y) return std::numeric_limits<float>::quiet_NaN();
    const float size = std::fabs(x);
    const bool whole = std::floor(y) == y;
    const bool odd = whole && std::floor(y * 0.5f) != y * 0.5f;
    if (x < 0 && size != kInf && !whole) return std::numeric_limits<float>::quiet_NaN();
    float result = 0;
    if (size == 1) {
        result = 1; // also where y is infinite
    } else if (std::fabs(y) == kInf) {
        result = (size > 1) == (y > 0) ? kInf : 0.0f;
    } else if (size == 0 || size == kInf) {
        result = (size == 0) == (y > 0) ? 0.0f : kInf;
    } else {
        const double power = double(y) * detail::logOf(size);
        result = power > 89 ? kInf : power < -104 ? 0.0f : float(detail::expOf(power));
    }
    return std::signbit(x) && odd ? -result : result;
}

/// Not finite: NaN.
inline float sin(float x) {
    if (!(std::fabs(x) <= std::numeric_limits<float>::max()))
        return std::numeric_limits<float>::quiet_NaN();
    if (x == 0) return x;
    int quadrant = 0;
    const double r = detail::reduceAngle(x, quadrant);
    return detail::sineOfQuadrant(r, quadrant);
}

/// Not finite: NaN.
inline float cos(float x) {
    if (!(std::fabs(x) <= std::numeric_limits<float>::max()))
        return std::numeric_limits<float>::quiet_NaN();
    int quadrant = 0;
    const double r = detail::reduceAngle(x, quadrant);
    return detail::sineOfQuadrant(r, quadrant + 1);
}

/// Signs of zeros and infinities as in C99.
inline float atan2(float y, float x) {
    if (x != x || y != y) return std::numeric_limits<float>::quiet_NaN();
    return float(detail::atan2Of(y, x));
}

/// Outside [-1, 1]: NaN.
inline float asin(float x) {
    if (!(std::fabs(x) <= 1)) return std::numeric_limits<float>::quiet_NaN();
    const double d = x;
    return float(detail::atan2Of(d, std::sqrt((1 - d) * (1 + d))));
}

/// sRGB's transfer function (IEC 61966-2-1), linear to encoded; values outside [0, 1] go on as
/// their formula does, negative ones along the straight part.
inline float encodeSrgb(float linear) {
    if (!(linear > 0.0031308f)) return linear * 12.92f;
    if (linear == std::numeric_limits<float>::infinity()) return linear;
    return float(1.055 * detail::expOf(detail::logOf(linear) / 2.4) - 0.055);
}

inline float decodeSrgb(float encoded) {
    if (!(encoded > 0.04045f)) return float(double(encoded) / 12.92);
    if (encoded == std::numeric_limits<float>::infinity()) return encoded;
    const double power = 2.4 * detail::logOf((double(encoded) + 0.055) / 1.055);
    return power > 89 ? std::numeric_limits<float>::infinity() : float(detail::expOf(power));
}

} // namespace smart::math
