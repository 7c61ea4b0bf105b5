/* SPDX-License-Identifier: MIT */
/* Clearing, layers and reading back: what is called when, and what is refused. */
#include <stdint.h>
#include <stdlib.h>

#include "check.h"
#include "picture.h"

static void red(void) { rtColor3f(1, 0, 0); }
static void green(void) { rtColor3f(0, 1, 0); }

static RTint64 statistic(RTenum name) {
    RTint64 value = -1;
    rtGetInteger64v(name, &value);
    return value;
}

/* The pixel as it is read back in floats. */
static void readAt(float x, float y, float *rgba) {
    rtReadPixels((RTint)((x + 1) * 0.5f * PICTURE_SIZE), (RTint)((y + 1) * 0.5f * PICTURE_SIZE), 1,
                 1, RT_RGBA, RT_FLOAT, rgba);
}

static void testClears(void) {
    startPicture();
    rtClearColor(0.25f, 0.5f, 0.75f, 1);
    rtRender(); /* without rtClear too */
    CHECK(isColor(at(0, 0), 0.25f, 0.5f, 0.75f));

    rtClear(RT_COLOR_BUFFER_BIT);
    red();
    square(-1, -1, 0, 1, 0);
    rtClear(RT_COLOR_BUFFER_BIT | RT_DEPTH_BUFFER_BIT); /* forgets it */
    green();
    square(0, -1, 1, 1, 0);
    rtRender();
    CHECK(isColor(at(-0.5f, 0), 0.25f, 0.5f, 0.75f));
    CHECK(isColor(at(0.5f, 0), 0, 1, 0));
    CHECK(statistic(RT_STAT_INSTANCES) == 1);

    red();
    square(-1, -1, 0, 1, 0);
    rtClear(RT_DEPTH_BUFFER_BIT);
    rtClear(RT_COLOR_BUFFER_BIT); /* both together do as well */
    rtRender();
    CHECK(isColor(at(-0.5f, 0), 0.25f, 0.5f, 0.75f));
    CHECK(statistic(RT_STAT_INSTANCES) == 0);

    red();
    square(-1, -1, 0, 1, 0);
    rtClearColor(0, 0, 1, 1);
    rtEnable(RT_SCISSOR_TEST);
    rtScissor(4, 4, 4, 4);
    rtClear(RT_COLOR_BUFFER_BIT);
    rtDisable(RT_SCISSOR_TEST);
    rtRender();
    CHECK(isColor(at(-0.25f, -0.25f), 0, 0, 1));
    CHECK(isColor(at(-0.75f, -0.75f), 1, 0, 0));
    CHECK(isColor(at(0.75f, 0.75f), 0, 0, 1)); /* the frame's clear colour */

    rtClear(0);
    rtClear(RT_STENCIL_BUFFER_BIT | RT_ACCUM_BUFFER_BIT);
    CHECK_ERROR(RT_NO_ERROR);
    rtClear(1u << 31);
    CHECK_ERROR(RT_INVALID_VALUE);
    rtBegin(RT_TRIANGLES);
    rtClear(RT_COLOR_BUFFER_BIT);
    rtEnd();
    CHECK_ERROR(RT_INVALID_OPERATION);
    rtNewObject(RT_DEFINE);
    rtClear(RT_COLOR_BUFFER_BIT);
    CHECK_ERROR(RT_INVALID_OPERATION);
    rtScissor(0, 0, 1, 1);
    CHECK_ERROR(RT_INVALID_OPERATION);
    rtDepthRange(0, 1);
    CHECK_ERROR(RT_INVALID_OPERATION);
    rtReadPixels(0, 0, 1, 1, RT_RGBA, RT_FLOAT, picture);
    CHECK_ERROR(RT_INVALID_OPERATION);
    rtEndObject();
    rtExit();
}

