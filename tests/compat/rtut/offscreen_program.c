/* SPDX-License-Identifier: MIT */
/* A program of the kind that gets ported, in C99: prints what is called, and when. Its argument
 * says what is special: "single", "idle", "silent" (never swaps), "leave", "two" windows, "huge",
 * "leftout", "close" (after the first frame), "restless" (timers without time). */
#include <openrt/rt.h>
#include <openrt/rtut.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *kind = "";
static int frame;

static int is(const char *name) { return strcmp(kind, name) == 0; }
static int now(void) { return rtutGet(RTUT_ELAPSED_TIME); }

static void onReshape(int width, int height) {
    printf("reshape %d %d\n", width, height);
    rtViewport(0, 0, width, height);
    rtMatrixMode(RT_PROJECTION);
    rtLoadIdentity();
    rtOrtho(0, 4, 0, 4, -1, 1);
    rtMatrixMode(RT_MODELVIEW);
}

/* Frame n shows a square in column n. */
static void onDisplay(void) {
    printf("display %d at %d in %d\n", frame, now(), rtutGetWindow());
    rtBegin(RT_QUADS);
    rtVertex2f((float)(frame % 4), 0.0f);
    rtVertex2f((float)(frame % 4 + 1), 0.0f);
    rtVertex2f((float)(frame % 4 + 1), 1.0f);
    rtVertex2f((float)(frame % 4), 1.0f);
    rtEnd();
    ++frame;
    if (is("leave")) rtutPostRedisplay();
    if (is("leave") && frame == 2) rtutLeaveMainLoop();
    if (!is("silent")) rtutSwapBuffers();
    if (is("close")) rtutDestroyWindow(rtutGetWindow());
}

static void onTimer(int value) {
    printf("timer %d at %d\n", value, now());
    if (value < 3) rtutTimerFunc(30, onTimer, value + 1);
}
/* Asks for itself again at once, and at 30 ms for a timer at 40 ms. */
static void onRestlessTimer(int value) {
    printf("restless %d at %d\n", value, now());
    if (value == 0) rtutTimerFunc(10, onRestlessTimer, -1);
    if (value >= 0) rtutTimerFunc(0, onRestlessTimer, value + 1);
}
static void onIdle(void) { printf("idle at %d\n", now()); }
static void onVisibility(int state) { printf("visibility %d\n", state); }

int main(int argc, char **argv) {
    rtutInit(&argc, argv);
    if (argc > 1) kind = argv[1];
    printf("arguments %d\n", argc - 1);
    rtutInitDisplayMode(RTUT_RGBA | RTUT_DEPTH | (is("single") ? RTUT_SINGLE : RTUT_DOUBLE));
    rtutInitWindowSize(16, 16);
    if (is("huge")) rtutInitWindowSize(1000000, 1000000);
    rtutCreateWindow("a window");
    rtClearColor(0.0f, 0.0f, 1.0f, 1.0f);
    rtutDisplayFunc(onDisplay);
    rtutReshapeFunc(onReshape);
    rtutVisibilityFunc(onVisibility);
    rtutTimerFunc(30, onTimer, 1);
    if (is("restless")) rtutTimerFunc(30, onRestlessTimer, 0);
    if (is("idle")) rtutIdleFunc(onIdle);
    if (is("two")) {
        rtutCreateWindow("another window");
        rtutDisplayFunc(onDisplay);
        rtutReshapeFunc(onReshape);
    }
    if (is("leftout")) {
        rtutCreateMenu(NULL);
        rtutCreateMenu(NULL);
        rtutAddMenuEntry("entry", 1);
        rtutEstablishOverlay();
        rtutSetColor(0, 0, 0, 0);
        rtutGet(12345);
        printf("text %s\n", rtutGetErrorText());
        rtutDestroyWindow(77);
        rtutSetWindow(-1);
        rtutPostWindowRedisplay(0);
        rtutTimerFunc(1, NULL, 0);
        rtutReshapeWindow(-1, 0);
    }
    rtutMainLoop();
    printf("left the loop\n");
    return 0;
}
