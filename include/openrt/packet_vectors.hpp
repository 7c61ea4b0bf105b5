// SPDX-License-Identifier: MIT
// Vectors and colours of the lanes of a packet. Plain ones convert to them: the same in all lanes.
// Each operation is that of vectors.hpp, lane by lane and to the bit.
#pragma once

#include "openrt/lanes.hpp"
#include "openrt/vectors.hpp"

namespace openrt {

struct PacketVec2 {
    Floats x, y;

    PacketVec2() = default;
    PacketVec2(const Floats& x_, const Floats& y_) : x(x_), y(y_) {}
    PacketVec2(const Vec2& v) : x(v.x), y(v.y) {} // NOLINT: the same in all lanes
    Vec2 operator[](int lane) const { return {x[lane], y[lane]}; }
};

struct PacketVec3 {
    Floats x, y, z;

    PacketVec3() = default;
    PacketVec3(const Floats& x_, const Floats& y_, const Floats& z_) : x(x_), y(y_), z(z_) {}
    PacketVec3(const Vec3& v) : x(v.x), y(v.y), z(v.z) {} // NOLINT: the same in all lanes
    explicit PacketVec3(const RTSvectors& v) : x(v.x), y(v.y), z(v.z) {}
    Vec3 operator[](int lane) const { return {x[lane], y[lane], z[lane]}; }
};

struct PacketVec4 {
    Floats x, y, z, w;

    PacketVec4() = default;
    PacketVec4(const Floats& x_, const Floats& y_, const Floats& z_, const Floats& w_)
        : x(x_), y(y_), z(z_), w(w_) {}
    PacketVec4(const Vec4& v) : x(v.x), y(v.y), z(v.z), w(v.w) {} // NOLINT: as above
    explicit PacketVec4(const RTSfloats (&v)[4]) : x(v[0]), y(v[1]), z(v[2]), w(v[3]) {}
    Vec4 operator[](int lane) const { return {x[lane], y[lane], z[lane], w[lane]}; }
};

struct PacketColor {
    Floats r, g, b;