/* What a layer takes from the state when it begins. */
static void testLayers(void) {
    startPicture();
    red();
    square(-1, -1, 1, 1, -5);
    rtViewport(0, 0, 8, 16);
    green();
    square(-1, -1, 1, 1, 0);
    rtViewport(0, 0, 16, 16); /* changed and back: still two layers */
    rtMatrixMode(RT_PROJECTION);
    rtPushMatrix();
    rtTranslatef(0, 1, 0);
    rtMatrixMode(RT_MODELVIEW);
    rtColor3f(0, 0, 1);
    square(-1, -1, 1, 1, 5);
    rtMatrixMode(RT_PROJECTION);
    rtPopMatrix();
    rtMatrixMode(RT_MODELVIEW);
    rtFinish();
    CHECK_ERROR(RT_NO_ERROR);
    CHECK(isColor(at(-0.5f, -0.5f), 0, 1, 0));
    CHECK(isColor(at(0.5f, -0.5f), 1, 0, 0));
    CHECK(isColor(at(0.5f, 0.5f), 0, 0, 1));
    CHECK(statistic(RT_STAT_INSTANCES) == 3);

    /* Queries see all of them, numbered in the order of submission. */
    const RTuint scene = rtCompileScene();
    const RTray ray = {{0.5f, 0.5f, -2}, 0, {0, 0, 1}, 10};
    RThit hit;
    rtIntersect(scene, &ray, &hit, 1, RT_INCOHERENT);
    CHECK(hit.instance == 1 && hit.t == 2);
    rtReleaseScene(scene);

    RTuint ids[PICTURE_SIZE][PICTURE_SIZE];
    rtSetAuxBuffer(RT_INSTANCE_ID, ids, RT_UNSIGNED_INT);
    rtRender();
    CHECK(ids[4][4] == 1 && ids[4][12] == 0 && ids[12][12] == 2);
    rtSetAuxBuffer(RT_INSTANCE_ID, NULL, RT_UNSIGNED_INT);

    /* An empty layer takes what holds when its first primitive comes; a frame without any, what
     * holds at its end. */
    rtViewport(0, 0, 4, 4);
    rtBegin(RT_TRIANGLES);
    rtEnd();
    rtViewport(0, 0, 16, 16);
    red();
    square(-1, -1, 1, 1, 0);
    rtRender();
    CHECK(isColor(at(0.5f, 0.5f), 1, 0, 0));
    CHECK(statistic(RT_STAT_INSTANCES) == 1);
    rtExit();
}

static void testReadingBack(void) {
    float rgba[4], depth[2];
    startPicture();
    rtEnable(RT_DEPTH_TEST);
    rtClearColor(0, 0, 0.5f, 1);
    rtClear(RT_COLOR_BUFFER_BIT | RT_DEPTH_BUFFER_BIT);
    red();
    square(-1, -1, 0, 1, 0);
    readAt(-0.5f, 0, rgba);
    CHECK(isColor(rgba, 1, 0, 0));
    const RTint64 rays = statistic(RT_STAT_PRIMARY_RAYS);
    readAt(0.5f, 0, rgba);
    CHECK(isColor(rgba, 0, 0, 0.5f));
    CHECK(statistic(RT_STAT_PRIMARY_RAYS) == rays);
    /* Nothing new: the memory is read, not rendered again. */
    picture[8][4][1] = 0.125f;
    readAt(-0.5f, 0, rgba);
    CHECK(rgba[1] == 0.125f);

    green(); /* the scene stayed open */
    square(0, 0, 1, 1, 0);
    readAt(0.5f, 0.5f, rgba);
    CHECK(isColor(rgba, 0, 1, 0));
    readAt(-0.5f, 0.5f, rgba);
    CHECK(isColor(rgba, 1, 0, 0));
    rtReadPixels(3, 3, 1, 1, RT_DEPTH_COMPONENT, RT_FLOAT, depth);
    rtReadPixels(12, 3, 1, 1, RT_DEPTH_COMPONENT, RT_FLOAT, depth + 1);
    CHECK(fabsf(depth[0] - 0.5f) < 1e-6f && depth[1] == 1.0f);
    rtRender();
    readAt(0.5f, 0.5f, rgba); /* the frame that has ended */
    CHECK(isColor(rgba, 0, 1, 0));
    rtReadPixels(3, 3, 1, 1, RT_DEPTH_COMPONENT, RT_FLOAT, depth);
    CHECK(fabsf(depth[0] - 0.5f) < 1e-6f);
    CHECK_ERROR(RT_NO_ERROR);
    rtExit();

    startPicture(); /* depth that nobody asked for in time */
    square(-1, -1, 1, 1, 0);
    rtRender();
    rtReadPixels(3, 3, 1, 1, RT_DEPTH_COMPONENT, RT_FLOAT, depth);
    CHECK_ERROR(RT_INVALID_OPERATION);
    square(-1, -1, 1, 1, 0);
    rtRender();
    rtReadPixels(3, 3, 1, 1, RT_DEPTH_COMPONENT, RT_FLOAT, depth);
    CHECK_ERROR(RT_NO_ERROR);
    CHECK(fabsf(depth[0] - 0.5f) < 1e-6f);
    rtExit();
}

