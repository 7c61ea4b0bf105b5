/* SPDX-License-Identifier: MIT */
/* Which texel and share of a pixel a fragment gets: coordinates far beyond an image, borders,
 * smooth lines and points, and pixels that several primitives claim. */
#define GL_GLEXT_PROTOTYPES
#include "tests/conformance/window_pixels.h"

#include <math.h>

/* A rectangle with a texture's coordinates from (s0, t0) to (s1, t1). */
static void rectangle(GLfloat s0, GLfloat t0, GLfloat s1, GLfloat t1) {
    glBegin(GL_TRIANGLE_STRIP); /* how a quad is split would be open */
    glTexCoord2f(s0, t0);
    glVertex2f(0.0f, 0.0f);
    glTexCoord2f(s1, t0);
    glVertex2f(kWindow, 0.0f);
    glTexCoord2f(s0, t1);
    glVertex2f(0.0f, kWindow);
    glTexCoord2f(s1, t1);
    glVertex2f(kWindow, kWindow);
    glEnd();
}

static void useImage(GLint format, int side, GLint wrap) {
    static GLubyte image[64][4];
    for (int i = 0; i < side * side; ++i)
        for (int k = 0; k < 4; ++k)
            image[i][k] = (GLubyte)(30 + (i * 53 + k * 71 + i * i * k) % 200);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
    glTexImage2D(GL_TEXTURE_2D, 0, format, side, side, 0, GL_RGBA, GL_UNSIGNED_BYTE, image);
    glEnable(GL_TEXTURE_2D);
}

/* The middles of the texels of one period fall on pixels that are looked at. */
static void mirrors(void) {
    useImage(GL_RGB, 4, GL_MIRRORED_REPEAT);
    for (int filter = 0; filter < 2; ++filter) {
        const GLint value = filter ? GL_LINEAR : GL_NEAREST;
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, value);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, value);
        for (int period = -5; period < 7; ++period) {
            char name[64];
            const GLfloat s = (GLfloat)period, t = (GLfloat)(1 - period);
            snprintf(name, sizeof name, "mirrored/%s/%d", filter ? "linear" : "nearest", period);
            beginCase(name);
            clearBoth();
            /* By 1/64 of a period aside: pixel 8 i + 3 sees a texel's middle. */
            rectangle(s + 1.0f / 64, t + 1.0f / 64, s + 65.0f / 64, t + 65.0f / 64);
            readWindow();
            for (int y = 3; y < kWindow; y += 8)
                for (int x = 3; x < kWindow; x += 8) tellPixel(x, y);
        }
    }
    beginCase("mirrored/all");
    clearBoth();
    useImage(GL_RGB, 2, GL_MIRRORED_REPEAT);
    rectangle(-5.01f, -5.02f, 7.01f, 7.02f);
    readWindow();
    for (int y = 0; y < kWindow; y += 3)
        for (int x = 0; x < kWindow; ++x) tellPixel(x, y);
    glDisable(GL_TEXTURE_2D);
}

static void borders(void) {
    static const struct {
        const char* name;
        GLint format;
    } formats[] = {{"alpha", GL_ALPHA},
                   {"luminance", GL_LUMINANCE},
                   {"luminance_alpha", GL_LUMINANCE_ALPHA},
                   {"intensity", GL_INTENSITY},
                   {"rgb", GL_RGB},
                   {"rgba", GL_RGBA}};
    static const struct {
        const char* name;
        GLint mode;
    } modes[] = {{"replace", GL_REPLACE}, {"modulate", GL_MODULATE}};
    static const GLfloat border[4] = {0.2f, 0.7f, 0.45f, 0.6f};
    glColor4f(0.9f, 0.8f, 0.5f, 0.7f);
    glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, border);
    for (size_t i = 0; i < sizeof formats / sizeof formats[0]; ++i)
        for (size_t j = 0; j < sizeof modes / sizeof modes[0]; ++j)
            for (int blend = 0; blend < 2; ++blend) {
                char name[96];
                snprintf(name, sizeof name, "border/%s/%s%s", formats[i].name, modes[j].name,
                         blend ? "/blend" : "");
                beginCase(name);
                glClearColor(0.5f, 0.3f, 0.9f, 1.0f);
                clearBoth();
                useImage(formats[i].format, 4, GL_CLAMP_TO_BORDER);
                glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, modes[j].mode);
                if (blend) glEnable(GL_BLEND);
                glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
                rectangle(-1.6f, -0.7f, 2.3f, 1.8f);
                glDisable(GL_BLEND);
                readWindow();
                for (int y = 2; y < kWindow; y += 13)
                    for (int x = 2; x < kWindow; x += 13) tellPixel(x, y);
            }
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
    glColor4f(1.0f, 1.0f, 1.0f, 1.0f);
    glDisable(GL_TEXTURE_2D);
}

