/* SPDX-License-Identifier: MIT */
/* What a test program in C needs: conditions that are counted, and an exit status. */
#ifndef OPENRT_TESTS_API_CHECK_H
#define OPENRT_TESTS_API_CHECK_H

#include <stdio.h>

#include "openrt/rt.h"

static int failureCount = 0;

static void checkAt(int condition, const char *what, const char *file, int line) {
    if (condition) return;
    fprintf(stderr, "%s:%d: failed: %s\n", file, line, what);
    ++failureCount;
}
static void checkErrorAt(RTenum expected, const char *file, int line) {
    const RTenum error = rtGetError();
    if (error == expected) return;
    fprintf(stderr, "%s:%d: error 0x%X (%s) instead of 0x%X\n", file, line, error,
            rtGetErrorText(), expected);
    ++failureCount;
}

#define CHECK(condition) checkAt(!!(condition), #condition, __FILE__, __LINE__)
/* The error recorded since the last check is this one. */
#define CHECK_ERROR(expected) checkErrorAt((expected), __FILE__, __LINE__)

#endif
