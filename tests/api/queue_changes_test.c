/* SPDX-License-Identifier: MIT */
/* Changing what queued frames use: updates and removals while they are in flight, wrong updates,
 * ids of other contexts. Frames show what was there when they were queued, and nothing is lost. */
#define _DEFAULT_SOURCE
#include <pthread.h>
#include <stdlib.h>
#include <time.h>

#include "check.h"
#include "picture.h"

enum { kFrames = 12, kCells = 12, kVertices = 2 * kCells * (kCells + 1) };

typedef float Picture[PICTURE_SIZE][PICTURE_SIZE][4];

static void pause_(long microseconds) {
    const struct timespec t = {microseconds / 1000000, microseconds % 1000000 * 1000};
    nanosleep(&t, NULL);
}

/* A sheet whose shape is that of a state; vertices as its strips take them. */
static void sheetVertices(int state, float *xyz) {
    int row, column, i;
    for (row = 0; row < kCells; ++row) {
        for (column = 0; column <= kCells; ++column) {
            for (i = 0; i < 2; ++i) {
                const float x = 1.6f * ((float)column / kCells - 0.5f);
                const float y = 1.6f * ((float)(row + i) / kCells - 0.5f);
                *xyz++ = x * (1 + 0.2f * sinf((float)state + 3 * y));
                *xyz++ = y * (1 - 0.05f * (float)(state % 5));
                *xyz++ = 0.3f * cosf((float)state * 2 + 5 * x);
            }
        }
    }
}

static RTuint defineSheet(int state) {
    static float xyz[3 * kVertices];
    const RTuint object = rtNewObject(RT_DEFINE);
    int i;
    sheetVertices(state, xyz);
    for (i = 0; i < kVertices; ++i) {
        const int inRow = i % (2 * (kCells + 1));
        if (inRow == 0) rtBegin(RT_QUAD_STRIP);
        rtColor3f((float)(i % 5) / 5, (float)(i % 7) / 7, 0.5f);
        rtVertex3fv(xyz + 3 * i);
        if (inRow == 2 * kCells + 1) rtEnd();
    }
    rtEndObject();
    return object;
}

static int same(Picture a, Picture b) {
    return memcmp(a, b, sizeof(Picture)) == 0;
}

/* One object, updated for each frame while earlier frames are rendered, against an object of its
 * own for each frame, rendered alone. */
static void framesInFlightKeepTheirPositions(void) {
    static Picture alone[kFrames], together[kFrames];
    static float xyz[3 * kVertices];
    RTuint frames[kFrames], sheet;
    int i, different = 0;
    startPicture();
    for (i = 0; i < kFrames; ++i) {
        rtSetFrameBuffer((RTubyte *)alone[i], PICTURE_SIZE, PICTURE_SIZE, RT_RGBA_32F);
        rtInstantiateObject(defineSheet(i));
        rtRender();
        if (i > 0) different += !same(alone[i], alone[i - 1]);
    }
    CHECK(different == kFrames - 1); /* the control: the states do differ */
    CHECK_ERROR(RT_NO_ERROR);
    startPicture();
    rtThreads(2);
    rtFrameDepth(5);
    sheet = defineSheet(99);
    for (i = 0; i < kFrames; ++i) {
        sheetVertices(i, xyz);
        rtUpdateObject(sheet, 0, kVertices, xyz);
        rtSetFrameBuffer((RTubyte *)together[i], PICTURE_SIZE, PICTURE_SIZE, RT_RGBA_32F);
        rtInstantiateObject(sheet);
        frames[i] = rtQueueFrame();
        memset(xyz, 0, sizeof xyz); /* the memory is the application's again */
        rtUpdateObject(sheet, 0, kVertices, xyz);
    }
    rtRemoveObject(sheet);
    CHECK_ERROR(RT_NO_ERROR);
    for (i = kFrames - 1; i >= 0; --i) {
        CHECK(rtWaitFrame(frames[i]) == RT_TRUE);
        CHECK(same(alone[i], together[i]));
    }
    CHECK_ERROR(RT_NO_ERROR);
}