/* All around an image; filters take whole quarters of texels. */
static void wraps(void) {
    static const struct {
        const char* name;
        GLint wrap;
    } cases[] = {{"clamp", GL_CLAMP},
                 {"clamp_to_edge", GL_CLAMP_TO_EDGE},
                 {"clamp_to_border", GL_CLAMP_TO_BORDER},
                 {"repeat", GL_REPEAT},
                 {"mirrored_repeat", GL_MIRRORED_REPEAT}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        char name[64];
        snprintf(name, sizeof name, "wrap/%s", cases[i].name);
        beginCase(name);
        clearBoth();
        useImage(GL_RGB, 4, cases[i].wrap);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        rectangle(-1.5f, -1.5f, 2.5f, 2.5f);
        readWindow();
        for (int y = 0; y < kWindow; ++y)
            for (int x = 0; x < kWindow; ++x) tellPixel(x, y);
    }
    glDisable(GL_TEXTURE_2D);
}

typedef struct {
    double x, y;
} Place;

/* The share of a pixel that lies in a line's rectangle. */
static double shareOf(Place from, Place to, double width, int x, int y) {
    enum { kParts = 32 };
    const double dx = to.x - from.x, dy = to.y - from.y, length = sqrt(dx * dx + dy * dy);
    int inside = 0;
    for (int j = 0; j < kParts; ++j)
        for (int i = 0; i < kParts; ++i) {
            const double px = x + (i + 0.5) / kParts - from.x, py = y + (j + 0.5) / kParts - from.y;
            const double along = (px * dx + py * dy) / length;
            const double across = (dx * py - dy * px) / length;
            inside += along >= 0 && along < length && fabs(across) < width / 2;
        }
    return (double)inside / (kParts * kParts);
}

/* The share of a pixel that lies in a point's disc. */
static double shareOfDisc(Place center, double size, int x, int y) {
    enum { kParts = 32 };
    int inside = 0;
    for (int j = 0; j < kParts; ++j)
        for (int i = 0; i < kParts; ++i) {
            const double dx = x + (i + 0.5) / kParts - center.x;
            const double dy = y + (j + 0.5) / kParts - center.y;
            inside += dx * dx + dy * dy < size * size / 4;
        }
    return (double)inside / (kParts * kParts);
}

/* OpenGL wants the share of each pixel. Mesa's discs are about half a pixel smaller, so that only
 * what lies well inside or outside is asked for, and that there is something in between. */
