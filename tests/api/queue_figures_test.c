/* SPDX-License-Identifier: MIT */
/* The queue of frames in figures: how busy it keeps the threads, by the library's own counts and by
 * the system's; how soon a cancelled frame ends; memory of frames, while they live and afterwards.
 *
 *     queue_figures_test [frames]     how many frames in constant memory, 1000 without
 *     queue_figures_test times        what only a machine without other work can tell */
#define _DEFAULT_SOURCE
#include <dirent.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "check.h"
#include "picture.h"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
enum { kSanitized = 1 };
#else
enum { kSanitized = 0 };
#endif

enum { kEdge = 160, kInFlight = 4, kThreads = 2 };

static RTubyte pixels[kInFlight][kEdge * kEdge * 4];

static void pause_(long microseconds) {
    const struct timespec t = {microseconds / 1000000, microseconds % 1000000 * 1000};
    nanosleep(&t, NULL);
}

/* A frame of `samples` rays a pixel that costs the application next to nothing. */
static RTuint queueFrame(int i, RTuint samples) {
    rtSetFrameBuffer(pixels[i % kInFlight], kEdge, kEdge, RT_RGBA_8);
    rtSamples(samples);
    square(-0.75f, -0.75f, 0.75f, 0.75f, 0);
    return rtQueueFrame();
}

static void startFigures(void) {
    startPicture();
    rtThreads(kThreads);
    rtFrameDepth(kInFlight);
}

typedef struct Times {
    double busy, idle; /* seconds, by the library */
    double system;     /* on a processor or waiting for one, by the system; 0: it does not tell */
} Times;

static void addFrame(RTuint frame, Times *times) {
    RTint64 busy = -1, idle = -1;
    CHECK(rtWaitFrame(frame) == RT_TRUE);
    rtGetInteger64v(RT_STAT_BUSY_MICROSECONDS, &busy);
    rtGetInteger64v(RT_STAT_IDLE_MICROSECONDS, &idle);
    CHECK(busy >= 0 && idle >= 0);
    times->busy += 1e-6 * (double)busy;
    times->idle += 1e-6 * (double)idle;
}

/* Of all threads of the library so far. */
static double systemSeconds(void) {
    DIR *const folder = opendir("/proc/self/task");
    double sum = 0;
    const struct dirent *entry;
    while (folder && (entry = readdir(folder)) != NULL) {
        char path[300], name[32] = "";
        unsigned long long running = 0, waiting = 0;
        FILE *file;
        snprintf(path, sizeof path, "/proc/self/task/%s/comm", entry->d_name);
        if ((file = fopen(path, "r")) != NULL) {
            if (!fgets(name, sizeof name, file)) name[0] = 0;
            fclose(file);
        }
        if (strncmp(name, "openrt-", 7) != 0) continue;
        snprintf(path, sizeof path, "/proc/self/task/%s/schedstat", entry->d_name);
        if ((file = fopen(path, "r")) != NULL) {
            if (fscanf(file, "%llu %llu", &running, &waiting) == 2)
                sum += 1e-9 * ((double)running + (double)waiting);
            fclose(file);
        }
    }
    if (folder) closedir(folder);
    return sum;
}

/* Of an application that keeps the queue full, or waits for each frame and then pauses. */
static Times timesOf(int frames, long pause) {
    RTuint queued[kInFlight] = {0};
    Times times = {0, 0, 0};
    double before;
    int i;
    startFigures();
    rtWaitFrame(queueFrame(0, 1)); /* starts the threads */
    before = systemSeconds();
    for (i = 0; pause && i < frames; ++i) {
        pause_(pause);
        addFrame(queueFrame(i, 4), &times);
    }
    for (i = 0; !pause && i < frames + kInFlight; ++i) {
        if (i >= kInFlight) addFrame(queued[i % kInFlight], &times);
        if (i < frames) queued[i % kInFlight] = queueFrame(i, 8);
    }
    times.system = before > 0 ? systemSeconds() - before : 0;
    CHECK_ERROR(RT_NO_ERROR);
    return times;
}

static double share(double part, double rest) {
    return part / (part + rest);
}

