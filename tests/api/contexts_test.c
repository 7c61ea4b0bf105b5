/* SPDX-License-Identifier: MIT */
/* Contexts: independent of each other, current per thread. */
#include <pthread.h>
#include <string.h>

#include "check.h"

enum { kThreads = 4, kSize = 32 };

static RTcontext shared;
static int otherThreadRefused, otherThreadHadNone;

static void *useShared(void *unused) {
    (void)unused;
    otherThreadHadNone = rtGetCurrentContext() == NULL && rtGetError() == RT_INVALID_OPERATION;
    otherThreadRefused = rtMakeCurrent(shared) == RT_FALSE;
    return NULL;
}

typedef struct Drawing {
    float shade;
    RTubyte pixels[kSize * kSize * 4];
    RTuint handle, firstObject;
    RTenum error;
} Drawing;

/* One thread: its own context, its own picture. */
static void *draw(void *argument) {
    Drawing *drawing = argument;
    const RTcontext context = rtCreateContext();
    int i;
    rtMakeCurrent(context);
    rtThreads(2);
    rtSetFrameBuffer(drawing->pixels, kSize, kSize, RT_RGBA_8);
    drawing->firstObject = rtNewObject(RT_DEFINE);
    rtBegin(RT_QUADS);
    rtVertex3f(-1, -1, 0);
    rtVertex3f(1, -1, 0);
    rtVertex3f(1, 1, 0);
    rtVertex3f(-1, 1, 0);
    rtEnd();
    rtEndObject();
    for (i = 0; i < 10; ++i) {
        rtColor3f(drawing->shade, drawing->shade, drawing->shade);
        rtInstantiateObject(drawing->firstObject);
        rtRender();
    }
    rtInstantiateObject(drawing->firstObject);
    drawing->handle = rtCompileScene();
    drawing->error = rtGetError();
    rtDestroyContext(context);
    if (rtGetCurrentContext() != NULL) drawing->error = RT_INVALID;
    return NULL;
}

/* A thread that ends with its context current, a frame in flight. */
static void *abandon(void *argument) {
    RTubyte *pixels = argument;
    rtMakeCurrent(rtCreateContext());
    rtSetFrameBuffer(pixels, kSize, kSize, RT_RGBA_8);
    rtStartRendering();
    return NULL;
}

int main(void) {
    pthread_t thread, threads[kThreads];
    static Drawing drawings[kThreads];
    static RTubyte abandoned[kSize * kSize * 4];
    RTcontext first, second;
    RTfloat color[4];
    int i;

    first = rtCreateContext();
    second = rtCreateContext();
    CHECK(first && second && first != second);
    CHECK(rtGetCurrentContext() == NULL);
    CHECK(rtMakeCurrent(first) == RT_TRUE && rtGetCurrentContext() == first);
    CHECK(rtMakeCurrent(first) == RT_TRUE);

    /* State and errors belong to one context. */
    rtColor3f(0.5f, 0, 0);
    rtEnd();
    CHECK(rtMakeCurrent(second) == RT_TRUE);
    CHECK_ERROR(RT_NO_ERROR);
    rtGetFloatv(RT_CURRENT_COLOR, color);
    CHECK(color[0] == 1);
    CHECK(rtMakeCurrent(first) == RT_TRUE);
    CHECK_ERROR(RT_INVALID_OPERATION);
    rtGetFloatv(RT_CURRENT_COLOR, color);
    CHECK(color[0] == 0.5f);

    /* A context is current on one thread at a time. */
    shared = first;
    pthread_create(&thread, NULL, useShared, NULL);
    pthread_join(thread, NULL);
    CHECK(otherThreadRefused && otherThreadHadNone);
    CHECK_ERROR(RT_NO_ERROR);

    /* Unknown contexts are refused; the current one stays. */
    CHECK(rtMakeCurrent((RTcontext)(size_t)123456) == RT_FALSE);
    CHECK_ERROR(RT_INVALID_VALUE);
    CHECK(rtGetCurrentContext() == first);
    rtDestroyContext((RTcontext)(size_t)123456);
    CHECK_ERROR(RT_INVALID_VALUE);
    rtDestroyContext(NULL);
    CHECK_ERROR(RT_NO_ERROR);
    rtDestroyContext(second);
    rtDestroyContext(second);
    CHECK_ERROR(RT_INVALID_VALUE);
    CHECK(rtMakeCurrent(NULL) == RT_TRUE && rtGetCurrentContext() == NULL);
    rtDestroyContext(first);
    CHECK(rtMakeCurrent(first) == RT_FALSE);

    /* Several at once. */
    for (i = 0; i < kThreads; ++i) {
        drawings[i].shade = (float)(i + 1) / kThreads;
        pthread_create(&threads[i], NULL, draw, &drawings[i]);
    }
    for (i = 0; i < kThreads; ++i) pthread_join(threads[i], NULL);
    for (i = 0; i < kThreads; ++i) {
        const RTubyte expected = (RTubyte)(drawings[i].shade * 255 + 0.5f);
        int k, wrong = 0, j;
        for (k = 0; k < kSize * kSize; ++k) wrong += drawings[i].pixels[4 * k] != expected;
        CHECK(wrong == 0);
        CHECK(drawings[i].error == RT_NO_ERROR);
        CHECK(drawings[i].firstObject == 1); /* ids count in each context */
        for (j = 0; j < i; ++j) CHECK(drawings[i].handle != drawings[j].handle);
    }

    /* Query handles outlive their contexts, and need none. */
    {
        const RTray ray = {{0.5f, 0.25f, 5}, 0, {0, 0, -1}, 100};
        RThit hit;
        CHECK(rtGetCurrentContext() == NULL);
        rtIntersect(drawings[0].handle, &ray, &hit, 1, RT_INCOHERENT);
        CHECK(hit.object == 1 && hit.t == 5);
        rtReleaseScene(drawings[0].handle);
        hit.t = -1;
        rtIntersect(drawings[0].handle, &ray, &hit, 1, RT_INCOHERENT);
        CHECK(hit.t == -1); /* unknown now: no effect */
    }

    pthread_create(&thread, NULL, abandon, abandoned);
    pthread_join(thread, NULL);

    /* rtExit ends what other calls left. */
    first = rtCreateContext();
    rtMakeCurrent(first);
    rtExit();
    CHECK(rtGetCurrentContext() == NULL && rtMakeCurrent(first) == RT_FALSE);
    return failureCount;
}
