/* SPDX-License-Identifier: MIT */
/* opened_library LIBOPENRT OUTPUT: the same where libOpenRT comes by dlopen, with local symbols. */
#include <dlfcn.h>
#include <stdio.h>

#include "openrt/rt.h"

enum { kSide = 128 };
static RTubyte pixels[4 * kSide * kSide];

/* ISO C has no conversion between pointers to objects and to functions. */
#define CALL(name, type, ...)                        \
    do {                                             \
        void (*function) type = 0;                   \
        *(void **)&function = dlsym(library, #name); \
        if (!function) return 3;                     \
        function(__VA_ARGS__);                       \
    } while (0)

int main(int argc, char *argv[]) {
    FILE *output;
    void *library;
    if (argc < 3) return 2;
    library = dlopen(argv[1], RTLD_NOW | RTLD_LOCAL);
    if (!library) return fprintf(stderr, "%s\n", dlerror()), 2;
    CALL(rtInit, (int *, char **), &argc, argv);
    output = fopen(argv[2], "wb");
    if (!output) return 4;
    CALL(rtSetFrameBuffer, (RTubyte *, RTuint, RTuint, RTuint), pixels, kSide, kSide, RT_RGBA_8);
    CALL(rtBegin, (RTenum), RT_TRIANGLES);
    CALL(rtColor3f, (RTfloat, RTfloat, RTfloat), 1.0f, 0.5f, 0.2f);
    CALL(rtVertex3f, (RTfloat, RTfloat, RTfloat), -0.7f, -0.8f, 0.0f);
    CALL(rtVertex3f, (RTfloat, RTfloat, RTfloat), 0.9f, -0.3f, 0.0f);
    CALL(rtVertex3f, (RTfloat, RTfloat, RTfloat), 0.1f, 0.8f, 0.0f);
    CALL(rtEnd, (void), );
    CALL(rtRender, (void), );
    fwrite(pixels, 1, sizeof pixels, output);
    fclose(output);
    CALL(rtExit, (void), );
    return dlclose(library);
}
