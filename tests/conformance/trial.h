/* SPDX-License-Identifier: MIT */
/* Tries a call from one and the same state, and tells its error and what it has changed. */
#ifndef OPENRT_CONFORMANCE_TRIAL_H
#define OPENRT_CONFORMANCE_TRIAL_H

#define GL_GLEXT_PROTOTYPES
#include <limits.h>
#include <math.h>
#include <string.h>

#include "tests/conformance/known_state.h"

#ifdef OPENRT
enum { kMayCrash = 0 };
#else
enum { kMayCrash = 1 }; /* where OpenGL leaves everything open, Mesa does */
#endif

/* For pointers that are written to, and for images. */
static GLubyte memory[16384];
static const GLubyte zeros[1024];
static const void* const pointers[4] = {zeros, zeros, zeros, zeros};
static const GLfloat floats[16] = {0.5f, 0.25f, 0.75f, 1.0f, 0.0f, 1.0f};
static const GLdouble doubles[16] = {0.5, 0.25, 0.75, 1.0, 0.0, 1.0};
static const GLint ints[16] = {3, 2, 1, 1, 5};
static const GLint fogModes[1] = {GL_EXP2};
static const GLuint uints[16] = {3, 2, 1, 1, 5};
static const GLshort shorts[16] = {3, 2, 1, 1, 5};
static const GLushort ushorts[16] = {3, 2, 1, 1, 5};
static const GLbyte bytes[16] = {3, 2, 1, 1, 5};
static const GLubyte ubytes[128] = {3, 2, 1, 1, 5};
static const GLboolean booleans[4] = {GL_TRUE, GL_FALSE, GL_TRUE, GL_TRUE};
static GLuint names[4], list, texture, buffer, deletedList, deletedTexture, deletedBuffer;
static int wantsBuffer; /* calls of a buffer need one that is bound; arrays need none */

static KnownState before, after;

static void prepareTrials(void) {
    GLuint both[2];
    list = glGenLists(2);
    deletedList = list + 1;
    glDeleteLists(deletedList, 1);
    glGenTextures(2, both);
    texture = both[0];
    deletedTexture = both[1];
    glDeleteTextures(1, &deletedTexture);
    glGenBuffers(2, both);
    buffer = both[0];
    deletedBuffer = both[1];
    glBindBuffer(GL_ARRAY_BUFFER, deletedBuffer);
    glDeleteBuffers(1, &deletedBuffer);
}

static void startTrial(void) {
    memset(memory, 0, sizeof memory);
    names[0] = deletedTexture;
    glNewList(list, GL_COMPILE);
    glEndList();
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 8, 8, 0, GL_RGB, GL_UNSIGNED_BYTE, memory);
    glTexImage1D(GL_TEXTURE_1D, 0, GL_RGB, 8, 0, GL_RGB, GL_UNSIGNED_BYTE, memory);
    if (wantsBuffer) {
        glBindBuffer(GL_ARRAY_BUFFER, buffer);
        glBufferData(GL_ARRAY_BUFFER, 16, memory, GL_STATIC_DRAW);
    }
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    glPushClientAttrib((GLbitfield)GL_CLIENT_ALL_ATTRIB_BITS);
    takeState(&before);
    while (glGetError() != GL_NO_ERROR) {
    }
}

static int depthOf(GLenum stack) {
    GLint depth = 0;
    glGetIntegerv(stack, &depth);
    return depth;
}

static void clearMatrices(GLenum mode, GLenum stack) {
    glMatrixMode(mode);
    while (depthOf(stack) > 1) glPopMatrix();
    glLoadIdentity();
}

static void endTrial(void) {
    glEndList(); /* of a call that began one */
    while (depthOf(GL_ATTRIB_STACK_DEPTH) > 0) glPopAttrib();
    while (depthOf(GL_CLIENT_ATTRIB_STACK_DEPTH) > 0) glPopClientAttrib();
    clearMatrices(GL_TEXTURE, GL_TEXTURE_STACK_DEPTH);
    clearMatrices(GL_PROJECTION, GL_PROJECTION_STACK_DEPTH);
    clearMatrices(GL_MODELVIEW, GL_MODELVIEW_STACK_DEPTH);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
    while (glGetError() != GL_NO_ERROR) {
    }
}

static int isError(const char* error) {
    return strcmp(error, "no_error") != 0;
}

/* A wrong call changes nothing. That is OpenGL's rule; Mesa breaks it here and there. */
static void tellWhetherKept(const char* error) {
    printf("  %s\n", kMayCrash || !isError(error) || isSame(&before, &after)
                         ? "right"
                         : "recorded an error and changed state");
}

static void tellTrial(const char* what, const char* also) {
    const char* const error = errorName();
    takeState(&after);
    if (kTellsAlternatives && *also)
        printf("%s %s|%s\n", what, error, also);
    else
        printf("%s %s\n", what, error);
    tellWhetherKept(error);
    if (!*also && !isError(error)) tellChanges(&before, &after);
}

/* What the library makes of it is its own affair, as long as it obeys its own rules. */
static void tellSurvival(const char* what) {
    const char* const error = errorName();
    takeState(&after);
    printf("%s %s\n", what,
           kTellsAlternatives ? "no_error|invalid_value|invalid_operation|invalid_enum|out_of_memory"
                              : error);
    tellWhetherKept(error);
}

#define TRY(what, call, also) \
    startTrial();             \
    call;                     \
    tellTrial(what, also);    \
    endTrial()

#define SURVIVE(what, call) \
    startTrial();           \
    if (!kMayCrash) call;   \
    tellSurvival(what);     \
    endTrial()

#define INSIDE_BEGIN(what, call, also) \
    startTrial();                      \
    glBegin(GL_POINTS);                \
    call;                              \
    glEnd();                           \
    tellTrial(what, also);             \
    endTrial()

/* Objects are the library's own. */
#ifdef OPENRT
#define INSIDE_OBJECT(what, call)      \
    startTrial();                      \
    tryInsideObject();                 \
    call;                              \
    endObjectTrial(what);              \
    endTrial()

static GLuint object;

static void tryInsideObject(void) {
    object = rtNewObject(RT_DEFINE);
}

static void endObjectTrial(const char* what) {
    const char* const error = errorName();
    int ended;
    while (glGetError() != GL_NO_ERROR) {
    }
    takeState(&after);
    printf("%s ", what);
    tellWhetherKept(error);
    rtEndObject();
    ended = glGetError() == GL_NO_ERROR;
    rtRemoveObject(object);
    printf("  %s\n", ended && glGetError() == GL_NO_ERROR ? "ended" : "the object did not end");
}
#else
#define INSIDE_OBJECT(what, call) printf("%s right\n  ended\n", what)
#endif

#endif
