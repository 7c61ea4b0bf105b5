/* SPDX-License-Identifier: MIT */
/* The shapes of GLUT 3.7 but for the teapot, with its vertices in its order. */
#include <math.h>
#include <stddef.h>

#include "compat/rtut/drawing_names.h"
#include "compat/rtut/drawing_state.h"

/* ---- Sphere and cone: quadrics -------------------------------------------------------------- */

static void drawSphere(RTenum style, RTdouble radius, RTint slices, RTint stacks) {
    RTUquadric *quad = rtuNewQuadric();
    if (quad == NULL) return;
    rtuQuadricDrawStyle(quad, style);
    rtuSphere(quad, radius, slices, stacks);
    rtuDeleteQuadric(quad);
}

static void drawCone(RTenum style, RTdouble base, RTdouble height, RTint slices, RTint stacks) {
    RTUquadric *quad = rtuNewQuadric();
    if (quad == NULL) return;
    rtuQuadricDrawStyle(quad, style);
    rtuCylinder(quad, base, 0.0, height, slices, stacks);
    rtuDeleteQuadric(quad);
}

RTAPI void RTAPIENTRY rtutWireSphere(RTdouble radius, RTint slices, RTint stacks) {
    drawSphere(RTU_LINE, radius, slices, stacks);
}
RTAPI void RTAPIENTRY rtutSolidSphere(RTdouble radius, RTint slices, RTint stacks) {
    drawSphere(RTU_FILL, radius, slices, stacks);
}
RTAPI void RTAPIENTRY rtutWireCone(RTdouble base, RTdouble height, RTint slices, RTint stacks) {
    drawCone(RTU_LINE, base, height, slices, stacks);
}
RTAPI void RTAPIENTRY rtutSolidCone(RTdouble base, RTdouble height, RTint slices, RTint stacks) {
    drawCone(RTU_FILL, base, height, slices, stacks);
}

/* ---- Torus ----------------------------------------------------------------------------------- */

enum { kMaxTorusSteps = 4096 };

/* Taylor's series in x * x. */
static double series(double square, const double *coefficients, int count) {
    double sum = 0;
    while (count > 0) sum = sum * square + coefficients[--count];
    return sum;
}

/* Sine of a part of a turn, the same on every machine. */
static double sineOfTurn(double turn) {
    static const double sine[] = {1,
                                  -1.0 / 6,
                                  1.0 / 120,
                                  -1.0 / 5040,
                                  1.0 / 362880,
                                  -1.0 / 39916800,
                                  1.0 / 6227020800.0,
                                  -1.0 / 1307674368000.0};
    static const double cosine[] = {1,
                                    -1.0 / 2,
                                    1.0 / 24,
                                    -1.0 / 720,
                                    1.0 / 40320,
                                    -1.0 / 3628800,
                                    1.0 / 479001600,
                                    -1.0 / 87178291200.0};
    const double kTurn = 6.283185307179586477;
    double t = turn - floor(turn), sign = 1, x;
    if (t >= 0.5) {
        t -= 0.5;
        sign = -1;
    }
    if (t > 0.25) t = 0.5 - t;
    x = (t > 0.125 ? 0.25 - t : t) * kTurn;
    return sign * (t > 0.125 ? series(x * x, cosine, 8) : x * series(x * x, sine, 8));
}
static double cosineOfTurn(double turn) { return sineOfTurn(turn + 0.25); }

/* Strips around the tube, one for each step of the ring. */
static void drawTorus(RTdouble tube, RTdouble ring, RTint sides, RTint rings) {
    RTint i, j, k;
    if (!(sides >= 1 && rings >= 1) || !isOutsidePrimitive()) return;
    if (sides > kMaxTorusSteps) sides = kMaxTorusSteps;
    if (rings > kMaxTorusSteps) rings = kMaxTorusSteps;
    for (i = 0; i < rings; ++i) {
        rtBegin(RT_QUAD_STRIP);
        for (j = 1; j <= sides + 1; ++j) {
            const double cosTube = cosineOfTurn((double)j / sides);
            const double sinTube = sineOfTurn((double)j / sides);
            for (k = 1; k >= 0; --k) {
                const double cosRing = cosineOfTurn((double)(i + k) / rings);
                const double sinRing = -sineOfTurn((double)(i + k) / rings);
                const double distance = ring + tube * cosTube;
                rtNormal3d(cosRing * cosTube, sinRing * cosTube, sinTube);
                rtVertex3d(cosRing * distance, sinRing * distance, tube * sinTube);
            }
        }
        rtEnd();
    }
}