static void smoothPoints(void) {
    static const struct {
        Place center;
        GLfloat size;
    } cases[] = {{{10.3, 21.7}, 9.0f}, {{16.0, 15.5}, 4.0f}, {{7.5, 8.5}, 13.0f}, {{20.2, 4.1}, 2.5f}};
    glColor3f(1.0f, 1.0f, 1.0f);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glEnable(GL_POINT_SMOOTH);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        char name[32];
        snprintf(name, sizeof name, "smooth_point/%d", (int)i);
        beginCase(name);
        clearBoth();
        glPointSize(cases[i].size);
        glBegin(GL_POINTS);
        glVertex2d(cases[i].center.x, cases[i].center.y);
        glEnd();
        readWindow();
        int between = 0;
        for (int y = 0; y < kWindow; ++y)
            for (int x = 0; x < kWindow; ++x) {
                const double share = shareOfDisc(cases[i].center, cases[i].size, x, y);
                const double inner = shareOfDisc(cases[i].center, cases[i].size - 2.0, x, y);
                const GLubyte seen = window[y][x][0];
                if (inner == 1.0 && seen != 255) printf("%d %d is not whole\n", x, y);
                if (share == 0.0 && seen != 0) printf("%d %d is not free\n", x, y);
                if (share < 0.6 && seen > 220) printf("%d %d is too much\n", x, y);
                between += seen > 30 && seen < 220;
            }
        printf("something in between: %d\n", kTellsAlternatives || between > 4);
    }
    glPointSize(1.0f);
    glDisable(GL_POINT_SMOOTH);
    glDisable(GL_BLEND);
}

/* OpenGL wants the share of each pixel, and lets implementations approximate it. */
static void smoothLines(void) {
    static const struct {
        Place from, to;
        GLfloat width;
    } cases[] = {{{3.3, 5.2}, {28.1, 19.6}, 5.0f},
                 {{4.2, 27.4}, {26.3, 6.1}, 3.0f},
                 {{9.4, 3.3}, {20.2, 28.9}, 7.0f},
                 {{28.2, 11.7}, {4.6, 16.4}, 4.0f},
                 {{21.6, 28.3}, {17.1, 3.4}, 1.0f}};
    glColor3f(1.0f, 1.0f, 1.0f);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glEnable(GL_LINE_SMOOTH);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        const Place from = cases[i].from, to = cases[i].to;
        char name[32];
        snprintf(name, sizeof name, "smooth_line/%d", (int)i);
        beginCase(name);
        clearBoth();
        glLineWidth(cases[i].width);
        glBegin(GL_LINES);
        glVertex2d(from.x, from.y);
        glVertex2d(to.x, to.y);
        glEnd();
        readWindow();
        for (int y = 0; y < kWindow; ++y)
            for (int x = 0; x < kWindow; ++x) {
                const double share = shareOf(from, to, cases[i].width, x, y);
                const double off = window[y][x][0] / 255.0 - share;
                if (fabs(off) > 0.08) printf("%d %d is not covered by %.2f\n", x, y, share);
            }
    }
    glLineWidth(1.0f);
    glDisable(GL_LINE_SMOOTH);
    glDisable(GL_BLEND);
}

static void flat(GLfloat z) {
    glBegin(GL_TRIANGLE_STRIP);
    glVertex3f(0.0f, 0.0f, z);
    glVertex3f(kWindow, 0.0f, z);
    glVertex3f(0.0f, kWindow, z);
    glVertex3f(kWindow, kWindow, z);
    glEnd();
}

/* Points that show what lies behind them, and keep what is drawn later, between both, away. */
static void seenThrough(void) {
    beginCase("seen_through");
    clearBoth();
    glEnable(GL_DEPTH_TEST);
    glColor4f(0.2f, 0.7f, 0.4f, 1.0f);
    flat(-0.5f);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glColor4f(0.9f, 0.1f, 0.3f, 0.5f);
    glBegin(GL_POINTS);
    for (int i = 0; i < 300; ++i)
        glVertex3f((GLfloat)(i * 7 % kWindow) + 0.5f, (GLfloat)(i * i * 5 % 31) + 0.5f,
                   (GLfloat)(i + 1) / 512.0f + 0.25f);
    glEnd();
    glDisable(GL_BLEND);
    glColor4f(0.6f, 0.3f, 0.9f, 1.0f);
    flat(0.0f);
    glDisable(GL_DEPTH_TEST);
    readWindow();
    for (int y = 0; y < kWindow; ++y)
        for (int x = 0; x < kWindow; ++x) tellPixel(x, y);
}

