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
    for (id[0] = 1048574; id[0] < 1048580; ++id[0]) rtDeleteTextures(1, id); /* beyond all names */
    bound = -1;
    rtGetTexParameteriv(RT_TEXTURE_1D, RT_TEXTURE_WRAP_S, &bound);
    CHECK(bound == RT_REPEAT);
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

/* Colour of a square that shows 2 of the texture a pixel, hence has its coarsest level. */
static const float *coarsest(RTuint texture) {
    show(texture, 2.0f * PICTURE_SIZE);
    return at(0, 0);
}

static void mipmaps(void) {
    static const RTubyte red[16 * 4] = {0};
    static const RTubyte blue[4] = {0, 0, 255, 255};
    static const RTubyte green[4 * 4] = {0, 255, 0, 255, 0, 255, 0, 255,
                                         0, 255, 0, 255, 0, 255, 0, 255};
    RTubyte base[16 * 4];
    RTint value = -1;
    RTfloat number = -1;
    int i;
    for (i = 0; i < 16; ++i) {
        base[4 * i] = base[4 * i + 3] = 255;
        base[4 * i + 1] = base[4 * i + 2] = 0;
    }
    startTextures();
    rtBindTexture(RT_TEXTURE_2D, 1);
    rtTexParameteri(RT_TEXTURE_2D, RT_TEXTURE_MIN_FILTER, RT_LINEAR_MIPMAP_LINEAR);
    rtTexImage2D(RT_TEXTURE_2D, 0, RT_RGBA, 4, 4, 0, RT_RGBA, RT_UNSIGNED_BYTE, base);
    rtTexImage2D(RT_TEXTURE_2D, 1, RT_RGBA, 2, 2, 0, RT_RGBA, RT_UNSIGNED_BYTE, green);
    CHECK(isColor(coarsest(1), 1, 0, 0)); /* incomplete: the base level */
    rtTexImage2D(RT_TEXTURE_2D, 2, RT_RGBA, 1, 1, 0, RT_RGBA, RT_UNSIGNED_BYTE, blue);
    CHECK(isColor(coarsest(1), 0, 0, 1));
    show(1, PICTURE_SIZE / 2.0f); /* two texels of level 0 a pixel: level 1 */
    CHECK(isColor(at(0, 0), 0, 1, 0));
    show(1, 1);
    CHECK(isColor(at(0, 0), 1, 0, 0));
    rtTexParameteri(RT_TEXTURE_2D, RT_TEXTURE_MAX_LEVEL, 1);
    CHECK(isColor(coarsest(1), 0, 1, 0));
    rtTexParameterf(RT_TEXTURE_2D, RT_TEXTURE_MAX_LOD, 0.0f);
    CHECK(isColor(coarsest(1), 1, 0, 0));
    rtTexParameterf(RT_TEXTURE_2D, RT_TEXTURE_MAX_LOD, 1000.0f);
    rtTexParameteri(RT_TEXTURE_2D, RT_TEXTURE_MIN_FILTER, RT_NEAREST);
    CHECK(isColor(coarsest(1), 1, 0, 0));
    CHECK_ERROR(RT_NO_ERROR);

    /* Made by the library; in linear light, the mean of black and white is code 188. */
    for (i = 0; i < 16 * 4; ++i) base[i] = (RTubyte)(i / 4 % 2 * 255);
    rtBindTexture(RT_TEXTURE_2D, 2);
    rtTexParameteri(RT_TEXTURE_2D, RT_GENERATE_MIPMAP, RT_TRUE);
    rtTexParameteri(RT_TEXTURE_2D, RT_TEXTURE_MIN_FILTER, RT_LINEAR_MIPMAP_LINEAR);
    rtTexImage2D(RT_TEXTURE_2D, 0, RT_SRGB8_ALPHA8, 4, 4, 0, RT_RGBA, RT_UNSIGNED_BYTE, base);
    CHECK(fabsf(coarsest(2)[0] - 0.5028865f) < 1e-4f);
    rtGetTexLevelParameteriv(RT_TEXTURE_2D, 1, RT_TEXTURE_WIDTH, &value);
    CHECK(value == 2);
    rtGetTexLevelParameteriv(RT_TEXTURE_2D, 2, RT_TEXTURE_INTERNAL_FORMAT, &value);
    CHECK(value == RT_SRGB8_ALPHA8);
    rtGetTexLevelParameterfv(RT_TEXTURE_2D, 2, RT_TEXTURE_ALPHA_SIZE, &number);
    CHECK(number == 8);
    rtGetTexLevelParameteriv(RT_TEXTURE_2D, 3, RT_TEXTURE_WIDTH, &value);
    CHECK(value == 0);
    /* A part of the base level: everything after it follows. */
    rtTexSubImage2D(RT_TEXTURE_2D, 0, 0, 0, 4, 4, RT_RGBA, RT_UNSIGNED_BYTE, red);
    CHECK(isColor(coarsest(2), 0, 0, 0));
    rtTexSubImage2D(RT_TEXTURE_2D, 2, 0, 0, 1, 1, RT_RGBA, RT_UNSIGNED_BYTE, blue);
    CHECK(isColor(coarsest(2), 0, 0, 1));
    CHECK_ERROR(RT_NO_ERROR);
}