RTAPI void RTAPIENTRY rtutWireTorus(RTdouble innerRadius, RTdouble outerRadius, RTint sides,
                                    RTint rings) {
    const int isPushed = attributesFit();
    RTint modes[2] = {RT_FILL, RT_FILL};
    if (isPushed)
        rtPushAttrib(RT_POLYGON_BIT);
    else
        rtGetIntegerv(RT_POLYGON_MODE, modes);
    rtPolygonMode(RT_FRONT_AND_BACK, RT_LINE);
    drawTorus(innerRadius, outerRadius, sides, rings);
    if (isPushed) {
        rtPopAttrib();
    } else {
        rtPolygonMode(RT_FRONT, (RTenum)modes[0]);
        rtPolygonMode(RT_BACK, (RTenum)modes[1]);
    }
}
RTAPI void RTAPIENTRY rtutSolidTorus(RTdouble innerRadius, RTdouble outerRadius, RTint sides,
                                     RTint rings) {
    drawTorus(innerRadius, outerRadius, sides, rings);
}

/* ---- Cube ------------------------------------------------------------------------------------ */

static void drawCube(RTenum mode, RTdouble size) {
    /* Corners by bits: 1 for +x, 2 for +y, 4 for +z. */
    static const struct {
        signed char normal[3];
        unsigned char corner[4];
    } faces[6] = {
        {{0, 0, -1}, {3, 1, 0, 2}}, {{0, 0, 1}, {5, 7, 6, 4}}, {{0, -1, 0}, {1, 5, 4, 0}},
        {{1, 0, 0}, {3, 7, 5, 1}},  {{0, 1, 0}, {2, 6, 7, 3}}, {{-1, 0, 0}, {0, 4, 6, 2}},
    };
    const double half = size / 2;
    int face, k;
    if (!isOutsidePrimitive()) return;
    for (face = 0; face < 6; ++face) {
        rtBegin(mode);
        rtNormal3f(faces[face].normal[0], faces[face].normal[1], faces[face].normal[2]);
        for (k = 0; k < 4; ++k) {
            const int corner = faces[face].corner[k];
            rtVertex3d(corner & 1 ? half : -half, corner & 2 ? half : -half,
                       corner & 4 ? half : -half);
        }
        rtEnd();
    }
}

RTAPI void RTAPIENTRY rtutWireCube(RTdouble size) { drawCube(RT_LINE_LOOP, size); }
RTAPI void RTAPIENTRY rtutSolidCube(RTdouble size) { drawCube(RT_QUADS, size); }

/* ---- Polyhedra ------------------------------------------------------------------------------- */

/* Faces of `sides` vertices each, anticlockwise from outside. */
static void drawFaces(RTenum mode, const double (*vertices)[3], const unsigned char *faces,
                      int count, int sides) {
    int face, k;
    if (!isOutsidePrimitive()) return;
    for (face = 0; face < count; ++face) {
        const unsigned char *index = faces + face * sides;
        const double *a = vertices[index[0]], *b = vertices[index[1]], *c = vertices[index[2]];
        const double n[3] = {
            (b[1] - a[1]) * (c[2] - b[2]) - (b[2] - a[2]) * (c[1] - b[1]),
            (b[2] - a[2]) * (c[0] - b[0]) - (b[0] - a[0]) * (c[2] - b[2]),
            (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]),
        };
        const double length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        rtBegin(mode);
        rtNormal3d(n[0] / length, n[1] / length, n[2] / length);
        for (k = 0; k < sides; ++k) {
            const double *v = vertices[index[k]];
            rtVertex3d(v[0], v[1], v[2]);
        }
        rtEnd();
    }
}

