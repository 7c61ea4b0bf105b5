/* SPDX-License-Identifier: MIT */
/* Writes a picture of linear floats, row 0 at the bottom: as PNG, sRGB-encoded, or to a name that
 * ends in .pfm as a portable float map, value by value. For samples in C. */
#ifndef OPENRT_SAMPLES_WRITE_PICTURE_H
#define OPENRT_SAMPLES_WRITE_PICTURE_H

#include <errno.h>
#include <math.h>
#include <stdlib.h>

#include "samples/common/write_png.h"

static int writePfm(const char *path, const float *rgb, unsigned width, unsigned height) {
    const unsigned one = 1;
    const int littleEndian = *(const unsigned char *)&one == 1;
    const size_t count = (size_t)width * height * 3;
    FILE *file = fopen(path, "wb");
    int good = file && fprintf(file, "PF\n%u %u\n%s\n", width, height,
                               littleEndian ? "-1.0" : "1.0") > 0;
    good = good && fwrite(rgb, sizeof(float), count, file) == count;
    if (file && fclose(file) != 0) good = 0;
    if (good)
        printf("%s\n", path);
    else
        fprintf(stderr, "%s: %s\n", path, strerror(errno));
    return good;
}

static unsigned char encodeSrgb(float linear) {
    const double x = linear > 0 ? (linear < 1 ? linear : 1) : 0;
    const double encoded = x <= 0.0031308 ? 12.92 * x : 1.055 * pow(x, 1 / 2.4) - 0.055;
    return (unsigned char)(255 * encoded + 0.5);
}

/* 1: written, and a line says where; 0: not, and a line says why. */
static int writePicture(const char *path, const float *rgb, unsigned width, unsigned height) {
    const size_t length = strlen(path), pixels = (size_t)width * height;
    unsigned char *rgba;
    int written;
    if (length > 4 && strcmp(path + length - 4, ".pfm") == 0)
        return writePfm(path, rgb, width, height);
    rgba = malloc(4 * pixels);
    if (!rgba) return 0;
    for (size_t i = 0; i < pixels; ++i) {
        for (int c = 0; c < 3; ++c) rgba[4 * i + c] = encodeSrgb(rgb[3 * i + c]);
        rgba[4 * i + 3] = 255;
    }
    written = writePng(path, rgba, width, height);
    free(rgba);
    return written;
}

#endif
