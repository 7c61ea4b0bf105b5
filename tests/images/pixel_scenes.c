/* SPDX-License-Identifier: MIT */
#include "tests/images/pixel_scenes.h"

#include <math.h>
#include <string.h>

#ifndef OPENRT
#    include <GL/gl.h>
#    define drawPixelScene drawPixelSceneOpenGl
#else
#    define drawPixelScene drawPixelSceneOpenRt
#endif

#define WIDTH PIXEL_SCENE_WIDTH
#define HEIGHT PIXEL_SCENE_HEIGHT

static unsigned state;
static float uniform(float low, float high) {
    state = state * 1664525u + 1013904223u;
    return low + (high - low) * (float)(state >> 8) / 16777216.0f;
}

static void flat(void) {
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(0, WIDTH, 0, HEIGHT, -1, 1);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
}

static void deep(void) {
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glFrustum(-0.8, 0.8, -0.6, 0.6, 1, 20);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glTranslatef(0, 0, -4);
    glRotatef(30, 1, 0.3f, 0.1f);
    glRotatef(25, 0, 1, 0);
    glEnable(GL_DEPTH_TEST);
}

static void points(int size) {
    int i;
    flat();
    glPointSize((float)size);
    glBegin(GL_POINTS);
    for (i = 0; i < 40; ++i) {
        glColor3f(uniform(0.3f, 1), uniform(0.3f, 1), uniform(0.3f, 1));
        glVertex2f(uniform(5, WIDTH - 5), uniform(5, HEIGHT - 5));
    }
    for (i = 0; i < 8; ++i) glVertex2f(6 + 11 * (float)i + 0.25f * (float)i, 10 + 0.25f * (float)i);
    glEnd();
}

/* Centres inside and outside of the picture's borders. */
static void pointsAtBorders(void) {
    int i;
    flat();
    glPointSize(5);
    glBegin(GL_POINTS);
    for (i = 0; i < 7; ++i) {
        glVertex2f(-1.25f + 0.5f * (float)i, 6 + 10 * (float)i);
        glVertex2f(WIDTH - 1.75f + 0.5f * (float)i, 6 + 10 * (float)i);
        glVertex2f(14 + 10 * (float)i, HEIGHT - 1.75f + 0.5f * (float)i);
    }
    glEnd();
}

static void star(int width) {
    int i;
    flat();
    glLineWidth((float)width);
    glBegin(GL_LINES);
    for (i = 0; i < 32; ++i) {
        const float a = (float)i * 0.19634954f + 0.01f;
        glColor3f(i % 2 ? 1.0f : 0.5f, i % 3 ? 1.0f : 0.3f, 1);
        glVertex2f(48.3f + 12 * cosf(a), 36.4f + 12 * sinf(a));
        glVertex2f(48.3f + 33 * cosf(a), 36.4f + 33 * sinf(a));
    }
    glEnd();
}

static void randomLines(int width) {
    int i;
    flat();
    glLineWidth((float)width);
    glBegin(GL_LINES);
    for (i = 0; i < 10; ++i) {
        glVertex2f(uniform(-30, WIDTH + 30), uniform(-30, HEIGHT + 30));
        glVertex2f(uniform(-30, WIDTH + 30), uniform(-30, HEIGHT + 30));
    }
    glEnd();
}

static void stipple(int factor) {
    int i;
    flat();
    glEnable(GL_LINE_STIPPLE);
    for (i = 0; i < 6; ++i) {
        glLineStipple(factor, (GLushort)(0x0F35u + 0x1111u * (unsigned)i));
        glBegin(GL_LINES);
        glVertex2f(3.3f, 3.3f + 4 * (float)i);
        glVertex2f(90.4f, 5.1f + 7 * (float)i);
        glEnd();
    }
    glLineStipple(factor, 0x00FF);
    glBegin(GL_LINE_STRIP);
    for (i = 0; i < 9; ++i) glVertex2f(5.3f + 10 * (float)i, i % 2 ? 55.4f : 68.2f);
    glEnd();
}

