// SPDX-License-Identifier: MIT
// Compiled once for each instruction set, into namespace smart::SMART_ISA. Loops over lanes whose
// bodies have neither calls nor branches: compilers make vector instructions of them.
#include "libsmart/kernel/packet_math.h"

namespace smart::SMART_ISA {

extern const PacketMath kPacketMath;

namespace {

constexpr int N = kPacketSize;

constexpr uint32_t kLaneBit[N] = {1u << 0,  1u << 1,  1u << 2,  1u << 3, 1u << 4,  1u << 5,
                                  1u << 6,  1u << 7,  1u << 8,  1u << 9, 1u << 10, 1u << 11,
                                  1u << 12, 1u << 13, 1u << 14, 1u << 15};

Real3 widened(const float (&x)[N], const float (&y)[N], const float (&z)[N], int i) {
    return {double(x[i]), double(y[i]), double(z[i])};
}
Real3 widened(const RTSvectors& v, int i) { return widened(v.x.lane, v.y.lane, v.z.lane, i); }

template <bool hasEye, bool upright>
uint32_t raysThrough(const MatrixLens& lens, const double* __restrict x, const double* __restrict y,
                     RayPacket& __restrict rays, float* __restrict coneWidth,
                     float* __restrict coneSpread) {
    uint32_t made = 0;
    for (int i = 0; i < N; ++i) {
        const LensRay ray = rayThrough<hasEye, upright>(lens, x[i], y[i]);
        rays.org[0][i] = ray.org[0];
        rays.org[1][i] = ray.org[1];
        rays.org[2][i] = ray.org[2];
        rays.dir[0][i] = ray.dir[0];
        rays.dir[1][i] = ray.dir[1];
        rays.dir[2][i] = ray.dir[2];
        rays.tNear[i] = ray.tNear;
        rays.tFar[i] = ray.tFar;
        coneWidth[i] = ray.coneWidth;
        coneSpread[i] = ray.coneSpread;
        made |= ray.made ? kLaneBit[i] : 0u;
    }
    return made;
}

uint32_t cameraRays(const MatrixLens& lens, const double* x, const double* y, RayPacket& rays,
                    float* coneWidth, float* coneSpread) {
    return forLens(lens, [&](auto hasEye, auto upright) {
        return raysThrough<hasEye.value, upright.value>(lens, x, y, rays, coneWidth, coneSpread);
    });
}

/// Values of the vertices of sixteen triangles.
template <int kFloats>
struct CornerLanes {
    alignas(64) float at[3][kFloats][N];
};
using Weights = double[3][N];

void gatherCorners(const Triangle* triangles, const uint32_t (&number)[N], CornerLanes<3>& to) {
    for (int i = 0; i < N; ++i) {
        const Triangle& triangle = triangles[number[i]];
        for (int k = 0; k < 3; ++k) {
            to.at[0][k][i] = triangle.v0[k];
            to.at[1][k][i] = triangle.v1[k];
            to.at[2][k][i] = triangle.v2[k];
        }
    }
}

/// Gathers values of vertices, what is inherited included.
void gatherValues(const VertexValues& from, const VertexLanes& vertices, CornerLanes<4>& to) {
    for (int i = 0; i < N; ++i)
        for (int corner = 0; corner < 3; ++corner) {
            const uint32_t vertex = vertices[corner][i];
            const float* value = vertex < from.first
                                     ? from.inherited
                                     : from.values + uint64_t(4) * (vertex - from.first);
            for (int k = 0; k < 4; ++k) to.at[corner][k][i] = value[k];
        }
}

/// Gathers normals; returns the lanes with three of them, and in `some` those with one or two.
uint32_t gatherNormals(const VertexValues& from, const VertexLanes& vertices, CornerLanes<3>& to,
                       uint32_t& some) {
    uint32_t all = 0;
    for (int i = 0; i < N; ++i) {
        int found = 0;
        for (int corner = 0; corner < 3; ++corner) {
            const uint32_t vertex = vertices[corner][i];
            const bool given = vertex >= from.first;
            const float* value = from.values + uint64_t(3) * (given ? vertex - from.first : 0);
            for (int k = 0; k < 3; ++k) to.at[corner][k][i] = value[k];
            found += given;
        }
        if (found == 3) all |= kLaneBit[i];
        if (found == 1 || found == 2) some |= kLaneBit[i];
    }
    return all;
}

/// See weightsOf for a single point.
void findWeights(const HitPacket& hits, Weights& w) {
    uint32_t over = 0;
    for (int i = 0; i < N; ++i) {
        const double u = hits.u[i], v = hits.v[i], sum = u + v;
        w[0][i] = 1.0 - sum;
        w[1][i] = u;
        w[2][i] = v;
        over |= sum > 1.0 ? kLaneBit[i] : 0u;
    }
    for (; over != 0; over &= over - 1) {
        const int i = __builtin_ctz(over);
        const double sum = w[1][i] + w[2][i];
        w[0][i] = 0.0;
        w[1][i] /= sum;
        w[2][i] /= sum;
    }
}

Real3 cornerOf(const CornerLanes<3>& from, int corner, int i) {
    return widened(from.at[corner][0], from.at[corner][1], from.at[corner][2], i);
}

/// An affine matrix in columns.
struct Matrix {
    Real3 x, y, z, offset;