/* The library's own memory, where the application gave none. */
static void testOwnMemory(void) {
    unsigned char rgb[4 * 4 * 3];
    rtInit(NULL, NULL);
    rtThreads(1);
    rtReadPixels(0, 0, 4, 4, RT_RGB, RT_UNSIGNED_BYTE, rgb);
    CHECK_ERROR(RT_INVALID_OPERATION);
    rtViewport(0, 0, 4, 4);
    rtClearColor(1, 0.5f, 0, 1);
    rtClear(RT_COLOR_BUFFER_BIT);
    rtPixelStorei(RT_PACK_ALIGNMENT, 1);
    rtReadPixels(0, 0, 4, 4, RT_RGB, RT_UNSIGNED_BYTE, rgb);
    CHECK_ERROR(RT_NO_ERROR);
    for (int i = 0; i < 16; ++i)
        CHECK(rgb[3 * i] == 255 && rgb[3 * i + 1] == 128 && rgb[3 * i + 2] == 0);
    rtRender();
    CHECK_ERROR(RT_INVALID_OPERATION); /* for frames of its own it is not */
    rtExit();
}

static void testFormats(void) {
    unsigned char bytes[64], swapped[64];
    uint16_t shorts[8];
    uint32_t ints[8];
    int8_t low[4];
    startPicture();
    rtClearColor(0.2f, 0.4f, 0.6f, 0.8f);
    rtClear(RT_COLOR_BUFFER_BIT);
    rtReadPixels(0, 0, 1, 1, RT_BGRA, RT_UNSIGNED_BYTE, bytes);
    CHECK(bytes[0] == 153 && bytes[1] == 102 && bytes[2] == 51 && bytes[3] == 204);
    rtReadPixels(0, 0, 1, 1, RT_LUMINANCE_ALPHA, RT_UNSIGNED_BYTE, bytes);
    CHECK(bytes[0] == 255 && bytes[1] == 204); /* the sum, limited */
    rtReadPixels(0, 0, 1, 1, RT_BLUE, RT_UNSIGNED_SHORT, shorts);
    CHECK(shorts[0] == 39321);
    rtReadPixels(0, 0, 1, 1, RT_RGB, RT_UNSIGNED_INT, ints);
    CHECK(ints[0] > 858993400u && ints[0] < 858993600u);
    rtReadPixels(0, 0, 1, 1, RT_RGBA, RT_BYTE, low);
    CHECK(low[0] == 25 && low[1] == 51 && low[3] == 102);
    rtReadPixels(0, 0, 1, 1, RT_RGB, RT_UNSIGNED_SHORT_5_6_5, shorts);
    CHECK(shorts[0] == (6 << 11 | 25 << 5 | 19));
    rtReadPixels(0, 0, 1, 1, RT_RGB, RT_UNSIGNED_SHORT_5_6_5_REV, shorts);
    CHECK(shorts[0] == (19 << 11 | 25 << 5 | 6));
    rtReadPixels(0, 0, 1, 1, RT_RGBA, RT_UNSIGNED_INT_8_8_8_8, ints);
    CHECK(ints[0] == 0x336699CCu);
    rtReadPixels(0, 0, 1, 1, RT_BGRA, RT_UNSIGNED_INT_8_8_8_8_REV, ints);
    CHECK(ints[0] == 0xCC336699u);
    rtReadPixels(0, 0, 1, 1, RT_RGBA, RT_UNSIGNED_SHORT_1_5_5_5_REV, shorts);
    CHECK(shorts[0] == (1 << 15 | 19 << 10 | 12 << 5 | 6));

    /* Where rows go, and what lies outside of the frame buffer. */
    memset(bytes, 7, sizeof bytes);
    rtPixelStorei(RT_PACK_ALIGNMENT, 4);
    rtReadPixels(PICTURE_SIZE - 1, PICTURE_SIZE - 2, 3, 4, RT_RED, RT_UNSIGNED_BYTE, bytes);
    CHECK(bytes[0] == 51 && bytes[1] == 7 && bytes[4] == 51 && bytes[8] == 7);
    memset(bytes, 7, sizeof bytes);
    rtReadPixels(-1, -1, 2, 2, RT_RED, RT_UNSIGNED_BYTE, bytes);
    CHECK(bytes[0] == 7 && bytes[4] == 7 && bytes[5] == 51);
    memset(bytes, 7, sizeof bytes);
    rtPixelStorei(RT_PACK_ROW_LENGTH, 5);
    rtPixelStorei(RT_PACK_SKIP_ROWS, 1);
    rtPixelStorei(RT_PACK_SKIP_PIXELS, 2);
    rtReadPixels(0, 0, 2, 2, RT_RED, RT_UNSIGNED_BYTE, bytes);
    for (int i = 0; i < 24; ++i)
        CHECK(bytes[i] == (i == 10 || i == 11 || i == 18 || i == 19 ? 51 : 7));
    rtPixelStorei(RT_PACK_ROW_LENGTH, 0);
    rtPixelStorei(RT_PACK_SKIP_ROWS, 0);
    rtPixelStorei(RT_PACK_SKIP_PIXELS, 0);
    rtReadPixels(0, 0, 1, 1, RT_RGBA, RT_FLOAT, bytes);
    rtPixelStorei(RT_PACK_SWAP_BYTES, 1);
    rtReadPixels(0, 0, 1, 1, RT_RGBA, RT_FLOAT, swapped);
    for (int i = 0; i < 16; ++i) CHECK(bytes[i] == swapped[i / 4 * 4 + 3 - i % 4]);
    CHECK_ERROR(RT_NO_ERROR);

    rtReadPixels(0, 0, 1, 1, RT_RGBA, RT_FLOAT, NULL);
    CHECK_ERROR(RT_INVALID_VALUE);
    rtReadPixels(0, 0, -1, 1, RT_RGBA, RT_FLOAT, bytes);
    CHECK_ERROR(RT_INVALID_VALUE);
    rtReadPixels(0, 0, 0, 1, RT_RGBA, RT_FLOAT, NULL);
    CHECK_ERROR(RT_NO_ERROR);
    rtReadPixels(0, 0, 1, 1, RT_TRIANGLES, RT_FLOAT, bytes);
    CHECK_ERROR(RT_INVALID_ENUM);
    rtReadPixels(0, 0, 1, 1, RT_RGBA, RT_TRIANGLES, bytes);
    CHECK_ERROR(RT_INVALID_ENUM);
    rtReadPixels(0, 0, 1, 1, RT_RGBA, RT_BITMAP, bytes);
    CHECK_ERROR(RT_INVALID_ENUM);
    rtReadPixels(0, 0, 1, 1, RT_STENCIL_INDEX, RT_FLOAT, bytes);
    CHECK_ERROR(RT_INVALID_OPERATION);
    rtReadPixels(0, 0, 1, 1, RT_RGBA, RT_UNSIGNED_SHORT_5_6_5, shorts);
    CHECK_ERROR(RT_INVALID_OPERATION);
    rtExit();
}

