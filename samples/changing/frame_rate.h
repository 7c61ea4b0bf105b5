/* SPDX-License-Identifier: MIT */
/* How fast a program with rtut renders: the frames it queued, over the time from the first of them
 * to the end of the program, and how long the description of one took. */
#ifndef OPENRT_SAMPLES_FRAME_RATE_H
#define OPENRT_SAMPLES_FRAME_RATE_H

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

static struct FrameRate {
    const char *program;
    long frames;
    double first, begun, describing;
} frameRate;

static double frameRateSeconds(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static void printFrameRate(void) {
    const double seconds = frameRateSeconds() - frameRate.first;
    if (frameRate.frames == 0 || seconds <= 0) return;
    printf("%s: %ld frames, %.2f a second, %.3f ms to describe one\n", frameRate.program,
           frameRate.frames, (double)frameRate.frames / seconds,
           1e3 * frameRate.describing / (double)frameRate.frames);
}

/* Prints when the program ends. */
static void countFrames(const char *program) {
    frameRate.program = program;
    atexit(printFrameRate);
}

/* Around the description of a frame, up to the call that queues it. */
static void frameBegins(void) {
    frameRate.begun = frameRateSeconds();
    if (frameRate.frames == 0) frameRate.first = frameRate.begun;
}
static void frameIsDescribed(void) {
    frameRate.describing += frameRateSeconds() - frameRate.begun;
    ++frameRate.frames;
}

#endif
