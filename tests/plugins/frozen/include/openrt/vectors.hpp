// SPDX-License-Identifier: MIT
// Plain vectors, colours and matrices of the C++ interface: floats without alignment tricks, so
// that they may be members of shader classes and parameter blocks. They convert from and to the
// GLM types of the same shape when a GLM header was included before this one.
#pragma once

#include <cmath>
#include <concepts>
#include <cstddef>

#if defined(GLM_VERSION)
#    include <glm/mat4x4.hpp>
#    include <glm/vec2.hpp>
#    include <glm/vec3.hpp>
#    include <glm/vec4.hpp>
#endif

namespace openrt {

namespace detail {

/// Length of a vector type of another library that ours convert from and to; 16: a 4x4 matrix.
template <class V>
inline constexpr int kForeignLength = 0;
#if defined(GLM_VERSION)
template <>
inline constexpr int kForeignLength<glm::vec2> = 2;
template <>
inline constexpr int kForeignLength<glm::vec3> = 3;
template <>
inline constexpr int kForeignLength<glm::vec4> = 4;
template <>
inline constexpr int kForeignLength<glm::mat4> = 16;
#endif
template <class V, int length>
concept Foreign = kForeignLength<V> == length;

} // namespace detail

struct Vec2 {
    float x = 0, y = 0;

    constexpr Vec2() = default;
    constexpr Vec2(float x_, float y_) : x(x_), y(y_) {}
    constexpr explicit Vec2(const float* v) : x(v[0]), y(v[1]) {}
    template <detail::Foreign<2> V>
    constexpr Vec2(const V& v) : x(v.x), y(v.y) {}
    template <detail::Foreign<2> V>
    constexpr operator V() const {
        return V(x, y);
    }
    constexpr bool operator==(const Vec2&) const = default;
};

struct Vec3 {
    float x = 0, y = 0, z = 0;

    constexpr Vec3() = default;
    constexpr Vec3(float x_, float y_, float z_) : x(x_), y(y_), z(z_) {}
    constexpr explicit Vec3(const float* v) : x(v[0]), y(v[1]), z(v[2]) {}
    template <detail::Foreign<3> V>
    constexpr Vec3(const V& v) : x(v.x), y(v.y), z(v.z) {}
    template <detail::Foreign<3> V>
    constexpr operator V() const {
        return V(x, y, z);
    }
    constexpr bool operator==(const Vec3&) const = default;
};

struct Vec4 {
    float x = 0, y = 0, z = 0, w = 0;

    constexpr Vec4() = default;
    constexpr Vec4(float x_, float y_, float z_, float w_) : x(x_), y(y_), z(z_), w(w_) {}
    constexpr Vec4(const Vec3& v, float w_) : x(v.x), y(v.y), z(v.z), w(w_) {}
    constexpr explicit Vec4(const float* v) : x(v[0]), y(v[1]), z(v[2]), w(v[3]) {}
    template <detail::Foreign<4> V>
    constexpr Vec4(const V& v) : x(v.x), y(v.y), z(v.z), w(v.w) {}
    template <detail::Foreign<4> V>
    constexpr operator V() const {
        return V(x, y, z, w);
    }
    constexpr bool operator==(const Vec4&) const = default;
};

/// Linear RGB.
struct Color {
    float r = 0, g = 0, b = 0;