static void stripAndLoop(void) {
    flat();
    glShadeModel(GL_FLAT);
    glBegin(GL_LINE_LOOP);
    glColor3f(1, 0, 0);
    glVertex2f(6.3f, 6.4f);
    glColor3f(0, 1, 0);
    glVertex2f(60.2f, 9.7f);
    glColor3f(0, 0, 1);
    glVertex2f(70.6f, 50.1f);
    glColor3f(1, 1, 0);
    glVertex2f(20.2f, 60.8f);
    glEnd();
    glBegin(GL_LINE_STRIP);
    glColor3f(1, 1, 1);
    glVertex2f(30.4f, 20.3f);
    glColor3f(0, 1, 1);
    glVertex2f(80.1f, 30.9f);
    glColor3f(1, 0, 1);
    glVertex2f(45.7f, 44.2f);
    glEnd();
}

static void shadedLines(void) {
    int i;
    deep();
    glBegin(GL_LINES);
    for (i = 0; i < 12; ++i) {
        const float x = -1.7f + 0.31f * (float)i;
        glColor3f(1, 0, 0);
        glVertex3f(x, -1.4f, 2.2f);
        glColor3f(0, 1, 0.5f);
        glVertex3f(-x * 0.7f, 1.5f, -7);
    }
    glEnd();
}

static const float corners[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                    {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
static const int faces[6][4] = {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                {2, 3, 7, 6}, {1, 2, 6, 5}, {3, 0, 4, 7}};

static void cube(void) {
    int i, k;
    glBegin(GL_QUADS);
    for (i = 0; i < 6; ++i)
        for (k = 0; k < 4; ++k) glVertex3fv(corners[faces[i][k]]);
    glEnd();
}

static void cubeEdges(void) {
    deep();
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1, 2);
    glColor3f(0.2f, 0.2f, 0.4f);
    cube();
    glDisable(GL_POLYGON_OFFSET_FILL);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glColor3f(1, 1, 0);
    cube();
}

static void sphere(int slices, int stacks) {
    int i, j, k;
    for (j = 0; j < stacks; ++j) {
        glBegin(GL_QUAD_STRIP);
        for (i = 0; i <= slices; ++i)
            for (k = 1; k >= 0; --k) {
                const float a = (float)i / (float)slices * 6.2831853f;
                const float b = (float)(j + k) / (float)stacks * 3.1415927f;
                glNormal3f(sinf(b) * cosf(a), sinf(b) * sinf(a), cosf(b));
                glVertex3f(1.4f * sinf(b) * cosf(a), 1.4f * sinf(b) * sinf(a), 1.4f * cosf(b));
            }
        glEnd();
    }
}

static void sphereEdges(void) {
    deep();
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glEnable(GL_CULL_FACE);
    sphere(12, 7);
}

static void edgeFlags(void) {
    int i;
    flat();
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glBegin(GL_POLYGON);
    for (i = 0; i < 7; ++i) {
        glEdgeFlag(i % 3 != 1);
        glVertex2f(24.3f + 20 * cosf((float)i * 0.9f), 36.6f + 20 * sinf((float)i * 0.9f));
    }
    glEnd();
    glBegin(GL_TRIANGLES);
    for (i = 0; i < 6; ++i) {
        glEdgeFlag(i % 2);
        glVertex2f(52.2f + 7 * (float)i, i % 3 == 1 ? 60.1f : 40.3f);
    }
    glEnd();
    glEdgeFlag(GL_FALSE);
    glBegin(GL_QUAD_STRIP);
    for (i = 0; i < 8; ++i) glVertex2f(50.4f + 5 * (float)i, i % 2 ? 30.3f : 10.1f);
    glEnd();
    glBegin(GL_QUADS);
    glEdgeFlag(GL_TRUE);
    glVertex2f(6.2f, 3.1f);
    glEdgeFlag(GL_FALSE);
    glVertex2f(40.1f, 4.2f);
    glEdgeFlag(GL_TRUE);
    glVertex2f(42.9f, 12.4f);
    glVertex2f(9.3f, 11.8f);
    glEnd();
}

static void quadAt(float x, int clockwise) {
    static const float at[4][2] = {{0, 0}, {25, 2}, {23, 30}, {3, 27}};
    int i;
    glBegin(GL_QUADS);
    for (i = 0; i < 4; ++i) {
        const float* const p = at[clockwise ? 3 - i : i];
        glVertex2f(x + p[0], 20.4f + p[1]);
    }
    glEnd();
}

static void faceModes(void) {
    flat();
    glPolygonMode(GL_FRONT, GL_LINE);
    glPolygonMode(GL_BACK, GL_FILL);
    glColor3f(1, 1, 1);
    quadAt(8.3f, 0);
    quadAt(36.3f, 1);
    glFrontFace(GL_CW);
    quadAt(64.3f, 1);
}

static void polygonPoints(void) {
    deep();
    glPointSize(4);
    glPolygonMode(GL_FRONT_AND_BACK, GL_POINT);
    sphere(10, 6);
}

static void clipPlane(void) {
    const GLdouble plane[4] = {-1, 0.35, 0, 44.3};
    int i;
    flat();
    glClipPlane(GL_CLIP_PLANE0, plane);
    glEnable(GL_CLIP_PLANE0);
    glBegin(GL_LINES);
    for (i = 0; i < 10; ++i) {
        glVertex2f(4.2f, 4.3f + 6 * (float)i);
        glVertex2f(90.7f, 8.1f + 6 * (float)i);
    }
    glEnd();
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glColor3f(1, 0, 0);
    glBegin(GL_QUADS);
    glVertex2f(20.3f, 30.2f);
    glVertex2f(80.3f, 33.2f);
    glVertex2f(78.3f, 60.2f);
    glVertex2f(22.3f, 66.2f);
    glEnd();
}

static void nearPlane(void) {
    int i;
    deep();
    glLoadIdentity();
    glBegin(GL_LINES);
    for (i = 0; i < 20; ++i) {
        const float a = (float)i * 0.31416f;
        glVertex3f(0.6f * cosf(a), 0.6f * sinf(a), 3);
        glVertex3f(2.5f * cosf(a + 0.4f), 2.5f * sinf(a + 0.4f), -8);
    }
    glEnd();
}

static const GLubyte letter[13] = {0x00, 0x00, 0xc3, 0xc3, 0xc3, 0xc3, 0xff,
                                   0xc3, 0xc3, 0xc3, 0x66, 0x3c, 0x18};

static void bitmaps(void) {
    int i;
    GLubyte rows[4 * 12];
    flat();
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (i = 0; i < 5; ++i) {
        glColor3f(1, 0.2f * (float)i, 0.5f);
        glRasterPos2f(4.3f + 3 * (float)i, 4.6f + 13 * (float)i);
        glBitmap(8, 13, 0, 2, 10, 0, letter);
        glBitmap(0, 0, 0, 0, 3.5f, 0, 0);
        glColor3f(0, 0, 1); /* not before the next raster position */
        glBitmap(8, 13, 0.4f, 2, 10.25f, 1, letter);
        glBitmap(7, 11, -1, 2, 0, 0, letter);
    }
    glRasterPos2f(-0.5f, 20); /* not valid */
    glBitmap(8, 13, -20, 0, 0, 0, letter);
    /* Two pixels skipped of rows of 20, four bytes each. */
    memset(rows, 0, sizeof rows);
    for (i = 0; i < 12; ++i) {
        rows[4 * i] = 0x9F;
        rows[4 * i + 1] = (GLubyte)(0x11 * i);
        rows[4 * i + 2] = 0xF0;
    }
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 20);
    glPixelStorei(GL_UNPACK_SKIP_PIXELS, 2);
    glPixelStorei(GL_UNPACK_SKIP_ROWS, 1);
    glColor3f(1, 1, 1);
    glRasterPos2i(70, 40);
    glBitmap(18, 10, 0, 0, 0, 0, rows);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    glPixelStorei(GL_UNPACK_SKIP_PIXELS, 0);
    glPixelStorei(GL_UNPACK_SKIP_ROWS, 0);
    glWindowPos2i(72, 55);
    glBitmap(8, 13, 0, 0, 0, 0, letter);
}

