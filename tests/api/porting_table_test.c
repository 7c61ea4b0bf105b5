/* SPDX-License-Identifier: MIT */
/* Every function of the tables is declared, exported and callable; the refused ones say so, the
 * others do not. */
#include <string.h>

#include "check.h"
#include "openrt/rtu.h"
#include "openrt/rtut.h"

static int refusedCount, carriedOutCount;

/* The call is made in a context in which nothing happened before. */
static void start(void) {
    rtInit(NULL, NULL);
    rtThreads(1);
}

static void finish(const char *name, int refused) {
    const int says = strstr(rtGetErrorText(), "not part of this release") != NULL;
    const RTenum error = rtGetError();
    const int right = refused ? error == RT_INVALID_OPERATION && says : !says;
    if (!right) {
        fprintf(stderr, "%s: error 0x%X, '%s'\n", name, error, rtGetErrorText());
        ++failureCount;
    }
    *(refused ? &refusedCount : &carriedOutCount) += 1;
    rtExit();
}

#define REFUSED(name, call) \
    start();                \
    call;                   \
    finish(name, 1);
#define CARRIED_OUT(name, call) \
    start();                    \
    call;                       \
    finish(name, 0);
#define GLUT_REFUSED(name, call)
#define GLUT_NAME(name)

static void openGlFunctions(void) {
#include "porting_table_calls.inc"
}

#undef REFUSED
#undef CARRIED_OUT
#undef GLUT_REFUSED
#undef GLUT_NAME
#define REFUSED(name, call)
#define CARRIED_OUT(name, call)
#define GLUT_REFUSED(name, call) \
    call;                        \
    glutSaysSo(name);            \
    ++names;
#define GLUT_NAME(name) names += (void (*)(void))name != NULL;

static void glutSaysSo(const char *name) {
    const char *text = rtutGetErrorText();
    const size_t length = strlen(name);
    const int right = strncmp(text, name, length) == 0 && text[length] == ':' &&
                      strstr(text, "not part of this release") != NULL;
    if (!right) fprintf(stderr, "%s: '%s'\n", name, text);
    failureCount += !right;
}

static int glutFunctions(void) {
    int names = 0;
#include "porting_table_calls.inc"
    return names;
}

int main(void) {
    openGlFunctions();
    printf("%d functions refused, %d carried out, %d of GLUT\n", refusedCount, carriedOutCount,
           glutFunctions());
    CHECK(carriedOutCount > 300);
    /* A function that is carried out does not pass for a refused one, nor the other way round. */
    const int before = failureCount;
    start();
    CHECK_ERROR(RT_NO_ERROR);
    rtLoadIdentity();
    finish("rtLoadIdentity (control)", 1);
    start();
    rtAccum(RT_ADD, 1.0f);
    finish("rtAccum (control)", 0);
    const int caught = failureCount - before;
    failureCount = before;
    CHECK(caught == 2);
    return failureCount != 0;
}
