/* SPDX-License-Identifier: MIT */
/* A small picture in floats, seen along -z through the square from -1 to 1. */
#ifndef OPENRT_TESTS_API_PICTURE_H
#define OPENRT_TESTS_API_PICTURE_H

#include <math.h>
#include <string.h>

#include "openrt/rt.h"

enum { PICTURE_SIZE = 16 };
static float picture[PICTURE_SIZE][PICTURE_SIZE][4]; /* row, column, RGBA */

/* A fresh context that draws into the picture, on one thread. */
static inline void startPicture(void) {
    rtInit(NULL, NULL);
    rtThreads(1);
    memset(picture, 0, sizeof picture);
    rtSetFrameBuffer((RTubyte *)picture, PICTURE_SIZE, PICTURE_SIZE, RT_RGBA_32F);
    rtMatrixMode(RT_PROJECTION);
    rtOrtho(-1, 1, -1, 1, -10, 10);
    rtMatrixMode(RT_MODELVIEW);
}

/* A square that covers the part of the view from (x0, y0) to (x1, y1), facing the viewer. */
static inline void square(float x0, float y0, float x1, float y1, float z) {
    rtBegin(RT_QUADS);
    rtVertex3f(x0, y0, z);
    rtVertex3f(x1, y0, z);
    rtVertex3f(x1, y1, z);
    rtVertex3f(x0, y1, z);
    rtEnd();
}

/* The pixel at a point of the view. */
static inline const float *at(float x, float y) {
    return picture[(int)((y + 1) * 0.5f * PICTURE_SIZE)][(int)((x + 1) * 0.5f * PICTURE_SIZE)];
}

static inline int isColor(const float *pixel, float r, float g, float b) {
    const float e = 1e-5f;
    return fabsf(pixel[0] - r) < e && fabsf(pixel[1] - g) < e && fabsf(pixel[2] - b) < e;
}

#endif