/* An object that is wrongly updated is what it was, in frames in flight and in those to come. */
static void wrongUpdatesChangeNothing(void) {
    static Picture before, after, later;
    static float xyz[3 * kVertices];
    RTuint sheet, frame, removed;
    startPicture();
    sheet = defineSheet(3);
    removed = defineSheet(4);
    rtSetFrameBuffer((RTubyte *)before, PICTURE_SIZE, PICTURE_SIZE, RT_RGBA_32F);
    rtInstantiateObject(sheet);
    rtRender();
    rtSetFrameBuffer((RTubyte *)after, PICTURE_SIZE, PICTURE_SIZE, RT_RGBA_32F);
    rtInstantiateObject(sheet);
    frame = rtQueueFrame();
    rtUpdateObject(sheet, 0, kVertices + 1, xyz);
    CHECK_ERROR(RT_INVALID_VALUE);
    rtUpdateObject(sheet, kVertices, 1, xyz);
    CHECK_ERROR(RT_INVALID_VALUE);
    rtUpdateObject(sheet, 0xFFFFFFFFu, 2, xyz); /* wraps around */
    CHECK_ERROR(RT_INVALID_VALUE);
    rtUpdateObject(sheet, 0, -1, xyz);
    CHECK_ERROR(RT_INVALID_VALUE);
    rtUpdateObject(sheet, 0, 1, NULL);
    CHECK_ERROR(RT_INVALID_VALUE);
    rtRemoveObject(removed);
    rtUpdateObject(removed, 0, 1, xyz);
    CHECK_ERROR(RT_INVALID_VALUE);
    rtInstantiateObject(removed);
    CHECK_ERROR(RT_INVALID_VALUE);
    rtRemoveObject(removed);
    CHECK_ERROR(RT_INVALID_VALUE);
    CHECK(rtWaitFrame(frame) == RT_TRUE && rtWaitFrame(frame) == RT_TRUE);
    CHECK(same(before, after));
    rtSetFrameBuffer((RTubyte *)later, PICTURE_SIZE, PICTURE_SIZE, RT_RGBA_32F);
    rtInstantiateObject(sheet);
    rtRender();
    CHECK(same(before, later));
    CHECK_ERROR(RT_NO_ERROR);
}

/* Vertices that are not a number take their triangles away until they are numbers again. */
static void positionsThatAreNoNumbers(void) {
    static Picture before, without, after;
    static float xyz[3 * kVertices];
    RTuint sheet;
    int i;
    startPicture();
    sheet = defineSheet(3);
    rtSetFrameBuffer((RTubyte *)before, PICTURE_SIZE, PICTURE_SIZE, RT_RGBA_32F);
    rtInstantiateObject(sheet);
    rtRender();
    for (i = 0; i < 3 * kVertices; ++i) xyz[i] = i % 2 ? NAN : INFINITY;
    rtUpdateObject(sheet, 0, kVertices, xyz);
    rtSetFrameBuffer((RTubyte *)without, PICTURE_SIZE, PICTURE_SIZE, RT_RGBA_32F);
    rtInstantiateObject(sheet);
    rtRender();
    CHECK(isColor(without[8][8], 0, 0, 0) && !isColor(before[8][8], 0, 0, 0));
    sheetVertices(3, xyz);
    rtUpdateObject(sheet, 0, kVertices, xyz);
    rtSetFrameBuffer((RTubyte *)after, PICTURE_SIZE, PICTURE_SIZE, RT_RGBA_32F);
    rtInstantiateObject(sheet);
    rtRender();
    CHECK(same(before, after));
    CHECK_ERROR(RT_NO_ERROR);
}

/* What belongs to one context is unknown in another, and is not harmed there. */
static void idsOfOtherContexts(void) {
    static Picture before, after;
    const float origin[3] = {0, 0, 0};
    RTuint object, scene, frame, i;
    RTcontext first, second;
    startPicture();
    for (i = 0; i < 5; ++i) object = defineSheet((int)i);
    for (i = 0; i < 5; ++i) scene = rtGenScene();
    rtSetFrameBuffer((RTubyte *)before, PICTURE_SIZE, PICTURE_SIZE, RT_RGBA_32F);
    rtInstantiateObject(object);
    rtRender();
    first = rtGetCurrentContext();
    second = rtCreateContext();
    rtMakeCurrent(second);
    rtUpdateObject(object, 0, 1, origin);
    CHECK_ERROR(RT_INVALID_VALUE);
    rtReplaceObject(object);
    CHECK_ERROR(RT_INVALID_VALUE);
    rtRemoveObject(object);
    CHECK_ERROR(RT_INVALID_VALUE);
    rtBindScene(scene);
    CHECK_ERROR(RT_INVALID_VALUE);
    rtDeleteScene(scene);
    CHECK_ERROR(RT_INVALID_VALUE);
    rtMakeCurrent(first);
    rtBindScene(scene);
    rtSetFrameBuffer((RTubyte *)after, PICTURE_SIZE, PICTURE_SIZE, RT_RGBA_32F);
    rtInstantiateObject(object);
    frame = rtQueueFrame();
    rtMakeCurrent(second); /* ids of frames are known everywhere */
    CHECK(rtWaitFrame(frame) == RT_TRUE && rtFrameProgress(frame) == 1);
    rtCancelFrame(frame);
    CHECK(rtFrameStatus(frame) == RT_DONE);
    rtDestroyContext(second);
    rtMakeCurrent(first);
    CHECK(same(before, after));
    CHECK_ERROR(RT_NO_ERROR);
}

