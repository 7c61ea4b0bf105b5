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

template <class Term>
void lensTerms(const double* __restrict at, uint32_t packets, LensLanes* __restrict to,
               const Term& term) {
    for (uint32_t p = 0; p < packets; ++p)
        for (int i = 0; i < N; ++i) {
            const LensPoint point = term(at[p * uint32_t(N) + uint32_t(i)]);
            to[p].x[i] = point.xyz.x;
            to[p].y[i] = point.xyz.y;
            to[p].z[i] = point.xyz.z;
            to[p].w[i] = point.w;
        }
}
void lensColumns(const MatrixLens& lens, const double* x, uint32_t packets, LensLanes* to) {
    lensTerms(x, packets, to, [&](double at) { return lensColumn(lens, at); });
}
void lensRows(const MatrixLens& lens, const double* y, uint32_t packets, LensLanes* to) {
    lensTerms(y, packets, to, [&](double at) { return lensRow(lens, at); });
}

LensPoint pointOf(const LensLanes& lanes, int i) {
    return {{lanes.x[i], lanes.y[i], lanes.z[i]}, lanes.w[i]};
}

template <bool hasEye, bool upright, bool cones>
uint32_t raysThrough(const MatrixLens& lens, const LensLanes& __restrict columns,
                     const LensLanes& __restrict rows, RayPacket& __restrict rays,
                     float* __restrict coneWidth, float* __restrict coneSpread) {
    uint32_t made = 0;
    for (int i = 0; i < N; ++i) {
        const LensRay ray =
            rayThrough<hasEye, upright, cones>(lens, pointOf(columns, i), pointOf(rows, i));
        rays.org[0][i] = ray.org[0];
        rays.org[1][i] = ray.org[1];
        rays.org[2][i] = ray.org[2];
        rays.dir[0][i] = ray.dir[0];
        rays.dir[1][i] = ray.dir[1];
        rays.dir[2][i] = ray.dir[2];
        rays.tNear[i] = ray.tNear;
        rays.tFar[i] = ray.tFar;
        if constexpr (cones) {
            coneWidth[i] = ray.coneWidth;
            coneSpread[i] = ray.coneSpread;
        }
        made |= ray.made ? kLaneBit[i] : 0u;
    }
    return made;
}