    constexpr Color() = default;
    constexpr explicit Color(float gray) : r(gray), g(gray), b(gray) {}
    constexpr Color(float r_, float g_, float b_) : r(r_), g(g_), b(b_) {}
    constexpr explicit Color(const float* v) : r(v[0]), g(v[1]), b(v[2]) {}
    template <detail::Foreign<3> V>
    constexpr Color(const V& v) : r(v.x), g(v.y), b(v.z) {}
    template <detail::Foreign<3> V>
    constexpr operator V() const {
        return V(r, g, b);
    }
    constexpr bool operator==(const Color&) const = default;
    constexpr bool black() const { return r == 0 && g == 0 && b == 0; }
    constexpr float largest() const {
        const float rg = r > g ? r : g;
        return rg > b ? rg : b;
    }
};

/// Column-major: m[4 * column + row]; the identity at the start.
struct Mat4 {
    float m[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

    constexpr Mat4() = default;
    constexpr explicit Mat4(const float* v) {
        for (int i = 0; i < 16; ++i) m[i] = v[i];
    }
    template <detail::Foreign<16> V>
    constexpr Mat4(const V& v) {
        for (int i = 0; i < 16; ++i) m[i] = v[i / 4][i % 4];
    }
    template <detail::Foreign<16> V>
    constexpr operator V() const {
        V v;
        for (int i = 0; i < 16; ++i) v[i / 4][i % 4] = m[i];
        return v;
    }
    constexpr bool operator==(const Mat4&) const = default;
    constexpr float operator()(int row, int column) const { return m[4 * column + row]; }
};

static_assert(sizeof(Vec2) == 8 && sizeof(Vec3) == 12 && sizeof(Vec4) == 16);
static_assert(sizeof(Color) == 12 && sizeof(Mat4) == 64 && alignof(Mat4) == 4);

constexpr Vec2 operator+(const Vec2& a, const Vec2& b) { return {a.x + b.x, a.y + b.y}; }
constexpr Vec2 operator-(const Vec2& a, const Vec2& b) { return {a.x - b.x, a.y - b.y}; }
constexpr Vec2 operator*(const Vec2& a, float s) { return {a.x * s, a.y * s}; }
constexpr Vec2 operator*(float s, const Vec2& a) { return a * s; }

constexpr Vec3 operator+(const Vec3& a, const Vec3& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
constexpr Vec3 operator-(const Vec3& a, const Vec3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
constexpr Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
constexpr Vec3 operator*(const Vec3& a, float s) { return {a.x * s, a.y * s, a.z * s}; }
constexpr Vec3 operator*(float s, const Vec3& a) { return a * s; }
constexpr Vec3 operator/(const Vec3& a, float s) { return {a.x / s, a.y / s, a.z / s}; }
constexpr Vec3& operator+=(Vec3& a, const Vec3& b) { return a = a + b; }
constexpr Vec3& operator-=(Vec3& a, const Vec3& b) { return a = a - b; }
constexpr Vec3& operator*=(Vec3& a, float s) { return a = a * s; }

constexpr Vec4 operator+(const Vec4& a, const Vec4& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w};
}
constexpr Vec4 operator-(const Vec4& a, const Vec4& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z, a.w - b.w};
}
constexpr Vec4 operator*(const Vec4& a, float s) {
    return {a.x * s, a.y * s, a.z * s, a.w * s};
}
constexpr Vec4 operator*(float s, const Vec4& a) { return a * s; }

constexpr Color operator+(const Color& a, const Color& b) {
    return {a.r + b.r, a.g + b.g, a.b + b.b};
}
constexpr Color operator-(const Color& a, const Color& b) {
    return {a.r - b.r, a.g - b.g, a.b - b.b};
}
constexpr Color operator*(const Color& a, const Color& b) {
    return {a.r * b.r, a.g * b.g, a.b * b.b};
}
constexpr Color operator*(const Color& a, float s) { return {a.r * s, a.g * s, a.b * s}; }
constexpr Color operator*(float s, const Color& a) { return a * s; }
constexpr Color operator/(const Color& a, float s) { return {a.r / s, a.g / s, a.b / s}; }
constexpr Color& operator+=(Color& a, const Color& b) { return a = a + b; }
constexpr Color& operator*=(Color& a, const Color& b) { return a = a * b; }
constexpr Color& operator*=(Color& a, float s) { return a = a * s; }

constexpr Vec4 operator*(const Mat4& a, const Vec4& v) {
    const auto row = [&](int i) {
        return a(i, 0) * v.x + a(i, 1) * v.y + a(i, 2) * v.z + a(i, 3) * v.w;
    };
    return {row(0), row(1), row(2), row(3)};
}
constexpr Mat4 operator*(const Mat4& a, const Mat4& b) {
    Mat4 product;
    for (int column = 0; column < 4; ++column) {
        const Vec4 v = a * Vec4(b.m + 4 * column);
        product.m[4 * column] = v.x;
        product.m[4 * column + 1] = v.y;
        product.m[4 * column + 2] = v.z;
        product.m[4 * column + 3] = v.w;
    }
    return product;
}

constexpr float dot(const Vec2& a, const Vec2& b) { return a.x * b.x + a.y * b.y; }
constexpr float dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr float dot(const Vec4& a, const Vec4& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;
}
constexpr Vec3 cross(const Vec3& a, const Vec3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline float length(const Vec3& a) {
    const double x = a.x, y = a.y, z = a.z; // squares of floats never overflow in double
    return float(std::sqrt(x * x + y * y + z * z));
}
/// Length 1 at any scale; the zero vector stays zero.
inline Vec3 normalize(const Vec3& a) {
    const double x = a.x, y = a.y, z = a.z;
    const double squared = x * x + y * y + z * z;
    if (!(squared > 0)) return a;
    const double scale = 1 / std::sqrt(squared);
    return {float(x * scale), float(y * scale), float(z * scale)};
}
/// Mirror image of an incoming direction at a surface with a normal of length 1.
constexpr Vec3 reflect(const Vec3& incoming, const Vec3& normal) {
    return incoming - normal * (2.0f * dot(incoming, normal));
}

} // namespace openrt
