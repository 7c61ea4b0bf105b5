/* SPDX-License-Identifier: MIT */
/* What rtut says of itself, before, with and after a window off screen: GLUT 3.7's start values
 * and what the calls before made of them. */
#include <openrt/rtut.h>

#include "tests/api/check.h"

static void onDisplay(void) {}

static void withoutWindow(void) {
    CHECK(rtutGet(RTUT_INIT_WINDOW_X) == -1 && rtutGet(RTUT_INIT_WINDOW_Y) == -1);
    CHECK(rtutGet(RTUT_INIT_WINDOW_WIDTH) == 300 && rtutGet(RTUT_INIT_WINDOW_HEIGHT) == 300);
    CHECK(rtutGet(RTUT_INIT_DISPLAY_MODE) == (RTUT_RGBA | RTUT_SINGLE | RTUT_DEPTH));
    CHECK(rtutGet(RTUT_DISPLAY_MODE_POSSIBLE) == 1 && rtutGet(RTUT_MENU_NUM_ITEMS) == 0);
    CHECK(rtutGet(RTUT_WINDOW_WIDTH) == 0 && rtutGet(RTUT_WINDOW_RED_SIZE) == 0);
    CHECK(rtutGet(RTUT_SCREEN_WIDTH) > 0 && rtutGet(RTUT_SCREEN_HEIGHT_MM) > 0);
    CHECK(rtutGet(RTUT_ELAPSED_TIME) >= 0);
    CHECK(rtutGet(0xABCD) == -1 && rtutDeviceGet(0xABCD) == -1 && rtutLayerGet(0xABCD) == -1);
    CHECK(rtutGetModifiers() == 0);
}

static void withWindow(void) {
    CHECK(rtutGet(RTUT_WINDOW_WIDTH) == 64 && rtutGet(RTUT_WINDOW_HEIGHT) == 48);
    CHECK(rtutGet(RTUT_WINDOW_RED_SIZE) == 8 && rtutGet(RTUT_WINDOW_ALPHA_SIZE) == 8);
    CHECK(rtutGet(RTUT_WINDOW_BUFFER_SIZE) == 32 && rtutGet(RTUT_WINDOW_DEPTH_SIZE) == 24);
    CHECK(rtutGet(RTUT_WINDOW_DOUBLEBUFFER) == 1 && rtutGet(RTUT_WINDOW_RGBA) == 1);
    CHECK(rtutGet(RTUT_WINDOW_NUM_SAMPLES) == 4);
    CHECK(rtutGet(RTUT_WINDOW_STENCIL_SIZE) == 0 && rtutGet(RTUT_WINDOW_PARENT) == 0);
    rtutSetCursor(RTUT_CURSOR_HELP);
    CHECK(rtutGet(RTUT_WINDOW_CURSOR) == RTUT_CURSOR_HELP);
    CHECK(rtutLayerGet(RTUT_LAYER_IN_USE) == RTUT_NORMAL && !rtutLayerGet(RTUT_OVERLAY_POSSIBLE));
    rtutPostRedisplay();
    CHECK(rtutLayerGet(RTUT_NORMAL_DAMAGED) == 1);
    CHECK(rtutExtensionSupported("GL_ARB_multitexture"));
    CHECK(!rtutExtensionSupported("GL_ARB_multi") && !rtutExtensionSupported(NULL));
    CHECK_ERROR(RT_NO_ERROR);
    rtEnable(0xABCD);
    rtutReportErrors();
    CHECK_ERROR(RT_NO_ERROR);
}

/* Nothing can be typed or moved off screen. */
static void devices(void) {
    CHECK(!rtutDeviceGet(RTUT_HAS_KEYBOARD) && !rtutDeviceGet(RTUT_HAS_MOUSE));
    CHECK(rtutDeviceGet(RTUT_NUM_MOUSE_BUTTONS) == 0 && !rtutDeviceGet(RTUT_HAS_JOYSTICK));
    CHECK(rtutDeviceGet(RTUT_DEVICE_KEY_REPEAT) == RTUT_KEY_REPEAT_ON);
    rtutSetKeyRepeat(RTUT_KEY_REPEAT_OFF);
    CHECK(rtutDeviceGet(RTUT_DEVICE_KEY_REPEAT) == RTUT_KEY_REPEAT_OFF);
    CHECK(rtutDeviceGet(RTUT_DEVICE_IGNORE_KEY_REPEAT) == 0);
    rtutIgnoreKeyRepeat(1);
    CHECK(rtutDeviceGet(RTUT_DEVICE_IGNORE_KEY_REPEAT) == 1);
}

int main(void) {
    char *argv[] = {"queries", "--rt-offscreen", "1", NULL};
    int argc = 3;
    rtutInit(&argc, argv);
    CHECK(argc == 1);
    withoutWindow();
    rtutInitWindowSize(64, 48);
    rtutInitWindowPosition(7, 9);
    rtutInitDisplayMode(RTUT_DOUBLE | RTUT_RGBA | RTUT_DEPTH | RTUT_MULTISAMPLE);
    CHECK(rtutGet(RTUT_INIT_WINDOW_X) == 7 && rtutGet(RTUT_INIT_WINDOW_HEIGHT) == 48);
    const int window = rtutCreateWindow("queries");
    rtutDisplayFunc(onDisplay);
    CHECK(rtutGetWindow() == window);
    withWindow();
    devices();
    rtutDestroyWindow(window);
    CHECK(rtutGet(RTUT_WINDOW_WIDTH) == 0);
    return failureCount;
}
