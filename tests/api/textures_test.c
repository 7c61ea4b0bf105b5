/* SPDX-License-Identifier: MIT */
/* Textures: names, images in every format, wrapping, filters, lives. */
#include "check.h"
#include "picture.h"

static RTuint parameter, shader;

static void startTextures(void) {
    startPicture();
    rtGenNewShaderClass("TextureShader", NULL);
    shader = rtGenNewShader();
    parameter = rtParameterHandle("texture");
}

/* Shows texture coordinates 0..n over the whole view. */
static void show(RTuint texture, float n) {
    rtBindShader(shader);
    rtParameter1i(parameter, (RTint)texture);
    rtBegin(RT_QUADS);
    rtTexCoord2f(0, 0);
    rtVertex2f(-1, -1);
    rtTexCoord2f(n, 0);
    rtVertex2f(1, -1);
    rtTexCoord2f(n, n);
    rtVertex2f(1, 1);
    rtTexCoord2f(0, n);
    rtVertex2f(-1, 1);
    rtEnd();
    rtRender();
}

static void nearest(void) {
    rtTexParameteri(RT_TEXTURE_2D, RT_TEXTURE_MAG_FILTER, RT_NEAREST);
    rtTexParameterf(RT_TEXTURE_2D, RT_TEXTURE_MIN_FILTER, RT_NEAREST);
}

static void names(void) {
    RTuint id[3];
    RTint bound = -1;
    startTextures();
    rtGenTextures(3, id);
    CHECK(id[0] != 0 && id[0] != id[1] && id[1] != id[2]);
    CHECK(rtIsTexture(id[0]) == RT_FALSE && rtIsTexture(0) == RT_FALSE);
    rtBindTexture(RT_TEXTURE_2D, id[0]);
    CHECK(rtIsTexture(id[0]) == RT_TRUE);
    rtBindTexture(RT_TEXTURE_2D, 777); /* unknown: created */
    CHECK(rtIsTexture(777) == RT_TRUE);
    rtGetIntegerv(RT_TEXTURE_BINDING_2D, &bound);
    CHECK(bound == 777);
    id[1] = 777;
    id[2] = 12345; /* unknown: ignored */
    rtDeleteTextures(3, id);
    CHECK(rtIsTexture(777) == RT_FALSE);
    rtGetIntegerv(RT_TEXTURE_BINDING_2D, &bound);
    CHECK(bound == 0);
    CHECK_ERROR(RT_NO_ERROR);
}

static void formats(void) {
    /* Red, green over blue, white; what a format does not hold is 0, its alpha 1. */
    static const RTubyte rgb[] = {255, 0, 0, 0, 255, 0, 9, 9, 0, 0, 255, 255, 255, 255, 9, 9};
    static const RTubyte bgra[] = {0, 0, 255, 255, 0,   255, 0,   255,
                                   255, 0, 0,  255, 255, 255, 255, 255};
    static const RTushort shorts[] = {65535, 0, 0, 0, 65535, 0, 0, 0, 65535, 65535, 65535, 65535};
    static const float floats[] = {1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1};
    static const RTubyte luminance[] = {64, 255, 0, 0, 0, 128, 0, 0};
    int i;
    for (i = 0; i < 4; ++i) {
        startTextures();
        rtBindTexture(RT_TEXTURE_2D, 1);
        nearest();
        switch (i) {
        case 0: /* rows are aligned to 4 bytes */
            rtTexImage2D(RT_TEXTURE_2D, 0, RT_RGB, 2, 2, 0, RT_RGB, RT_UNSIGNED_BYTE, rgb);
            break;
        case 1:
            rtTexImage2D(RT_TEXTURE_2D, 0, RT_RGBA8, 2, 2, 0, RT_BGRA, RT_UNSIGNED_BYTE, bgra);
            break;
        case 2:
            rtTexImage2D(RT_TEXTURE_2D, 0, 3, 2, 2, 0, RT_RGB, RT_UNSIGNED_SHORT, shorts);
            break;
        default: rtTexImage2D(RT_TEXTURE_2D, 0, RT_RGB16, 2, 2, 0, RT_RGB, RT_FLOAT, floats);
        }
        show(1, 1);
        CHECK_ERROR(RT_NO_ERROR);
        CHECK(isColor(at(-0.5f, -0.5f), 1, 0, 0) && isColor(at(0.5f, -0.5f), 0, 1, 0));
        CHECK(isColor(at(-0.5f, 0.5f), 0, 0, 1) && isColor(at(0.5f, 0.5f), 1, 1, 1));
    }
    startTextures();
    rtBindTexture(RT_TEXTURE_2D, 1);
    nearest();
    rtTexImage2D(RT_TEXTURE_2D, 0, RT_LUMINANCE, 2, 2, 0, RT_LUMINANCE, RT_UNSIGNED_BYTE, luminance);
    show(1, 1);
    CHECK(isColor(at(-0.5f, -0.5f), 64 / 255.0f, 64 / 255.0f, 64 / 255.0f));
    CHECK(isColor(at(0.5f, 0.5f), 128 / 255.0f, 128 / 255.0f, 128 / 255.0f));
    /* sRGB bytes are decoded. */
    rtTexImage2D(RT_TEXTURE_2D, 0, RT_SRGB8, 1, 1, 0, RT_RGB, RT_UNSIGNED_BYTE, bgra + 8);
    {
        static const RTubyte gray[3] = {188, 188, 188};
        rtTexImage2D(RT_TEXTURE_2D, 0, RT_SRGB8, 1, 1, 0, RT_RGB, RT_UNSIGNED_BYTE, gray);
        show(1, 1);
        CHECK(fabsf(at(0, 0)[0] - 0.5028865f) < 1e-4f);
    }
    /* Floats are kept as they are. */
    {
        static const float bright[3] = {100, -1, 0.5f};
        rtTexImage2D(RT_TEXTURE_2D, 0, RT_RGB, 1, 1, 0, RT_RGB, RT_FLOAT, bright);
        show(1, 1);
        CHECK(at(0, 0)[0] == 100 && at(0, 0)[2] == 0.5f);
    }
    CHECK_ERROR(RT_NO_ERROR);
}

