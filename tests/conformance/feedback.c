/* SPDX-License-Identifier: MIT */
/* Which triangles a number of vertices makes, for each mode of filled primitives, in their order
 * and with their winding. OpenGL tells in its feedback buffer. The library is asked by rays: what
 * three hits of a triangle say of their barycentric coordinates gives its corners. */
#include <math.h>

#include "tests/conformance/questions.h"

enum { kMaxVertices = 64, kMaxTriangles = 64 };

typedef struct {
    double x, y;
} Point;

typedef struct {
    int corners[3];
} Corners;

static int mirrored, vertexCount;

/* Two rows of points, as strips have them. */
static Point zigzag(int i) {
    const Point p = {2.0 + 28.0 * i / (vertexCount > 1 ? vertexCount : 1), i % 2 ? 26.0 : 5.0};
    return p;
}

/* The cells of a grid of seven by seven. */
static Point inCell(int cell, double x, double y) {
    const Point p = {1.5 + 4.1 * (cell % 7) + 3.5 * x, 1.5 + 4.1 * (cell / 7) + 3.5 * y};
    return p;
}

static Point groupsOfFour(int i) {
    static const double x[4] = {0.0, 1.0, 0.9, 0.1}, y[4] = {0.1, 0.0, 1.0, 0.9};
    return inCell(i / 4, x[i % 4], y[i % 4]);
}

static Point groupsOfThree(int i) {
    static const double x[3] = {0.0, 1.0, 0.3}, y[3] = {0.1, 0.0, 1.0};
    return inCell(i / 3, x[i % 3], y[i % 3]);
}

static Point circle(int i) {
    const double turn = 6.283185307179586 * i / (vertexCount > 0 ? vertexCount : 1) + 0.3;
    const Point p = {16.0 + 14.0 * cos(turn), 16.0 + 14.0 * sin(turn)};
    return p;
}

typedef struct {
    const char* name;
    GLenum mode;
    Point (*layout)(int);
    int trianglesOfOne; /* the triangles that a polygon is split into, which OpenGL leaves open */
} Primitive;

static const Primitive* primitive;

static Point vertexAt(int i) {
    Point p = primitive->layout(i);
    if (mirrored) p.x = kWindow - p.x;
    return p;
}

static void draw(void) {
    glBegin(primitive->mode);
    for (int i = 0; i < vertexCount; ++i) {
        const Point p = vertexAt(i);
        glVertex2d(p.x, p.y);
    }
    glEnd();
}

/* -1: none is there. */
static int numberOf(double x, double y) {
    for (int i = 0; i < vertexCount; ++i) {
        const Point p = vertexAt(i);
        if (fabs(p.x - x) < 0.02 && fabs(p.y - y) < 0.02) return i;
    }
    return -1;
}

#ifdef OPENRT

enum { kRays = 192 };

/* Farthest apart of a triangle's hits so far. */
typedef struct {
    int hits;
    double place[3][2], weights[3][2];
} Hits;

static double areaOf(const double (*p)[2]) {
    return (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[1][1] - p[0][1]) * (p[2][0] - p[0][0]);
}

static void keep(Hits* hits, double x, double y, double u, double v) {
    Hits best = *hits;
    const int first = hits->hits < 3 ? hits->hits : 0, last = hits->hits < 3 ? first : 2;
    for (int i = first; i <= last; ++i) {
        Hits other = *hits;
        other.place[i][0] = x;
        other.place[i][1] = y;
        other.weights[i][0] = u;
        other.weights[i][1] = v;
        if (hits->hits < 3 || fabs(areaOf((const double(*)[2])other.place)) >
                                  fabs(areaOf((const double(*)[2])best.place)))
            best = other;
    }
    best.hits = hits->hits + 1;
    *hits = best;
}

/* Place where the second and third corner have these weights. */
static Point placeOf(const Hits* hits, double u, double v) {
    const double (*w)[2] = hits->weights, (*p)[2] = hits->place;
    const double area = areaOf(w);
    const double target[3][2] = {{u, v}, {w[1][0], w[1][1]}, {w[2][0], w[2][1]}};
    const double other[3][2] = {{w[0][0], w[0][1]}, {u, v}, {w[2][0], w[2][1]}};
    const double a = areaOf(target) / area, b = areaOf(other) / area, c = 1.0 - a - b;
    const Point result = {a * p[0][0] + b * p[1][0] + c * p[2][0],
                          a * p[0][1] + b * p[1][1] + c * p[2][1]};
    return result;
}

