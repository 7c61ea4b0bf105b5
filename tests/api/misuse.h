/* SPDX-License-Identifier: MIT */
/* Wrong calls: each is made at one place of a small program that draws a picture; the error has
 * to be the expected one, and everything that can be observed of the library has to be as if the
 * call had not been made. */
#ifndef OPENRT_TESTS_API_MISUSE_H
#define OPENRT_TESTS_API_MISUSE_H

#include "openrt/rt.h"

typedef enum Place {
    OUTSIDE,      /* neither in a primitive nor in an object */
    IN_PRIMITIVE, /* between rtBegin and rtEnd */
    IN_OBJECT,    /* between rtNewObject and rtEndObject */
    IN_FLIGHT,    /* between rtStartRendering and rtEndRendering */
    PLACES
} Place;

/* What the program has made before the call. */
typedef struct Ids {
    RTuint object, openObject, surfaceClass, surface, light, camera, environment, colorHandle,
        lightHandle, texture;
} Ids;
extern Ids ids;
extern RTubyte framePixels[];

typedef struct Misuse {
    const char *name;
    RTuint (*call)(void); /* what the call returns; 0 for one that returns nothing */
    Place place;
    RTenum error;
    RTuint result; /* expected */
} Misuse;

/* Number of failures: of the misuses, and of the controls, calls that do change something. */
int checkMisuses(const Misuse *misuses, int count);

#define MISUSE(call, place, error) {#call, call, place, error, 0}
#define MISUSE_ID(call, place, error) {#call, call, place, error, RT_INVALID}
#define CHECK_MISUSES(list) checkMisuses(list, (int)(sizeof(list) / sizeof(list)[0]))

#endif
