/* SPDX-License-Identifier: MIT */
/* What frame callbacks hear, on which threads, and that what they may not do does nothing. */
#include <pthread.h>
#include <stdlib.h>

#include "check.h"
#include "openrt/rts.h"
#include "picture.h"

enum { kSide = 100, kFrames = 12 };

static pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
static pthread_t applicationsThread;

typedef struct Heard {
    RTuint frame;
    int pixels, tiles, ends, wrong;
    RTenum end;
} Heard;
static Heard heard[256]; /* by frame id modulo the number */
static RTuint lastEnded;

static void note(RTuint frame, RTenum event, RTint x, RTint y, RTsizei w, RTsizei h, void *user) {
    Heard *const of = &heard[frame % 256];
    const RTenum status = rtFrameStatus(frame);
    const float progress = rtFrameProgress(frame);
    pthread_mutex_lock(&mutex);
    of->frame = frame;
    of->wrong += pthread_equal(pthread_self(), applicationsThread) || of->ends > 0;
    of->wrong += user != (void *)heard;
    if (event == RT_FRAME_PROGRESS) {
        ++of->tiles;
        of->pixels += w * h;
        of->wrong += x < 0 || y < 0 || w < 1 || h < 1 || x + w > kSide || y + h > kSide;
        of->wrong += status != RT_RENDERING || progress >= 1 || rtWaitFrame(frame) != RT_FALSE;
    } else {
        ++of->ends;
        of->end = event;
        of->wrong += x != 0 || y != 0 || w != kSide || h != kSide;
        of->wrong += status != event || progress != 1;
        of->wrong += rtWaitFrame(frame) != (event == RT_DONE);
        if (event == RT_DONE) {
            of->wrong += frame <= lastEnded;
            lastEnded = frame;
        }
    }
    pthread_mutex_unlock(&mutex);
}

static RTuint queueOne(RTubyte *pixels) {
    rtSetFrameBuffer(pixels, kSide, kSide, RT_RGBA_8);
    square(-1, -1, 1, 1, 0);
    return rtQueueFrame();
}

static void eventsOfFrames(void) {
    static RTubyte pixels[kFrames][kSide * kSide * 4];
    RTuint frames[kFrames];
    int i;
    startPicture();
    rtThreads(3);
    rtFrameDepth(4);
    memset(heard, 0, sizeof heard);
    lastEnded = 0;
    rtSetFrameCallback(note, heard);
    for (i = 0; i < kFrames; ++i) frames[i] = queueOne(pixels[i]);
    rtSetFrameCallback(NULL, NULL); /* frames keep the one they were queued with */
    for (i = 0; i < kFrames; ++i) {
        const Heard *of = &heard[frames[i] % 256];
        CHECK(rtWaitFrame(frames[i]) == RT_TRUE);
        CHECK(of->frame == frames[i] && of->wrong == 0);
        CHECK(of->pixels == kSide * kSide && of->tiles == 16);
        CHECK(of->ends == 1 && of->end == RT_DONE);
    }
    frames[0] = queueOne(pixels[0]);
    CHECK(rtWaitFrame(frames[0]) == RT_TRUE);
    CHECK(heard[frames[0] % 256].tiles == 0);

    /* Frames of the other calls are told of too. */
    rtSetFrameCallback(note, heard);
    square(-1, -1, 1, 1, 0);
    rtFinish();
    rtRender();
    for (i = 1; i < 3; ++i) {
        const Heard *of = &heard[(frames[0] + (RTuint)i) % 256];
        CHECK(of->pixels == kSide * kSide && of->end == RT_DONE && of->wrong == 0);
    }
    CHECK_ERROR(RT_NO_ERROR);
}

/* Cancels its own frame after some tiles; with it the next frame, which may not be queued yet. */
static RTuint cancelToo;
static void cancelAtThird(RTuint frame, RTenum event, RTint x, RTint y, RTsizei w, RTsizei h,
                          void *user) {
    int tiles;
    note(frame, event, x, y, w, h, user);
    pthread_mutex_lock(&mutex);
    tiles = heard[frame % 256].tiles;
    pthread_mutex_unlock(&mutex);
    if (event == RT_FRAME_PROGRESS && tiles >= 3) {
        rtCancelFrame(frame);
        rtCancelFrame(__atomic_load_n(&cancelToo, __ATOMIC_ACQUIRE));
    }
}

static void cancellingInACallback(void) {
    static RTubyte pixels[4][kSide * kSide * 4];
    int round, i;
    startPicture();
    rtThreads(2);
    rtFrameDepth(1); /* each rtQueueFrame waits for what the callback cancels */
    for (round = 0; round < 20; ++round) {
        RTuint frames[4];
        memset(heard, 0, sizeof heard);
        rtSetFrameCallback(cancelAtThird, heard);
        for (i = 0; i < 4; ++i) {
            frames[i] = queueOne(pixels[i]);
            __atomic_store_n(&cancelToo, frames[i], __ATOMIC_RELEASE);
        }
        for (i = 0; i < 4; ++i) {
            const Heard *of = &heard[frames[i] % 256];
            CHECK(rtWaitFrame(frames[i]) == RT_FALSE);
            CHECK(rtFrameStatus(frames[i]) == RT_CANCELLED);
            CHECK(of->ends == 1 && of->end == RT_CANCELLED && of->wrong == 0);
            CHECK(of->tiles < 16);
        }
    }
    /* A cancelled frame of rtStartRendering is waited for like any other. */
    rtSetFrameBuffer(pixels[0], kSide, kSide, RT_RGBA_8);
    rtRender();
    CHECK_ERROR(RT_NO_ERROR);
    rtSetFrameCallback(NULL, NULL);
    rtRender();
    CHECK_ERROR(RT_NO_ERROR);
}

