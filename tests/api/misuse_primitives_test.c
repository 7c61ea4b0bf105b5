/* SPDX-License-Identifier: MIT */
#include "misuse.h"

static RTuint begin(void) { return rtBegin(RT_TRIANGLES), 0u; }
static RTuint beginUnknown(void) { return rtBegin(0x106), 0u; }
static RTuint beginPoints(void) { return rtBegin(RT_POINTS), 0u; }
static RTuint beginOpenGlTriangles(void) { return rtBegin(4), 0u; }
static RTuint end(void) { return rtEnd(), 0u; }
static RTuint vertex(void) { return rtVertex3f(1, 2, 3), 0u; }
static RTuint vertexNull(void) { return rtVertex3fv(NULL), 0u; }
static RTuint normalNull(void) { return rtNormal3fv(NULL), 0u; }
static RTuint colorNull(void) { return rtColor3ubv(NULL), 0u; }
static RTuint texCoordNull(void) { return rtTexCoord2dv(NULL), 0u; }
static RTuint vertexWithLight(void) {
    rtBindShader(ids.light);
    rtBegin(RT_TRIANGLES);
    rtVertex3f(0, 0, 0);
    rtVertex3f(1, 0, 0);
    rtVertex3f(1, 1, 0);
    rtEnd();
    rtBindShader(0);
    return 0;
}
static RTuint drawArrays(void) { return rtDrawArrays(RT_TRIANGLES, 0, -3), 0u; }
static RTuint drawArraysMode(void) { return rtDrawArrays(0xABCD, 0, 3), 0u; }
static RTuint newList(void) { return rtNewList(1, RT_COMPILE), 0u; }
static RTuint newListZero(void) { return rtNewList(0, RT_COMPILE), 0u; }

int main(void) {
    static const Misuse misuses[] = {
        MISUSE(begin, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(beginUnknown, OUTSIDE, RT_INVALID_ENUM),
        MISUSE(beginUnknown, IN_OBJECT, RT_INVALID_ENUM),
        MISUSE(beginUnknown, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(beginOpenGlTriangles, OUTSIDE, RT_INVALID_ENUM),
        MISUSE(beginPoints, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(end, OUTSIDE, RT_INVALID_OPERATION),
        MISUSE(end, IN_OBJECT, RT_INVALID_OPERATION),
        MISUSE(vertex, OUTSIDE, RT_INVALID_OPERATION),
        MISUSE(vertex, IN_OBJECT, RT_INVALID_OPERATION),
        MISUSE(vertexNull, IN_PRIMITIVE, RT_INVALID_VALUE),
        MISUSE(normalNull, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(normalNull, IN_PRIMITIVE, RT_INVALID_VALUE),
        MISUSE(colorNull, IN_PRIMITIVE, RT_INVALID_VALUE),
        MISUSE(texCoordNull, IN_OBJECT, RT_INVALID_VALUE),
        MISUSE(vertexWithLight, OUTSIDE, RT_INVALID_OPERATION),
        MISUSE(drawArrays, OUTSIDE, RT_INVALID_VALUE),
        MISUSE(drawArraysMode, OUTSIDE, RT_INVALID_ENUM),
        MISUSE(newList, IN_PRIMITIVE, RT_INVALID_OPERATION),
        MISUSE(newListZero, OUTSIDE, RT_INVALID_VALUE),
    };
    return CHECK_MISUSES(misuses);
}
