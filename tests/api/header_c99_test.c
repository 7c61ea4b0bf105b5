/* SPDX-License-Identifier: MIT */
/* The C headers in a C99 program: types have their sizes, tokens their values, calls link. */
#include <openrt/rt.h>
#include <openrt/rt_gl.h>
#include <openrt/rts.h>
#include <openrt/version.h>

#include <stdio.h>

static int failures = 0;

static void expect(int condition, const char *what)
{
    if (!condition) {
        fprintf(stderr, "failed: %s\n", what);
        ++failures;
    }
}

#define EXPECT(condition) expect((condition), #condition)

int main(void)
{
    EXPECT(sizeof(RTenum) == 4 && sizeof(RTuint) == 4 && sizeof(RTint) == 4);
    EXPECT(sizeof(RTboolean) == 1 && sizeof(RTubyte) == 1 && sizeof(RTushort) == 2);
    EXPECT(sizeof(RTint64) == 8 && sizeof(RTfloat) == 4 && sizeof(RTdouble) == 8);
    EXPECT(sizeof(RTray) == 32);

    EXPECT(RT_TRIANGLES == 0x100 && RT_TRIANGLE_STRIP == 0x101 && RT_TRIANGLE_FAN == 0x102);
    EXPECT(RT_QUADS == 0x103 && RT_QUAD_STRIP == 0x104 && RT_POLYGON == 0x105);
    EXPECT(RT_DEFINE == 0x200 && RT_COMPILE == 0x200);
    EXPECT(RT_DEFINE_AND_INSTANTIATE == 0x201 && RT_COMPILE_AND_EXECUTE == 0x201);
    EXPECT(RT_BGR_32 == 0x300);
    EXPECT(RT_SURFACE_SHADER == 0x400 && RT_ENV_SHADER == 0x401);
    EXPECT(RT_LIGHT_SHADER == 0x402 && RT_CAMERA_SHADER == 0x403);
    EXPECT(RT_NO_ERROR == 0 && RT_INVALID_ENUM == 0xFFFFFE01u);
    EXPECT(RT_INVALID_VALUE == 0xFFFFFE02u && RT_INVALID_OPERATION == 0xFFFFFE03u);
    EXPECT(RT_STACK_OVERFLOW == 0xFFFFFE04u && RT_STACK_UNDERFLOW == 0xFFFFFE05u);
    EXPECT(RT_OUT_OF_MEMORY == 0xFFFFFE06u && RT_INVALID == 0xFFFFFFFFu);

    EXPECT(rtGetError() == RT_INVALID_OPERATION); /* no context yet */
    rtInit(NULL, NULL);
    EXPECT(rtGetError() == RT_NO_ERROR);
    rtAccum(RT_ADD, 1.0f); /* declared, and refused */
    EXPECT(rtGetError() == RT_INVALID_OPERATION);
    EXPECT(rtGetError() == RT_NO_ERROR);
    rtExit();
    return failures != 0;
}