static void parts(void) {
    static const RTubyte black[2 * 2 * 3];
    static const float white[3] = {1, 1, 1};
    startTextures();
    rtPixelStorei(RT_UNPACK_ALIGNMENT, 1);
    rtBindTexture(RT_TEXTURE_2D, 1);
    nearest();
    rtTexImage2D(RT_TEXTURE_2D, 0, RT_RGB, 2, 2, 0, RT_RGB, RT_UNSIGNED_BYTE, black);
    rtTexSubImage2D(RT_TEXTURE_2D, 0, 1, 0, 1, 1, RT_RGB, RT_FLOAT, white);
    rtTexSubImage2D(RT_TEXTURE_2D, 0, 2, 2, 0, 0, RT_RGB, RT_FLOAT, white); /* nothing */
    show(1, 1);
    CHECK(isColor(at(-0.5f, -0.5f), 0, 0, 0) && isColor(at(0.5f, -0.5f), 1, 1, 1));
    CHECK(isColor(at(-0.5f, 0.5f), 0, 0, 0) && isColor(at(0.5f, 0.5f), 0, 0, 0));
    /* A frame in flight keeps the image it was started with. */
    rtBindShader(shader);
    rtTexCoord2f(0.75f, 0.25f);
    square(-1, -1, 1, 1, 0);
    rtStartRendering();
    rtTexSubImage2D(RT_TEXTURE_2D, 0, 0, 0, 2, 2, RT_RGB, RT_UNSIGNED_BYTE, black);
    rtEndRendering();
    CHECK(isColor(at(0, 0), 1, 1, 1));
    CHECK_ERROR(RT_NO_ERROR);
}

static void halves(void) {
    static const RTushort texels[3] = {0x3C00, 0x3800, 0x7BFF}; /* 1, 1/2, 65504 */
    startTextures();
    rtBindTexture(RT_TEXTURE_2D, 1);
    nearest();
    rtTexImage2D(RT_TEXTURE_2D, 0, RT_RGB, 1, 1, 0, RT_RGB, RT_HALF_FLOAT, texels);
    show(1, 1);
    CHECK(at(0, 0)[0] == 1 && at(0, 0)[1] == 0.5f && at(0, 0)[2] == 65504.0f);
    CHECK_ERROR(RT_NO_ERROR);
}

static void borders(void) {
    static const RTubyte white[4] = {255, 255, 255, 255};
    static const RTfloat color[4] = {1, 0.5f, 0, 0.25f};
    static const RTint codes[4] = {2147483647, 0, -2147483647 - 1, 0};
    RTfloat got[4] = {0, 0, 0, 0};
    RTint wrap = 0;
    startTextures();
    rtBindTexture(RT_TEXTURE_2D, 1);
    rtTexImage2D(RT_TEXTURE_2D, 0, RT_RGBA, 1, 1, 0, RT_RGBA, RT_UNSIGNED_BYTE, white);
    rtTexParameterfv(RT_TEXTURE_2D, RT_TEXTURE_BORDER_COLOR, color);
    rtTexParameteri(RT_TEXTURE_2D, RT_TEXTURE_WRAP_S, RT_CLAMP_TO_BORDER);
    rtTexParameteri(RT_TEXTURE_2D, RT_TEXTURE_WRAP_T, RT_CLAMP_TO_EDGE);
    show(1, 4);
    CHECK(isColor(at(0.9f, 0.9f), 1, 0.5f, 0) && at(-0.9f, 0.9f)[1] > 0.6f);
    rtTexParameterf(RT_TEXTURE_2D, RT_TEXTURE_WRAP_S, RT_CLAMP); /* half border, half edge */
    show(1, 4);
    CHECK(isColor(at(0.9f, 0.9f), 1, 0.75f, 0.5f));
    rtTexParameteri(RT_TEXTURE_2D, RT_TEXTURE_WRAP_S, RT_CLAMP_TO_EDGE);
    show(1, 4);
    CHECK(isColor(at(0.9f, 0.9f), 1, 1, 1));
    rtGetTexParameterfv(RT_TEXTURE_2D, RT_TEXTURE_BORDER_COLOR, got);
    CHECK(got[0] == 1 && got[1] == 0.5f && got[2] == 0 && got[3] == 0.25f);
    rtGetTexParameteriv(RT_TEXTURE_2D, RT_TEXTURE_WRAP_S, &wrap);
    CHECK(wrap == RT_CLAMP_TO_EDGE);
    rtTexParameteriv(RT_TEXTURE_2D, RT_TEXTURE_BORDER_COLOR, codes);
    rtGetTexParameterfv(RT_TEXTURE_2D, RT_TEXTURE_BORDER_COLOR, got);
    CHECK(got[0] == 1 && fabsf(got[1]) < 1e-9f && got[2] == 0); /* clamped, as in OpenGL 1.5 */
    CHECK_ERROR(RT_NO_ERROR);
}