    explicit Matrix(const double* m)
        : x{m[0], m[1], m[2]},
          y{m[3], m[4], m[5]},
          z{m[6], m[7], m[8]},
          offset{m[9], m[10], m[11]} {}
    Real3 turned(const Real3& v) const { return x * v.x + y * v.y + z * v.z; }
    Real3 placed(const Real3& v) const { return turned(v) + offset; }
};

/// Rays, positions, geometric normals and sides; returns the lanes whose numbers are usual.
uint32_t placePoints(const Matrix& m, const CornerLanes<3>& corners, const Weights& w,
                     const RayPacket& rays, const HitPacket& hits, RTSpacket& __restrict p,
                     double* __restrict area) {
    uint32_t usual = 0, front = 0;
    for (int i = 0; i < N; ++i) {
        Real3 direction = widened(rays.dir[0], rays.dir[1], rays.dir[2], i);
        const double length = __builtin_sqrt(dot(direction, direction));
        const bool fineDirection = normalizeUsual(direction);
        p.rayOrigin.x.lane[i] = rays.org[0][i];
        p.rayOrigin.y.lane[i] = rays.org[1][i];
        p.rayOrigin.z.lane[i] = rays.org[2][i];
        p.rayDirection.x.lane[i] = float(direction.x);
        p.rayDirection.y.lane[i] = float(direction.y);
        p.rayDirection.z.lane[i] = float(direction.z);
        p.rayDistance.lane[i] = float(double(hits.t[i]) * length);
        const Real3 a = cornerOf(corners, 0, i), b = cornerOf(corners, 1, i),
                    c = cornerOf(corners, 2, i);
        const Real3 position =
            m.placed(a) * w[0][i] + m.placed(b) * w[1][i] + m.placed(c) * w[2][i];
        p.position.x.lane[i] = float(position.x);
        p.position.y.lane[i] = float(position.y);
        p.position.z.lane[i] = float(position.z);
        Real3 normal = cross(m.turned(b - a), m.turned(c - a));
        area[i] = dot(normal, normal);
        const bool fineNormal = normalizeUsual(normal);
        p.geometricNormal.x.lane[i] = float(normal.x);
        p.geometricNormal.y.lane[i] = float(normal.y);
        p.geometricNormal.z.lane[i] = float(normal.z);
        p.barycentric[0].lane[i] = float(w[0][i]);
        p.barycentric[1].lane[i] = float(w[1][i]);
        p.barycentric[2].lane[i] = float(w[2][i]);
        front |= dot(direction, normal) > 0.0 ? 0u : kLaneBit[i];
        usual |= fineDirection & fineNormal ? kLaneBit[i] : 0u;
    }
    p.frontFace = front;
    return usual;
}

/// surfaceError for points of an instance of the scene.
void findErrors(const Matrix& m, const CornerLanes<3>& corners, const HitPacket& hits,
                const RTSpacket& p, float* __restrict error) {
    constexpr double kUnit = 0x1p-23;
    const auto sum = [](double x, double y, double z) {
        return __builtin_fabs(x) + __builtin_fabs(y) + __builtin_fabs(z);
    };
    const double rows = largerOf(largerOf(sum(m.x.x, m.y.x, m.z.x), sum(m.x.y, m.y.y, m.z.y)),
                                 sum(m.x.z, m.y.z, m.z.z));
    for (int i = 0; i < N; ++i) {
        const Real3 a = cornerOf(corners, 0, i), b = cornerOf(corners, 1, i),
                    c = cornerOf(corners, 2, i);
        const Real3 point = a + (b - a) * double(hits.u[i]) + (c - a) * double(hits.v[i]);
        const double lost =
            largestCoordinate(widened(p.position, i)) + rows * largestCoordinate(point);
        const double far = largerOf(largerOf(largestCoordinate(a), largestCoordinate(b)),
                                    largestCoordinate(c));
        error[i] = float(4.0 * kUnit * lost + 0x1p-48 * rows * far);
    }
}

/// Shading normals of vertices; returns the lanes whose numbers are usual.
uint32_t interpolateNormals(const Matrix& m, const CornerLanes<3>& normals, const Weights& w,
                            RTSpacket& __restrict p) {
    const Real3 x = cross(m.y, m.z), y = cross(m.z, m.x), z = cross(m.x, m.y);
    const double shrink = 1.0 / dot(m.x, x);
    uint32_t usual = 0;
    for (int i = 0; i < N; ++i) {
        const Real3 sum = cornerOf(normals, 0, i) * w[0][i] + cornerOf(normals, 1, i) * w[1][i] +
                          cornerOf(normals, 2, i) * w[2][i];
        Real3 normal = (x * sum.x + y * sum.y + z * sum.z) * shrink;
        p.rawNormal.x.lane[i] = float(normal.x);
        p.rawNormal.y.lane[i] = float(normal.y);
        p.rawNormal.z.lane[i] = float(normal.z);
        const bool fine = normalizeUsual(normal);
        p.shadingNormal.x.lane[i] = float(normal.x);
        p.shadingNormal.y.lane[i] = float(normal.y);
        p.shadingNormal.z.lane[i] = float(normal.z);
        usual |= fine ? kLaneBit[i] : 0u;
    }
    return usual;
}

/// The geometric normals, where no vertex has one.
void takeGeometric(uint32_t lanes, RTSpacket& p) {
    for (; lanes != 0; lanes &= lanes - 1) {
        const int i = __builtin_ctz(lanes);
        p.rawNormal.x.lane[i] = p.shadingNormal.x.lane[i] = p.geometricNormal.x.lane[i];
        p.rawNormal.y.lane[i] = p.shadingNormal.y.lane[i] = p.geometricNormal.y.lane[i];
        p.rawNormal.z.lane[i] = p.shadingNormal.z.lane[i] = p.geometricNormal.z.lane[i];
    }
}

/// Returns the lanes, among the given ones, that have what they need.
uint32_t findShadingNormals(const SurfaceView& view, const VertexLanes& vertices, const Matrix& m,
                            const Weights& w, uint32_t lanes, RTSpacket& p) {
    if (!view.normals.values) {
        p.rawNormal = p.shadingNormal = p.geometricNormal;
        return lanes;
    }
    CornerLanes<3> normals;
    uint32_t some = 0;
    const uint32_t all = gatherNormals(view.normals, vertices, normals, some) & lanes;
    uint32_t fine = lanes & ~some;
    if (all) fine &= interpolateNormals(m, normals, w, p) | ~all;
    takeGeometric(lanes & ~(all | some), p);
    return fine;
}

void interpolate(const CornerLanes<4>& from, const Weights& w, RTSfloats (&to)[4]) {
    for (int k = 0; k < 4; ++k)
        for (int i = 0; i < N; ++i)
            to[k].lane[i] = float(w[0][i] * double(from.at[0][k][i]) +
                                  w[1][i] * double(from.at[1][k][i]) +
                                  w[2][i] * double(from.at[2][k][i]));
}
/// What all corners have is what interpolation gives: the weights' sum is off by less than 2^-50,
/// too little for another float.
void spread(const float* same, RTSfloats (&to)[4]) {
    for (int k = 0; k < 4; ++k)
        for (int i = 0; i < N; ++i) to[k].lane[i] = same[k];
}

/// Texture coordinates per unit of length; area: square of twice the triangles' areas.
void findDensities(const CornerLanes<4>& from, const double* area, RTSfloats& to) {
    for (int i = 0; i < N; ++i) {
        const double s1 = double(from.at[1][0][i]) - double(from.at[0][0][i]);
        const double t1 = double(from.at[1][1][i]) - double(from.at[0][1][i]);
        const double s2 = double(from.at[2][0][i]) - double(from.at[0][0][i]);
        const double t2 = double(from.at[2][1][i]) - double(from.at[0][1][i]);
        const double ratio = __builtin_fabs(s1 * t2 - s2 * t1) / __builtin_sqrt(area[i]);
        to.lane[i] = squareSide(ratio, 1.0);
    }
}

void findAttributes(const SurfaceView& view, const VertexLanes& vertices, const Weights& w,
                    const double* area, RTSpacket& p) {
    CornerLanes<4> values;
    if (view.texCoords.values) {
        gatherValues(view.texCoords, vertices, values);
        interpolate(values, w, p.texCoord);
        findDensities(values, area, p.texCoordDensity);
    } else {
        spread(view.texCoords.inherited, p.texCoord);
        p.texCoordDensity = {};
    }
    if (view.colors.values) {
        gatherValues(view.colors, vertices, values);
        interpolate(values, w, p.color);
    } else {
        spread(view.colors.inherited, p.color);
    }
}

uint32_t surfacePoints(const SurfaceView& view, const VertexLanes& vertices, const RayPacket& rays,
                       const HitPacket& hits, uint32_t lanes, RTSpacket& p, float* error) {
    uint32_t number[N]; // lanes that do not count take a triangle that exists
    const uint32_t some = hits.triangle[__builtin_ctz(lanes)];
    for (int i = 0; i < N; ++i) number[i] = (lanes & kLaneBit[i]) != 0 ? hits.triangle[i] : some;
    CornerLanes<3> corners;
    gatherCorners(view.triangles, number, corners);
    alignas(64) Weights w;
    alignas(64) double area[N];
    findWeights(hits, w);
    const Matrix m(view.toWorld);
    uint32_t fine = placePoints(m, corners, w, rays, hits, p, area) & lanes;
    if (view.oneLevel)
        findErrors(m, corners, hits, p, error);
    else
        for (int i = 0; i < N; ++i) error[i] = -1.0f;
    fine &= findShadingNormals(view, vertices, m, w, lanes, p);
    findAttributes(view, vertices, w, area, p);
    for (int i = 0; i < N; ++i) {
        p.object.lane[i] = view.object;
        p.instance.lane[i] = view.instance;
        p.primitive.lane[i] = number[i];
    }
    return lanes & ~fine;
}

template <bool onSurface>
void spawnRays(const RTSpacket& p, const float* error, const RTSvectors& origin,
               const RTSvectors& direction, RayPacket& __restrict rays) {
    for (int i = 0; i < N; ++i) {
        const Real3 unit = unitOf(widened(direction, i));
        rays.dir[0][i] = float(unit.x);
        rays.dir[1][i] = float(unit.y);
        rays.dir[2][i] = float(unit.z);
        rays.tNear[i] = 0.0f;
        rays.tFar[i] = __builtin_inff();
        float x = origin.x.lane[i], y = origin.y.lane[i], z = origin.z.lane[i];
        if constexpr (onSurface) {
            const Real3 outgoing{double(rays.dir[0][i]), double(rays.dir[1][i]),
                                 double(rays.dir[2][i])};
            const Real3 moved =
                offSurface(widened(p.position, i), widened(p.geometricNormal, i),
                           widened(p.rayDirection, i), outgoing, double(error[i]));
            const bool there = (x == p.position.x.lane[i]) & (y == p.position.y.lane[i]) &
                               (z == p.position.z.lane[i]);
            x = there ? float(moved.x) : x;
            y = there ? float(moved.y) : y;
            z = there ? float(moved.z) : z;
        }
        rays.org[0][i] = x;
        rays.org[1][i] = y;
        rays.org[2][i] = z;
    }
}

void spawn(const RTSpacket& p, const float* error, const RTSvectors& origin,
           const RTSvectors& direction, RayPacket& rays) {
    if (error)
        spawnRays<true>(p, error, origin, direction, rays);
    else
        spawnRays<false>(p, error, origin, direction, rays);
}

uint32_t pointLight(const float* from, const float* strength, const RTSvectors& position,
                    RTSlightpacket& __restrict to) {
    const Real3 at{double(from[0]), double(from[1]), double(from[2])};
    const double r = strength[0], g = strength[1], b = strength[2];
    uint32_t lit = 0;
    for (int i = 0; i < N; ++i) {
        const PointLightSample sample = samplePointLight(at, widened(position, i));
        const float distance = float(sample.distance);
        const float red = float(r * sample.share), green = float(g * sample.share),
                    blue = float(b * sample.share);
        to.direction.x.lane[i] = float(sample.direction.x);
        to.direction.y.lane[i] = float(sample.direction.y);
        to.direction.z.lane[i] = float(sample.direction.z);
        to.distance.lane[i] = distance;
        to.radiance.r.lane[i] = red;
        to.radiance.g.lane[i] = green;
        to.radiance.b.lane[i] = blue;
        const bool fine = (sample.distance > 0.0) & isFiniteNumber(distance) & isFiniteNumber(red) &
                          isFiniteNumber(green) & isFiniteNumber(blue);
        lit |= fine ? kLaneBit[i] : 0u;
    }
    return lit;
}

#define SMART_STRINGIZE_(x) #x
#define SMART_STRINGIZE(x) SMART_STRINGIZE_(x)

} // namespace

const PacketMath kPacketMath = {SMART_STRINGIZE(SMART_ISA), cameraRays, surfacePoints, spawn,
                                pointLight};

} // namespace smart::SMART_ISA