    PacketColor() = default;
    explicit PacketColor(const Floats& gray) : r(gray), g(gray), b(gray) {}
    PacketColor(const Floats& r_, const Floats& g_, const Floats& b_) : r(r_), g(g_), b(b_) {}
    PacketColor(const Color& c) : r(c.r), g(c.g), b(c.b) {} // NOLINT: the same in all lanes
    explicit PacketColor(const RTScolors& c) : r(c.r), g(c.g), b(c.b) {}
    Color operator[](int lane) const { return {r[lane], g[lane], b[lane]}; }
    Mask black() const { return (r == 0.0f) & (g == 0.0f) & (b == 0.0f); }
    Floats largest() const {
        const Floats rg = select(r > g, r, g);
        return select(rg > b, rg, b);
    }
};

inline PacketVec2 operator+(const PacketVec2& a, const PacketVec2& b) {
    return {a.x + b.x, a.y + b.y};
}
inline PacketVec2 operator-(const PacketVec2& a, const PacketVec2& b) {
    return {a.x - b.x, a.y - b.y};
}
inline PacketVec2 operator*(const PacketVec2& a, const Floats& s) { return {a.x * s, a.y * s}; }
inline PacketVec2 operator*(const Floats& s, const PacketVec2& a) { return a * s; }

inline PacketVec3 operator+(const PacketVec3& a, const PacketVec3& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline PacketVec3 operator-(const PacketVec3& a, const PacketVec3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline PacketVec3 operator-(const PacketVec3& a) { return {-a.x, -a.y, -a.z}; }
inline PacketVec3 operator*(const PacketVec3& a, const Floats& s) {
    return {a.x * s, a.y * s, a.z * s};
}
inline PacketVec3 operator*(const Floats& s, const PacketVec3& a) { return a * s; }
inline PacketVec3 operator/(const PacketVec3& a, const Floats& s) {
    return {a.x / s, a.y / s, a.z / s};
}
inline PacketVec3& operator+=(PacketVec3& a, const PacketVec3& b) { return a = a + b; }
inline PacketVec3& operator-=(PacketVec3& a, const PacketVec3& b) { return a = a - b; }
inline PacketVec3& operator*=(PacketVec3& a, const Floats& s) { return a = a * s; }

inline PacketVec4 operator+(const PacketVec4& a, const PacketVec4& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w};
}
inline PacketVec4 operator-(const PacketVec4& a, const PacketVec4& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z, a.w - b.w};
}
inline PacketVec4 operator*(const PacketVec4& a, const Floats& s) {
    return {a.x * s, a.y * s, a.z * s, a.w * s};
}
inline PacketVec4 operator*(const Floats& s, const PacketVec4& a) { return a * s; }

inline PacketColor operator+(const PacketColor& a, const PacketColor& b) {
    return {a.r + b.r, a.g + b.g, a.b + b.b};
}
inline PacketColor operator-(const PacketColor& a, const PacketColor& b) {
    return {a.r - b.r, a.g - b.g, a.b - b.b};
}
inline PacketColor operator*(const PacketColor& a, const PacketColor& b) {
    return {a.r * b.r, a.g * b.g, a.b * b.b};
}
inline PacketColor operator*(const PacketColor& a, const Floats& s) {
    return {a.r * s, a.g * s, a.b * s};
}
inline PacketColor operator*(const Floats& s, const PacketColor& a) { return a * s; }
inline PacketColor operator/(const PacketColor& a, const Floats& s) {
    return {a.r / s, a.g / s, a.b / s};
}
inline PacketColor& operator+=(PacketColor& a, const PacketColor& b) { return a = a + b; }
inline PacketColor& operator*=(PacketColor& a, const PacketColor& b) { return a = a * b; }
inline PacketColor& operator*=(PacketColor& a, const Floats& s) { return a = a * s; }

inline Floats dot(const PacketVec2& a, const PacketVec2& b) { return a.x * b.x + a.y * b.y; }
inline Floats dot(const PacketVec3& a, const PacketVec3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Floats dot(const PacketVec4& a, const PacketVec4& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;
}
inline PacketVec3 cross(const PacketVec3& a, const PacketVec3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Floats length(const PacketVec3& a) {
    return forEachLane([](float x, float y, float z) { return length(Vec3(x, y, z)); }, a.x, a.y,
                       a.z);
}
/// Length 1 at any scale; zero vectors stay zero.
inline PacketVec3 normalize(const PacketVec3& a) {
    PacketVec3 result;
    for (int i = 0; i < kLanes; ++i) {
        const double x = a.x[i], y = a.y[i], z = a.z[i];
        const double squared = x * x + y * y + z * z;
        const double scale = squared > 0 ? 1 / std::sqrt(squared) : 1.0;
        result.x[i] = float(x * scale);
        result.y[i] = float(y * scale);
        result.z[i] = float(z * scale);
    }
    return result;
}
/// Mirror images of incoming directions at a surface with normals of length 1.
inline PacketVec3 reflect(const PacketVec3& incoming, const PacketVec3& normal) {
    return incoming - normal * (2.0f * dot(incoming, normal));
}

inline PacketVec2 select(const Mask& mask, const PacketVec2& yes, const PacketVec2& no) {
    return {select(mask, yes.x, no.x), select(mask, yes.y, no.y)};
}
inline PacketVec3 select(const Mask& mask, const PacketVec3& yes, const PacketVec3& no) {
    return {select(mask, yes.x, no.x), select(mask, yes.y, no.y), select(mask, yes.z, no.z)};
}
inline PacketVec4 select(const Mask& mask, const PacketVec4& yes, const PacketVec4& no) {
    return {select(mask, yes.x, no.x), select(mask, yes.y, no.y), select(mask, yes.z, no.z),
            select(mask, yes.w, no.w)};
}
inline PacketColor select(const Mask& mask, const PacketColor& yes, const PacketColor& no) {
    return {select(mask, yes.r, no.r), select(mask, yes.g, no.g), select(mask, yes.b, no.b)};
}
constexpr Vec2 select(bool condition, const Vec2& yes, const Vec2& no) {
    return condition ? yes : no;
}
constexpr Vec3 select(bool condition, const Vec3& yes, const Vec3& no) {
    return condition ? yes : no;
}
constexpr Vec4 select(bool condition, const Vec4& yes, const Vec4& no) {
    return condition ? yes : no;
}
constexpr Color select(bool condition, const Color& yes, const Color& no) {
    return condition ? yes : no;
}

} // namespace openrt