static int assembled(Corners* triangles) {
    static RTray rays[kRays];
    static RThit found[kRays];
    Hits hits[kMaxTriangles] = {0};
    int count = 0;
    const RTuint scene = rtGenScene();
    RTuint compiled;
    rtBindScene(scene);
    draw();
    compiled = rtCompileScene();
    for (int row = 0; row < kRays; ++row) {
        for (int i = 0; i < kRays; ++i) {
            const RTray ray = {{(float)kWindow * (0.5f + (float)i) / kRays,
                                (float)kWindow * (0.5f + (float)row) / kRays, 1.0f},
                               0.0f,
                               {0.0f, 0.0f, -1.0f},
                               2.0f};
            rays[i] = ray;
        }
        rtIntersect(compiled, rays, found, kRays, RT_COHERENT);
        for (int i = 0; i < kRays; ++i) {
            const int triangle = (int)found[i].primitive;
            if (found[i].instance == RT_INVALID || triangle >= kMaxTriangles) continue;
            keep(&hits[triangle], rays[i].origin[0], rays[i].origin[1], found[i].u, found[i].v);
            if (triangle >= count) count = triangle + 1;
        }
    }
    for (int i = 0; i < count; ++i)
        for (int k = 0; k < 3; ++k) {
            const Point p = placeOf(&hits[i], k == 1, k == 2);
            triangles[i].corners[k] = hits[i].hits < 3 ? -1 : numberOf(p.x, p.y);
        }
    rtReleaseScene(compiled);
    rtBindScene(0);
    rtDeleteScene(scene);
    return count;
}

#else

static int assembled(Corners* triangles) {
    static GLfloat buffer[16 * kMaxTriangles];
    const GLfloat* at = buffer;
    int values, count = 0;
    glFeedbackBuffer(sizeof buffer / sizeof buffer[0], GL_3D, buffer);
    glRenderMode(GL_FEEDBACK);
    draw();
    values = glRenderMode(GL_RENDER);
    while (at < buffer + values && *at++ == GL_POLYGON_TOKEN) {
        const int corners = (int)*at++;
        /* A polygon that was not split, as a fan. */
        for (int k = 2; k < corners; ++k) {
            triangles[count].corners[0] = numberOf(at[0], at[1]);
            triangles[count].corners[1] = numberOf(at[3 * k - 3], at[3 * k - 2]);
            triangles[count].corners[2] = numberOf(at[3 * k], at[3 * k + 1]);
            ++count;
        }
        at += 3 * corners;
    }
    return count;
}

#endif

/* The edge that leaves this corner and belongs to no other triangle the other way round. */
static int outerNext(const Corners* triangles, int count, int corner) {
    for (int i = 0; i < count; ++i)
        for (int k = 0; k < 3; ++k) {
            const int from = triangles[i].corners[k], to = triangles[i].corners[(k + 1) % 3];
            int inner = 0;
            for (int j = 0; j < count; ++j)
                for (int m = 0; m < 3; ++m)
                    inner |= triangles[j].corners[m] == to &&
                             triangles[j].corners[(m + 1) % 3] == from;
            if (from == corner && !inner) return to;
        }
    return -1;
}

/* Once around, from the lowest corner on: two splits of a polygon tell the same. */
static void tellOutline(const Corners* triangles, int count) {
    int first = vertexCount, corner;
    for (int i = 0; i < 3 * count; ++i)
        if (triangles[i / 3].corners[i % 3] < first) first = triangles[i / 3].corners[i % 3];
    corner = first;
    for (int i = 0; i < 3 * count + 1; ++i) {
        printf("%d ", corner);
        corner = outerNext(triangles, count, corner);
        if (corner == first || corner < 0) break;
    }
    printf("\n");
}

static void askQuestions(void) {
    static const Primitive primitives[] = {{"triangles", GL_TRIANGLES, groupsOfThree, 1},
                                           {"triangle_strip", GL_TRIANGLE_STRIP, zigzag, 1},
                                           {"triangle_fan", GL_TRIANGLE_FAN, circle, 1},
                                           {"quads", GL_QUADS, groupsOfFour, 2},
                                           {"quad_strip", GL_QUAD_STRIP, zigzag, 2},
                                           {"polygon", GL_POLYGON, circle, kMaxTriangles}};
    static const int counts[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 31, 32, 33, 47, 48,
                                 kMaxVertices};
    useWindowCoordinates();
    for (size_t p = 0; p < sizeof primitives / sizeof primitives[0]; ++p)
        for (size_t n = 0; n < sizeof counts / sizeof counts[0]; ++n)
            for (mirrored = 0; mirrored < 2; ++mirrored) {
                Corners triangles[kMaxTriangles];
                char name[64];
                int count;
                primitive = &primitives[p];
                vertexCount = counts[n];
                snprintf(name, sizeof name, "%s/%d_vertices%s", primitive->name, vertexCount,
                         mirrored ? "_mirrored" : "");
                beginCase(name);
                count = assembled(triangles);
                printf("%d triangles\n", count);
                for (int i = 0; i < count; i += primitive->trianglesOfOne) {
                    const int left = count - i;
                    tellOutline(triangles + i, primitive->trianglesOfOne < left
                                                   ? primitive->trianglesOfOne
                                                   : left);
                }
                tellError();
            }
}
