/* SPDX-License-Identifier: MIT */
/* A program with a window that calls librtut alone, which finds libOpenRT by itself. */
#include <openrt/rtut.h>

static void display(void) {
    rtutSolidTeapot(1);
    rtutSwapBuffers();
}

int main(int argc, char *argv[]) {
    rtutInit(&argc, argv);
    rtutInitDisplayMode(RTUT_DOUBLE);
    rtutCreateWindow("teapot");
    rtutDisplayFunc(display);
    rtutMainLoop();
    return 0;
}
