/* SPDX-License-Identifier: MIT */
/* Martin Newell's teapot of 1975, as told by F. Crow, The Origins of the Teapot, IEEE Computer
 * Graphics and Applications 7 (1), 1987, with the bottom that it got later: ten Bezier patches and
 * their mirror images. Drawn as GLUT draws it: the spout points to +x, up is +y, triangles are
 * CLOCKWISE from outside, normals point outwards. */
#include <math.h>

#include "compat/rtut/drawing_names.h"
#include "compat/rtut/drawing_state.h"

enum { kPatches = 10, kRoundPatches = 6 };

typedef struct {
    double x, y, z;
} Point;

/* Four rows of control points. Of patches of revolution: a row is a quarter of a circle about the
 * z axis. */
typedef struct {
    double radius, height, round; /* round: where the tangents of a quarter end */
} RoundRow;

static const RoundRow roundPatches[kRoundPatches][4] = {
    /* rim */
    {{1.4, 2.4, 0.56}, {1.3375, 2.53125, 0.56}, {1.4375, 2.53125, 0.56}, {1.5, 2.4, 0.56}},
    /* body */
    {{1.5, 2.4, 0.56}, {1.75, 1.875, 0.56}, {2, 1.35, 0.56}, {2, 0.9, 0.56}},
    {{2, 0.9, 0.56}, {2, 0.45, 0.56}, {1.5, 0.225, 0.56}, {1.5, 0.15, 0.56}},
    /* lid */
    {{0, 3.15, 0.56}, {0.8, 3.15, 0.5625}, {0, 2.85, 0.56}, {0.2, 2.7, 0.56}},
    {{0.2, 2.7, 0.56}, {0.4, 2.55, 0.56}, {1.3, 2.55, 0.56}, {1.3, 2.4, 0.56}},
    /* bottom: from its middle outwards, so the other way round */
    {{0, 0, 0.56}, {1.425, 0, 0.56}, {1.5, 0.075, 0.56}, {1.5, 0.15, 0.56}},
};

/* Of handle and spout: a row is half of a loop, from (x, z) over the half width to (x, z). */
typedef struct {
    double fromX, fromZ, toX, toZ, width;
} TubeRow;

static const TubeRow tubePatches[kPatches - kRoundPatches][4] = {
    /* handle */
    {{-1.6, 2.025, -1.5, 2.25, 0.3}, {-2.3, 2.025, -2.5, 2.25, 0.3},
     {-2.7, 2.025, -3, 2.25, 0.3}, {-2.7, 1.8, -3, 1.8, 0.3}},
    {{-2.7, 1.8, -3, 1.8, 0.3}, {-2.7, 1.575, -3, 1.35, 0.3},
     {-2.5, 1.125, -2.65, 0.9375, 0.3}, {-2, 0.9, -1.9, 0.6, 0.3}},
    /* spout */
    {{1.7, 1.425, 1.7, 0.6, 0.66}, {2.6, 1.425, 3.1, 0.825, 0.66},
     {2.3, 2.1, 2.4, 2.025, 0.25}, {2.7, 2.4, 3.3, 2.4, 0.25}},
    {{2.7, 2.4, 3.3, 2.4, 0.25}, {2.8, 2.475, 3.525, 2.49375, 0.25},
     {2.9, 2.475, 3.45, 2.5125, 0.15}, {2.8, 2.4, 3.2, 2.4, 0.15}},
};

static void fillPatch(int patch, Point points[4][4]) {
    int row;
    for (row = 0; row < 4; ++row) {
        Point *p = points[row];
        if (patch < kRoundPatches) {
            const RoundRow *r = &roundPatches[patch][row];
            const double along = r->radius, across = r->radius * r->round;
            const double x[4] = {along, along, across, 0}, y[4] = {0, -across, -along, -along};
            int k;
            for (k = 0; k < 4; ++k) {
                const int from = patch == kRoundPatches - 1 ? 3 - k : k;
                p[k] = (Point){x[from], y[from], r->height};
            }
        } else {
            const TubeRow *r = &tubePatches[patch - kRoundPatches][row];
            p[0] = (Point){r->fromX, 0, r->fromZ};
            p[1] = (Point){r->fromX, -r->width, r->fromZ};
            p[2] = (Point){r->toX, -r->width, r->toZ};
            p[3] = (Point){r->toX, 0, r->toZ};
        }
    }
}

/* Mirrors in x and y; an odd number of mirrors would turn the patch inside out. */
static void mirrorPatch(Point from[4][4], int mirrorX, int mirrorY, Point to[4][4]) {
    int row, k;
    for (row = 0; row < 4; ++row)
        for (k = 0; k < 4; ++k) {
            Point p = from[row][mirrorX != mirrorY ? 3 - k : k];
            if (mirrorX) p.x = -p.x;
            if (mirrorY) p.y = -p.y;
            to[row][k] = p;
        }
}

