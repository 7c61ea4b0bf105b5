/* SPDX-License-Identifier: MIT */
/* The smallest program: one triangle with a colour at each vertex, as loose geometry. */
#include <stdlib.h>

#include "openrt/rt.h"
#include "samples/common/refuse_options.h"
#include "samples/common/write_png.h"

enum { kWidth = 640, kHeight = 480 };

int main(int argc, char *argv[]) {
    RTubyte *pixels = malloc(4 * kWidth * kHeight);
    RTenum error;
    int written = 0;
    if (!pixels) return 1;

    rtInit(&argc, argv);
    refuseOptions(argc, argv, "01_triangle [FILE]");
    rtSetFrameBuffer(pixels, kWidth, kHeight, RT_RGBA_8);
    rtClearColor(0.1f, 0.1f, 0.15f, 1.0f);
    rtSamples(16);

    rtMatrixMode(RT_PROJECTION);
    rtPerspective(45.0, (double)kWidth / kHeight, 0.1, 100.0);
    rtMatrixMode(RT_MODELVIEW);
    rtLookAt(0.0, 0.0, 4.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0);

    rtBegin(RT_TRIANGLES);
    rtColor3f(1.0f, 0.2f, 0.1f);
    rtVertex3f(-1.2f, -1.0f, 0.0f);
    rtColor3f(0.1f, 1.0f, 0.2f);
    rtVertex3f(1.2f, -1.0f, 0.0f);
    rtColor3f(0.1f, 0.3f, 1.0f);
    rtVertex3f(0.0f, 1.2f, 0.0f);
    rtEnd();
    rtRender();

    error = rtGetError();
    if (error != RT_NO_ERROR)
        fprintf(stderr, "01_triangle: %s\n", rtGetErrorText());
    else
        written = writePng(argc > 1 ? argv[1] : "01_triangle.png", pixels, kWidth, kHeight);
    rtExit();
    free(pixels);
    return written ? 0 : 1;
}