static void drawPixels(int zoom) {
    static const float zooms[][2] = {{1, 1}, {2, 3}, {-1.7f, 2.4f}, {0.4f, 0.6f}};
    GLubyte bytes[20 * 10 * 4];
    GLfloat floats[10 * 6 * 3];
    int i;
    flat();
    for (i = 0; i < 800; ++i) bytes[i] = (GLubyte)(i * 7);
    for (i = 0; i < 180; ++i) floats[i] = (float)(i % 11) / 10.0f;
    glPixelZoom(zooms[zoom][0], zooms[zoom][1]);
    glRasterPos2f(42.2f, 6.2f);
    glDrawPixels(20, 10, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
    glRasterPos2f(60.7f, 38.3f);
    glDrawPixels(10, 6, GL_RGB, GL_FLOAT, floats);
    glPixelTransferf(GL_RED_SCALE, 0.5f);
    glPixelTransferf(GL_GREEN_BIAS, 0.25f);
    glRasterPos2f(20.2f, 40.9f);
    glDrawPixels(10, 6, GL_LUMINANCE, GL_FLOAT, floats);
    glPixelTransferf(GL_RED_SCALE, 1);
    glPixelTransferf(GL_GREEN_BIAS, 0);
    glPixelZoom(1, 1);
}

static void foggedLitLines(void) {
    const GLfloat fog[] = {0.1f, 0.2f, 0.4f, 1}, red[] = {0.9f, 0.2f, 0.1f, 1};
    int i;
    deep();
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_NORMALIZE);
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, red);
    glEnable(GL_FOG);
    glFogi(GL_FOG_MODE, GL_LINEAR);
    glFogf(GL_FOG_START, 2);
    glFogf(GL_FOG_END, 7);
    glFogfv(GL_FOG_COLOR, fog);
    glBegin(GL_LINE_STRIP);
    for (i = 0; i < 30; ++i) {
        const float a = (float)i * 0.6f;
        glNormal3f(cosf(a), sinf(a), 0.5f);
        glVertex3f(1.3f * cosf(a), 1.3f * sinf(a), 2 - 0.2f * (float)i);
    }
    glEnd();
    glColor3f(1, 1, 1);
    glRasterPos3f(0, 0, 1);
    glBitmap(8, 13, 0, 0, 0, 0, letter);
}