static void testState(void) {
    RTint values[4];
    RTdouble range[2];
    startPicture();
    rtGetIntegerv(RT_SCISSOR_BOX, values);
    CHECK(values[0] == 0 && values[1] == 0 && values[2] == 16 && values[3] == 16);
    rtScissor(-3, 2, 5, 7);
    rtGetIntegerv(RT_SCISSOR_BOX, values);
    CHECK(values[0] == -3 && values[1] == 2 && values[2] == 5 && values[3] == 7);
    rtScissor(0, 0, -1, 7);
    CHECK_ERROR(RT_INVALID_VALUE);
    rtDepthRange(-1, 0.25);
    rtGetDoublev(RT_DEPTH_RANGE, range);
    CHECK(range[0] == 0 && range[1] == 0.25);
    rtClearDepth(7);
    rtGetDoublev(RT_DEPTH_CLEAR_VALUE, range);
    CHECK(range[0] == 1);
    rtGetIntegerv(RT_DRAW_BUFFER, values);
    CHECK(values[0] == RT_BACK);
    rtDrawBuffer(RT_NONE);
    rtGetIntegerv(RT_DRAW_BUFFER, values);
    CHECK(values[0] == RT_NONE);
    rtDrawBuffer(RT_FRONT_AND_BACK);
    rtReadBuffer(RT_FRONT);
    rtGetIntegerv(RT_READ_BUFFER, values);
    CHECK(values[0] == RT_FRONT);
    CHECK_ERROR(RT_NO_ERROR);
    rtReadBuffer(RT_NONE);
    CHECK_ERROR(RT_INVALID_ENUM);
    rtDrawBuffer(RT_RIGHT);
    CHECK_ERROR(RT_INVALID_OPERATION);
    rtDrawBuffer(RT_AUX1);
    CHECK_ERROR(RT_INVALID_OPERATION);
    rtDrawBuffer(RT_TRIANGLES);
    CHECK_ERROR(RT_INVALID_ENUM);
    rtPixelStorei(RT_PACK_ALIGNMENT, 2);
    rtGetIntegerv(RT_PACK_ALIGNMENT, values);
    rtGetIntegerv(RT_UNPACK_ALIGNMENT, values + 1);
    CHECK(values[0] == 2 && values[1] == 4);
    rtPixelStorei(RT_PACK_ALIGNMENT, 3);
    CHECK_ERROR(RT_INVALID_VALUE);
    rtExit();
}

