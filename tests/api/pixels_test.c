/* SPDX-License-Identifier: MIT */
/* Points, lines, the raster position, bitmaps and rectangles of pixels: state, errors, and who sees
 * them. */
#include <math.h>
#include <string.h>

#include "check.h"

enum { SIDE = 32 };
static RTubyte picture[SIDE * SIDE * 4];

static const RTubyte *pixel(int x, int y) { return &picture[(y * SIDE + x) * 4]; }
static int drawnPixels(void) {
    int count = 0, i;
    for (i = 0; i < SIDE * SIDE; ++i) count += picture[4 * i] != 0;
    return count;
}

static void start(void) {
    rtMakeCurrent(rtCreateContext());
    rtSetFrameBuffer(picture, SIDE, SIDE, RT_RGBA_8);
    rtMatrixMode(RT_PROJECTION);
    rtOrtho(0, SIDE, 0, SIDE, -1, 1);
    rtMatrixMode(RT_MODELVIEW);
}
static void stop(void) {
    CHECK_ERROR(RT_NO_ERROR);
    rtDestroyContext(rtGetCurrentContext());
}

static int isAt(double x, double y, int valid) {
    RTdouble at[4];
    RTboolean isValid = 2;
    rtGetDoublev(RT_CURRENT_RASTER_POSITION, at);
    rtGetBooleanv(RT_CURRENT_RASTER_POSITION_VALID, &isValid);
    return fabs(at[0] - x) < 1e-6 && fabs(at[1] - y) < 1e-6 && isValid == valid;
}

static void rasterPosition(void) {
    const RTubyte bits[1] = {0x80};
    RTfloat color[4];
    start();
    CHECK(isAt(0, 0, RT_TRUE));
    rtColor3f(0.5f, 0.25f, 1);
    rtRasterPos2f(4, 5);
    CHECK(isAt(4, 5, RT_TRUE));
    rtColor3f(1, 1, 1);
    rtGetFloatv(RT_CURRENT_RASTER_COLOR, color);
    CHECK(color[0] == 0.5f && color[1] == 0.25f && color[2] == 1.0f && color[3] == 1.0f);
    rtBitmap(0, 0, 0, 0, 3.5f, -1, NULL);
    CHECK(isAt(7.5, 4, RT_TRUE));
    rtBitmap(8, 1, 0, 0, 1, 1, NULL);
    CHECK(isAt(8.5, 5, RT_TRUE));
    rtPushAttrib(RT_CURRENT_BIT);
    rtRasterPos2f(-1, 5); /* outside: nothing is drawn, nothing moves */
    CHECK(isAt(8.5, 5, RT_FALSE));
    rtBitmap(1, 1, -6, 0, 5, 5, bits);
    CHECK(isAt(8.5, 5, RT_FALSE));
    rtPopAttrib();
    CHECK(isAt(8.5, 5, RT_TRUE));
    rtWindowPos2i(-3, 4); /* valid wherever it is */
    CHECK(isAt(-3, 4, RT_TRUE));
    rtBitmap(1, 1, -6, 0, 0, 0, bits);
    rtRasterPos3f(NAN, 1, 0);
    CHECK(isAt(-3, 4, RT_FALSE));
    rtRasterPos4d(8, 6, 0, 2);
    CHECK(isAt(4, 3, RT_TRUE));
    rtRender();
    CHECK(drawnPixels() == 1 && pixel(3, 4)[0] == 255);
    stop();
}

