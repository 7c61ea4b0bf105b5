/* SPDX-License-Identifier: MIT */
/* Pictures of floats as portable float maps: three floats a pixel, rows from the bottom. */
#ifndef OPENRT_SAMPLES_WRITE_PFM_H
#define OPENRT_SAMPLES_WRITE_PFM_H

#include <stdio.h>

/* Writes width x height pixels of red, green, blue; returns 0, or -1 with the reason in errno. */
static inline int writePfm(const char *path, const float *rgb, unsigned width, unsigned height) {
    const unsigned one = 1;
    const int littleEndian = *(const unsigned char *)&one == 1;
    const size_t count = (size_t)width * height * 3;
    FILE *file = fopen(path, "wb");
    int good;
    if (!file) return -1;
    good = fprintf(file, "PF\n%u %u\n%s\n", width, height, littleEndian ? "-1.0" : "1.0") > 0 &&
           fwrite(rgb, sizeof(float), count, file) == count;
    if (fclose(file) != 0) good = 0;
    return good ? 0 : -1;
}

#endif
