/* SPDX-License-Identifier: MIT */
/* Leaves the process in one of many ways, usually with frames in flight: leave WAY. Exit status 0
 * where the way allows one. */
#include <openrt/rt.h>

#include <pthread.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

enum { kSize = LEAVE_SIZE, kFrames = 3 };

static RTubyte pixels[kFrames][kSize * kSize * 4];

/* Large enough that frames are still under way when the program leaves. */
static void startFrames(void) {
    int frame, i;
    rtInit(NULL, NULL);
    rtThreads(2);
    rtSamples(16);
    rtFrameDepth(kFrames);
    for (frame = 0; frame < kFrames; ++frame) {
        rtSetFrameBuffer(pixels[frame], kSize, kSize, RT_RGBA_8);
        rtBegin(RT_TRIANGLES);
        for (i = 0; i < 300; ++i) {
            rtVertex3f(-1, -1, (float)i / 300);
            rtVertex3f(1, -1, (float)i / 300);
            rtVertex3f(0, 1, (float)i / 300);
        }
        rtEnd();
        rtQueueFrame();
    }
}

static void *exitThere(void *unused) {
    (void)unused;
    exit(0);
}
static void *leaveThread(void *unused) {
    startFrames();
    return unused; /* its context stays, current nowhere */
}
static void exitInCallback(RTuint frame, RTenum event, RTint x, RTint y, RTsizei w, RTsizei h,
                           void *user) {
    (void)frame, (void)event, (void)x, (void)y, (void)w, (void)h, (void)user;
    exit(0);
}
static void endAtExit(void) { rtExit(); }
static void renderAtExit(void) {
    rtInit(NULL, NULL);
    rtSetFrameBuffer(pixels[0], kSize, kSize, RT_RGBA_8);
    rtRender();
    rtWaitFrame(1);
    rtGetError();
    rtExit();
}
static void leaveOnSignal(int number) {
    (void)number;
    _exit(0);
}

/* What a child may do, and that nothing else harms it. */
static int child(const char *how) {
    if (strcmp(how, "exec") == 0) {
        execlp("true", "true", (char *)NULL);
        return 1;
    }
    if (strcmp(how, "use") == 0) {
        RTray ray = {{0, 0, 5}, 0, {0, 0, -1}, 100};
        RThit hit;
        rtVertex3f(0, 0, 0);
        if (rtGetError() != RT_INVALID_OPERATION) return 1;
        rtInit(NULL, NULL);
        if (rtGetCurrentContext() || rtCreateContext()) return 2;
        if (rtQueueFrame() != RT_INVALID || rtWaitFrame(1)) return 3;
        rtIntersect(1, &ray, &hit, 1, RT_INCOHERENT);
        rtRender();
        rtExit();
        if (rtGetError() != RT_INVALID_OPERATION) return 4;
        if (!strstr(rtGetErrorText(), "fork")) return 5;
    }
    exit(0); /* runs the library's end */
}
static int afterFork(const char *how) {
    int status = 1;
    pid_t process;
    startFrames();
    process = fork();
    if (process == 0) exit(child(how));
    if (waitpid(process, &status, 0) != process || status != 0) return 1;
    rtFinish(); /* the parent goes on */
    return rtGetError() == RT_NO_ERROR ? 0 : 1;
}

int main(int argc, char *argv[]) {
    const char *way = argc > 1 ? argv[1] : "";
    pthread_t thread;
    if (strcmp(way, "atexit-before") == 0) atexit(renderAtExit);
    if (strncmp(way, "fork-", 5) == 0) return afterFork(way + 5);
    if (strcmp(way, "thread-ended") == 0) {
        pthread_create(&thread, NULL, leaveThread, NULL);
        pthread_join(thread, NULL);
        return 0;
    }
    if (strcmp(way, "exit-in-callback") == 0) {
        rtInit(NULL, NULL);
        rtSetFrameCallback(exitInCallback, NULL);
        rtSetFrameBuffer(pixels[0], kSize, kSize, RT_RGBA_8);
        rtRender();
        return 1;
    }
    if (strcmp(way, "no-frame") == 0) {
        rtInit(NULL, NULL);
        return 0;
    }
    startFrames();
    if (strcmp(way, "return") == 0) return 0;
    if (strcmp(way, "exit") == 0) exit(0);
    if (strcmp(way, "quick_exit") == 0) quick_exit(0);
    if (strcmp(way, "_exit") == 0) _exit(0);
    if (strcmp(way, "pthread_exit") == 0) pthread_exit(NULL);
    if (strcmp(way, "rtExit") == 0) {
        rtExit();
        rtExit();
        return 0;
    }
    if (strcmp(way, "atexit") == 0) {
        atexit(endAtExit);
        return 0;
    }
    if (strcmp(way, "atexit-before") == 0) return 0;
    if (strcmp(way, "other-thread") == 0) {
        pthread_create(&thread, NULL, exitThere, NULL);
        rtFinish();
        pthread_join(thread, NULL);
        return 1;
    }
    if (strcmp(way, "exec") == 0) execlp("true", "true", (char *)NULL);
    if (strcmp(way, "signal") == 0) {
        signal(SIGTERM, leaveOnSignal);
        raise(SIGTERM);
    }
    fprintf(stderr, "leave: no such way: %s\n", way);
    return 2;
}