/* A mesh around the window whose corners and edges run through the centres of pixels, but for the
 * rounding of vertices, matrices and rays: no pixel is drawn twice, and none is not drawn. */
static const GLdouble angles[] = {0.0, 0.5, 1.1, 2.3};
static const GLdouble halfWidths[] = {3.65, 7.3, 11.9, 0.57};

static void meshVertex(int way, int column, int row) {
    const double x = (4 * column + 0.5) / 16 - 1, y = (4 * row + 0.5) / 16 - 1;
    const double wide = halfWidths[way], c = cos(angles[way]), s = sin(angles[way]);
    glVertex2d(wide * (c * x + s * y), wide * (c * y - s * x));
}

/* How often pixels were drawn: not at all, once, or more. */
static void tellDrawn(int from, int to) {
    for (int y = from; y < to; ++y) {
        for (int x = from; x < to; ++x)
            putchar(window[y][x][0] > 76 ? 'x' : window[y][x][0] > 25 ? '.' : 'o');
        putchar('\n');
    }
}

static void roundedMeshes(void) {
    for (int way = 0; way < 4; ++way) {
        const GLdouble wide = halfWidths[way];
        char name[32];
        snprintf(name, sizeof name, "rounded_mesh/%d", way);
        beginCase(name);
        clearBoth();
        glColor3f(0.0f, 0.0f, 0.0f); /* so that the mesh is not the first that is drawn */
        flat(-0.5f);
        glColor3f(0.2f, 0.2f, 0.2f);
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE);
        glMatrixMode(GL_PROJECTION);
        glPushMatrix();
        glLoadIdentity();
        glOrtho(-wide, wide, -wide, wide, -1.0, 1.0);
        glMatrixMode(GL_MODELVIEW);
        glPushMatrix();
        glRotated(angles[way] * 180 / 3.14159265358979323846, 0.0, 0.0, 1.0);
        for (int row = -1; row < 9; ++row) {
            glBegin(GL_TRIANGLES);
            for (int column = -1; column < 9; ++column)
                for (int half = 0; half < 2; ++half) {
                    const int other = (row + column) & 1;
                    meshVertex(way, column + half, row + (half ^ other));
                    meshVertex(way, column + 1, row + other);
                    meshVertex(way, column, row + 1 - other);
                }
            glEnd();
        }
        glPopMatrix();
        glMatrixMode(GL_PROJECTION);
        glPopMatrix();
        glMatrixMode(GL_MODELVIEW);
        glDisable(GL_BLEND);
        readWindow();
        tellDrawn(0, kWindow);
    }
}

/* A square of a list turned about the diagonal that its two triangles share, which stays on pixel
 * centres but for rounding. Its middle is looked at. */
static void turnedSquares(void) {
    static const GLdouble turns[] = {15.0, 20.0, 35.0, 45.0, 50.0};
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    glBegin(GL_TRIANGLES);
    glVertex2d(-1.0, -1.0), glVertex2d(1.0, -1.0), glVertex2d(1.0, 1.0);
    glVertex2d(-1.0, -1.0), glVertex2d(1.0, 1.0), glVertex2d(-1.0, 1.0);
    glEnd();
    glEndList();
    glMatrixMode(GL_PROJECTION);
    glPushMatrix();
    glLoadIdentity();
    glFrustum(-0.25, 0.25, -0.25, 0.25, 1.0, 20.0);
    glMatrixMode(GL_MODELVIEW);
    glPushMatrix();
    glColor3f(0.2f, 0.2f, 0.2f);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    for (int i = 0; i < 5; ++i) {
        char name[32];
        snprintf(name, sizeof name, "turned_square/%d", i);
        beginCase(name);
        clearBoth();
        glLoadIdentity();
        glTranslated(0.0, 0.0, -5.0);
        glRotated(turns[i], 1.0, 1.0, 0.0);
        glCallList(list);
        readWindow();
        tellDrawn(kWindow / 2 - 6, kWindow / 2 + 6);
    }
    glDisable(GL_BLEND);
    glPopMatrix();
    glMatrixMode(GL_PROJECTION);
    glPopMatrix();
    glMatrixMode(GL_MODELVIEW);
    glDeleteLists(list, 1);
}

