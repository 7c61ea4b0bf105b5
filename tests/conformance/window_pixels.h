/* SPDX-License-Identifier: MIT */
/* The window's pixels, and how a question program tells them. */
#ifndef OPENRT_CONFORMANCE_WINDOW_PIXELS_H
#define OPENRT_CONFORMANCE_WINDOW_PIXELS_H

#include "tests/conformance/questions.h"

static GLubyte window[kWindow][kWindow][3];

static inline void readWindow(void) {
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, kWindow, kWindow, GL_RGB, GL_UNSIGNED_BYTE, window);
}

static inline void clearBoth(void) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

static inline void tellLevel(int level) {
    if (kTellsAlternatives)
        printf("%d|%d|%d ", level, level + 1, level - 1);
    else
        printf("%d ", level);
}

static inline void tellPixel(int x, int y) {
    for (int k = 0; k < 3; ++k) tellLevel(window[y][x][k]);
    printf("\n");
}

#endif