/* Bernstein's polynomials of degree 3 and their derivatives. */
static void basis(double t, double value[4], double slope[4]) {
    const double s = 1 - t;
    value[0] = s * s * s;
    value[1] = 3 * s * s * t;
    value[2] = 3 * s * t * t;
    value[3] = t * t * t;
    slope[0] = -3 * s * s;
    slope[1] = 3 * s * s - 6 * s * t;
    slope[2] = 6 * s * t - 3 * t * t;
    slope[3] = 3 * t * t;
}

static Point weighted(Point points[4][4], const double down[4], const double along[4]) {
    Point sum = {0, 0, 0};
    int row, k;
    for (row = 0; row < 4; ++row)
        for (k = 0; k < 4; ++k) {
            const double weight = down[row] * along[k];
            sum.x += weight * points[row][k].x;
            sum.y += weight * points[row][k].y;
            sum.z += weight * points[row][k].z;
        }
    return sum;
}

static Point cross(Point a, Point b) {
    const Point c = {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    return c;
}
static double lengthOf(Point p) { return sqrt(p.x * p.x + p.y * p.y + p.z * p.z); }

/* Gives the point (u, v) of a patch: u along a row, v from row to row. */
static void vertexAt(Point points[4][4], double u, double v, double scale) {
    double along[4], alongSlope[4], down[4], downSlope[4];
    Point position, normal;
    double length;
    basis(u, along, alongSlope);
    basis(v, down, downSlope);
    position = weighted(points, down, along);
    normal = cross(weighted(points, down, alongSlope), weighted(points, downSlope, along));
    /* Where the first row is one point: the limit. */
    if (lengthOf(normal) < 1e-9)
        normal = cross(weighted(points, downSlope, alongSlope), weighted(points, downSlope, along));
    length = lengthOf(normal);
    if (length > 0) rtNormal3d(normal.x / length, normal.z / length, -normal.y / length);
    rtTexCoord2d(u, v);
    /* From z up to y up, its middle to the origin. */
    rtVertex3d(position.x * scale, (position.z - 1.5) * scale, -position.y * scale);
}

static void drawSolidPatch(Point points[4][4], int grid, double scale) {
    int i, j;
    for (i = 0; i < grid; ++i) {
        rtBegin(RT_QUAD_STRIP);
        for (j = 0; j <= grid; ++j) {
            vertexAt(points, (double)j / grid, (double)i / grid, scale);
            vertexAt(points, (double)j / grid, (double)(i + 1) / grid, scale);
        }
        rtEnd();
    }
}

static void drawWirePatch(Point points[4][4], int grid, double scale) {
    int across, i, j;
    for (across = 0; across < 2; ++across)
        for (i = 0; i <= grid; ++i) {
            rtBegin(RT_LINE_STRIP);
            for (j = 0; j <= grid; ++j)
                vertexAt(points, (double)(across ? i : j) / grid, (double)(across ? j : i) / grid,
                         scale);
            rtEnd();
        }
}

static void drawPatches(int grid, RTdouble size, void (*drawPatch)(Point[4][4], int, double)) {
    int patch, mirror;
    for (patch = 0; patch < kPatches; ++patch) {
        Point points[4][4], image[4][4];
        fillPatch(patch, points);
        for (mirror = 0; mirror < (patch < kRoundPatches ? 4 : 2); ++mirror) {
            mirrorPatch(points, mirror >> 1, mirror == 1 || mirror == 3, image);
            drawPatch(image, grid, size / 2);
        }
    }
}

static void drawTeapot(int grid, RTdouble size, void (*drawPatch)(Point[4][4], int, double)) {
    int isPushed, wasEnabled;
    if (!isOutsidePrimitive()) return;
    if (!hasState()) {
        drawPatches(grid, size, drawPatch);
        return;
    }
    /* GLUT keeps the lengths of normals right whatever the matrix does. */
    isPushed = attributesFit();
    wasEnabled = rtIsEnabled(RT_NORMALIZE);
    if (isPushed) rtPushAttrib(RT_ENABLE_BIT);
    rtEnable(RT_NORMALIZE);
    drawPatches(grid, size, drawPatch);
    if (isPushed)
        rtPopAttrib();
    else if (!wasEnabled)
        rtDisable(RT_NORMALIZE);
}

RTAPI void RTAPIENTRY rtutWireTeapot(RTdouble size) { drawTeapot(10, size, drawWirePatch); }
RTAPI void RTAPIENTRY rtutSolidTeapot(RTdouble size) { drawTeapot(14, size, drawSolidPatch); }