uint32_t cameraRays(const MatrixLens& lens, const LensLanes& columns, const LensLanes& rows,
                    RayPacket& rays, float* coneWidth, float* coneSpread) {
    return forLens(lens, [&](auto hasEye, auto upright) {
        constexpr bool eye = hasEye.value, straight = upright.value;
        return coneWidth ? raysThrough<eye, straight, true>(lens, columns, rows, rays, coneWidth,
                                                            coneSpread)
                         : raysThrough<eye, straight, false>(lens, columns, rows, rays, nullptr,
                                                             nullptr);
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
void findWeights(const HitPacket& hits, uint32_t lanes, Weights& w) {
    uint32_t over = 0;
    for (int i = 0; i < N; ++i) {
        const double u = hits.u[i], v = hits.v[i], sum = u + v;
        w[0][i] = 1.0 - sum;
        w[1][i] = u;
        w[2][i] = v;
        over |= sum > 1.0 ? kLaneBit[i] : 0u;
    }
    for (over &= lanes; over != 0; over &= over - 1) {
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

/// The corners of one triangle, which all lanes hit.
struct OneTriangle {
    Real3 at[3];

    explicit OneTriangle(const Triangle& t)
        : at{{t.v0[0], t.v0[1], t.v0[2]}, {t.v1[0], t.v1[1], t.v1[2]}, {t.v2[0], t.v2[1], t.v2[2]}} {
    }
};

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

struct alignas(64) DoubleLanes {
    double x[N], y[N], z[N];
};

/// Rays; returns the lanes whose directions are usual. `unit`: the directions, of length 1.
uint32_t findRays(const RayPacket& rays, const HitPacket& hits, RTSpacket& __restrict p,
                  DoubleLanes& __restrict unit) {
    uint32_t usual = 0;
    for (int i = 0; i < N; ++i) {
        Real3 direction = widened(rays.dir[0], rays.dir[1], rays.dir[2], i);
        const double length = __builtin_sqrt(dot(direction, direction));
        const bool fine = normalizeUsual(direction);
        p.rayOrigin.x.lane[i] = rays.org[0][i];
        p.rayOrigin.y.lane[i] = rays.org[1][i];
        p.rayOrigin.z.lane[i] = rays.org[2][i];
        p.rayDirection.x.lane[i] = float(direction.x);
        p.rayDirection.y.lane[i] = float(direction.y);
        p.rayDirection.z.lane[i] = float(direction.z);
        p.rayDistance.lane[i] = float(double(hits.t[i]) * length);
        unit.x[i] = direction.x;
        unit.y[i] = direction.y;
        unit.z[i] = direction.z;
        usual |= fine ? kLaneBit[i] : 0u;
    }
    return usual;
}

void storePosition(const Real3& a, const Real3& b, const Real3& c, const Weights& w, int i,
                   RTSpacket& p) {
    const Real3 position = a * w[0][i] + b * w[1][i] + c * w[2][i];
    p.position.x.lane[i] = float(position.x);
    p.position.y.lane[i] = float(position.y);
    p.position.z.lane[i] = float(position.z);
}
void findPositions(const Matrix& m, const CornerLanes<3>& corners, const Weights& w,
                   RTSpacket& __restrict p) {
    for (int i = 0; i < N; ++i)
        storePosition(m.placed(cornerOf(corners, 0, i)), m.placed(cornerOf(corners, 1, i)),
                      m.placed(cornerOf(corners, 2, i)), w, i, p);
}
void findPositions(const Matrix& m, const OneTriangle& corners, const Weights& w,
                   RTSpacket& __restrict p) {
    const Real3 a = m.placed(corners.at[0]), b = m.placed(corners.at[1]),
                c = m.placed(corners.at[2]);
    for (int i = 0; i < N; ++i) storePosition(a, b, c, w, i, p);
}

/// Of a triangle's normal in the world.
struct WorldNormal {
    Real3 unit;
    double area; ///< square of twice the triangle's area
    bool usual;

    WorldNormal(const Matrix& m, const Real3& a, const Real3& b, const Real3& c)
        : unit(cross(m.turned(b - a), m.turned(c - a))), area(dot(unit, unit)),
          usual(normalizeUsual(unit)) {}
};
bool storeNormal(const WorldNormal& normal, const DoubleLanes& ray, int i, RTSpacket& p) {
    p.geometricNormal.x.lane[i] = float(normal.unit.x);
    p.geometricNormal.y.lane[i] = float(normal.unit.y);
    p.geometricNormal.z.lane[i] = float(normal.unit.z);
    return !(dot({ray.x[i], ray.y[i], ray.z[i]}, normal.unit) > 0.0);
}
/// Geometric normals and sides; returns the lanes whose normals are usual.
uint32_t findNormals(const Matrix& m, const CornerLanes<3>& corners, const DoubleLanes& ray,
                     RTSpacket& __restrict p, double* __restrict area) {
    uint32_t usual = 0, front = 0;
    for (int i = 0; i < N; ++i) {
        const WorldNormal normal(m, cornerOf(corners, 0, i), cornerOf(corners, 1, i),
                                 cornerOf(corners, 2, i));
        area[i] = normal.area;
        front |= storeNormal(normal, ray, i, p) ? kLaneBit[i] : 0u;
        usual |= normal.usual ? kLaneBit[i] : 0u;
    }
    p.frontFace = front;
    return usual;
}
uint32_t findNormals(const Matrix& m, const OneTriangle& corners, const DoubleLanes& ray,
                     RTSpacket& __restrict p, double* __restrict area) {
    const WorldNormal normal(m, corners.at[0], corners.at[1], corners.at[2]);
    uint32_t front = 0;
    for (int i = 0; i < N; ++i) {
        area[i] = normal.area;
        front |= storeNormal(normal, ray, i, p) ? kLaneBit[i] : 0u;
    }
    p.frontFace = front;
    return normal.usual ? (1u << N) - 1u : 0u;
}

/// surfaceError for points of an instance of the scene; rows: the largest sum of a row of the
/// matrix.
double largestRow(const Matrix& m) {
    const auto sum = [](double x, double y, double z) {
        return __builtin_fabs(x) + __builtin_fabs(y) + __builtin_fabs(z);
    };
    return largerOf(largerOf(sum(m.x.x, m.y.x, m.z.x), sum(m.x.y, m.y.y, m.z.y)),
                    sum(m.x.z, m.y.z, m.z.z));
}
[[gnu::always_inline]] inline double farthest(const Real3& a, const Real3& b, const Real3& c) {
    return largerOf(largerOf(largestCoordinate(a), largestCoordinate(b)), largestCoordinate(c));
}
[[gnu::always_inline]] inline float errorAt(const Real3& a, const Real3& ab, const Real3& ac,
                                            double far, double rows, const HitPacket& hits,
                                            const RTSpacket& p, int i) {
    constexpr double kUnit = 0x1p-23;
    const Real3 point = a + ab * double(hits.u[i]) + ac * double(hits.v[i]);
    const double lost = largestCoordinate(widened(p.position, i)) + rows * largestCoordinate(point);
    return float(4.0 * kUnit * lost + 0x1p-48 * rows * far);
}
void findErrors(const Matrix& m, const CornerLanes<3>& corners, const HitPacket& hits,
                const RTSpacket& p, float* __restrict error) {
    const double rows = largestRow(m);
    for (int i = 0; i < N; ++i) {
        const Real3 a = cornerOf(corners, 0, i), b = cornerOf(corners, 1, i),
                    c = cornerOf(corners, 2, i);
        error[i] = errorAt(a, b - a, c - a, farthest(a, b, c), rows, hits, p, i);
    }
}
void findErrors(const Matrix& m, const OneTriangle& corners, const HitPacket& hits,
                const RTSpacket& p, float* __restrict error) {
    const double rows = largestRow(m);
    const Real3 a = corners.at[0], ab = corners.at[1] - a, ac = corners.at[2] - a;
    const double far = farthest(a, corners.at[1], corners.at[2]);
    for (int i = 0; i < N; ++i) error[i] = errorAt(a, ab, ac, far, rows, hits, p, i);
}

/// Positions and normals, with errors where rays may start; returns the lanes whose numbers are
/// usual.
template <class Corners>
uint32_t placePoints(const SurfaceView& view, const Matrix& m, const Corners& corners,
                     const Weights& w, const HitPacket& hits, const DoubleLanes& ray,
                     uint32_t reads, RTSpacket& p, double* area, float* error) {
    if (reads & RTS_READS_POSITION) findPositions(m, corners, w, p);
    uint32_t usual = (1u << N) - 1u;
    if (reads & RTS_READS_NORMAL) usual = findNormals(m, corners, ray, p, area);
    if ((reads & RTS_READS_TRACE) == RTS_READS_TRACE && view.oneLevel)
        findErrors(m, corners, hits, p, error);
    else
        for (int i = 0; i < N; ++i) error[i] = -1.0f;
    return usual;
}

/// Shading normals of vertices; returns the lanes whose numbers are usual.
uint32_t interpolateNormals(const Matrix& m, const CornerLanes<3>& normals, const Weights& w,
                            RTSvectors& __restrict raw, RTSvectors& __restrict shading) {
    const Real3 x = cross(m.y, m.z), y = cross(m.z, m.x), z = cross(m.x, m.y);
    const double shrink = 1.0 / dot(m.x, x);
    uint32_t usual = 0;
    for (int i = 0; i < N; ++i) {
        const Real3 sum = cornerOf(normals, 0, i) * w[0][i] + cornerOf(normals, 1, i) * w[1][i] +
                          cornerOf(normals, 2, i) * w[2][i];
        Real3 normal = (x * sum.x + y * sum.y + z * sum.z) * shrink;
        raw.x.lane[i] = float(normal.x);
        raw.y.lane[i] = float(normal.y);
        raw.z.lane[i] = float(normal.z);
        const bool fine = normalizeUsual(normal);
        shading.x.lane[i] = float(normal.x);
        shading.y.lane[i] = float(normal.y);
        shading.z.lane[i] = float(normal.z);
        usual |= fine ? kLaneBit[i] : 0u;
    }
    return usual;
}

/// The geometric normals, where no vertex has one.
void takeGeometric(const RTSvectors& geometric, uint32_t lanes, RTSvectors& raw,
                   RTSvectors& shading) {
    for (; lanes != 0; lanes &= lanes - 1) {
        const int i = __builtin_ctz(lanes);
        raw.x.lane[i] = shading.x.lane[i] = geometric.x.lane[i];
        raw.y.lane[i] = shading.y.lane[i] = geometric.y.lane[i];
        raw.z.lane[i] = shading.z.lane[i] = geometric.z.lane[i];
    }
}

/// Returns the lanes, among the given ones, that have what they need.
uint32_t findShadingNormals(const SurfaceView& view, const VertexLanes& vertices, const Matrix& m,
                            const Weights& w, uint32_t lanes, uint32_t reads, RTSpacket& p) {
    if (!view.normals.values) {
        if (reads & RTS_READS_SHADING_NORMAL) p.shadingNormal = p.geometricNormal;
        if (reads & RTS_READS_RAW_NORMAL) p.rawNormal = p.geometricNormal;
        return lanes;
    }
    CornerLanes<3> normals;
    uint32_t some = 0;
    const uint32_t all = gatherNormals(view.normals, vertices, normals, some) & lanes;
    uint32_t fine = lanes & ~some;
    RTSvectors unread;
    RTSvectors& raw = reads & RTS_READS_RAW_NORMAL ? p.rawNormal : unread;
    RTSvectors& shading = reads & RTS_READS_SHADING_NORMAL ? p.shadingNormal : unread;
    if (all) fine &= interpolateNormals(m, normals, w, raw, shading) | ~all;
    takeGeometric(p.geometricNormal, lanes & ~(all | some), raw, shading);
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
                    const double* area, uint32_t reads, RTSpacket& p) {
    CornerLanes<4> values;
    if ((reads & (RTS_READS_TEXCOORD | RTS_READS_FOOTPRINT)) && view.texCoords.values) {
        gatherValues(view.texCoords, vertices, values);
        if (reads & RTS_READS_TEXCOORD) interpolate(values, w, p.texCoord);
        if (reads & RTS_READS_FOOTPRINT) findDensities(values, area, p.texCoordDensity);
    } else {
        if (reads & RTS_READS_TEXCOORD) spread(view.texCoords.inherited, p.texCoord);
        if (reads & RTS_READS_FOOTPRINT) p.texCoordDensity = {};
    }
    if (!(reads & RTS_READS_COLOR)) return;
    if (view.colors.values) {
        gatherValues(view.colors, vertices, values);
        interpolate(values, w, p.color);
    } else {
        spread(view.colors.inherited, p.color);
    }
}

uint32_t surfacePoints(const SurfaceView& view, const VertexLanes& vertices, const RayPacket& rays,
                       const HitPacket& hits, uint32_t lanes, uint32_t reads, RTSpacket& p,
                       float* error) {
    constexpr uint32_t kOfCorners = RTS_READS_POSITION | RTS_READS_NORMAL;
    constexpr uint32_t kOfWeights = RTS_READS_POSITION | RTS_READS_SHADING_NORMAL |
                                    RTS_READS_RAW_NORMAL | RTS_READS_BARYCENTRIC |
                                    RTS_READS_TEXCOORD | RTS_READS_COLOR;
    reads = filledFor(reads);
    uint32_t number[N]; // lanes that do not count take a triangle that exists
    const uint32_t some = hits.triangle[__builtin_ctz(lanes)];
    uint32_t differ = 0;
    for (int i = 0; i < N; ++i) {
        number[i] = (lanes & kLaneBit[i]) != 0 ? hits.triangle[i] : some;
        differ |= number[i] ^ some;
    }
    alignas(64) Weights w;
    alignas(64) double area[N];
    alignas(64) DoubleLanes unit;
    uint32_t fine = lanes;
    if (reads & kOfWeights) findWeights(hits, lanes, w);
    if (reads & RTS_READS_RAY) fine &= findRays(rays, hits, p, unit);
    const Matrix m(view.toWorld);
    if ((reads & kOfCorners) && differ == 0) {
        const OneTriangle corners(view.triangles[some]);
        fine &= placePoints(view, m, corners, w, hits, unit, reads, p, area, error);
    } else if (reads & kOfCorners) {
        CornerLanes<3> corners;
        gatherCorners(view.triangles, number, corners);
        fine &= placePoints(view, m, corners, w, hits, unit, reads, p, area, error);
    }
    if (reads & RTS_READS_BARYCENTRIC)
        for (int k = 0; k < 3; ++k)
            for (int i = 0; i < N; ++i) p.barycentric[k].lane[i] = float(w[k][i]);
    if (reads & (RTS_READS_SHADING_NORMAL | RTS_READS_RAW_NORMAL))
        fine &= findShadingNormals(view, vertices, m, w, lanes, reads, p);
    findAttributes(view, vertices, w, area, reads, p);
    if (reads & RTS_READS_IDS)
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
        // Numbers, not conditions: a jump in the loop would keep it from being vectorised.
        const int fine = int(sample.distance > 0.0) & int(isFiniteNumber(distance)) &
                         int(isFiniteNumber(red)) & int(isFiniteNumber(green)) &
                         int(isFiniteNumber(blue));
        lit |= fine ? kLaneBit[i] : 0u;
    }
    return lit;
}

#define SMART_STRINGIZE_(x) #x
#define SMART_STRINGIZE(x) SMART_STRINGIZE_(x)

} // namespace

const PacketMath kPacketMath = {SMART_STRINGIZE(SMART_ISA), lensColumns,   lensRows,
                                cameraRays,                 surfacePoints, spawn,
                                pointLight};

} // namespace smart::SMART_ISA