static void order(void) {
    int i;
    flat();
    for (i = 0; i < 4; ++i) {
        glColor3f(0.2f * (float)i, 0.4f, 0.3f);
        glBegin(GL_QUADS);
        glVertex2f(10.2f + 9 * (float)i, 10.3f);
        glVertex2f(50.2f + 9 * (float)i, 10.3f);
        glVertex2f(50.2f + 9 * (float)i, 60.3f);
        glVertex2f(10.2f + 9 * (float)i, 60.3f);
        glEnd();
        glColor3f(1, 0.25f * (float)i, 1);
        glBegin(GL_LINES);
        glVertex2f(4.3f, 20.7f + 7 * (float)i);
        glVertex2f(91.2f, 25.1f + 7 * (float)i);
        glEnd();
        glRasterPos2i(30 + 9 * i, 30);
        glBitmap(8, 13, 0, 0, 0, 0, letter);
    }
}

static void lists(void) {
    const GLuint list = glGenLists(2);
    flat();
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glNewList(list, GL_COMPILE);
    glBitmap(8, 13, 0, 2, 10, 0, letter);
    glEndList();
    glNewList(list + 1, GL_COMPILE);
    glLineWidth(2);
    glColor3f(1, 1, 0);
    glBegin(GL_LINE_STRIP);
    glVertex2f(4.3f, 6.2f);
    glVertex2f(30.1f, 9.4f);
    glVertex2f(12.7f, 30.8f);
    glEnd();
    glRasterPos2f(10, 40);
    glCallList(list);
    glCallList(list);
    glEndList();
    glCallList(list + 1);
    glTranslatef(40.25f, 10.5f, 0);
    glCallList(list + 1);
    glDeleteLists(list, 2);
}

void drawPixelScene(enum PixelScene scene, int parameter) {
    state = 12345u + (unsigned)parameter;
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    switch (scene) {
    case SCENE_POINTS: points(parameter); break;
    case SCENE_POINTS_AT_BORDERS: pointsAtBorders(); break;
    case SCENE_STAR: star(parameter); break;
    case SCENE_RANDOM_LINES: randomLines(parameter); break;
    case SCENE_STIPPLE: stipple(parameter); break;
    case SCENE_STRIP_AND_LOOP: stripAndLoop(); break;
    case SCENE_SHADED_LINES: shadedLines(); break;
    case SCENE_CUBE_EDGES: cubeEdges(); break;
    case SCENE_SPHERE_EDGES: sphereEdges(); break;
    case SCENE_EDGE_FLAGS: edgeFlags(); break;
    case SCENE_FACE_MODES: faceModes(); break;
    case SCENE_POLYGON_POINTS: polygonPoints(); break;
    case SCENE_CLIP_PLANE: clipPlane(); break;
    case SCENE_NEAR_PLANE: nearPlane(); break;
    case SCENE_BITMAPS: bitmaps(); break;
    case SCENE_DRAW_PIXELS: drawPixels(parameter); break;
    case SCENE_FOGGED_LIT_LINES: foggedLitLines(); break;
    case SCENE_ORDER: order(); break;
    case SCENE_LISTS: lists(); break;
    }
}
