// SPDX-License-Identifier: MIT
// Arithmetic of camera rays, shaded points and the rays that leave them, for one of each. Common
// code calls it for single points, packet_math_isa.cpp in loops over the lanes of a packet, which
// become the instructions of its set: the same bits by construction.
//
// Static: each object file has to have its own, since some are compiled for machines that others
// have to run without. No function of the C library but sqrt, no branch on a lane's numbers.
#pragma once

#include <type_traits>

#include "libsmart/kernel/packet.h"

namespace smart {

struct Real3 {
    double x, y, z;
};
static inline Real3 operator+(const Real3& a, const Real3& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
static inline Real3 operator-(const Real3& a, const Real3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
static inline Real3 operator*(const Real3& a, double s) { return {a.x * s, a.y * s, a.z * s}; }
static inline double dot(const Real3& a, const Real3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
static inline Real3 cross(const Real3& a, const Real3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
static inline double largerOf(double a, double b) { return a > b ? a : b; }
static inline double largestCoordinate(const Real3& a) {
    return largerOf(largerOf(__builtin_fabs(a.x), __builtin_fabs(a.y)), __builtin_fabs(a.z));
}
static inline bool isFiniteNumber(float x) { return __builtin_fabsf(x) <= __FLT_MAX__; }

/// Makes the length 1 where its square is far from the ends of double's range; otherwise false,
/// and the vector holds anything.
static inline bool normalizeUsual(Real3& v) {
    const double squared = dot(v, v);
    v = v * (1.0 / __builtin_sqrt(squared));
    return squared > 0x1p-900 && squared < 0x1p900;
}

/// Length 1 of three floats; zero where there is no direction.
static inline Real3 unitOf(const Real3& direction) {
    const double length = __builtin_sqrt(dot(direction, direction)); // squares are in range
    const bool fine = length > 0.0 && length <= __DBL_MAX__;
    const double scale = 1.0 / (fine ? length : 1.0);
    return {fine ? direction.x * scale : 0.0, fine ? direction.y * scale : 0.0,
            fine ? direction.z * scale : 0.0};
}

/// The camera of OpenGL, prepared for rays; see CameraRays.
struct MatrixLens {
    double inverse[4][4]; ///< of the projection matrix; columns
    double eye[3], turning[3];
    double left, bottom, width, height;  ///< of the viewport, in pixels
    double pixelWidth, pixelHeight;      ///< 1 / width, 1 / height
    double sampleSide; ///< share of a pixel's side that a sample stands for
    bool hasEye;
    /// Whether near and far plane are seen upright: their w is the same in all pixels. Then the
    /// distances to both are these multiples of the length of `motion` (see rayThrough).
    bool upright;
    double nearScale, farScale;
};

/// A camera ray, of direction length 1, and its cone.
struct LensRay {
    float org[3], dir[3];
    float tNear, tFar;
    float coneWidth, coneSpread;
    bool made; ///< false: there is none
};

/// Side of a square of the given area, times `scale`; 0 if that is no number.
static inline float squareSide(double area, double scale) {
    const float length = float(scale * __builtin_sqrt(area));
    return isFiniteNumber(length) ? length : 0.0f;
}

/// A homogeneous point, or what a coordinate adds to one.
struct LensPoint {
    Real3 xyz;
    double w;
};
/// The near plane's point of a pixel is the sum of what its column gives and what its row adds.
static inline LensPoint lensColumn(const MatrixLens& lens, double x) {
    const double across = (2.0 * (x - lens.left) - lens.width) * lens.pixelWidth;
    const auto& m = lens.inverse;
    return {{m[3][0] - m[2][0] + across * m[0][0], m[3][1] - m[2][1] + across * m[0][1],
             m[3][2] - m[2][2] + across * m[0][2]},
            m[3][3] - m[2][3] + across * m[0][3]};
}
static inline LensPoint lensRow(const MatrixLens& lens, double y) {
    const double up = (2.0 * (y - lens.bottom) - lens.height) * lens.pixelHeight;
    const auto& m = lens.inverse;
    return {{up * m[1][0], up * m[1][1], up * m[1][2]}, up * m[1][3]};
}

/// What lies in the near or the far plane is seen, though the distances of its hits are rounded.
inline constexpr double kBeforeNear = 1.0 - 0x1p-20, kBeyondFar = 1.0 + 0x1p-20;

/// The ray through a point of the picture. Without `cones` the cone is zero.
template <bool hasEye, bool upright, bool cones>
static inline LensRay rayThrough(const MatrixLens& lens, const LensPoint& column,
                                 const LensPoint& row) {
    // Homogeneous points of this pixel: near + s * step with s from 0 (near plane) to 2 (far).
    const auto& m = lens.inverse;
    const Real3 step{m[2][0], m[2][1], m[2][2]};
    const double stepW = m[2][3];
    const Real3 near = column.xyz + row.xyz;
    const double nearW = column.w + row.w;
    const double farW = nearW + 2.0 * stepW;
    // Which way the point moves as s grows: the derivative of xyz / w, times a positive number.
    const Real3 motion = step * nearW - near * stepW;
    const double squared = dot(motion, motion), length = __builtin_sqrt(squared);
    const double shrink = 1.0 / length;
    const Real3 direction = motion * shrink;
    // A far plane at infinity, or beyond it, is no limit.
    const bool endless = !(farW * nearW > 0.0);
    LensRay ray;
    ray.coneWidth = ray.coneSpread = 0.0f;
    if constexpr (cones) {
        // A pixel's step to the side turns the ray by (w of the step) * motion's change / length,
        // of which what points along the ray drops out.
        const Real3 turning{lens.turning[0], lens.turning[1], lens.turning[2]};
        const double turn = __builtin_fabs(dot(turning, motion)) * (shrink * shrink * shrink);
        ray.coneSpread = squareSide(turn, lens.sampleSide);
    }
    Real3 origin;
    if constexpr (hasEye) {
        origin = {lens.eye[0], lens.eye[1], lens.eye[2]};
        double start, end;
        if constexpr (upright) {
            start = length * lens.nearScale;
            end = length * lens.farScale;
        } else {
            start = -length / (stepW * nearW);
            end = -length / (stepW * farW);
        }
        ray.tNear = float(start > 0.0 ? start * kBeforeNear : 0.0);
        ray.tFar = float(endless ? __builtin_inf() : end * kBeyondFar);
    } else {
        const double nearer = 1.0 / nearW;
        origin = near * nearer;
        ray.tNear = 0.0f;
        const double range = 2.0 * length / __builtin_fabs(nearW * farW);
        ray.tFar = float(endless ? __builtin_inf() : range * kBeyondFar);
        if constexpr (cones) {
            const Real3 right = (Real3{m[0][0], m[0][1], m[0][2]} - near * (m[0][3] * nearer)) * nearer;
            const Real3 above = (Real3{m[1][0], m[1][1], m[1][2]} - near * (m[1][3] * nearer)) * nearer;
            const double area = __builtin_fabs(dot(cross(right, above), motion)) * shrink *
                                (2.0 * lens.pixelWidth) * (2.0 * lens.pixelHeight);
            ray.coneWidth = squareSide(area, lens.sampleSide);
        }
    }
    ray.org[0] = float(origin.x);
    ray.org[1] = float(origin.y);
    ray.org[2] = float(origin.z);
    ray.dir[0] = float(direction.x);
    ray.dir[1] = float(direction.y);
    ray.dir[2] = float(direction.z);
    // Infinite or NaN in any of them, and so in the sum of their differences to themselves.
    const float none = (ray.org[0] - ray.org[0]) + (ray.org[1] - ray.org[1]) +
                       (ray.org[2] - ray.org[2]) + (ray.dir[0] - ray.dir[0]) +
                       (ray.dir[1] - ray.dir[1]) + (ray.dir[2] - ray.dir[2]);
    ray.made = none == 0.0f;
    return ray;
}

/// function(hasEye, upright) with the lens's own, as types.
template <class Function>
static inline auto forLens(const MatrixLens& lens, Function&& function) {
    constexpr std::true_type yes;
    constexpr std::false_type no;
    if (!lens.hasEye) return function(no, no);
    return lens.upright ? function(yes, yes) : function(yes, no);
}

/// Where a ray that leaves a surface starts: off it by its error, to the side of the direction.
static inline Real3 offSurface(const Real3& position, const Real3& normal, const Real3& incoming,
                               const Real3& outgoing, double error) {
    const double towards = dot(outgoing, normal);
    const double side = towards == 0.0 ? -dot(incoming, normal) : towards;
    return position + normal * __builtin_copysign(error, side);
}

/// A light at a point: where it is seen, and what share of its strength arrives.
struct PointLightSample {
    Real3 direction; ///< length 1
    double distance;
    double share;
};
static inline PointLightSample samplePointLight(const Real3& from, const Real3& position) {
    const Real3 towards = from - position;
    const double squared = dot(towards, towards), length = __builtin_sqrt(squared);
    return {towards * (1.0 / length), length, 1.0 / squared};
}

} // namespace smart
