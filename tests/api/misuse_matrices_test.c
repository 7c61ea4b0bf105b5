/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "misuse.h"

static RTuint modeUnknown(void) { return rtMatrixMode(RT_COLOR), 0u; }
static RTuint push(void) { return rtPushMatrix(), 0u; }
static RTuint pop(void) { return rtPopMatrix(), 0u; }
static RTuint popTooOften(void) {
    /* What is on the stack outside: one matrix; in the object: what rtNewObject found. */
    rtPushMatrix();
    rtPopMatrix();
    rtPopMatrix();
    return 0;
}
static RTuint overflow(void) {
    int i, pushed = 0;
    RTint before, after;
    rtGetIntegerv(RT_MODELVIEW_STACK_DEPTH, &before);
    for (i = 0; i < 100; ++i) rtPushMatrix();
    rtGetIntegerv(RT_MODELVIEW_STACK_DEPTH, &after);
    for (pushed = after - before; pushed > 0; --pushed) rtPopMatrix();
    return after == 32 ? 0 : 1;
}
static RTuint identity(void) { return rtLoadIdentity(), 0u; }
static RTuint loadNull(void) { return rtLoadMatrixf(NULL), 0u; }
static RTuint multNull(void) { return rtMultMatrixd(NULL), 0u; }
static RTuint transposeNull(void) { return rtLoadTransposeMatrixd(NULL), 0u; }
static RTuint translate(void) { return rtTranslatef(1, 2, 3), 0u; }
static RTuint rotate(void) { return rtRotated(10, 0, 0, 1), 0u; }
static RTuint scale(void) { return rtScalef(2, 2, 2), 0u; }
static RTuint frustumFlat(void) { return rtFrustum(1, 1, -1, 1, 1, 10), 0u; }
static RTuint frustumBehind(void) { return rtFrustum(-1, 1, -1, 1, -1, 10), 0u; }
static RTuint frustumZero(void) { return rtFrustum(-1, 1, -1, 1, 0, 10), 0u; }
static RTuint orthoFlat(void) { return rtOrtho(-1, 1, 2, 2, 1, 10), 0u; }
static RTuint orthoNan(void) { return rtOrtho(-1, NAN, -1, 1, 1, 10), 0u; }
static RTuint perspectiveWide(void) { return rtPerspective(180, 1, 1, 10), 0u; }
static RTuint perspectiveAspect(void) { return rtPerspective(60, 0, 1, 10), 0u; }
static RTuint perspectiveEqual(void) { return rtPerspective(60, 1, 10, 10), 0u; }
static RTuint perspectiveInfinite(void) { return rtPerspective(60, 1, 1, INFINITY), 0u; }
static RTuint lookAtItself(void) { return rtLookAt(1, 2, 3, 1, 2, 3, 0, 1, 0), 0u; }
static RTuint lookAlongUp(void) { return rtLookAt(0, 0, 0, 0, 5, 0, 0, 1, 0), 0u; }

int main(void) {
    static const Misuse misuses[] = {
        MISUSE(modeUnknown, OUTSIDE, RT_INVALID_ENUM),
        MISUSE(push, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(pop, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(pop, OUTSIDE, RT_STACK_UNDERFLOW),
        MISUSE(pop, IN_OBJECT, RT_STACK_UNDERFLOW),
        MISUSE(popTooOften, OUTSIDE, RT_STACK_UNDERFLOW),
        MISUSE(popTooOften, IN_OBJECT, RT_STACK_UNDERFLOW),
        MISUSE(overflow, OUTSIDE, RT_STACK_OVERFLOW),
        MISUSE(overflow, IN_OBJECT, RT_STACK_OVERFLOW),
        MISUSE(identity, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(loadNull, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(multNull, IN_OBJECT, RT_INVALID_VALUE),
        MISUSE(transposeNull, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(translate, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(rotate, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(scale, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(frustumFlat, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(frustumBehind, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(frustumZero, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(orthoFlat, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(orthoNan, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(perspectiveWide, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(perspectiveAspect, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(perspectiveEqual, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(perspectiveInfinite, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(lookAtItself, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(lookAlongUp, OUTSIDE, RT_INVALID_VALUE),
    };
    return CHECK_MISUSES(misuses);
}
