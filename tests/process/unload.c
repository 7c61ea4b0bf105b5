/* SPDX-License-Identifier: MIT */
/* The library as a plug-in host has it: opened, used, closed, several times; and two copies of it in
 * one process. unload LIBRARY COPY */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdio.h>
#include <string.h>

#include <openrt/enums.h>
#include <openrt/types.h>

enum { kSize = 64 };

typedef struct Calls {
    void *library;
    void (*init)(int *, char **);
    void (*exit)(void);
    void (*frameBuffer)(RTubyte *, RTuint, RTuint, RTenum);
    void (*clearColor)(RTfloat, RTfloat, RTfloat, RTfloat);
    void (*clear)(RTbitfield);
    void (*render)(void);
    RTuint (*queue)(void);
    RTenum (*error)(void);
} Calls;

static void *find(void *library, const char *name) {
    void *const found = dlsym(library, name);
    if (!found) fprintf(stderr, "unload: no %s\n", name);
    return found;
}

static int openIt(Calls *calls, const char *path) {
    calls->library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    if (!calls->library) {
        fprintf(stderr, "unload: %s\n", dlerror());
        return 0;
    }
    *(void **)&calls->init = find(calls->library, "rtInit");
    *(void **)&calls->exit = find(calls->library, "rtExit");
    *(void **)&calls->frameBuffer = find(calls->library, "rtSetFrameBuffer");
    *(void **)&calls->clearColor = find(calls->library, "rtClearColor");
    *(void **)&calls->clear = find(calls->library, "rtClear");
    *(void **)&calls->render = find(calls->library, "rtRender");
    *(void **)&calls->queue = find(calls->library, "rtQueueFrame");
    *(void **)&calls->error = find(calls->library, "rtGetError");
    return calls->init && calls->exit && calls->frameBuffer && calls->clearColor && calls->clear &&
           calls->render && calls->queue && calls->error;
}

/* Renders one colour; whether it is there. */
static int renders(const Calls *calls, RTubyte red) {
    static RTubyte pixels[kSize * kSize][4];
    memset(pixels, 7, sizeof pixels);
    calls->frameBuffer(&pixels[0][0], kSize, kSize, RT_RGBA_8);
    calls->clearColor((float)red / 255, 0, 0, 1);
    calls->render();
    return calls->error() == 0 && pixels[kSize][0] == red;
}

int main(int argc, char *argv[]) {
    static RTubyte pixels[kSize * kSize * 4];
    Calls one, two;
    int i;
    if (argc != 3) return 2;
    for (i = 0; i < 20; ++i) {
        if (!openIt(&one, argv[1])) return 1;
        one.init(NULL, NULL);
        if (!renders(&one, (RTubyte)(100 + i))) return 3;
        if (i % 2) {
            one.frameBuffer(pixels, kSize, kSize, RT_RGBA_8);
            one.queue(); /* in flight when the library is closed */
        } else {
            one.exit();
        }
        if (dlclose(one.library) != 0) return 4;
    }
    if (!openIt(&one, argv[1]) || !openIt(&two, argv[2])) return 5;
    if (one.library == two.library || one.init == two.init) return 6;
    one.init(NULL, NULL);
    two.init(NULL, NULL);
    if (!renders(&one, 50) || !renders(&two, 60) || !renders(&one, 70)) return 7;
    one.exit();
    if (!renders(&two, 80)) return 8;
    if (dlclose(one.library) != 0 || !renders(&two, 90)) return 9;
    return 0;
}