/* Others may want the processors, so the best of several attempts counts. */
static void workersAreBusyBetweenQueuedFrames(void) {
    double idle = 1, off = 1;
    int attempt;
    for (attempt = 0; attempt < 12 && (idle >= 0.01 || off >= 0.05); ++attempt) {
        const Times times = timesOf(kSanitized ? 8 : 20, 0);
        idle = fmin(idle, share(times.idle, times.busy));
        if (times.system == 0) off = 0;
        /* The idle time before the first of the frames was not on a processor. */
        off = fmin(off, fabs(times.system - times.busy) / times.busy);
    }
    if (idle >= 0.01) fprintf(stderr, "idle: %.2f %%\n", 100 * idle);
    if (off >= 0.05) fprintf(stderr, "off the system's count: %.2f %%\n", 100 * off);
    CHECK(idle < 0.01);
    CHECK(off < 0.05);
}

/* The control: an application that lets the queue run dry is seen. */
static Times waitingIsSeen(void) {
    const Times times = timesOf(6, 60000);
    CHECK(times.idle > 6 * 0.05); /* of one thread alone, even */
    return times;
}

/* By the system's count too. */
static void waitingIsNotWork(void) {
    const Times times = waitingIsSeen();
    CHECK(times.system == 0 || times.system < times.busy + 0.5 * times.idle);
}

/* ---- Cancelling ------------------------------------------------------------------------- */

static int delivered;

static void RTAPIENTRY countTiles(RTuint frame, RTenum event, RTint x, RTint y, RTsizei w,
                                  RTsizei h, void *user) {
    (void)frame, (void)x, (void)y, (void)w, (void)h, (void)user;
    if (event == RT_FRAME_PROGRESS) __atomic_fetch_add(&delivered, 1, __ATOMIC_SEQ_CST);
}

/* After rtCancelFrame each thread ends the tile that it has, and no more. */
static void aCancelledFrameEndsWithinATile(void) {
    enum { kTiles = kEdge / 32 * (kEdge / 32) };
    int round, early = 0;
    startFigures();
    rtSetFrameCallback(countTiles, NULL);
    for (round = 0; round < 20; ++round) {
        RTuint frame, behind;
        int before;
        __atomic_store_n(&delivered, 0, __ATOMIC_SEQ_CST);
        frame = queueFrame(0, 256);
        pause_(500 * round);
        rtCancelFrame(frame);
        before = __atomic_load_n(&delivered, __ATOMIC_SEQ_CST);
        rtWaitFrame(frame);
        CHECK(__atomic_load_n(&delivered, __ATOMIC_SEQ_CST) - before <= kThreads);
        if (rtFrameStatus(frame) == RT_CANCELLED) {
            ++early;
            CHECK(__atomic_load_n(&delivered, __ATOMIC_SEQ_CST) < kTiles);
        }
        CHECK(rtFrameProgress(frame) == 1);
        behind = queueFrame(1, 1); /* and the queue goes on */
        CHECK(rtWaitFrame(behind) == RT_TRUE);
    }
    CHECK(early > 0); /* the control: some were cancelled before their end */
    CHECK_ERROR(RT_NO_ERROR);
}

/* ---- Memory ----------------------------------------------------------------------------- */

enum { kSlack = 4096 }; /* which tree an object of few triangles has depends on the rays it got */

static RTint64 bytesHeld(void) {
    RTint64 bytes = 0;
    rtGetInteger64v(RT_STAT_BYTES, &bytes);
    return bytes;
}

static RTuint defineSquare(void) {
    const RTuint object = rtNewObject(RT_DEFINE);
    square(-1, -1, 1, 1, 0);
    rtEndObject();
    return object;
}

static void instantiate(RTuint object, int count) {
    int i;
    rtPushMatrix();
    for (i = 0; i < count; ++i) {
        rtTranslatef(0.001f, 0, 0.001f);
        rtInstantiateObject(object);
    }
    rtPopMatrix();
}

