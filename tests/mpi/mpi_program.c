/* SPDX-License-Identifier: MIT */
/* mpi_program OUTPUT WAY: a picture through the public interface, to be run by mpirun.
 * Ways: frames (several, of changing scenes), copy (a picture becomes a texture of the next),
 * contexts (two, with frames in both queues), exit (leaves without rtExit), abandon (in the middle
 * of a frame), plugin (a shader of a library), clock (many frames; prints the milliseconds that
 * each took). Prints the library's errors. */
#define _POSIX_C_SOURCE 200809L
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "openrt/rt.h"

enum { kWidth = 200, kHeight = 150, kBytes = 4 * kWidth * kHeight };
static RTubyte pixels[2][kBytes];
static FILE *output;

static void print(void) {
    const RTenum error = rtGetError();
    if (error != RT_NO_ERROR) printf("error: %s\n", rtGetErrorText());
}

static void keep(const RTubyte *picture) {
    if (fwrite(picture, 1, kBytes, output) != kBytes) exit(5);
}

static void camera(void) {
    rtMatrixMode(RT_PROJECTION);
    rtLoadIdentity();
    rtPerspective(45.0, (double)kWidth / kHeight, 0.1, 100.0);
    rtMatrixMode(RT_MODELVIEW);
    rtLoadIdentity();
    rtLookAt(0.0, 0.0, 6.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0);
}

static RTuint wave(int steps) {
    const RTuint object = rtNewObject(RT_COMPILE);
    int i, j, k;
    for (i = 0; i < steps; ++i) {
        rtBegin(RT_QUAD_STRIP);
        for (j = 0; j <= steps; ++j)
            for (k = 0; k < 2; ++k) {
                const int row = i + k;
                rtColor3f((float)row / (float)steps, (float)j / (float)steps, 0.5f);
                rtVertex3f((float)j / (float)steps * 4 - 2, (float)row / (float)steps * 4 - 2,
                           (float)((row * 7 + j * 5) % 9) * 0.05f);
            }
        rtEnd();
    }
    rtEndObject();
    return object;
}

static void frames(int count) {
    const RTuint object = wave(40);
    int i;
    for (i = 0; i < count; ++i) {
        camera();
        rtRotatef((float)(i * 10), 0.2f, 1.0f, 0.1f);
        rtInstantiateObject(object);
        rtTranslatef(1.0f, 0.5f, 0.7f);
        rtInstantiateObject(object);
        rtRender();
        keep(pixels[0]);
        print();
    }
}

static void copy(void) {
    RTuint texture = 0;
    frames(1);
    rtGenTextures(1, &texture);
    rtBindTexture(RT_TEXTURE_2D, texture);
    rtTexParameteri(RT_TEXTURE_2D, RT_TEXTURE_MIN_FILTER, RT_NEAREST);
    rtCopyTexImage2D(RT_TEXTURE_2D, 0, RT_RGBA, 30, 20, 128, 64, 0);
    rtEnable(RT_TEXTURE_2D);
    camera();
    rtRotatef(25.0f, 0.0f, 1.0f, 0.0f);
    rtBegin(RT_QUADS);
    rtColor3f(1, 1, 1);
    rtTexCoord2f(0, 0), rtVertex3f(-2, -1, 0);
    rtTexCoord2f(1, 0), rtVertex3f(2, -1, 0);
    rtTexCoord2f(1, 1), rtVertex3f(2, 1, 0);
    rtTexCoord2f(0, 1), rtVertex3f(-2, 1, 0);
    rtEnd();
    rtRender();
    keep(pixels[0]);
    print();
}

static void contexts(void) {
    RTcontext own = rtGetCurrentContext(), other = rtCreateContext();
    RTuint object[2], frame[2] = {0, 0};
    int i, k;
    for (k = 0; k < 2; ++k) {
        rtMakeCurrent(k ? other : own);
        rtSetFrameBuffer(pixels[k], kWidth, kHeight, RT_RGBA_8);
        object[k] = wave(20 + 10 * k);
    }
    for (i = 0; i < 5; ++i)
        for (k = 0; k < 2; ++k) {
            rtMakeCurrent(k ? other : own);
            if (i > 0) {
                rtWaitFrame(frame[k]);
                keep(pixels[k]);
            }
            camera();
            rtRotatef((float)(i * 20), 0.0f, 1.0f, (float)k);
            rtInstantiateObject(object[k]);
            frame[k] = rtQueueFrame();
            print();
        }
    for (k = 0; k < 2; ++k) rtWaitFrame(frame[k]);
    rtMakeCurrent(own);
    rtDestroyContext(other);
}

static void plugin(void) {
    int i;
    rtGenNewShaderClass("Marble", "only_here.so");
    rtBindShader(rtGenNewShader());
    print();
    for (i = 0; i < 3; ++i) frames(3);
}

static double milliseconds(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec * 1e3 + (double)now.tv_nsec * 1e-6;
}

static void clockFrames(void) {
    const RTuint object = wave(40);
    int i;
    rtSamples(64);
    for (i = 0; i < 120; ++i) {
        const double start = milliseconds();
        camera();
        rtRotatef((float)i, 0.2f, 1.0f, 0.1f);
        rtInstantiateObject(object);
        rtRender();
        printf("%.3f\n", milliseconds() - start);
        fflush(stdout);
        print();
    }
}

int main(int argc, char *argv[]) {
    const char *way;
    if (argc < 3) return 2;
    way = argv[2];
    rtInit(&argc, argv);
    output = fopen(argv[1], "wb");
    if (!output) return 4;
    rtSetFrameBuffer(pixels[0], kWidth, kHeight, RT_RGBA_8);
    rtClearColor(0.1f, 0.2f, 0.3f, 1.0f);
    if (strcmp(way, "frames") == 0) frames(8);
    if (strcmp(way, "copy") == 0) copy();
    if (strcmp(way, "contexts") == 0) contexts();
    if (strcmp(way, "plugin") == 0) plugin();
    if (strcmp(way, "clock") == 0) clockFrames();
    if (strcmp(way, "exit") == 0) {
        frames(2);
        fclose(output);
        exit(3);
    }
    if (strcmp(way, "abandon") == 0) {
        frames(1);
        rtInstantiateObject(wave(60));
        rtQueueFrame();
        fclose(output);
        exit(0);
    }
    fclose(output);
    rtExit();
    return 0;
}