/* A frame callback may not change anything: the first call that does is the frame's error. */
static RTuint sheetOfCallback;

static void RTAPIENTRY update(RTuint frame, RTenum event, RTint x, RTint y, RTsizei w, RTsizei h,
                              void *user) {
    const float origin[3] = {0, 0, 0};
    (void)frame, (void)event, (void)x, (void)y, (void)w, (void)h, (void)user;
    rtUpdateObject(sheetOfCallback, 0, 1, origin);
    rtRemoveObject(sheetOfCallback);
}

static void callbacksChangeNothing(void) {
    static Picture before, after;
    RTuint frame;
    startPicture();
    sheetOfCallback = defineSheet(1);
    rtSetFrameBuffer((RTubyte *)before, PICTURE_SIZE, PICTURE_SIZE, RT_RGBA_32F);
    rtInstantiateObject(sheetOfCallback);
    rtSetFrameCallback(update, NULL);
    frame = rtQueueFrame();
    CHECK(rtWaitFrame(frame) == RT_TRUE);
    CHECK_ERROR(RT_INVALID_OPERATION);
    rtSetFrameCallback(NULL, NULL);
    rtSetFrameBuffer((RTubyte *)after, PICTURE_SIZE, PICTURE_SIZE, RT_RGBA_32F);
    rtInstantiateObject(sheetOfCallback);
    rtRender();
    CHECK(same(before, after));
    CHECK_ERROR(RT_NO_ERROR);
}

/* Another thread cancels at random while this one updates, queues and removes. */
static RTuint newest;
static int leaving;

static void *cancelAtRandom(void *unused) {
    unsigned random = 7;
    (void)unused;
    while (!__atomic_load_n(&leaving, __ATOMIC_ACQUIRE)) {
        const RTuint frame = __atomic_load_n(&newest, __ATOMIC_ACQUIRE);
        random = random * 1664525u + 1013904223u;
        if (frame && random >> 31) rtCancelFrame(frame);
        pause_(random >> 8 & 255);
    }
    return NULL;
}

static void cancellingWhileEverythingChanges(void) {
    enum { kRounds = 150, kMemories = 4 };
    static float memory[kMemories][40 * 40][4];
    static float xyz[3 * kVertices];
    RTuint frames[kMemories] = {0}, sheet;
    pthread_t thread;
    int i, done = 0, cancelled = 0;
    startPicture();
    rtThreads(2);
    rtFrameDepth(3);
    sheet = defineSheet(0);
    pthread_create(&thread, NULL, cancelAtRandom, NULL);
    for (i = 0; i < kRounds; ++i) {
        RTuint *const frame = &frames[i % kMemories];
        if (*frame) {
            const RTboolean isDone = rtWaitFrame(*frame);
            CHECK(rtFrameStatus(*frame) == (isDone ? RT_DONE : RT_CANCELLED));
            isDone ? ++done : ++cancelled;
        }
        if (i % 8 == 7) {
            rtRemoveObject(sheet);
            sheet = defineSheet(i);
        }
        sheetVertices(i, xyz);
        rtUpdateObject(sheet, 0, kVertices, xyz);
        rtSetFrameBuffer((RTubyte *)memory[i % kMemories], 40, 40, RT_RGBA_32F);
        rtInstantiateObject(sheet);
        *frame = rtQueueFrame();
        __atomic_store_n(&newest, *frame, __ATOMIC_RELEASE);
    }
    __atomic_store_n(&leaving, 1, __ATOMIC_RELEASE);
    pthread_join(thread, NULL);
    rtFinish();
    CHECK(done > 0 && cancelled > 0); /* the control: both happen */
    CHECK_ERROR(RT_NO_ERROR);
}

int main(void) {
    framesInFlightKeepTheirPositions();
    wrongUpdatesChangeNothing();
    positionsThatAreNoNumbers();
    idsOfOtherContexts();
    callbacksChangeNothing();
    cancellingWhileEverythingChanges();
    rtExit();
    return failureCount;
}