/* Every value that can be set is the one that is got. */
static void parameters(void) {
    static const struct {
        RTenum name;
        RTint start, values[6];
        int count;
    } rows[] = {
        {RT_TEXTURE_WRAP_S, RT_REPEAT,
         {RT_CLAMP, RT_CLAMP_TO_EDGE, RT_CLAMP_TO_BORDER, RT_MIRRORED_REPEAT, RT_REPEAT}, 5},
        {RT_TEXTURE_WRAP_T, RT_REPEAT,
         {RT_CLAMP, RT_CLAMP_TO_EDGE, RT_CLAMP_TO_BORDER, RT_MIRRORED_REPEAT, RT_REPEAT}, 5},
        {RT_TEXTURE_MAG_FILTER, RT_LINEAR, {RT_NEAREST, RT_LINEAR}, 2},
        {RT_TEXTURE_MIN_FILTER, RT_NEAREST_MIPMAP_LINEAR,
         {RT_NEAREST, RT_LINEAR, RT_NEAREST_MIPMAP_NEAREST, RT_LINEAR_MIPMAP_NEAREST,
          RT_NEAREST_MIPMAP_LINEAR, RT_LINEAR_MIPMAP_LINEAR}, 6},
        {RT_TEXTURE_BASE_LEVEL, 0, {0, 3, 1000000}, 3},
        {RT_TEXTURE_MAX_LEVEL, 1000, {0, 3, 1000000}, 3},
        {RT_TEXTURE_MIN_LOD, -1000, {-3, 5}, 2},
        {RT_TEXTURE_MAX_LOD, 1000, {-3, 5}, 2},
        {RT_TEXTURE_LOD_BIAS, 0, {-3, 5}, 2},
        {RT_GENERATE_MIPMAP, RT_FALSE, {RT_TRUE, RT_FALSE}, 2},
    };
    int row, i;
    startTextures();
    rtBindTexture(RT_TEXTURE_2D, 1);
    for (row = 0; row < (int)(sizeof rows / sizeof *rows); ++row) {
        RTint value = -77;
        RTfloat number = -77;
        rtGetTexParameteriv(RT_TEXTURE_2D, rows[row].name, &value);
        CHECK(value == rows[row].start);
        for (i = 0; i < rows[row].count; ++i) {
            const RTint wanted = rows[row].values[i];
            const RTfloat wantedNumber = (RTfloat)wanted;
            if (i % 2)
                rtTexParameterfv(RT_TEXTURE_2D, rows[row].name, &wantedNumber);
            else
                rtTexParameteriv(RT_TEXTURE_2D, rows[row].name, &wanted);
            rtGetTexParameteriv(RT_TEXTURE_2D, rows[row].name, &value);
            rtGetTexParameterfv(RT_TEXTURE_2D, rows[row].name, &number);
            CHECK(value == wanted && number == wantedNumber);
        }
    }
    CHECK_ERROR(RT_NO_ERROR);
}

/* Level's value, or -77. */
static RTint levelOf(RTenum target, RTint level, RTenum name) {
    RTint value = -77;
    rtGetTexLevelParameteriv(target, level, name, &value);
    return value;
}

static RTint proxyWidth(RTint level, RTint internalFormat, RTsizei width, RTsizei height,
                        RTint border, RTenum format, RTenum type) {
    rtTexImage2D(RT_PROXY_TEXTURE_2D, level, internalFormat, width, height, border, format, type,
                 (const void *)1); /* is not read */
    return levelOf(RT_PROXY_TEXTURE_2D, level, RT_TEXTURE_WIDTH);
}

