/* SPDX-License-Identifier: MIT */
/* Which triangles, lines and points a number of vertices makes, for each mode and both windings:
 * pixels are told as the vertex whose colour they have (flat shading: the provoking one).
 * A pixel whose centre is nearer than a tenth of a pixel to an edge that a primitive may have is
 * left open. */
#include <math.h>

#include "tests/conformance/questions.h"

enum { kMaxVertices = 12 };

typedef struct {
    double x, y;
} Point;

typedef Point (*Layout)(int index, int count);

/* Two rows of points, as strips have them. */
static Point zigzag(int i, int count) {
    const Point p = {2.3 + 4.9 * (i / 2) + 0.17 * (i % 3), i % 2 ? 25.4 - 0.6 * i : 5.6 + 0.5 * i};
    (void)count;
    return p;
}

/* Groups of four points around a cell each. */
static Point cells(int i, int count) {
    static const Point corners[4] = {{0.0, 0.0}, {8.3, 1.2}, {7.1, 20.7}, {1.4, 18.9}};
    const Point p = {2.2 + 9.7 * (i / 4) + corners[i % 4].x, 4.7 + corners[i % 4].y};
    (void)count;
    return p;
}

static Point groupsOfThree(int i, int count) {
    static const Point corners[3] = {{0.0, 0.0}, {6.6, 1.2}, {2.1, 20.7}};
    const Point p = {2.2 + 7.3 * (i / 3) + corners[i % 3].x, 4.7 + corners[i % 3].y};
    (void)count;
    return p;
}

static Point circle(int i, int count) {
    const double turn = 6.283185307179586 * i / (count > 0 ? count : 1) + 0.3;
    const Point p = {16.1 + 13.0 * cos(turn), 15.8 + 12.1 * sin(turn)};
    return p;
}

/* Pixel centres, joined by level and upright lines. */
static Point stairs(int i, int count) {
    const Point p = {3.5 + 4.0 * ((i + 1) / 2), 3.5 + 4.0 * (i / 2)};
    (void)count;
    return p;
}

static Point grid(int i, int count) {
    const Point p = {5.5 + 7.0 * (i % 4), 5.5 + 7.0 * (i / 4)};
    (void)count;
    return p;
}

typedef struct {
    const char* name;
    GLenum mode;
    Layout layout;
    int filled, closed;
} Primitive;

static void colorOf(int index, GLubyte* rgb) {
    rgb[0] = (GLubyte)(55 + 100 * (index % 3));
    rgb[1] = (GLubyte)(55 + 60 * (index / 3));
    rgb[2] = 200;
}

static char letterOf(const GLubyte* pixel) {
    for (int i = 0; i < kMaxVertices; ++i) {
        GLubyte rgb[3];
        colorOf(i, rgb);
        if (abs(pixel[0] - rgb[0]) <= 2 && abs(pixel[1] - rgb[1]) <= 2 &&
            abs(pixel[2] - rgb[2]) <= 2)
            return (char)('0' + i);
    }
    return pixel[0] + pixel[1] + pixel[2] == 0 ? '.' : 'x';
}

static int nearLine(Point p, Point a, Point b) {
    const double x = b.x - a.x, y = b.y - a.y, length = sqrt(x * x + y * y);
    if (length == 0.0) return 0;
    return fabs((p.x - a.x) * y - (p.y - a.y) * x) < 0.1 * length;
}

static int isOpen(const Primitive* primitive, int count, int column, int row) {
    const Point p = {column + 0.5, row + 0.5};
    for (int i = 0; i < count && primitive->filled; ++i)
        for (int j = i + 1; j < count; ++j)
            if (nearLine(p, primitive->layout(i, count), primitive->layout(j, count))) return 1;
    /* The line that closes a loop is neither level nor upright: told by its being there alone. */
    if (primitive->closed && count > 2) {
        const Point a = primitive->layout(count - 1, count), b = primitive->layout(0, count);
        const double x = b.x - a.x, y = b.y - a.y, length = sqrt(x * x + y * y);
        const double away = fabs((p.x - a.x) * y - (p.y - a.y) * x) / length;
        return away > 0.2 && away < 1.2;
    }
    return 0;
}

static void draw(const Primitive* primitive, int count, int clockwise) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glFrontFace(clockwise ? GL_CW : GL_CCW);
    glBegin(primitive->mode);
    for (int i = 0; i < count; ++i) {
        GLubyte rgb[3];
        const Point p = primitive->layout(i, count);
        colorOf(i, rgb);
        glColor3ubv(rgb);
        glVertex2d(p.x, p.y);
    }
    glEnd();
}

static void tellPixels(const Primitive* primitive, int count) {
    static GLubyte pixels[kWindow][kWindow][3];
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, kWindow, kWindow, GL_RGB, GL_UNSIGNED_BYTE, pixels);
    tellError();
    for (int row = kWindow - 1; row >= 0; --row) {
        for (int column = 0; column < kWindow; ++column) {
            const int open = isOpen(primitive, count, column, row);
            putchar(open ? '?' : letterOf(pixels[row][column]));
        }
        putchar('\n');
    }
}

static void askQuestions(void) {
    static const Primitive primitives[] = {{"points", GL_POINTS, grid, 0, 0},
                                           {"lines", GL_LINES, stairs, 0, 0},
                                           {"line_strip", GL_LINE_STRIP, stairs, 0, 0},
                                           {"line_loop", GL_LINE_LOOP, stairs, 0, 1},
                                           {"triangles", GL_TRIANGLES, groupsOfThree, 1, 0},
                                           {"triangle_strip", GL_TRIANGLE_STRIP, zigzag, 1, 0},
                                           {"triangle_fan", GL_TRIANGLE_FAN, circle, 1, 0},
                                           {"quads", GL_QUADS, cells, 1, 0},
                                           {"quad_strip", GL_QUAD_STRIP, zigzag, 1, 0},
                                           {"polygon", GL_POLYGON, circle, 1, 0}};
    useWindowCoordinates();
    glLoadIdentity();
    glShadeModel(GL_FLAT);
    glEnable(GL_CULL_FACE);
    glPointSize(3.0f);
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    for (size_t i = 0; i < sizeof primitives / sizeof primitives[0]; ++i)
        for (int clockwise = 0; clockwise < (primitives[i].filled ? 2 : 1); ++clockwise)
            for (int count = 0; count <= kMaxVertices; ++count) {
                char name[64];
                snprintf(name, sizeof name, "%s/%d_vertices%s", primitives[i].name, count,
                         clockwise ? "_clockwise" : "");
                beginCase(name);
                draw(&primitives[i], count, clockwise);
                tellPixels(&primitives[i], count);
            }
}