/* Triangles without neighbours whose edges run through the centres of pixels, in all orders of
 * their corners: which of these pixels are theirs does not depend on it. */
static void loneTriangles(void) {
    static const GLfloat corners[4][3][2] = {{{4.5f, 4.5f}, {20.5f, 4.5f}, {4.5f, 20.5f}},
                                             {{20.5f, 4.5f}, {20.5f, 20.5f}, {4.5f, 4.5f}},
                                             {{20.5f, 20.5f}, {4.5f, 20.5f}, {20.5f, 4.5f}},
                                             {{4.5f, 20.5f}, {4.5f, 4.5f}, {20.5f, 20.5f}}};
    for (int way = 0; way < 4; ++way)
        for (int first = 0; first < 3; ++first) {
            char name[40];
            snprintf(name, sizeof name, "lone_triangle/%d/%d", way, first);
            beginCase(name);
            clearBoth();
            glColor3f(0.0f, 0.0f, 0.0f);
            flat(-0.5f);
            glColor3f(0.5f, 0.5f, 0.5f);
            glEnable(GL_BLEND);
            glBlendFunc(GL_ONE, GL_ONE);
            glBegin(GL_TRIANGLES);
            for (int i = 0; i < 3; ++i) glVertex2fv(corners[way][(first + i) % 3]);
            glEnd();
            glDisable(GL_BLEND);
            readWindow();
            for (int y = 0; y < kWindow; ++y) {
                for (int x = 0; x < kWindow; ++x) putchar(window[y][x][0] > 76 ? 'x' : '.');
                putchar('\n');
            }
        }
}

/* Walls in the near or the far plane of a perspective are seen whole. */
static void wallsInPlanes(void) {
    static const GLdouble planes[][2] = {{2.0, 10.0}, {1.0, 100.0}, {3.0, 20.0}};
    glMatrixMode(GL_PROJECTION);
    glPushMatrix();
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glColor3f(1.0f, 1.0f, 1.0f);
    for (int way = 0; way < 12; ++way) {
        const GLdouble *plane = planes[way / 4], near = plane[0], z = plane[way / 2 % 2];
        char name[64];
        snprintf(name, sizeof name, "wall_in_plane/%g to %g/%g/%s", near, plane[1], z,
                 way % 2 ? "moved" : "placed");
        beginCase(name);
        clearBoth();
        glMatrixMode(GL_PROJECTION);
        glLoadIdentity();
        glFrustum(-0.5 * near, 0.5 * near, -0.5 * near, 0.5 * near, near, plane[1]);
        glMatrixMode(GL_MODELVIEW);
        glPushMatrix();
        if (way % 2) glTranslated(0.0, 0.0, -z);
        glBegin(GL_TRIANGLE_STRIP);
        for (int i = 0; i < 4; ++i)
            glVertex3d((i % 2 ? 0.31 : -0.31) * z, (i / 2 ? 0.31 : -0.31) * z, way % 2 ? 0.0 : -z);
        glEnd();
        glPopMatrix();
        readWindow();
        tellDrawn(0, kWindow);
    }
    glDepthFunc(GL_LESS);
    glDisable(GL_DEPTH_TEST);
    glMatrixMode(GL_PROJECTION);
    glPopMatrix();
    glMatrixMode(GL_MODELVIEW);
}

static void askQuestions(void) {
    useWindowCoordinates();
    glColor4f(1.0f, 1.0f, 1.0f, 1.0f);
    mirrors();
    borders();
    wraps();
    smoothPoints();
    smoothLines();
    seenThrough();
    roundedMeshes();
    turnedSquares();
    loneTriangles();
    wallsInPlanes();
}
