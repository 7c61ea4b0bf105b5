/* SPDX-License-Identifier: MIT */
/* For programs whose arguments are names of files, and which have no options. */
#ifndef OPENRT_SAMPLES_REFUSE_OPTIONS_H
#define OPENRT_SAMPLES_REFUSE_OPTIONS_H

#include <stdio.h>
#include <stdlib.h>

/* Where an argument begins with '-', leaves the program: no file shall be called --help. */
static void refuseOptions(int argc, char *argv[], const char *usage) {
    int i;
    for (i = 1; i < argc; ++i)
        if (argv[i][0] == '-') {
            fprintf(stderr, "usage: %s\n", usage);
            exit(2);
        }
}

#endif
