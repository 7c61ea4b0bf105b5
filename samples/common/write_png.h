/* SPDX-License-Identifier: MIT */
/* Writes a picture of 8-bit RGBA pixels, row 0 at the bottom as frame buffers have it, with
 * libpng. For samples in C. */
#ifndef OPENRT_SAMPLES_WRITE_PNG_H
#define OPENRT_SAMPLES_WRITE_PNG_H

#include <png.h>
#include <stdio.h>
#include <string.h>

/* 1: written, and a line says where; 0: not, and a line says why. */
static int writePng(const char *path, const unsigned char *rgba, unsigned width, unsigned height) {
    png_image image;
    memset(&image, 0, sizeof image);
    image.version = PNG_IMAGE_VERSION;
    image.width = width;
    image.height = height;
    image.format = PNG_FORMAT_RGBA;
    /* A negative stride: the first row in memory is the lowest of the picture. */
    if (!png_image_write_to_file(&image, path, 0, rgba, -(png_int_32)(4 * width), NULL)) {
        fprintf(stderr, "%s: %s\n", path, image.message);
        return 0;
    }
    printf("%s\n", path);
    return 1;
}

#endif