/* OpenGL 1.5, section 3.8.11. */
static void proxies(void) {
    static const RTenum twice[] = {RT_TEXTURE_2D, RT_PROXY_TEXTURE_2D};
    static const RTenum names[] = {RT_TEXTURE_WIDTH,          RT_TEXTURE_HEIGHT,
                                   RT_TEXTURE_DEPTH,          RT_TEXTURE_BORDER,
                                   RT_TEXTURE_RED_SIZE,       RT_TEXTURE_GREEN_SIZE,
                                   RT_TEXTURE_BLUE_SIZE,      RT_TEXTURE_ALPHA_SIZE,
                                   RT_TEXTURE_LUMINANCE_SIZE, RT_TEXTURE_INTENSITY_SIZE,
                                   RT_TEXTURE_COMPRESSED,     RT_TEXTURE_INTERNAL_FORMAT};
    static const RTint formats[] = {1, RT_RGB5, RT_RGBA8, RT_ALPHA, RT_INTENSITY16, RT_SRGB8};
    enum { nameCount = sizeof names / sizeof *names };
    RTfloat number = -77;
    RTint bound = -77;
    RTuint list;
    int i, k;
    startTextures();
    for (i = 0; i < nameCount - 1; ++i) CHECK(levelOf(RT_PROXY_TEXTURE_1D, 3, names[i]) == 0);
    CHECK(levelOf(RT_PROXY_TEXTURE_2D, 0, RT_TEXTURE_INTERNAL_FORMAT) == 1);

    /* What a proxy says is what the texture says. */
    rtBindTexture(RT_TEXTURE_2D, 1);
    for (i = 0; i < (int)(sizeof formats / sizeof *formats); ++i) {
        const RTenum type = i % 2 ? RT_UNSIGNED_SHORT : RT_UNSIGNED_BYTE;
        for (k = 0; k < 2; ++k)
            rtTexImage2D(twice[k], i, formats[i], 5, 3, 0, RT_RGBA, type, NULL);
        for (k = 0; k < nameCount; ++k)
            CHECK(levelOf(RT_TEXTURE_2D, i, names[k]) ==
                  levelOf(RT_PROXY_TEXTURE_2D, i, names[k]));
    }
    /* The texture and other levels stay. */
    CHECK(proxyWidth(0, RT_RGB, 64, 32, 0, RT_RGB, RT_UNSIGNED_BYTE) == 64);
    rtGetTexLevelParameterfv(RT_PROXY_TEXTURE_2D, 0, RT_TEXTURE_HEIGHT, &number);
    CHECK(number == 32 && levelOf(RT_PROXY_TEXTURE_2D, 1, RT_TEXTURE_WIDTH) == 5);
    CHECK(levelOf(RT_TEXTURE_2D, 0, RT_TEXTURE_WIDTH) == 5);
    rtGetIntegerv(RT_TEXTURE_BINDING_2D, &bound);
    CHECK(bound == 1);
    CHECK_ERROR(RT_NO_ERROR);

    /* The largest; what the library can not have, without an error. */
    CHECK(proxyWidth(0, RT_RGBA, 16384, 16384, 0, RT_RGBA, RT_UNSIGNED_BYTE) == 16384);
    CHECK(proxyWidth(0, RT_RGBA, 16385, 1, 0, RT_RGBA, RT_UNSIGNED_BYTE) == 0);
    for (i = 0; i < nameCount - 1; ++i) CHECK(levelOf(RT_PROXY_TEXTURE_2D, 0, names[i]) == 0);
    CHECK(proxyWidth(0, RT_RGBA, 8, 1 << 30, 0, RT_RGBA, RT_UNSIGNED_BYTE) == 0);
    CHECK(proxyWidth(14, RT_RGBA, 1, 1, 0, RT_RGBA, RT_UNSIGNED_BYTE) == 1);
    CHECK(proxyWidth(14, RT_RGBA, 1, 2, 0, RT_RGBA, RT_UNSIGNED_BYTE) == 0);
    CHECK(proxyWidth(2, RT_RGBA, 0, 2, 0, RT_RGBA, RT_UNSIGNED_BYTE) == 0);
    CHECK(proxyWidth(2, RT_RGBA, 6, 6, 1, RT_RGBA, RT_UNSIGNED_BYTE) == 0);
    CHECK(proxyWidth(2, RT_RGBA, 6, 6, 0, RT_COLOR_INDEX, RT_BITMAP) == 0);
    CHECK(proxyWidth(2, RT_DEPTH_COMPONENT24, 6, 6, 0, RT_DEPTH_COMPONENT, RT_FLOAT) == 0);
    CHECK_ERROR(RT_NO_ERROR);

    /* What is wrong for every target is an error and leaves the proxy. */
    CHECK(proxyWidth(2, RT_RGBA, 6, 6, 0, RT_RGBA, RT_FLOAT) == 6);
    CHECK(proxyWidth(2, RT_RGBA, -1, 6, 0, RT_RGBA, RT_UNSIGNED_BYTE) == 6);
    CHECK_ERROR(RT_INVALID_VALUE);
    CHECK(proxyWidth(2, RT_RGBA, 1 << 20, 6, 2, RT_RGBA, RT_UNSIGNED_BYTE) == 6);
    CHECK_ERROR(RT_INVALID_VALUE);
    CHECK(proxyWidth(2, 99, 1 << 20, 6, 0, RT_RGBA, RT_UNSIGNED_BYTE) == 6);
    CHECK_ERROR(RT_INVALID_VALUE);
    CHECK(proxyWidth(2, RT_RGBA, 1 << 20, 6, 0, RT_RGBA, 0xABCD) == 6);
    CHECK_ERROR(RT_INVALID_ENUM);
    CHECK(proxyWidth(2, RT_RGBA, 1 << 20, 6, 0, RT_COLOR_INDEX, 0xABCD) == 6);
    CHECK_ERROR(RT_INVALID_ENUM);
    CHECK(proxyWidth(2, RT_DEPTH_COMPONENT, 6, 6, 0, RT_RGBA, RT_UNSIGNED_BYTE) == 6);
    CHECK_ERROR(RT_INVALID_OPERATION);
    CHECK(proxyWidth(2, RT_RGBA, 6, 6, 0, RT_DEPTH_COMPONENT, RT_FLOAT) == 6);
    CHECK_ERROR(RT_INVALID_OPERATION);
    rtBegin(RT_TRIANGLES);
    rtTexImage2D(RT_PROXY_TEXTURE_2D, 2, RT_RGB, 9, 9, 0, RT_RGB, RT_UNSIGNED_BYTE, NULL);
    rtEnd();
    CHECK_ERROR(RT_INVALID_OPERATION);
    CHECK(levelOf(RT_PROXY_TEXTURE_2D, 2, RT_TEXTURE_WIDTH) == 6);

    /* Each number of dimensions has its own. */
    rtTexImage1D(RT_PROXY_TEXTURE_1D, 2, RT_LUMINANCE, 7, 0, RT_RGB, RT_UNSIGNED_BYTE, NULL);
    CHECK(levelOf(RT_PROXY_TEXTURE_1D, 2, RT_TEXTURE_WIDTH) == 7);
    CHECK(levelOf(RT_PROXY_TEXTURE_1D, 2, RT_TEXTURE_HEIGHT) == 1);
    CHECK(levelOf(RT_PROXY_TEXTURE_1D, 2, RT_TEXTURE_LUMINANCE_SIZE) == 8);
    CHECK(levelOf(RT_PROXY_TEXTURE_2D, 2, RT_TEXTURE_WIDTH) == 6);
    CHECK_ERROR(RT_NO_ERROR);

    /* Lists do not keep the call: it is made at once, and only then. */
    list = rtGenLists(1);
    rtNewList(list, RT_COMPILE);
    rtTexImage2D(RT_PROXY_TEXTURE_2D, 2, RT_RGB, 9, 9, 0, RT_RGB, RT_UNSIGNED_BYTE, NULL);
    CHECK(levelOf(RT_PROXY_TEXTURE_2D, 2, RT_TEXTURE_WIDTH) == 9);
    rtEndList();
    CHECK(proxyWidth(2, RT_RGBA, 6, 6, 0, RT_RGBA, RT_UNSIGNED_BYTE) == 6);
    rtCallList(list);
    CHECK(levelOf(RT_PROXY_TEXTURE_2D, 2, RT_TEXTURE_WIDTH) == 6);
    rtDeleteLists(list, 1);
    CHECK_ERROR(RT_NO_ERROR);
}

int main(void) {
    names();
    mipmaps();
    parts();
    halves();
    borders();
    parameters();
    proxies();
    formats();
    unpacking();
    lookups();
    rtExit();
    return failureCount;
}