/* Each frame in flight holds the tree over its instances; when it has ended nothing is left. */
static void aFrameCostsMemoryWhileItLives(void) {
    enum { kInstances = 1000 };
    RTint64 before, held[kInFlight];
    RTuint frames[kInFlight], object;
    int i;
    startFigures();
    object = defineSquare();
    instantiate(object, kInstances);
    rtSetFrameBuffer(pixels[0], kEdge, kEdge, RT_RGBA_8);
    rtRender(); /* what the object keeps once it was seen is there */
    before = bytesHeld();
    for (i = 0; i < kInFlight; ++i) {
        rtSetFrameBuffer(pixels[0], kEdge, kEdge, RT_RGBA_8); /* the same: one after the other */
        rtSamples(64);
        instantiate(object, kInstances);
        frames[i] = rtQueueFrame();
        held[i] = bytesHeld();
    }
    if (rtFrameStatus(frames[0]) == RT_RENDERING || rtFrameStatus(frames[0]) == RT_QUEUED) {
        for (i = 0; i < kInFlight; ++i)
            CHECK(held[i] >= before + (i + 1) * (RTint64)kInstances * 32);
    }
    for (i = 0; i < kInFlight; ++i) rtCancelFrame(frames[i]);
    for (i = 0; i < kInFlight; ++i) rtWaitFrame(frames[i]);
    CHECK(bytesHeld() <= before + kSlack);
    CHECK_ERROR(RT_NO_ERROR);
}

static long residentPages(void) {
    long size = 0, resident = 0;
    FILE *const file = fopen("/proc/self/statm", "r");
    if (!file) return 0;
    if (fscanf(file, "%ld %ld", &size, &resident) != 2) resident = 0;
    fclose(file);
    return resident;
}

/* Frames in which everything changes: instances, an object's shape, its positions, a texture. */
static void changeEverything(RTuint object, RTuint updated, RTuint texture, int frame) {
    static RTubyte texels[32 * 32 * 4];
    const float y = 0.5f + 0.4f * (float)(frame % 7) / 7;
    const float positions[4][3] = {{-1, -1, 0}, {1, -1, 0}, {1, y, 0}, {-1, y, 0}};
    rtReplaceObject(object);
    square(-0.5f, -0.5f, y, y, 0);
    square(-y, -y, 0, 0, 0.1f);
    rtEndObject();
    rtUpdateObject(updated, 0, 4, positions[0]);
    memset(texels, frame, sizeof texels);
    rtBindTexture(RT_TEXTURE_2D, texture);
    rtTexImage2D(RT_TEXTURE_2D, 0, RT_RGBA, 32, 32, 0, RT_RGBA, RT_UNSIGNED_BYTE, texels);
    instantiate(object, 20 + frame % 10);
    instantiate(updated, 3);
}

static void framesInConstantMemory(int frames) {
    RTuint queued[kInFlight] = {0}, object, updated, texture;
    RTint64 bytes = 0;
    long pages = 0, grown;
    int i;
    startFigures();
    object = defineSquare();
    updated = defineSquare();
    rtGenTextures(1, &texture);
    for (i = 0; i < frames; ++i) {
        if (queued[i % kInFlight]) rtWaitFrame(queued[i % kInFlight]);
        rtSetFrameBuffer(pixels[i % kInFlight], 16, 16, RT_RGBA_8);
        changeEverything(object, updated, texture, i);
        queued[i % kInFlight] = rtQueueFrame();
        if (i % 9 == 4) rtCancelFrame(queued[i % kInFlight]);
        if (i == frames / 4) {
            rtFinish();
            bytes = bytesHeld();
            pages = residentPages();
        }
    }
    rtFinish();
    CHECK(bytesHeld() <= bytes + kSlack);
    grown = (residentPages() - pages) * sysconf(_SC_PAGESIZE);
    if (!kSanitized && grown > (1 << 20)) fprintf(stderr, "grown by %ld bytes\n", grown);
    CHECK(kSanitized || grown <= 1 << 20);
    CHECK_ERROR(RT_NO_ERROR);
}

int main(int argc, char **argv) {
    const int frames = argc > 1 ? atoi(argv[1]) : kSanitized ? 200 : 1000;
    if (argc > 1 && strcmp(argv[1], "times") == 0) {
        workersAreBusyBetweenQueuedFrames();
        waitingIsNotWork();
        rtExit();
        return failureCount;
    }
    waitingIsSeen();
    aCancelledFrameEndsWithinATile();
    aFrameCostsMemoryWhileItLives();
    framesInConstantMemory(frames);
    rtExit();
    return failureCount;
}
