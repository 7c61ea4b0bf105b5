/* SPDX-License-Identifier: MIT */
/* State as it starts and as calls leave it; conversions of rtGet. */
#include <math.h>
#include <string.h>

#include "check.h"

static int integersAre(RTenum name, int count, const RTint *expected) {
    RTint values[16] = {0};
    rtGetIntegerv(name, values);
    return memcmp(values, expected, (size_t)count * sizeof *values) == 0;
}
static int integerIs(RTenum name, RTint expected) {
    return integersAre(name, 1, &expected);
}
static int floatsAre(RTenum name, float a, float b, float c, float d) {
    RTfloat v[4] = {0, 0, 0, 0};
    rtGetFloatv(name, v);
    return v[0] == a && v[1] == b && v[2] == c && v[3] == d;
}

int main(void) {
    static RTubyte pixels[4 * 8 * 6];
    RTdouble m[16];
    int i;
    rtInit(NULL, NULL);

    /* The start. */
    CHECK(floatsAre(RT_CURRENT_COLOR, 1, 1, 1, 1));
    CHECK(floatsAre(RT_CURRENT_NORMAL, 0, 0, 1, 0));
    CHECK(floatsAre(RT_CURRENT_TEXTURE_COORDS, 0, 0, 0, 1));
    CHECK(floatsAre(RT_COLOR_CLEAR_VALUE, 0, 0, 0, 0));
    CHECK(integerIs(RT_MATRIX_MODE, RT_MODELVIEW));
    CHECK(integerIs(RT_MODELVIEW_STACK_DEPTH, 1) && integerIs(RT_PROJECTION_STACK_DEPTH, 1));
    CHECK(integerIs(RT_MAX_MODELVIEW_STACK_DEPTH, 32) && integerIs(RT_TEXTURE_STACK_DEPTH, 1));
    CHECK(integerIs(RT_MAX_OBJECT_DEPTH, 8) && integerIs(RT_SHADER_BINDING, 0));
    CHECK(integerIs(RT_OBJECT_INDEX, 0));
    i = (int)rtNewObject(RT_COMPILE);
    CHECK(integerIs(RT_OBJECT_INDEX, i));
    rtEndObject();
    CHECK(integerIs(RT_OBJECT_INDEX, 0));
    rtRemoveObject((RTuint)i);
    CHECK(integerIs(RT_UNPACK_ALIGNMENT, 4) && integerIs(RT_SAMPLES, 1));
    CHECK(integerIs(RT_PRECISION_HINT, RT_DONT_CARE));
    CHECK(!rtIsEnabled(RT_MULTISAMPLE) && !rtIsEnabled(RT_FRAMEBUFFER_SRGB));
    CHECK(floatsAre(RT_FRAME_PROGRESS, 1, 0, 0, 0));

    /* The viewport is the frame buffer until it is set. */
    {
        const RTint whole[4] = {0, 0, 8, 6}, part[4] = {-1, 2, 3, 4};
        rtSetFrameBuffer(pixels, 8, 6, RT_RGBA_8);
        CHECK(integersAre(RT_VIEWPORT, 4, whole));
        rtViewport(-1, 2, 3, 4);
        CHECK(integersAre(RT_VIEWPORT, 4, part));
    }

    /* OpenGL 1.5, table 2.6: integers to floats. */
    rtColor3ub(255, 0, 128);
    CHECK(floatsAre(RT_CURRENT_COLOR, 1, 0, 128 / 255.0f, 1));
    rtColor4us(65535, 0, 65535, 0);
    CHECK(floatsAre(RT_CURRENT_COLOR, 1, 0, 1, 0));
    rtColor3ui(4294967295u, 0, 0);
    CHECK(floatsAre(RT_CURRENT_COLOR, 1, 0, 0, 1));
    rtColor3b(127, -128, 0);
    CHECK(floatsAre(RT_CURRENT_COLOR, 1, -1, 1 / 255.0f, 1));
    rtColor3s(32767, -32768, 0);
    CHECK(floatsAre(RT_CURRENT_COLOR, 1, -1, 1 / 65535.0f, 1));
    rtColor3i(2147483647, -2147483647 - 1, 0);
    CHECK(floatsAre(RT_CURRENT_COLOR, 1, -1, (float)(1 / 4294967295.0), 1));
    rtColor4d(0.25, 2.5, -3, 0.5);
    CHECK(floatsAre(RT_CURRENT_COLOR, 0.25f, 2.5f, -3, 0.5f));
    rtNormal3b(0, 0, 127);
    CHECK(floatsAre(RT_CURRENT_NORMAL, 1 / 255.0f, 1 / 255.0f, 1, 0));
    rtNormal2f(3, 4);
    CHECK(floatsAre(RT_CURRENT_NORMAL, 3, 4, 0, 0));
    rtNormal4d(1, 2, 3, 4);
    CHECK(floatsAre(RT_CURRENT_NORMAL, 1, 2, 3, 0));
    rtTexCoord1s(7);
    CHECK(floatsAre(RT_CURRENT_TEXTURE_COORDS, 7, 0, 0, 1));
    rtTexCoord2i(7, 8);
    CHECK(floatsAre(RT_CURRENT_TEXTURE_COORDS, 7, 8, 0, 1));
    rtTexCoord3d(7, 8, 9);
    CHECK(floatsAre(RT_CURRENT_TEXTURE_COORDS, 7, 8, 9, 1));
    {
        const RTfloat v[4] = {1, 2, 3, 4};
        rtTexCoord4fv(v);
        CHECK(floatsAre(RT_CURRENT_TEXTURE_COORDS, 1, 2, 3, 4));
    }
    CHECK_ERROR(RT_NO_ERROR);

    /* rtGet: colours fill the range of integers, other numbers are rounded, booleans compare. */
    {
        RTint color[4];
        RTint64 wide[4];
        RTboolean truth[4];
        rtColor4f(1, -1, 0, 0.5f);
        rtGetIntegerv(RT_CURRENT_COLOR, color);
        CHECK(color[0] == 2147483647 && color[1] == -2147483647 - 1);
        CHECK(color[2] == 0 || color[2] == -1);
        CHECK(color[3] >= 1073741822 && color[3] <= 1073741824);
        rtColor4f(9, NAN, 0, 0);
        rtGetIntegerv(RT_CURRENT_COLOR, color);
        CHECK(color[0] == 2147483647 && color[1] == 0);
        rtGetInteger64v(RT_CURRENT_COLOR, wide);
        CHECK(wide[0] > 2147483647);
        rtColor4f(0.001f, 0, -1, 1);
        rtGetBooleanv(RT_CURRENT_COLOR, truth);
        CHECK(truth[0] == 1 && truth[1] == 0 && truth[2] == 1 && truth[3] == 1);
        rtTexCoord4f(1.5f, 2.4f, -1.6f, 1e20f);
        rtGetIntegerv(RT_CURRENT_TEXTURE_COORDS, color);
        CHECK(color[0] == 2 && color[1] == 2 && color[2] == -2 && color[3] == 2147483647);
        CHECK_ERROR(RT_NO_ERROR);
    }

    /* Matrices. */
    rtTranslated(1, 2, 3);
    rtGetDoublev(RT_MODELVIEW_MATRIX, m);
    CHECK(m[12] == 1 && m[13] == 2 && m[14] == 3 && m[0] == 1);
    rtGetDoublev(RT_TRANSPOSE_MODELVIEW_MATRIX, m);
    CHECK(m[3] == 1 && m[7] == 2 && m[11] == 3);
    rtPushMatrix();
    rtScalef(2, 2, 2);
    rtPopMatrix();
    rtGetDoublev(RT_MODELVIEW_MATRIX, m);
    CHECK(m[0] == 1);
    for (i = 0; i < 16; ++i) m[i] = i;
    rtLoadMatrixd(m);
    rtMultTransposeMatrixd(m);
    {
        RTdouble product[16];
        int row, column, k, wrong = 0;
        rtGetDoublev(RT_MODELVIEW_MATRIX, product);
        for (row = 0; row < 4; ++row) {
            for (column = 0; column < 4; ++column) {
                double sum = 0;
                for (k = 0; k < 4; ++k) sum += m[4 * k + row] * m[4 * k + column];
                wrong += product[4 * column + row] != sum;
            }
        }
        CHECK(wrong == 0);
    }
    rtMatrixMode(RT_PROJECTION);
    rtPushMatrix();
    CHECK(integerIs(RT_PROJECTION_STACK_DEPTH, 2) && integerIs(RT_MODELVIEW_STACK_DEPTH, 1));
    rtMatrixMode(RT_TEXTURE);
    rtTranslatef(1, 0, 0);
    rtGetDoublev(RT_TEXTURE_MATRIX, m);
    CHECK(m[12] == 1);

    rtClearColor(2, -1, NAN, 0.5f);
    CHECK(floatsAre(RT_COLOR_CLEAR_VALUE, 1, 0, 0, 0.5f));
    rtEnable(RT_MULTISAMPLE);
    CHECK(rtIsEnabled(RT_MULTISAMPLE) == RT_TRUE && integerIs(RT_MULTISAMPLE, 1));
    rtDisable(RT_MULTISAMPLE);
    CHECK(rtIsEnabled(RT_MULTISAMPLE) == RT_FALSE);
    rtHint(RT_PRECISION_HINT, RT_FASTEST);
    CHECK(integerIs(RT_PRECISION_HINT, RT_FASTEST));
    rtHint(RT_PRECISION_HINT, RT_NICEST);
    CHECK(integerIs(RT_PRECISION_HINT, RT_NICEST));
    rtHint(RT_PRECISION_HINT, RT_DONT_CARE);
    CHECK(integerIs(RT_PRECISION_HINT, RT_DONT_CARE));
    rtObjectHint(RT_BUILD_QUALITY, RT_FASTEST);
    rtObjectHint(RT_LAZY_BUILD, RT_TRUE);
    CHECK(integerIs(RT_BUILD_QUALITY, RT_FASTEST) && integerIs(RT_LAZY_BUILD, RT_TRUE));
    rtObjectHint(RT_BUILD_QUALITY, RT_KD_TREE);
    CHECK(integerIs(RT_BUILD_QUALITY, RT_KD_TREE));
    CHECK_ERROR(RT_NO_ERROR);
    rtExit();
    return failureCount;
}
