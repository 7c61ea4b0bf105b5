/* SPDX-License-Identifier: MIT */
/* Several views of one frozen moment: rtQueueView. */
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "openrt/rtu.h"

enum { kSize = 48, kEyes = 4 };

typedef struct View {
    float color[kSize * kSize][4], depth[kSize * kSize];
} View;

static void target(View *view) {
    rtSetFrameBuffer((RTubyte *)view->color, kSize, kSize, RT_RGBA_32F);
    rtSetAuxBuffer(RT_DEPTH, view->depth, RT_FLOAT);
}

/* A wall of a room, two units away; each eye sees it from elsewhere. */
static void look(int eye) {
    const RTdouble low[3] = {-1, -1, -2}, right[3] = {1, -1, -2}, up[3] = {-1, 1, -2};
    const RTdouble position[3] = {0.2 * eye - 0.3, 0.1 * eye, 0.5};
    rtuCameraFromWall(low, right, up, position);
}

static void describe(float at, RTuint object) {
    rtMatrixMode(RT_MODELVIEW);
    rtLoadIdentity();
    rtTranslatef(at, 0, -4);
    rtInstantiateObject(object);
    rtColor3f(0.2f, 0.4f, at);
    rtBegin(RT_TRIANGLES);
    rtVertex3f(-3, -1, -3);
    rtVertex3f(3, -1, -3);
    rtVertex3f(0, 2, -3);
    rtEnd();
}

static RTuint makeObject(float red) {
    const RTuint object = rtNewObject(RT_DEFINE);
    rtColor3f(red, 1, 0.5f);
    rtBegin(RT_QUADS);
    rtVertex3f(-1, -1, 0);
    rtVertex3f(1, -1, 0.5f);
    rtVertex3f(1, 1, 0);
    rtVertex3f(-1, 1, -0.5f);
    rtEnd();
    rtEndObject();
    return object;
}

/* All eyes see what the first saw, whatever has changed since. */
static void testSameMoment(void) {
    static View expected[kEyes], seen[kEyes];
    RTuint frames[kEyes], object;
    int eye;
    rtInit(NULL, NULL);
    rtThreads(2);
    rtFrameDepth(kEyes + 1);
    object = makeObject(1);
    for (eye = 0; eye < kEyes; ++eye) {
        target(&expected[eye]);
        look(eye);
        describe(0.5f, object);
        rtRender();
    }
    CHECK_ERROR(RT_NO_ERROR);

    target(&seen[0]);
    look(0);
    describe(0.5f, object);
    frames[0] = rtQueueFrame();
    rtReplaceObject(object); /* for frames to come */
    rtEndObject();
    rtClearColor(1, 1, 1, 1);
    describe(-1, object);
    for (eye = 1; eye < kEyes; ++eye) {
        target(&seen[eye]);
        look(eye);
        frames[eye] = rtQueueView();
    }
    CHECK_ERROR(RT_NO_ERROR);
    for (eye = 0; eye < kEyes; ++eye) {
        CHECK(rtWaitFrame(frames[eye]));
        CHECK(memcmp(&expected[eye], &seen[eye], sizeof(View)) == 0);
        CHECK(eye == 0 || memcmp(seen[0].color, seen[eye].color, sizeof seen[0].color) != 0);
    }
    /* What was described between the views is in the frame after them. */
    {
        static View next, empty;
        target(&next);
        look(0);
        rtRender();
        CHECK(memcmp(next.color, seen[0].color, sizeof next.color) != 0);
        target(&empty);
        look(0);
        rtRender();
        CHECK(memcmp(next.color, empty.color, sizeof next.color) != 0);
    }
    CHECK_ERROR(RT_NO_ERROR);
    rtExit();
}

/* The size of the frame buffer is the view's own. */
static void testOtherSize(void) {
    static float large[2 * kSize * kSize][4], expected[2 * kSize * kSize][4];
    static View first;
    RTuint object;
    rtInit(NULL, NULL);
    object = makeObject(0.5f);
    rtSetFrameBuffer((RTubyte *)expected, 2 * kSize, kSize, RT_RGBA_32F);
    look(2);
    describe(0, object);
    rtRender();
    target(&first);
    look(1);
    describe(0, object);
    rtRender(); /* a frame of any kind may be seen again */
    rtSetAuxBuffer(RT_DEPTH, NULL, RT_FLOAT);
    rtSetFrameBuffer((RTubyte *)large, 2 * kSize, kSize, RT_RGBA_32F);
    look(2);
    CHECK(rtWaitFrame(rtQueueView()));
    CHECK(memcmp(large, expected, sizeof large) == 0);
    CHECK_ERROR(RT_NO_ERROR);
    rtExit();
}

static void testErrors(void) {
    static View view;
    RTuint object;
    rtInit(NULL, NULL);
    target(&view);
    look(0);
    CHECK(rtQueueView() == RT_INVALID); /* no frame before */
    CHECK_ERROR(RT_INVALID_OPERATION);
    object = makeObject(1);
    describe(0, object);
    rtRender();
    CHECK(rtQueueView() == RT_INVALID); /* its camera was used up */
    CHECK_ERROR(RT_INVALID_OPERATION);
    look(0);
    CHECK(rtWaitFrame(rtQueueView()));
    CHECK(rtQueueView() == RT_INVALID); /* and so was this one */
    CHECK_ERROR(RT_INVALID_OPERATION);
    look(0);
    rtSetFrameBuffer(NULL, 0, 0, RT_RGBA_32F);
    rtGetError();
    rtBegin(RT_TRIANGLES);
    CHECK(rtQueueView() == RT_INVALID);
    rtEnd();
    CHECK_ERROR(RT_INVALID_OPERATION);
    rtNewObject(RT_DEFINE);
    CHECK(rtQueueView() == RT_INVALID);
    CHECK_ERROR(RT_INVALID_OPERATION);
    rtEndObject();
    target(&view);
    CHECK(rtWaitFrame(rtQueueView())); /* the camera is still there */
    CHECK_ERROR(RT_NO_ERROR);
    describe(0, object);
    rtRender(); /* seen by the projection matrix: not kept */
    look(0);
    CHECK(rtQueueView() == RT_INVALID);
    CHECK_ERROR(RT_INVALID_OPERATION);
    rtExit();
}

int main(void) {
    testSameMoment();
    testOtherSize();
    testErrors();
    return failureCount != 0;
}
