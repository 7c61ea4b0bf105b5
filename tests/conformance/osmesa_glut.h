/* SPDX-License-Identifier: MIT */
/* The options of the off-screen GLUT driver and what it tells about a run.
 *
 *   --rt-offscreen N      renders N frames and ends the program (required)
 *   --rt-output PATTERN   each frame as PNG; PATTERN holds one %d conversion, frame%03d.png
 *   --rt-depth PATTERN    each frame's window depth as PFM, float, row 0 at the bottom
 *   --rt-variant DX,DY    each frame once more, moved by a part of a pixel; the files of variant k
 *                         (from 1) get .vK before the extension; may be repeated
 *   --rt-split first      quads split along the first and third vertex where GL_SMOOTH is set,
 *                         instead of the second and fourth
 *   --rt-buffer float     a frame buffer of floats, in which blending rounds nothing to 8 bits
 *   --rt-report FILE      JSON: renderer, version, clear colour, milliseconds of each frame
 *   -geometry WxH         the size of the window, as GLUT has it
 *
 * Frame n is drawn at kFrameMilliseconds * n: due timers are called in order of time, the idle
 * callback once, then the display callback. */
#ifndef OPENRT_CONFORMANCE_OSMESA_GLUT_H
#define OPENRT_CONFORMANCE_OSMESA_GLUT_H

#include <stdio.h>

enum { kMaxVariants = 16, kFrameMilliseconds = 40 };

typedef struct {
    float x, y;
} PixelShift;

typedef struct {
    int frames;
    const char *output, *depth, *report;
    PixelShift shifts[kMaxVariants + 1]; /* shifts[0] is none */
    int variants;                        /* how many of shifts besides the first */
    int splitFirst, floatBuffer;
    int width, height; /* 0: not given */
} DriverOptions;

/* Takes the driver's options out of the command line; wrong ones end the program with a text. */
void takeDriverOptions(int* argc, char** argv, DriverOptions* options);

/* The file of a frame and a variant; 0: the name would not fit. */
int frameFile(char* path, size_t size, const char* pattern, int frame, int variant);

/* 0: not written, and a line says why. Row 0 is the lowest. */
int writeDepth(const char* path, const float* depth, int width, int height);

#endif