/* Part of a larger image. */
static void unpacking(void) {
    RTubyte image[5][7][4];
    int x, y;
    for (y = 0; y < 5; ++y)
        for (x = 0; x < 7; ++x)
            image[y][x][0] = (RTubyte)(10 * y + x), image[y][x][1] = image[y][x][2] = 0;
    startTextures();
    rtPixelStorei(RT_UNPACK_ROW_LENGTH, 7);
    rtPixelStorei(RT_UNPACK_SKIP_PIXELS, 3);
    rtPixelStorei(RT_UNPACK_SKIP_ROWS, 2);
    rtPixelStorei(RT_UNPACK_ALIGNMENT, 1);
    rtBindTexture(RT_TEXTURE_2D, 1);
    nearest();
    rtTexImage2D(RT_TEXTURE_2D, 0, RT_RGB, 2, 2, 0, RT_RGBA, RT_UNSIGNED_BYTE, image);
    show(1, 1);
    CHECK(isColor(at(-0.5f, -0.5f), 23 / 255.0f, 0, 0) && isColor(at(0.5f, -0.5f), 24 / 255.0f, 0, 0));
    CHECK(isColor(at(-0.5f, 0.5f), 33 / 255.0f, 0, 0));
    CHECK_ERROR(RT_NO_ERROR);
}

static void lookups(void) {
    static const RTubyte two[] = {255, 0, 0, 255, 0, 255, 0, 255};
    startTextures();
    rtBindTexture(RT_TEXTURE_2D, 1);
    nearest();
    rtTexImage2D(RT_TEXTURE_2D, 0, RT_RGBA, 2, 1, 0, RT_RGBA, RT_UNSIGNED_BYTE, two);
    show(1, 2); /* repeats */
    CHECK(isColor(at(-0.8f, 0), 1, 0, 0) && isColor(at(-0.3f, 0), 0, 1, 0));
    CHECK(isColor(at(0.2f, 0), 1, 0, 0) && isColor(at(0.7f, 0), 0, 1, 0));
    rtTexParameteri(RT_TEXTURE_2D, RT_TEXTURE_WRAP_S, RT_CLAMP_TO_EDGE);
    show(1, 2);
    CHECK(isColor(at(-0.8f, 0), 1, 0, 0) && isColor(at(0.2f, 0), 0, 1, 0));
    rtTexParameteri(RT_TEXTURE_2D, RT_TEXTURE_WRAP_S, RT_MIRRORED_REPEAT);
    show(1, 2);
    CHECK(isColor(at(0.2f, 0), 0, 1, 0) && isColor(at(0.7f, 0), 1, 0, 0));
    rtTexParameteri(RT_TEXTURE_2D, RT_TEXTURE_MAG_FILTER, RT_LINEAR);
    show(1, 1);
    CHECK(fabsf(at(0.03f, 0)[0] + at(0.03f, 0)[1] - 1) < 1e-5f && at(0.03f, 0)[0] > 0.3f);
    CHECK_ERROR(RT_NO_ERROR);

    /* A frame keeps the image it was started with. */
    rtTexParameteri(RT_TEXTURE_2D, RT_TEXTURE_MAG_FILTER, RT_NEAREST);
    rtBindShader(shader);
    rtTexCoord2f(0.1f, 0.5f);
    square(-1, -1, 1, 1, 0);
    rtStartRendering();
    rtTexImage2D(RT_TEXTURE_2D, 0, RT_RGBA, 1, 1, 0, RT_RGBA, RT_UNSIGNED_BYTE, two + 4);
    rtDeleteTextures(1, (const RTuint[]){1});
    rtEndRendering();
    CHECK(isColor(at(0, 0), 1, 0, 0));

    /* An id that is no texture, an image without texels, one of zeros: no crash. */
    show(99, 1);
    rtBindTexture(RT_TEXTURE_2D, 2);
    rtTexImage2D(RT_TEXTURE_2D, 0, RT_RGBA, 0, 5, 0, RT_RGBA, RT_UNSIGNED_BYTE, two);
    show(2, 1);
    rtTexImage2D(RT_TEXTURE_2D, 0, RT_RGBA, 3, 5, 0, RT_RGBA, RT_UNSIGNED_BYTE, NULL);
    show(2, 1);
    CHECK(isColor(at(0, 0), 0, 0, 0));
    show((RTuint)-1, NAN);
    CHECK_ERROR(RT_NO_ERROR);
}

int main(void) {
    names();
    formats();
    unpacking();
    lookups();
    rtExit();
    return failureCount;
}
