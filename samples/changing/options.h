/* SPDX-License-Identifier: MIT */
/* The samples' own options, after rtut has taken its own. */
#ifndef OPENRT_SAMPLES_CHANGING_OPTIONS_H
#define OPENRT_SAMPLES_CHANGING_OPTIONS_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct Option {
    const char *name;
    long *value;    /* a number from least to most follows the name; */
    long least, most;
    int isFlag;     /* or none does, and the value becomes 1 */
} Option;

/* Ends the program with status 2 where something else is on the command line. */
static void readOptions(int argc, char **argv, const Option *options, int count) {
    int i, k;
    for (i = 1; i < argc; ++i) {
        const Option *option = NULL;
        char *end = NULL;
        long value;
        for (k = 0; k < count && !option; ++k)
            if (strcmp(argv[i], options[k].name) == 0) option = &options[k];
        if (option && option->isFlag) {
            *option->value = 1;
            continue;
        }
        value = option && i + 1 < argc ? strtol(argv[i + 1], &end, 10) : 0;
        if (end && *end == 0 && end != argv[i + 1] && value >= option->least &&
            value <= option->most) {
            *option->value = value;
            ++i;
            continue;
        }
        fprintf(stderr, "%s: %s; options:", argv[0], argv[i]);
        for (k = 0; k < count; ++k) {
            fprintf(stderr, " %s", options[k].name);
            if (!options[k].isFlag) fprintf(stderr, " %ld..%ld", options[k].least, options[k].most);
        }
        fprintf(stderr, "; and those of rtut\n");
        exit(2);
    }
}

#endif