/* The corners of the cube of side 2 and of three rectangles; circumscribed radius sqrt(3). */
#define A 0.61803398874989484820 /* 1 / golden ratio */
#define B 1.61803398874989484820 /* golden ratio */
static void drawDodecahedron(RTenum mode) {
    static const double vertices[20][3] = {
        {-A, 0, B},   {A, 0, B},   {-1, -1, -1}, {-1, -1, 1}, {-1, 1, -1}, {-1, 1, 1}, {1, -1, -1},
        {1, -1, 1},   {1, 1, -1},  {1, 1, 1},    {B, A, 0},   {B, -A, 0},  {-B, A, 0}, {-B, -A, 0},
        {-A, 0, -B},  {A, 0, -B},  {0, B, A},    {0, B, -A},  {0, -B, A},  {0, -B, -A},
    };
    static const unsigned char faces[12 * 5] = {
        0,  1,  9,  16, 5,  1,  0,  3,  18, 7,  1,  7,  11, 10, 9,  11, 7,  18, 19, 6,
        8,  17, 16, 9,  10, 2,  14, 15, 6,  19, 2,  13, 12, 4,  14, 2,  19, 18, 3,  13,
        3,  0,  5,  12, 13, 6,  15, 8,  10, 11, 4,  17, 8,  15, 14, 4,  12, 5,  16, 17,
    };
    drawFaces(mode, vertices, faces, 12, 5);
}
#undef A
#undef B

RTAPI void RTAPIENTRY rtutWireDodecahedron(void) { drawDodecahedron(RT_LINE_LOOP); }
RTAPI void RTAPIENTRY rtutSolidDodecahedron(void) { drawDodecahedron(RT_TRIANGLE_FAN); }

static void drawOctahedron(RTenum mode) {
    static const double vertices[6][3] = {{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                          {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
    static const unsigned char faces[8 * 3] = {0, 2, 4, 1, 4, 2, 0, 4, 3, 1, 3, 4,
                                               0, 5, 2, 1, 2, 5, 0, 3, 5, 1, 5, 3};
    drawFaces(mode, vertices, faces, 8, 3);
}

RTAPI void RTAPIENTRY rtutWireOctahedron(void) { drawOctahedron(RT_LINE_LOOP); }
RTAPI void RTAPIENTRY rtutSolidOctahedron(void) { drawOctahedron(RT_TRIANGLES); }

/* Four corners of a cube with its centre at the origin; circumscribed radius 3. */
#define T 1.7320508075688772935
static void drawTetrahedron(RTenum mode) {
    static const double vertices[4][3] = {{T, T, T}, {T, -T, -T}, {-T, T, -T}, {-T, -T, T}};
    static const unsigned char faces[4 * 3] = {0, 3, 1, 2, 0, 1, 3, 0, 2, 1, 3, 2};
    drawFaces(mode, vertices, faces, 4, 3);
}
#undef T

RTAPI void RTAPIENTRY rtutWireTetrahedron(void) { drawTetrahedron(RT_LINE_LOOP); }
RTAPI void RTAPIENTRY rtutSolidTetrahedron(void) { drawTetrahedron(RT_TRIANGLES); }

/* Three golden rectangles; circumscribed radius 1. */
#define X 0.525731112119133606
#define Z 0.850650808352039932
static void drawIcosahedron(RTenum mode) {
    static const double vertices[12][3] = {
        {-X, 0, Z}, {X, 0, Z},  {-X, 0, -Z}, {X, 0, -Z}, {0, Z, X},  {0, Z, -X},
        {0, -Z, X}, {0, -Z, -X}, {Z, X, 0},  {-Z, X, 0}, {Z, -X, 0}, {-Z, -X, 0},
    };
    static const unsigned char faces[20 * 3] = {
        0, 1, 4,  0, 4, 9,  9, 4, 5,  4, 8, 5,  4, 1, 8,  8, 1, 10, 8,  10, 3,
        5, 8, 3,  5, 3, 2,  2, 3, 7,  7, 3, 10, 7, 10, 6, 7, 6, 11, 11, 6, 0,
        0, 6, 1,  6, 10, 1, 9, 11, 0, 9, 2, 11, 9, 5, 2,  7, 11, 2,
    };
    drawFaces(mode, vertices, faces, 20, 3);
}
#undef X
#undef Z

RTAPI void RTAPIENTRY rtutWireIcosahedron(void) { drawIcosahedron(RT_LINE_LOOP); }
RTAPI void RTAPIENTRY rtutSolidIcosahedron(void) { drawIcosahedron(RT_TRIANGLES); }
