/* SPDX-License-Identifier: MIT */
/* Tells what the library made of the environment: the instruction set, the threads that a frame
 * started, the shader folders; and makes an error, for the log. */
#include <dirent.h>
#include <stdio.h>
#include <sys/auxv.h>

#include "openrt/rt.h"

static int threads(void) {
    int count = 0;
    DIR *folder = opendir("/proc/self/task");
    if (!folder) return 0;
    while (readdir(folder)) ++count;
    closedir(folder);
    return count;
}

int main(void) {
    RTubyte pixel[4];
    const int before = threads();
    rtInit(NULL, NULL);
    rtSetFrameBuffer(pixel, 1, 1, RT_RGBA_8);
    rtRender();
    printf("secure: %lu\n", getauxval(AT_SECURE));
    printf("isa: %s\n", (const char *)rtGetString(RT_ISA));
    printf("threads: %d\n", threads() - before);
    printf("folders: %s\n", (const char *)rtGetString(RT_SHADER_FOLDERS));
    rtEnd();
    rtExit();
    return 0;
}