/* Every kind of call that a callback may not make, one a frame. */
static RTcontext context;
static RTuint scene;
static int forbidden, survived;
static const char *const names[] = {"rtExit",         "rtInit",           "rtMakeCurrent",
                                    "rtCreateContext", "rtDestroyContext", "rtGetCurrentContext",
                                    "rtRender",       "rtQueueFrame",     "rtEndRendering",
                                    "rtThreads",      "rtIntersect",      "rtReleaseScene",
                                    "rtGetError",     "rtVertex3f",       "rtSetFrameCallback"};
enum { kForbidden = sizeof names / sizeof names[0] };

static void misbehave(RTuint frame, RTenum event, RTint x, RTint y, RTsizei w, RTsizei h,
                      void *user) {
    RTray ray = {{0, 0, 5}, 0, {0, 0, -1}, 100};
    RThit hit;
    (void)frame, (void)x, (void)y, (void)w, (void)h, (void)user;
    if (event != RT_DONE) return;
    hit.t = -1;
    switch (forbidden) {
    case 0: rtExit(); break;
    case 1: rtInit(NULL, NULL); break;
    case 2: CHECK(rtMakeCurrent(context) == RT_FALSE); break;
    case 3: CHECK(rtCreateContext() == NULL); break;
    case 4: rtDestroyContext(context); break;
    case 5: CHECK(rtGetCurrentContext() == NULL); break;
    case 6: rtRender(); break;
    case 7: CHECK(rtQueueFrame() == RT_INVALID); break;
    case 8: rtEndRendering(); break;
    case 9: rtThreads(1); break;
    case 10: rtIntersect(scene, &ray, &hit, 1, RT_COHERENT), CHECK(hit.t == -1); break;
    case 11: rtReleaseScene(scene); break;
    case 12: CHECK(rtGetError() == RT_INVALID_OPERATION); break;
    case 13: rtVertex3f(0, 0, 0); break;
    default: rtSetFrameCallback(NULL, NULL); break;
    }
    ++survived;
}

static void forbiddenCalls(void) {
    static RTubyte pixels[kSide * kSide * 4];
    startPicture();
    rtThreads(2);
    context = rtGetCurrentContext();
    scene = rtCompileScene();
    rtSetFrameCallback(misbehave, NULL);
    for (forbidden = 0; forbidden < kForbidden; ++forbidden) {
        const RTuint frame = queueOne(pixels);
        CHECK(rtWaitFrame(frame) == RT_TRUE);
        CHECK_ERROR(RT_INVALID_OPERATION);
        CHECK(strncmp(rtGetErrorText(), names[forbidden], strlen(names[forbidden])) == 0);
        CHECK(survived == forbidden + 1 && rtGetCurrentContext() == context);
        CHECK(rtWaitFrame(frame) == RT_TRUE);
        CHECK_ERROR(RT_NO_ERROR);
    }
    CHECK(pixels[0] == 255);
    rtReleaseScene(scene);
    CHECK_ERROR(RT_NO_ERROR); /* it was still there */
}

/* Shaders run on the same threads: they can neither end the library nor change contexts. */
static int construct(void *shader, void *triangle, void *vertex) {
    (void)shader, (void)triangle, (void)vertex;
    return 0;
}
static int endTheLibrary(const void *shader, struct RTSstate *state) {
    (void)shader;
    rtExit();
    rtInit(NULL, NULL);
    rtDestroyContext(context);
    rtMakeCurrent(context);
    rtRender();
    rtsResultColor(state, 0, rtGetCurrentContext() == NULL, 0);
    return 0;
}

static void shadersThatEndTheLibrary(void) {
    RTshaderclass ending = {0};
    startPicture();
    context = rtGetCurrentContext();
    ending.structSize = sizeof ending;
    ending.interfaceVersion = RTS_INTERFACE_VERSION;
    ending.kind = RT_SURFACE_SHADER;
    ending.name = "Ending";
    ending.alignment = 1;
    ending.construct = construct;
    ending.shade = endTheLibrary;
    rtRegisterShaderClass(&ending);
    rtGenNewShader();
    square(-1, -1, 1, 1, 0);
    CHECK(rtWaitFrame(rtQueueFrame()) == RT_TRUE);
    CHECK(isColor(at(0, 0), 0, 1, 0));
    CHECK(rtGetCurrentContext() == context);
    CHECK_ERROR(RT_NO_ERROR);
}

/* The callback of frames that are still queued when their context ends. */
static void endingWithFramesQueued(void) {
    static RTubyte pixels[6][kSide * kSide * 4];
    RTuint frames[6];
    int i;
    startPicture();
    memset(heard, 0, sizeof heard);
    lastEnded = 0;
    rtFrameDepth(6);
    rtSetFrameCallback(note, heard);
    for (i = 0; i < 6; ++i) frames[i] = queueOne(pixels[i]);
    rtExit();
    for (i = 0; i < 6; ++i) CHECK(heard[frames[i] % 256].ends == 1);
    for (i = 0; i < 6; ++i) CHECK(heard[frames[i] % 256].wrong == 0);
}

int main(void) {
    applicationsThread = pthread_self();
    rtSetFrameCallback(note, heard); /* no context */
    eventsOfFrames();
    cancellingInACallback();
    forbiddenCalls();
    shadersThatEndTheLibrary();
    endingWithFramesQueued();
    return failureCount;
}