static void errors(void) {
    const RTubyte bytes[64] = {0};
    RTuint object;
    start();
    rtBitmap(-1, 1, 0, 0, 0, 0, bytes);
    CHECK_ERROR(RT_INVALID_VALUE);
    rtDrawPixels(1, -1, RT_RGBA, RT_UNSIGNED_BYTE, bytes);
    CHECK_ERROR(RT_INVALID_VALUE);
    rtDrawPixels(1, 1, RT_RGBA, RT_UNSIGNED_BYTE, NULL);
    CHECK_ERROR(RT_INVALID_VALUE);
    rtDrawPixels(1, 1, RT_RGBA, 77, bytes);
    CHECK_ERROR(RT_INVALID_ENUM);
    rtDrawPixels(1, 1, 77, RT_UNSIGNED_BYTE, bytes);
    CHECK_ERROR(RT_INVALID_ENUM);
    rtDrawPixels(1, 1, RT_DEPTH_COMPONENT, RT_FLOAT, bytes);
    CHECK_ERROR(RT_INVALID_OPERATION);
    rtRasterPos3dv(NULL);
    CHECK_ERROR(RT_INVALID_VALUE);
    rtPixelZoom(INFINITY, 1);
    CHECK_ERROR(RT_INVALID_VALUE);
    rtPixelTransferf(RT_MAP_COLOR, 1);
    CHECK_ERROR(RT_INVALID_OPERATION);
    rtPixelTransferi(RT_ZOOM_X, 1);
    CHECK_ERROR(RT_INVALID_ENUM);
    rtBegin(RT_LINES);
    rtRasterPos2i(1, 1);
    CHECK_ERROR(RT_NO_ERROR); /* not told between begin and end, but not done either */
    rtEnd();
    CHECK_ERROR(RT_INVALID_OPERATION);
    CHECK(isAt(0, 0, RT_TRUE));
    object = rtNewObject(RT_DEFINE);
    rtBitmap(1, 1, 0, 0, 0, 0, bytes);
    CHECK_ERROR(RT_INVALID_OPERATION);
    rtWindowPos2i(1, 1);
    CHECK_ERROR(RT_INVALID_OPERATION);
    rtEndObject();
    rtRemoveObject(object);
    stop();
}

/* An object of lines alone, placed twice; rays do not meet it. */
static void objects(void) {
    RTuint object, scene;
    RTray ray = {{4.5f, 4.5f, 5}, 0, {0, 0, -1}, 100};
    RThit hit;
    start();
    object = rtNewObject(RT_DEFINE);
    rtBegin(RT_LINE_STRIP);
    rtColor3f(1, 0, 0);
    rtVertex2f(0.5f, 0.5f);
    rtVertex2f(8.5f, 0.5f);
    rtVertex2f(8.5f, 4.5f);
    rtEnd();
    rtEndObject();
    rtTranslatef(4, 4, 0);
    rtInstantiateObject(object);
    rtTranslatef(10, 10, 0);
    rtInstantiateObject(object);
    scene = rtCompileScene();
    rtIntersect(scene, &ray, &hit, 1, RT_INCOHERENT);
    CHECK(hit.object == RT_INVALID);
    rtReleaseScene(scene);
    rtRender();
    CHECK(drawnPixels() == 24);
    CHECK(pixel(4, 4)[0] == 255 && pixel(4, 4)[1] == 0 && pixel(12, 7)[0] == 255);
    CHECK(pixel(14, 14)[0] == 255 && pixel(22, 17)[0] == 255 && pixel(22, 18)[0] == 0);
    stop();
}

/* A triangle before and behind; the nearest is seen, in whatever order. */
static void depth(void) {
    start();
    rtBegin(RT_LINES);
    rtVertex3f(2.5f, 8.5f, 0);
    rtVertex3f(30.5f, 8.5f, 0);
    rtEnd();
    rtColor3f(0, 1, 0);
    rtBegin(RT_TRIANGLES);
    rtVertex3f(5, 2, 0.5f);
    rtVertex3f(15, 2, 0.5f);
    rtVertex3f(10, 30, 0.5f);
    rtVertex3f(20, 2, -0.5f);
    rtVertex3f(30, 2, -0.5f);
    rtVertex3f(25, 30, -0.5f);
    rtEnd();
    rtRender();
    CHECK(pixel(10, 8)[0] == 0 && pixel(10, 8)[1] == 255);
    CHECK(pixel(25, 8)[0] == 255 && pixel(25, 8)[1] == 255);
    CHECK(pixel(17, 8)[0] == 255);
    stop();
}

/* Half-covered pixels of a line are half as bright where samples are taken. */
static void samples(void) {
    int i, partly = 0;
    start();
    rtSamples(16);
    rtLineWidth(3);
    rtBegin(RT_LINES);
    rtVertex2f(2, 5);
    rtVertex2f(30, 21);
    rtEnd();
    rtRender();
    for (i = 0; i < SIDE * SIDE; ++i) partly += picture[4 * i] > 20 && picture[4 * i] < 235;
    CHECK(partly > 20);
    stop();
}

int main(void) {
    rasterPosition();
    errors();
    objects();
    depth();
    samples();
    return failureCount != 0;
}
