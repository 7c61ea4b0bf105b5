/* SPDX-License-Identifier: MIT */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/conformance/osmesa_glut.h"

static void refuse(const char* option, const char* what) {
    fprintf(stderr, "%s: %s\n", option, what);
    exit(2);
}

/* A pattern is formatted with a frame number: exactly one conversion, and that of an int. */
static void checkPattern(const char* option, const char* pattern) {
    int conversions = 0;
    for (const char* at = pattern; *at; ++at) {
        if (*at != '%') continue;
        ++at;
        while (*at >= '0' && *at <= '9') ++at;
        if (*at != 'd')
            refuse(option, "the file name takes one %d conversion, as in frame%03d.png");
        ++conversions;
    }
    if (conversions != 1) refuse(option, "the file name takes exactly one %d conversion");
}

static void takeShift(DriverOptions* options, const char* value) {
    PixelShift* shift;
    if (options->variants == kMaxVariants) refuse("--rt-variant", "too many");
    shift = &options->shifts[++options->variants];
    if (sscanf(value, "%f,%f", &shift->x, &shift->y) != 2) refuse("--rt-variant", "DX,DY expected");
}

static void takeGeometry(DriverOptions* options, const char* value) {
    if (sscanf(value, "%dx%d", &options->width, &options->height) != 2 || options->width < 1 ||
        options->height < 1 || options->width > 16384 || options->height > 16384)
        refuse("-geometry", "WIDTHxHEIGHT expected");
}

/* 1: option and value were the driver's. */
static int takeOption(DriverOptions* options, const char* option, const char* value) {
    if (!strcmp(option, "--rt-offscreen")) {
        options->frames = atoi(value);
        if (options->frames < 1) refuse(option, "a number of frames expected");
    } else if (!strcmp(option, "--rt-output")) {
        checkPattern(option, value);
        options->output = value;
    } else if (!strcmp(option, "--rt-depth")) {
        checkPattern(option, value);
        options->depth = value;
    } else if (!strcmp(option, "--rt-report")) {
        options->report = value;
    } else if (!strcmp(option, "--rt-variant")) {
        takeShift(options, value);
    } else if (!strcmp(option, "--rt-split")) {
        if (strcmp(value, "first") && strcmp(value, "last"))
            refuse(option, "first or last expected");
        options->splitFirst = !strcmp(value, "first");
    } else if (!strcmp(option, "--rt-buffer")) {
        if (strcmp(value, "float") && strcmp(value, "bytes"))
            refuse(option, "float or bytes expected");
        options->floatBuffer = !strcmp(value, "float");
    } else if (!strcmp(option, "-geometry")) {
        takeGeometry(options, value);
    } else {
        return 0;
    }
    return 1;
}

void takeDriverOptions(int* argc, char** argv, DriverOptions* options) {
    int kept = *argc > 0 ? 1 : 0;
    memset(options, 0, sizeof *options);
    for (int i = 1; i < *argc; ++i) {
        if (i + 1 < *argc && takeOption(options, argv[i], argv[i + 1]))
            ++i;
        else
            argv[kept++] = argv[i];
    }
    *argc = kept;
    argv[kept] = NULL;
    if (options->frames == 0) refuse("--rt-offscreen", "this driver has no windows: give it");
}

int frameFile(char* path, size_t size, const char* pattern, int frame, int variant) {
    char numbered[4096];
    const char* extension;
    const int length = snprintf(numbered, sizeof numbered, pattern, frame);
    int written;
    if (length < 0 || (size_t)length >= sizeof numbered) return 0;
    extension = strrchr(numbered, '.');
    if (extension == NULL || strchr(extension, '/') != NULL) extension = numbered + length;
    if (variant == 0)
        written = snprintf(path, size, "%s", numbered);
    else
        written = snprintf(path, size, "%.*s.v%d%s", (int)(extension - numbered), numbered, variant,
                           extension);
    return written > 0 && (size_t)written < size;
}

int writeDepth(const char* path, const float* depth, int width, int height) {
    FILE* file = fopen(path, "wb");
    size_t count = (size_t)width * (size_t)height;
    int written;
    if (file == NULL) {
        perror(path);
        return 0;
    }
    fprintf(file, "Pf\n%d %d\n-1.0\n", width, height);
    written = fwrite(depth, sizeof *depth, count, file) == count;
    written = fclose(file) == 0 && written;
    if (!written) fprintf(stderr, "%s: could not be written\n", path);
    return written;
}