static void testCopiedPixels(void) {
    float rgba[4];
    startPicture();
    rtClearColor(0, 0, 0, 1);
    rtClear(RT_COLOR_BUFFER_BIT | RT_DEPTH_BUFFER_BIT);
    red();
    square(-1, -1, -0.5f, -0.5f, 0);
    rtWindowPos2i(8, 8);
    rtCopyPixels(0, 0, 4, 4, RT_COLOR);
    readAt(0.25f, 0.25f, rgba);
    CHECK(isColor(rgba, 1, 0, 0));
    readAt(0.75f, 0.75f, rgba);
    CHECK(isColor(rgba, 0, 0, 0));
    CHECK_ERROR(RT_NO_ERROR);
    rtCopyPixels(0, 0, 4, 4, RT_DEPTH);
    CHECK_ERROR(RT_INVALID_OPERATION);
    rtCopyPixels(0, 0, 4, 4, RT_TRIANGLES);
    CHECK_ERROR(RT_INVALID_ENUM);
    rtCopyPixels(0, 0, 4, -4, RT_COLOR);
    CHECK_ERROR(RT_INVALID_VALUE);
    rtCopyTexImage2D(RT_TEXTURE_2D, 0, RT_RGB, 0, 0, 4, 4, 2);
    CHECK_ERROR(RT_INVALID_VALUE);
    rtCopyTexImage2D(RT_TEXTURE_2D, 0, 3, 0, 0, 4, 4, 0);
    CHECK_ERROR(RT_INVALID_ENUM);
    rtCopyTexImage2D(RT_TRIANGLES, 0, RT_RGB, 0, 0, 4, 4, 0);
    CHECK_ERROR(RT_INVALID_ENUM);
    rtCopyTexSubImage2D(RT_TEXTURE_2D, 0, 0, 0, 0, 0, 4, 4);
    CHECK_ERROR(RT_INVALID_OPERATION); /* the texture has no image */
    rtExit();
}

/* Scenes have layers of their own. */
static void testScenes(void) {
    startPicture();
    const RTuint other = rtGenScene();
    red();
    square(-1, -1, 0, 1, 0);
    rtBindScene(other);
    rtClear(RT_COLOR_BUFFER_BIT | RT_DEPTH_BUFFER_BIT);
    green();
    square(0, -1, 1, 1, 0);
    rtBindScene(0);
    rtViewport(0, 0, 16, 8);
    rtColor3f(0, 0, 1);
    square(-1, -1, 1, 1, 0);
    rtRender();
    CHECK(isColor(at(-0.5f, 0.5f), 1, 0, 0));
    CHECK(isColor(at(0.5f, 0.5f), 0, 0, 0));
    CHECK(isColor(at(0.5f, -0.5f), 0, 0, 1));
    rtBindScene(other);
    rtRender();
    CHECK(isColor(at(-0.5f, 0), 0, 0, 0));
    CHECK(isColor(at(0.5f, 0), 0, 1, 0));
    rtExit();
}

int main(void) {
    testClears();
    testLayers();
    testReadingBack();
    testOwnMemory();
    testFormats();
    testState();
    testCopiedPixels();
    testScenes();
    return failureCount != 0;
}
