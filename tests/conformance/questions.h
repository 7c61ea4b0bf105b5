/* SPDX-License-Identifier: MIT */
/* For programs that ask OpenGL, and with openrt/gl.h the library, the same questions and print the
 * answers: sections that begin with "case NAME". Each such program is one file that defines
 * askQuestions, which runs in the display callback of a window of 32 by 32 pixels. */
#ifndef OPENRT_CONFORMANCE_QUESTIONS_H
#define OPENRT_CONFORMANCE_QUESTIONS_H

#include <GL/glut.h>
#include <stdio.h>
#include <stdlib.h>

enum { kWindow = 32 };

static void askQuestions(void);

static void beginCase(const char* name) {
    while (glGetError() != GL_NO_ERROR) {
    }
    printf("case %s\n", name);
}

static inline void useWindowCoordinates(void) {
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(0.0, kWindow, 0.0, kWindow, -1.0, 1.0);
    glMatrixMode(GL_MODELVIEW);
}

static const char* errorName(void) {
    switch (glGetError()) {
        case GL_NO_ERROR:
            return "no_error";
        case GL_INVALID_ENUM:
            return "invalid_enum";
        case GL_INVALID_VALUE:
            return "invalid_value";
        case GL_INVALID_OPERATION:
            return "invalid_operation";
        case GL_STACK_OVERFLOW:
            return "stack_overflow";
        case GL_STACK_UNDERFLOW:
            return "stack_underflow";
        case GL_OUT_OF_MEMORY:
            return "out_of_memory";
        default:
            return "unknown_error";
    }
}

/* What the library may answer instead of OSMesa's answer, where OpenGL leaves that open. */
static const char* alsoAllowed;
#ifdef OPENRT
enum { kTellsAlternatives = 0 };
#else
enum { kTellsAlternatives = 1 };
#endif

static inline void tellError(void) {
    if (kTellsAlternatives && alsoAllowed != NULL)
        printf("error %s|%s\n", errorName(), alsoAllowed);
    else
        printf("error %s\n", errorName());
}

static void displayQuestions(void) {
    static int asked;
    if (asked) return;
    asked = 1;
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT); /* as every program of OpenGL does */
    askQuestions();
    fflush(stdout);
}

int main(int argc, char** argv) {
    glutInitWindowSize(kWindow, kWindow);
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_RGB | GLUT_DEPTH | GLUT_SINGLE);
    glutCreateWindow("questions");
    glutDisplayFunc(displayQuestions);
    glutMainLoop();
    return 0;
}

#endif
